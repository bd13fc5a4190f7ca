#pragma once
/// The page of a milling check from its result (milling_page.hpp draws it).

#include "report/milling_page.hpp"
#include "report/subject.hpp"

namespace obrys::report {

/// `subject.result.milled` must be there.
[[nodiscard]] MillingPage milling_page_of(const Subject& subject);

}  // namespace obrys::report
