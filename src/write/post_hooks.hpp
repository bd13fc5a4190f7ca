#pragma once
/// The table [lua] of a post file. Private to write.

#include "shop/files/section.hpp"
#include "write/post.hpp"

namespace obrys::write {

/// Reads it and tries it out; complaints go to the section's.
void read_hooks(shop::Section& file, const base::Sources& sources, const LoadText& load, Post& post);

}  // namespace obrys::write
