#pragma once
/// A time for people.

#include <string>

namespace obrys::report {

/// "1 h 2 min 3 s"; "?": not known.
[[nodiscard]] std::string clock(double seconds);

}  // namespace obrys::report
