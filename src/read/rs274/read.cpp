#include "read/rs274/read.hpp"

#include <algorithm>

#include "dialect/rs274/linuxcnc.hpp"
#include "read/rs274/state.hpp"

namespace obrys::read::rs274 {

namespace {

std::string stem(std::string_view path) {
    if (const std::size_t slash = path.find_last_of("/\\"); slash != std::string_view::npos)
        path.remove_prefix(slash + 1);
    if (const std::size_t dot = path.rfind('.'); dot != std::string_view::npos && dot > 0) path = path.substr(0, dot);
    return base::to_upper(path);
}

void read_line(State& s) {
    s.failed = false;
    begin_words(s);
    if (s.line.at_end()) return;
    if (s.line.fault() != CommentFault::none) {
        const bool nested = s.line.fault() == CommentFault::nested;
        const std::uint32_t at = s.line.fault_begin();
        return fail(s, at, at + 1, nested ? "a comment stands within a comment" : "this comment is not closed",
                    nested ? "end the first one in front of it" : "add )");
    }
    read_block_head(s);
    read_words(s);
    emit_block(s);
}

void read_lines(State& s) {
    const char* begin = s.text.data();
    const char* p = begin;
    const char* end = begin + s.text.size();
    while (p < end) {
        if (*p == '\n' || *p == '\r' || base::is_blank(*p)) {
            ++p;
            continue;
        }
        if (const char* behind = read_literal_block(s, p, end); behind != nullptr) {
            p = behind;
            continue;
        }
        const char* line_end = std::find(p, end, '\n');
        s.line.load(s.text, static_cast<std::uint32_t>(p - begin), static_cast<std::uint32_t>(line_end - begin),
                    s.variant.nested_comments, s.variant.semicolon_comment);
        read_line(s);
        p = line_end;
    }
}

}  // namespace

std::vector<program::Unit> read_linuxcnc(std::uint32_t file, const base::Sources& sources, program::Names& names,
                                         base::Diagnostics& diagnostics) {
    const base::Source& source = sources[file];
    State s(file, dialect::rs274::linuxcnc, names, diagnostics, source.text);
    s.part = &s.parts.emplace_back(file, s.variant, names, diagnostics, s.text);
    s.part->unit.name = stem(source.name);
    s.part->unit.end = static_cast<std::uint32_t>(source.text.size());
    read_lines(s);
    std::vector<program::Unit> units;
    for (Part& part : s.parts) units.push_back(std::move(part.unit));
    return units;
}

}  // namespace obrys::read::rs274
