#include "base/source.hpp"

#include <algorithm>
#include <utility>

#include "base/text.hpp"

namespace obrys::base {

std::uint32_t Sources::add(std::unique_ptr<Text> text, std::string_view bytes) {
    text->source.text = bytes;
    if (bytes.starts_with("\xEF\xBB\xBF")) text->source.text.remove_prefix(3);
    text->source.utf8 = is_utf8(text->source.text);
    texts_.push_back(std::move(text));
    return size() - 1;
}

std::uint32_t Sources::add(std::string name, std::string text, BlockNumbers numbers) {
    auto added = std::make_unique<Text>();
    added->source = {std::move(name), {}, numbers, true};
    added->bytes = std::move(text);
    const std::string_view bytes = added->bytes;
    return add(std::move(added), bytes);
}

std::uint32_t Sources::add(std::string name, std::unique_ptr<Store> text, BlockNumbers numbers) {
    auto added = std::make_unique<Text>();
    added->source = {std::move(name), {}, numbers, true};
    added->store = std::move(text);
    const std::string_view bytes = added->store->bytes();
    return add(std::move(added), bytes);
}

void Sources::lay_aside(std::uint32_t file, std::uint32_t end) const {
    Text& t = *texts_[file];
    if (t.store == nullptr) return;
    const std::scoped_lock alone(t.use);
    t.store->lay_aside(0, t.store->bytes().size() - t.source.text.size() + end);
}

void Sources::fetch(std::uint32_t file) const {
    Text& t = *texts_[file];
    if (t.store == nullptr) return;
    const std::scoped_lock alone(t.use);
    t.store->fetch(0, t.store->bytes().size());
}

std::string_view Sources::part(Text& t, std::size_t begin, std::size_t end) {
    const std::string_view text = t.source.text;
    begin = std::min(begin, text.size());
    end = std::clamp(end, begin, text.size());
    if (t.store != nullptr && begin < end) {
        const std::scoped_lock alone(t.use);
        const std::size_t mark = t.store->bytes().size() - text.size();
        t.store->fetch(mark + begin, mark + end);
    }
    return text.substr(begin, end - begin);
}

namespace {

/// Where lines begin in a piece that has no CR, and none before it.
void add_starts_behind_lf(std::string_view piece, std::size_t at, std::vector<std::uint32_t>& starts) {
    for (std::size_t lf = piece.find('\n'); lf != std::string_view::npos; lf = piece.find('\n', lf + 1))
        starts.push_back(static_cast<std::uint32_t>(at + lf + 1));
}

/// Adds where lines begin to `starts`. `at`: place of `piece` in the text; `cr`: the byte before it is a CR.
void add_line_starts(std::string_view piece, std::size_t at, bool& cr, std::vector<std::uint32_t>& starts) {
    if (!cr && piece.find('\r') == std::string_view::npos) return add_starts_behind_lf(piece, at, starts);
    for (const char c : piece) {
        if (cr && c != '\n') starts.push_back(static_cast<std::uint32_t>(at));
        cr = c == '\r';
        ++at;
        if (c == '\n') starts.push_back(static_cast<std::uint32_t>(at));
    }
}

}  // namespace

namespace {

/// Behind the begins of lines, where there are no others.
constexpr std::uint32_t no_more_lines = 0xFFFFFFFF;

}  // namespace

/// At least one line more, or that there is none: a message near the begin of a large text needs no more than its begin
/// looked through.
void Sources::find_lines(Text& t) {
    const std::string_view text = t.source.text;
    Store* store = t.store.get();
    const std::size_t mark = store == nullptr ? 0 : store->bytes().size() - text.size();  // bytes of a mark in front
    const std::size_t known = t.line_starts.size();
    bool cr = false;
    std::size_t begin = mark + t.line_starts.back(), end = begin;
    for (; t.line_starts.size() == known && end < mark + text.size(); begin = end) {
        end = std::min((begin / Store::piece + 1) * Store::piece, mark + text.size());
        const bool aside = store != nullptr && store->fetch(begin, end);
        add_line_starts(text.substr(begin - mark, end - begin), begin - mark, cr, t.line_starts);
        if (aside) store->lay_aside(begin / Store::piece * Store::piece, end);
    }
    if (end < mark + text.size()) return;
    if (cr) t.line_starts.push_back(static_cast<std::uint32_t>(text.size()));
    t.line_starts.push_back(no_more_lines);
}

/// Those found so far; the caller has locked the text.
const std::vector<std::uint32_t>& Sources::line_starts(Text& t) {
    if (t.line_starts.empty()) t.line_starts.push_back(0);
    return t.line_starts;
}

Position Sources::position(std::uint32_t file, std::uint32_t offset) const {
    Text& t = *texts_[file];
    const std::size_t end = std::min<std::size_t>(offset, t.source.text.size());
    std::uint32_t line = 0;
    std::size_t begin = 0;
    {
        const std::scoped_lock alone(t.use);
        const std::vector<std::uint32_t>& starts = line_starts(t);
        while (starts.back() <= end) find_lines(t);
        line = static_cast<std::uint32_t>(std::upper_bound(starts.begin(), starts.end(), end) - starts.begin());
        begin = starts[line - 1];
    }
    std::size_t column = end - begin;
    if (t.source.utf8) column = character_count(part(t, begin, begin + column));
    return {line, static_cast<std::uint32_t>(column + 1)};
}

std::string_view Sources::line(std::uint32_t file, std::uint32_t number) const {
    Text& t = *texts_[file];
    std::size_t begin = 0, end = 0;
    {
        const std::scoped_lock alone(t.use);
        const std::vector<std::uint32_t>& starts = line_starts(t);
        while (starts.size() <= number && starts.back() != no_more_lines) find_lines(t);
        if (number == 0 || number > starts.size() || starts[number - 1] == no_more_lines) return {};
        begin = starts[number - 1];
        end = number < starts.size() && starts[number] != no_more_lines ? starts[number] : t.source.text.size();
    }
    std::string_view text = part(t, begin, end);
    while (text.ends_with('\n') || text.ends_with('\r')) text.remove_suffix(1);
    return text;
}

std::string Sources::line_utf8(const Span& span) const {
    const std::string_view raw = line(span.file, position(span).line);
    return (*this)[span.file].utf8 ? std::string(raw) : cp1252_to_utf8(raw);
}

std::string_view Sources::text(const Span& span) const { return part(*texts_[span.file], span.begin, span.end); }

std::optional<std::uint32_t> Sources::block_number(std::uint32_t file, std::uint32_t offset) const {
    const BlockNumbers style = (*this)[file].block_numbers;
    if (style == BlockNumbers::none) return std::nullopt;
    std::string_view rest = trim(line(file, position(file, offset).line));
    if (style == BlockNumbers::n_word) {
        if (!rest.empty() && rest.front() == '/') {  // skip level: `/`, `/3`
            rest.remove_prefix(1);
            if (!rest.empty() && is_digit(rest.front())) rest.remove_prefix(1);
            rest = trim(rest);
        }
        if (rest.size() < 2 || upper(rest.front()) != 'N') return std::nullopt;
        rest.remove_prefix(1);
    }
    std::uint32_t number = 0;
    std::size_t digits = 0;
    while (digits < rest.size() && digits < 9 && is_digit(rest[digits]))
        number = number * 10 + static_cast<std::uint32_t>(rest[digits++] - '0');
    if (digits == 0) return std::nullopt;
    return number;
}

}  // namespace obrys::base
