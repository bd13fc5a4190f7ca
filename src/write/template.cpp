#include "write/template.hpp"

#include <algorithm>
#include <utility>

#include "base/number.hpp"

namespace obrys::write {

namespace {

/// Tokens of a block: blanks divide them, but not within braces.
std::vector<std::string_view> tokens_of(std::string_view text) {
    std::vector<std::string_view> out;
    std::size_t begin = 0;
    int depth = 0;
    for (std::size_t i = 0; i <= text.size(); ++i) {
        const char c = i < text.size() ? text[i] : ' ';
        depth += c == '{' ? 1 : c == '}' ? -1 : 0;
        if (c != ' ' || (depth > 0 && i < text.size())) continue;
        if (i > begin) out.push_back(text.substr(begin, i - begin));
        begin = i + 1;
    }
    return out;
}

int slot_of(std::string_view letters, const Grammar& g) {
    const auto found = std::find(g.modal_words.begin(), g.modal_words.end(), letters);
    return found == g.modal_words.end() ? -1 : static_cast<int>(found - g.modal_words.begin());
}

int group_of(std::string_view word, const Grammar& g) {
    for (std::size_t i = 0; i < g.groups.size(); ++i)
        if (std::find(g.groups[i].begin(), g.groups[i].end(), word) != g.groups[i].end()) return static_cast<int>(i);
    return -1;
}

/// Where the tool is and how fast it goes: what a control keeps from block to block.
bool stays_in_force(ValueIndex v) {
    for (const Value kept : {Value::x, Value::y, Value::z, Value::feed, Value::speed, Value::approach, Value::entry})
        if (v == index_of(kept)) return true;
    return false;
}

std::optional<Part> part_named(std::string_view name) {
    if (name == "comp") return Part::compensation;
    if (name == "corner") return Part::corner;
    if (name == "axes") return Part::axes;
    if (name == "length") return Part::length;
    if (name == "feed") return Part::feed;
    if (name == "coolant") return Part::coolant;
    return std::nullopt;
}

/// `name`, `name!`, `name*-1`, `name:style` and combinations in this order.
bool parse_value(std::string_view inside, const Grammar& g, Token& t, std::string& error) {
    const auto cut = [&](char sign) {
        const std::size_t at = inside.rfind(sign);
        if (at == std::string_view::npos) return std::string_view{};
        const std::string_view behind = inside.substr(at + 1);
        inside = inside.substr(0, at);
        return behind;
    };
    if (inside.ends_with('~')) t.slot = -1;
    if (inside.ends_with('!')) t.always = true;
    if (inside.ends_with('!') || inside.ends_with('~')) inside.remove_suffix(1);
    const bool styled = inside.find(':') != std::string_view::npos;
    const std::string_view style = cut(':');
    const bool scaled = inside.find('*') != std::string_view::npos;
    const std::string_view factor = cut('*');
    if (const auto text = text_named(inside); text && !styled && !scaled) {
        t.kind = Token::Kind::text;
        t.text = *text;
        return true;
    }
    const auto value = value_named(inside, g.in_cycle);
    if (!value) {
        error = "there is no value called '" + std::string(inside) + "'";
        return false;
    }
    t.value = *value;
    if (!stays_in_force(*value)) t.spoils = std::exchange(t.slot, -1);
    t.style = g.style_of[*value];
    if (scaled) {
        const auto number = base::parse_double(factor);
        if (!number || *number == 0) {
            error = "'" + std::string(factor) + "' is no number to multiply with";
            return false;
        }
        t.factor = *number;
    }
    if (styled) {
        const auto found = std::find(g.style_names.begin(), g.style_names.end(), style);
        if (found == g.style_names.end()) {
            error = "there is no style of numbers called '" + std::string(style) + "'";
            return false;
        }
        t.style = static_cast<std::size_t>(found - g.style_names.begin());
    }
    return true;
}

bool parse_choice(std::string_view inside, const Grammar& g, Token& t, std::string& error) {
    const std::size_t mark = inside.find('?'), bar = inside.find('|', mark);
    std::string_view name = inside.substr(0, mark);
    if (const std::size_t equals = name.find('='); equals != std::string_view::npos) {
        t.equals = base::parse_double(name.substr(equals + 1));
        if (!t.equals) return error = "what stands behind = is no number", false;
        name = name.substr(0, equals);
    }
    const auto value = value_named(name, g.in_cycle);
    if (!value) {
        error = "there is no value called '" + std::string(name) + "'";
        return false;
    }
    t.kind = Token::Kind::choice;
    t.value = *value;
    t.before = inside.substr(mark + 1, bar == std::string_view::npos ? bar : bar - mark - 1);
    if (bar != std::string_view::npos) t.after = inside.substr(bar + 1);
    t.group = group_of(t.before, g);
    return true;
}

/// Values that stand before the last one of a word.
bool parse_indices(const Grammar& g, Token& t, std::string& error) {
    for (;;) {
        const std::size_t open = t.before.find('{'), close = t.before.find('}', open);
        if (open == std::string::npos) return true;
        Token index;
        if (close == std::string::npos) return error = "a brace is not closed", false;
        if (!parse_value(std::string_view(t.before).substr(open + 1, close - open - 1), g, index, error)) return false;
        if (index.kind == Token::Kind::text)
            return error = "before the value of a word stand letters, values, or one text at its begin", false;
        t.indices.push_back({t.before.substr(0, open), index.value, index.factor, index.style});
        t.before.erase(0, close + 1);
    }
}

bool parse_token(std::string_view word, const Grammar& g, Token& t, std::string& error) {
    const std::size_t open = word.rfind('{');
    if (open == std::string_view::npos) {
        if (word.find('}') != std::string_view::npos) return error = "a brace is closed that is not open", false;
        t.before = word;
        t.group = group_of(word, g);
        return true;
    }
    const std::size_t close = word.find('}', open);
    if (close == std::string_view::npos) return error = "a brace is not closed", false;
    const std::string_view inside = word.substr(open + 1, close - open - 1);
    const bool whole = open == 0 && close + 1 == word.size();
    if (whole && inside.find('?') != std::string_view::npos) return parse_choice(inside, g, t, error);
    if (whole)
        if (const auto part = part_named(inside.substr(0, inside.size() - (inside.ends_with('!') ? 1 : 0)))) {
            t.kind = Token::Kind::part;
            t.part = *part;
            t.always = inside.ends_with('!');
            return true;
        }
    t.kind = Token::Kind::word;
    t.before = word.substr(0, open);
    if (const std::size_t end = t.before.find('}'); t.before.starts_with('{') && end != std::string::npos) {
        t.first = text_named(std::string_view(t.before).substr(1, end - 1));
        if (t.first) t.before.erase(0, end + 1);
    }
    if (!parse_indices(g, t, error)) return false;
    t.after = word.substr(close + 1);
    t.slot = slot_of(t.before, g);
    return parse_value(inside, g, t, error);
}

}  // namespace

std::optional<Block> parse_block(std::string_view text, const Grammar& grammar, std::string& error) {
    Block block;
    for (const std::string_view word : tokens_of(text)) {
        Token t;
        if (!parse_token(word, grammar, t, error)) return std::nullopt;
        block.push_back(std::move(t));
    }
    return block;
}

bool says(const Template& text, ValueIndex value) {
    return std::any_of(text.begin(), text.end(), [&](const Block& b) {
        return std::any_of(b.begin(), b.end(), [&](const Token& t) {
            const bool holds = t.kind == Token::Kind::word || t.kind == Token::Kind::choice;
            const auto is_index = [&](const Token::Index& i) { return i.value == value; };
            return holds && (t.value == value || std::any_of(t.indices.begin(), t.indices.end(), is_index));
        });
    });
}

bool has_part(const Template& text, Part part) {
    return std::any_of(text.begin(), text.end(), [&](const Block& block) {
        return std::any_of(block.begin(), block.end(),
                           [&](const Token& t) { return t.kind == Token::Kind::part && t.part == part; });
    });
}

Places::Places(const Template& text) {
    for (std::size_t i = 0; i < part_count; ++i) parts_[i] = has_part(text, static_cast<Part>(i));
    const bool by_sweep = says(text, index_of(Value::sweep));
    constexpr std::array values{Value::x, Value::y, Value::z};
    for (std::size_t k = 0; k < values.size(); ++k) axes_[k] = by_sweep || says(text, index_of(values[k]));
}

}  // namespace obrys::write
