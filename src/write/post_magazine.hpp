#pragma once
/// The table [magazine] of a post file. Private to write.

#include "shop/files/section.hpp"
#include "write/post.hpp"

namespace obrys::write {

/// Reads it; complaints go to the section's.
void read_magazine(shop::Section& file, Post& post);

}  // namespace obrys::write
