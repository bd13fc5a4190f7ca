#pragma once
/// Running a stretch of the program without output, to learn which contour elements it makes. Private to interp.

#include <memory>

#include "interp/state.hpp"

namespace obrys::interp {

/// Looks ahead in this run.
[[nodiscard]] std::unique_ptr<Onward> look_ahead(Run&);

/// Runs some statements ahead and forgets them: for tests, which look for a trace.
void look_ahead_in_vain(Run&, std::uint32_t statements);

}  // namespace obrys::interp
