#pragma once
/// obrys translate --keep.

#include <string>

#include "arguments.hpp"
#include "driver/session.hpp"
#include "write/post.hpp"

namespace obrys::cli {

[[nodiscard]] int translate_kept(driver::Session& s, const write::Post& post, const Arguments& a,
                                 const std::string& name);

}  // namespace obrys::cli
