#pragma once
/// The tables [magazine] and [function] of a post file. Private to write.

#include "shop/files/section.hpp"
#include "write/post.hpp"

namespace obrys::write {

/// What [function] says; `table` is it.
void read_functions(shop::Section& table, Post& post);
/// Complaints go to the section's.
void read_magazine(shop::Section& file, Post& post);

}  // namespace obrys::write
