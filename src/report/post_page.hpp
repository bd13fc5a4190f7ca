#pragma once
/// What a post writes, as text, JSON and page. Every function returns the whole document, UTF-8.

#include <string>
#include <vector>

namespace obrys::report {

/// A value or a remark: name and text.
using PostEntry = std::pair<std::string, std::string>;

/// One command with chosen values, or one sample of the stream.
struct PostRow {
    std::string name, form;
    std::vector<std::string> blocks;
    std::vector<PostEntry> values;
    std::string fault;  ///< why nothing is written
};

struct PostSheet {
    std::string name, title, control;
    std::vector<PostRow> rows;
};

[[nodiscard]] std::string preview_text(const PostSheet& sheet);
/// One page that needs no network.
[[nodiscard]] std::string preview_html(const PostSheet& sheet);

/// Of a check: what became of a sample.
struct PostSample {
    std::string name, kind, outcome, read;
    std::vector<std::string> blocks;
    std::vector<std::string> notes, differences;
};
struct PostCheck {
    std::string name, title, control;
    bool has_reader = false;
    std::vector<PostSample> samples;
};
/// `all`: also the blocks of what is written without a remark.
[[nodiscard]] std::string post_check_text(const PostCheck& check, bool all);
[[nodiscard]] std::string post_check_json(const PostCheck& check);

/// The shipped posts.
struct PostLine {
    std::string name, title, extends, control;
};
[[nodiscard]] std::string post_list_text(const std::vector<PostLine>& posts);
[[nodiscard]] std::string post_list_json(const std::vector<PostLine>& posts);

}  // namespace obrys::report
