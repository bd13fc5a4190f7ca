#pragma once
/// A text as lines with their ends, and the parts of a line. Private to the folder.

#include <string>
#include <string_view>
#include <vector>

#include "format/heidenhain/format.hpp"

namespace obrys::format::heidenhain {

struct Line {
    std::string_view text;  ///< without its end
    std::string_view end;   ///< LF, CR LF, CR (only in texts without any LF), or nothing at the text's end
};

[[nodiscard]] std::vector<Line> split_lines(std::string_view text);

/// Blanks and tabs off the right.
[[nodiscard]] std::string_view trim_right(std::string_view s);
[[nodiscard]] std::string_view trim_left(std::string_view s);
/// The line says that the block goes on behind it: `~` is its last character but blanks.
[[nodiscard]] bool goes_on(std::string_view line);
/// Blanks only, at least one: ends a block where an empty line would not, so its blanks must stay.
[[nodiscard]] bool blanks_only(std::string_view line);
/// Control characters other than tab: such a line is not touched.
[[nodiscard]] bool has_control_characters(std::string_view line);

/// A line's words and its comment (from `;` on, blanks at its end gone). `~` at the end of the words is taken off.
struct Parts {
    std::string_view code, comment;
    bool goes_on = false;  ///< with `~` behind the words; that of a comment is part of the comment
};
/// `texts`: a `;` inside double quotes is none.
[[nodiscard]] Parts split_comment(std::string_view line, bool texts);

/// Puts lines together.
class Writer {
public:
    Writer(std::string& out, LineEnds ends) : out_(out), ends_(ends) {}
    void line(std::string_view text, std::string_view end);

private:
    std::string& out_;
    LineEnds ends_;
};

}  // namespace obrys::format::heidenhain
