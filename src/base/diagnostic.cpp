#include "base/diagnostic.hpp"

#include <algorithm>

#include "base/text.hpp"

namespace obrys::base {

std::string_view name(Severity s) {
    switch (s) {
        case Severity::note: return "note";
        case Severity::warning: return "warning";
        case Severity::error: return "error";
    }
    return "error";
}

bool is_this_or_worse(Severity s, std::string_view named) {
    for (const Severity least : {Severity::note, Severity::warning, Severity::error})
        if (named == name(least)) return s >= least;
    return false;
}

void Diagnostics::add(Diagnostic d) {
    if (d.severity == Severity::error) ++errors_;
    if (++per_code_[d.code] > limit_) {
        ++dropped_;
        return;
    }
    all_.push_back(std::move(d));
}

namespace {

constexpr std::size_t widest_line = 160;  ///< characters of a source line that a message shows

std::string place(const Span& span, const Sources& sources) {
    const Position p = sources.position(span);
    return sources[span.file].name + ":" + std::to_string(p.line) + ":" + std::to_string(p.column);
}

/// Cuts a UTF-8 text to characters [from, from + count).
std::string characters(const std::string& text, std::size_t from, std::size_t count) {
    std::string out;
    std::size_t index = 0;
    for (const char c : text) {
        const bool starts = (static_cast<unsigned char>(c) & 0xC0) != 0x80;
        if (starts) ++index;
        if (index > from && index <= from + count) out += c == '\t' ? ' ' : c;
    }
    return out;
}

/// The source line and a caret line under the span; a very long line is shown around the span only.
std::string excerpt(const Span& span, const Sources& sources) {
    const std::string line = sources.line_utf8(span);
    const std::size_t column = sources.position(span).column - 1;
    const std::size_t all = character_count(line);
    const std::size_t from = column > widest_line / 2 && all > widest_line ? column - widest_line / 2 : 0;
    std::string_view marked = sources.text(span);
    marked = marked.substr(0, marked.find_first_of("\r\n"));
    const std::size_t room = widest_line - std::min(widest_line, column - from);
    const std::size_t width =
        std::clamp<std::size_t>(character_count(as_utf8(marked)), 1, std::max<std::size_t>(room, 1));
    std::string out = "  " + std::string(from > 0 ? "..." : "") + characters(line, from, widest_line);
    if (all > from + widest_line) out += "...";
    out += "\n  " + std::string(column - from + (from > 0 ? 3 : 0), ' ') + "^" + std::string(width - 1, '~') + "\n";
    return out;
}

}  // namespace

ShownStack shown(const std::vector<Span>& stack) {
    constexpr std::ptrdiff_t inner = 8, outer = 4;
    if (stack.size() <= static_cast<std::size_t>(inner + outer)) return {stack, {}, 0};
    return {{stack.begin(), stack.begin() + inner},
            {stack.end() - outer, stack.end()},
            stack.size() - static_cast<std::size_t>(inner + outer)};
}

std::string render(const Diagnostic& d, const Sources& sources) {
    std::string out;
    const bool placed = d.where.file < sources.size();
    if (placed) out += place(d.where, sources) + ": ";
    out += std::string(name(d.severity)) + ": " + d.text + " [" + std::string(d.code) + "]\n";
    if (placed && !sources[d.where.file].text.empty()) out += excerpt(d.where, sources);
    if (!d.remedy.empty()) out += "  remedy: " + d.remedy + "\n";
    const ShownStack stack = shown(d.stack);
    const auto call = [&](const Span& site) {
        out += "  called from " + place(site, sources) + ": " + std::string(trim(sources.line_utf8(site))) + "\n";
    };
    for (const Span& site : stack.inner) call(site);
    if (stack.left_out > 0) out += "  … " + std::to_string(stack.left_out) + " more calls\n";
    for (const Span& site : stack.outer) call(site);
    for (const Related& r : d.related)
        out += place(r.where, sources) + ": note: " + r.text + "\n" + excerpt(r.where, sources);
    return out;
}

}  // namespace obrys::base
