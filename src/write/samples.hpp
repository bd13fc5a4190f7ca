#pragma once
/// Streams with chosen values, by which a post is tried out: every kind of record, every kind of cycle in each form
/// that the post has for it.

#include <string>
#include <vector>

#include "write/post.hpp"

namespace obrys::write {

/// What a value is where nobody says another: whole lengths in mm, feeds in mm/min.
[[nodiscard]] double sample_value(ValueIndex value);

/// Whether the post's machine turns: its lines have no word for Y.
[[nodiscard]] bool turns(const Post& post);

struct Sample {
    std::string name;                      ///< "arc, half a turn in the plane of X and Y"
    std::string kind;                      ///< of record: the word that begins its line in the text form of the stream
    std::vector<cl::Step> steps;           ///< behind those of `sample_begin`
    std::vector<cl::CycleValue> values{};  ///< of a cycle
    std::optional<cl::CycleKind> cycle{};
    /// The moves are the control's own and not those of `steps`.
    [[nodiscard]] bool moves_itself() const { return kind == "lead"; }
};

/// Steps as records, each of a block of its own; moves that are made of a programmed element are of its block.
[[nodiscard]] std::vector<cl::Record> records_of(const std::vector<cl::Step>& steps);

/// What stands before every sample: a tool, its speed, a feed, a place.
[[nodiscard]] std::vector<cl::Step> sample_begin(const Post& post, double tool_radius);
/// Where the tool then stands.
[[nodiscard]] geom::Vec3 sample_place(bool turning);

[[nodiscard]] std::vector<Sample> record_samples(const Post& post);
/// Without the moves of the cycles, which are no business of posts: `steps` ends with the begin of the bracket.
[[nodiscard]] std::vector<Sample> cycle_samples(const Post& post);

}  // namespace obrys::write
