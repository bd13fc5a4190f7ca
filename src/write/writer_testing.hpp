#pragma once
/// Streams written by a post, for tests.

#include <optional>
#include <string>
#include <vector>

#include "write/writer.hpp"

namespace obrys::write {

/// A stream written by a post.
struct Written {
    std::string text;
    std::vector<std::string> lost, expanded;
    std::optional<base::Span> first_in_post;
};
inline Written write(const Post& post, const std::vector<cl::Step>& steps) {
    Written out;
    Output output;
    output.text = [&](std::string_view text) { out.text += text; };
    output.note = [&](const Note& n) {
        (n.fate == Fate::lost ? out.lost : out.expanded).push_back(n.what);
        if (!out.first_in_post) out.first_in_post = n.in_post;
    };
    Writer writer(post, "P", output);
    for (std::uint32_t i = 0; i < steps.size(); ++i) writer.take({steps[i], {0, i, i + 1}, 0});
    writer.finish();
    return out;
}

}  // namespace obrys::write
