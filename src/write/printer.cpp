#include "write/printer.hpp"

#include <algorithm>

namespace obrys::write {

static_assert(index_of(Value::x) == 0 && index_of(Value::y) == 1 && index_of(Value::z) == 2);  // of `stand_`

void Printer::Line::append(std::string_view token) {
    if (token.empty()) return;
    if (!text.empty()) text += ' ';
    text += token;
}

void Printer::Line::clear() {
    text.clear(), groups.clear(), in_force.clear();
    words = names = modes = plain = 0, slots = 0;
    mode_printed = asked = false;
}

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
        for (std::size_t i = 0; i < line.slots; ++i)
            words_[static_cast<std::size_t>(line.said[i].slot)] = line.said[i].word;
    }
}

void Printer::forget_coordinates() {
    for (std::size_t i = 0; i < words_.size(); ++i)
        if (post_.word_is_coordinate[i]) words_[i] = {};
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
                if (is_word) words_[i] = {};
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
        if (!post_.word_is_coordinate[i]) words_[i] = {};
    for (std::string& word : in_force_) word.clear();
}

void Printer::add_literal(Line& line, const std::string& text, int group) const {
    if (group < 0) line.plain += text.empty() ? 0 : 1;
    if (group < 0) return line.append(text);
    if (in_force_[static_cast<std::size_t>(group)] == text) return;
    line.append(text);
    ++line.modes;
    line.mode_printed = true;
    line.groups.emplace_back(group, &text);
}

/// Appends a number; false, with the word that fails, where the word cannot hold it or nobody knows it.
bool Printer::append_value(std::string& text, ValueIndex value, double factor, std::size_t style,
                           const Values& values) {
    const bool known = !values.is_unknown(value);
    if (known && append_number(text, values.number(value) * factor, post_.styles[style])) return true;
    failed_ = text + (known ? std::to_string(values.number(value) * factor) : "?");
    return false;
}

/// The word as it would stand; its text is empty where a value among its letters is not there.
bool Printer::make_word(Word& word, const Token& t, const Values& values) {
    word.clear();
    std::string& text = word.text;
    if (t.first) text = values.text(*t.first);
    for (const Token::Index& i : t.indices) {
        if (!values.has(i.value)) return text.clear(), true;
        text += i.before;
        if (!append_value(text, i.value, i.factor, i.style, values)) return false;
    }
    text += t.before;
    if (!append_value(text, t.value, t.factor, t.style, values)) return false;
    text += t.after;
    if (t.is_number_alone()) word.number = values.number(t.value), word.factor = t.factor, word.style = t.style;
    return true;
}

/// Whether a word that can hold on is to stand there; `holds`: it is the last one of its letters.
bool Printer::is_due(Line& line, const Token& t, const std::string& text, bool holds, double number) const {
    const bool is_coordinate = post_.word_is_coordinate[static_cast<std::size_t>(t.slot)];
    const bool behind_mode = line.mode_printed && !is_coordinate;
    const bool stands = t.value < stand_.size() && number == stand_[t.value];
    if ((holds || stands) && is_coordinate) line.in_force.push_back(text);
    return !holds || t.always || always_ || behind_mode || (all_words_ && is_coordinate);
}

bool Printer::add_word(Line& line, const Token& t, const Values& values) {
    if (!values.has(t.value)) return true;
    line.asked = true;
    const double number = values.number(t.value);
    const Word* last = t.slot >= 0 ? &words_[static_cast<std::size_t>(t.slot)] : nullptr;
    // Of the same number the same word is made.
    const bool as_last = last != nullptr && t.is_number_alone() && last->is_made_of(number, t);
    if (as_last && !is_due(line, t, last->text, true, number)) return true;
    Said& said = line.next();
    if (as_last) said.word = *last;
    if (!as_last && !make_word(said.word, t, values)) return false;
    if (said.word.text.empty()) return true;
    if (last != nullptr && !as_last && !is_due(line, t, said.word.text, last->text == said.word.text, number))
        return true;
    line.append(said.word.text);
    ++line.words;
    if (t.value == index_of(Value::number) || t.value == index_of(Value::edge)) ++line.names;
    const bool spoils = t.spoils >= 0 && !post_.word_is_coordinate[static_cast<std::size_t>(t.spoils)];
    if (spoils) said.word.clear();
    said.slot = spoils ? t.spoils : t.slot;
    if (said.slot >= 0) ++line.slots;
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
    return add_part(line, t, values, parts);
}

/// What others have to say in the place that the block has for it.
bool Printer::add_part(Line& line, const Token& t, const Values& values, const Parts& parts) {
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

Printer::Line& Printer::line_for(std::size_t n) {
    if (lines_.size() <= n) lines_.emplace_back();
    lines_[n].clear();
    return lines_[n];
}

/// What the block says holds behind it.
void Printer::put_in_force(Line& line) {
    for (std::size_t i = 0; i < line.slots; ++i)
        std::swap(words_[static_cast<std::size_t>(line.said[i].slot)], line.said[i].word);
    for (const auto& [group, word] : line.groups) in_force_[static_cast<std::size_t>(group)] = *word;
    std::swap(coordinates_in_force_, line.in_force);
}

Printed Printer::print_once(const Template& text, const Values& values, const Parts& parts, bool moves, bool by_hook) {
    std::size_t printed = 0;
    for (const Block& block : text) {
        Line& line = line_for(printed);
        const bool optional =
            !block.empty() && block.front().kind == Token::Kind::literal && block.front().before == "?";
        if (!add(line, std::span(block).subspan(optional ? 1 : 0), values, parts)) return Printed::failed;
        if (optional && line.words == line.names) continue;
        const bool goes_on = printed > 0 && !line.asked && line.plain > 0;  // what ends the word before it
        const bool says =
            line.words > 0 || goes_on || (by_hook && line.plain > 0) || (!moves && (line.modes > 0 || !line.asked));
        if (says && !line.text.empty())
            ++printed;
        else if (moves && block.size() > 0 && &block == &text.back())
            return Printed::nothing;
    }
    for (std::size_t i = 0; i < printed; ++i) {
        put_in_force(lines_[i]);
        out_(lines_[i].text);
    }
    return printed == 0 ? Printed::nothing : Printed::all;
}

std::optional<std::string> Printer::whole(const Block& block, const Values& values, const Parts& parts) const {
    Printer other(post_, [](std::string_view) {});
    Line line;
    if (!other.add(line, block, values, parts)) return std::nullopt;
    return line.text;
}

}  // namespace obrys::write
