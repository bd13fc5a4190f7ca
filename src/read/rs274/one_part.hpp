#pragma once
/// Inside only. A text that is one program: its lines from the first to the last, nothing behind each other but blocks.

#include <algorithm>
#include <vector>

#include "base/text.hpp"
#include "program/unit.hpp"

namespace obrys::read::rs274 {

/// `line` reads what the state's line holds. What has been read is laid aside, so that memory does not grow with the
/// text.
template <class State, class ReadLine>
[[nodiscard]] std::vector<program::Unit> read_one_part(State& s, base::Diagnostics& diagnostics, ReadLine line) {
    const base::Source& source = s.sources[s.file];
    s.text = base::without_end_signs(source.text);
    s.part = &s.add_part(diagnostics);
    program::Unit& unit = s.part->unit;
    unit.name = base::to_upper(base::stem(source.name));
    unit.end = static_cast<std::uint32_t>(source.text.size());
    unit.reserve(s.text.size());
    const std::size_t size = s.text.size();
    for (std::size_t at = 0, aside = 0; at < size;) {
        if (at - aside > base::Store::piece) {
            s.sources.lay_aside(s.file, static_cast<std::uint32_t>(at));
            aside = at;
        }
        const std::size_t end = std::min(s.text.find('\n', at), size);
        s.line.load(s.text, static_cast<std::uint32_t>(at), static_cast<std::uint32_t>(end), s.variant.nested_comments,
                    s.variant.semicolon_comment);
        line(s);
        at = end + 1;
    }
    if (!s.part->ended) unit.unended = "the program ends without M2 or M30";
    s.sources.lay_aside(s.file, static_cast<std::uint32_t>(size));
    std::vector<program::Unit> units;
    units.push_back(std::move(unit));
    return units;
}

}  // namespace obrys::read::rs274
