#pragma once
/// The file that `obrys post new` writes.

#include <string>

namespace obrys::cli {

/// `title` may hold any characters.
[[nodiscard]] std::string post_start(const std::string& title, const std::string& extends);

}  // namespace obrys::cli
