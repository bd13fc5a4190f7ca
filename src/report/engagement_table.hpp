#pragma once
/// How the tool was engaged in every move of a milling check, as CSV or JSON. Columns and keys: docs/engagement.md.

#include <string_view>

#include "base/function_ref.hpp"
#include "report/subject.hpp"

namespace obrys::report {

/// Takes the document piece by piece, a row or less each, so that it never lies in memory as a whole.
using TextSink = base::FunctionRef<void(std::string_view)>;

/// One row a move in the order of the moves; what is not known is empty. `subject.result.milled` must be there.
void engagement_csv(const Subject& subject, TextSink out);
/// The same as one object with the array "moves"; what is not known is null.
void engagement_json(const Subject& subject, TextSink out);

}  // namespace obrys::report
