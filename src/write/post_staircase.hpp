#pragma once
/// The table [staircase] of a post file. Private to write.

#include "shop/files/section.hpp"
#include "write/post.hpp"

namespace obrys::write {

/// Reads it, when all commands of the post have been read; complaints go to the section's.
void read_staircase(shop::Section& file, Post& post);

}  // namespace obrys::write
