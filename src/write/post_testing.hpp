#pragma once
/// Posts from texts, for tests.

#include <gtest/gtest.h>

#include "write/post.hpp"

namespace obrys::write {

/// What is wrong with a post, as "line: text" one below the other; empty where it can be used.
inline std::string faults_of(const std::string& text, std::optional<Post>* post = nullptr) {
    base::Sources sources;
    base::Diagnostics diagnostics;
    std::optional<Post> read = read_post(sources.add("p.toml", text), sources, diagnostics);
    std::string out;
    for (const base::Diagnostic& d : diagnostics.all())
        out += std::to_string(sources.position(d.where).line) + ": " + d.text + "\n";
    if (out.empty() && !read) out = "nothing was read\n";
    if (post != nullptr) *post = std::move(read);
    return out;
}

inline Post post_of(const std::string& text) {
    std::optional<Post> post;
    EXPECT_EQ(faults_of(text, &post), "");
    return post.value_or(Post{});
}

}  // namespace obrys::write
