#pragma once
/// A post that says less by words of its own: what its control does otherwise than the program is written by its moves.

#include <string_view>

#include "write/post.hpp"

namespace obrys::write {

/// Takes the post's words for tilted planes that turn the rotary axes; false where it has none.
[[nodiscard]] bool leave_out_turns(Post& post);

/// Takes the post's words for frames; false where it has none.
[[nodiscard]] bool leave_out_frames(Post& post);

/// mm: arcs whose ends lie in one of such steps are written as straight lines; 0: every arc is one.
[[nodiscard]] double least_arc(const Post& post);

/// Half of the last decimal of a style of numbers, in the unit of the values; 0 where the post has no such style.
[[nodiscard]] double half_step(const Post& post, std::string_view style);

}  // namespace obrys::write
