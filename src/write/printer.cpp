#include "write/printer.hpp"

#include <algorithm>

namespace obrys::write {

static_assert(index_of(Value::x) == 0 && index_of(Value::y) == 1 && index_of(Value::z) == 2);  // of `stand_`

/// A block on its way, with what will be in force behind it.
struct Printer::Line {
    std::string text;
    int words = 0;              ///< printed, of those that say more than how
    int names = 0;              ///< of these, those that only name what the block is about
    int modes = 0;              ///< words of groups
    bool mode_printed = false;  ///< in this template: a word behind it is printed, too
    int plain = 0;              ///< texts that stand as they are
    bool asked = false;         ///< the block has words with values
    std::vector<std::pair<int, std::string>> slots, groups;
    std::vector<std::string> in_force;  ///< words of coordinates that are so without it

    void append(std::string_view token) {
        if (token.empty()) return;
        if (!text.empty()) text += ' ';
        text += token;
    }
};

Printer::Printer(const Post& post, std::function<void(std::string_view)> out)
    : post_(post), out_(std::move(out)), words_(post.words), in_force_(post.groups.size()) {}

void Printer::force(const std::string& word) {
    for (std::size_t g = 0; g < post_.groups.size(); ++g)
        if (std::find(post_.groups[g].begin(), post_.groups[g].end(), word) != post_.groups[g].end())
            in_force_[g] = word;
}

void Printer::force(const Template& words) {
    for (const Block& block : words)
        for (const Token& t : block)
            if (t.kind == Token::Kind::literal) force(t.before);
}

void Printer::leave(const Template& words) {
    for (const Block& block : words)
        for (const Token& t : block)
            if (t.kind == Token::Kind::literal && t.group >= 0) in_force_[static_cast<std::size_t>(t.group)].clear();
}

void Printer::start() {
    for (const std::string& word : post_.in_force) force(word);
}

void Printer::remember(const Template& words, const Values& values) {
    for (const Block& block : words) {
        Line line;
        if (!add(line, block, values, {})) continue;
        for (const auto& [slot, word] : line.slots) words_[static_cast<std::size_t>(slot)] = word;
    }
}

void Printer::forget_coordinates() {
    for (std::size_t i = 0; i < words_.size(); ++i)
        if (post_.word_is_coordinate[i]) words_[i].clear();
}

void Printer::forget_words_of(const Template& text) {
    for (const Block& block : text)
        for (const Token& t : block) {
            if (t.kind != Token::Kind::literal || t.group >= 0) continue;
            for (std::size_t i = 0; i < words_.size(); ++i) {
                const std::string& letters = post_.grammar.modal_words[i];
                const bool is_word =
                    t.before.starts_with(letters) && t.before.size() > letters.size() &&
                    std::string_view("0123456789+-.").find(t.before[letters.size()]) != std::string_view::npos;
                if (is_word) words_[i].clear();
            }
        }
}

void Printer::forget_values_of(const Template& text) {
    for (const Block& block : text)
        for (const Token& t : block)
            if (t.slot >= 0) words_[static_cast<std::size_t>(t.slot)].clear();
}

void Printer::forget_modes() {
    for (std::size_t i = 0; i < words_.size(); ++i)
        if (!post_.word_is_coordinate[i]) words_[i].clear();
    for (std::string& word : in_force_) word.clear();
}

void Printer::add_literal(Line& line, const std::string& text, int group) const {
    if (group < 0) line.plain += text.empty() ? 0 : 1;
    if (group < 0) return line.append(text);
    if (in_force_[static_cast<std::size_t>(group)] == text) return;
    line.append(text);
    ++line.modes;
    line.mode_printed = true;
    line.groups.emplace_back(group, text);
}

bool Printer::add_word(Line& line, const Token& t, const Values& values) {
    if (!values.has(t.value)) return true;
    line.asked = true;
    std::string text(t.first ? values.text(*t.first) : std::string_view());
    for (const Token::Index& i : t.indices) {
        if (!values.has(i.value)) return true;
        text += i.before;
        const bool holds = !values.is_unknown(i.value);
        if (holds && append_number(text, values.number(i.value) * i.factor, post_.styles[i.style])) continue;
        failed_ = text + (holds ? std::to_string(values.number(i.value) * i.factor) : "?");
        return false;
    }
    text += t.before;
    const bool known = !values.is_unknown(t.value);
    if (!known || !append_number(text, values.number(t.value) * t.factor, post_.styles[t.style])) {
        failed_ = text + (known ? std::to_string(values.number(t.value) * t.factor) : "?");
        return false;
    }
    text += t.after;
    if (t.slot >= 0) {
        const auto slot = static_cast<std::size_t>(t.slot);
        const bool behind_mode = line.mode_printed && !post_.word_is_coordinate[slot];
        const bool is_coordinate = post_.word_is_coordinate[slot], holds = words_[slot] == text;
        const bool stands = t.value < stand_.size() && values.number(t.value) == stand_[t.value];
        if ((holds || stands) && is_coordinate) line.in_force.push_back(text);
        if (holds && !t.always && !always_ && !behind_mode && !(all_words_ && is_coordinate)) return true;
        line.slots.emplace_back(t.slot, text);
    }
    if (t.spoils >= 0 && !post_.word_is_coordinate[static_cast<std::size_t>(t.spoils)])
        line.slots.emplace_back(t.spoils, "");
    line.append(text);
    ++line.words;
    if (t.value == index_of(Value::number) || t.value == index_of(Value::edge)) ++line.names;
    return true;
}

bool Printer::add_token(Line& line, const Token& t, const Values& values, const Parts& parts) {
    switch (t.kind) {
        case Token::Kind::literal: add_literal(line, t.before, t.group); return true;
        case Token::Kind::word: return add_word(line, t, values);
        case Token::Kind::text:
            line.append(t.before + std::string(values.text(t.text)) + t.after);
            ++line.words;
            return true;
        case Token::Kind::choice: {
            const bool first = values.has(t.value) && (!t.equals || values.number(t.value) == *t.equals);
            add_literal(line, first ? t.before : t.after, t.group);
            if (first && t.group < 0 && !t.before.empty()) line.asked = true, ++line.words;
            return true;
        }
        case Token::Kind::part: break;
    }
    if (t.part == Part::axes) {
        line.asked = true;
        for (const std::string& axis : parts.axes) line.append(axis), ++line.words;
        return true;
    }
    const Template* part = t.part == Part::compensation ? parts.compensation
                           : t.part == Part::feed       ? parts.feed
                           : t.part == Part::length     ? parts.length
                           : t.part == Part::coolant    ? parts.coolant
                                                        : parts.corner;
    const int words = line.words;
    const bool mode = std::exchange(line.mode_printed, false);
    if (part != nullptr && !part->empty()) {
        const bool outer = std::exchange(always_, always_ || t.always);
        const bool printed = add(line, part->front(), values, {});
        always_ = outer;
        if (!printed) return false;
    }
    line.words = words;  // none of them moves
    line.mode_printed = mode;
    return true;
}

bool Printer::add(Line& line, std::span<const Token> block, const Values& values, const Parts& parts) {
    for (const Token& t : block)
        if (!add_token(line, t, values, parts)) return false;
    return true;
}

Printed Printer::print(const Template& text, const Values& values, const Parts& parts, bool moves, bool by_hook) {
    const Printed printed = print_once(text, values, parts, moves, by_hook);
    if (printed != Printed::nothing || !moves || !keeps_standing_) return printed;
    all_words_ = true;
    const Printed again = print_once(text, values, parts, moves, by_hook);
    all_words_ = false;
    return again;
}

Printed Printer::print_once(const Template& text, const Values& values, const Parts& parts, bool moves, bool by_hook) {
    std::vector<Line> lines;
    for (const Block& block : text) {
        Line line;
        const bool optional =
            !block.empty() && block.front().kind == Token::Kind::literal && block.front().before == "?";
        if (!add(line, std::span(block).subspan(optional ? 1 : 0), values, parts)) return Printed::failed;
        if (optional && line.words == line.names) continue;
        const bool goes_on = !lines.empty() && !line.asked && line.plain > 0;  // what ends the word before it
        const bool says =
            line.words > 0 || goes_on || (by_hook && line.plain > 0) || (!moves && (line.modes > 0 || !line.asked));
        if (says && !line.text.empty())
            lines.push_back(std::move(line));
        else if (moves && block.size() > 0 && &block == &text.back())
            return Printed::nothing;
    }
    for (Line& line : lines) {
        for (const auto& [slot, word] : line.slots) words_[static_cast<std::size_t>(slot)] = word;
        for (const auto& [group, word] : line.groups) in_force_[static_cast<std::size_t>(group)] = word;
        coordinates_in_force_ = std::move(line.in_force);
        out_(line.text);
    }
    return lines.empty() ? Printed::nothing : Printed::all;
}

std::optional<std::string> Printer::whole(const Block& block, const Values& values, const Parts& parts) const {
    Printer other(post_, [](std::string_view) {});
    Line line;
    if (!other.add(line, block, values, parts)) return std::nullopt;
    return line.text;
}

}  // namespace obrys::write
