#include "format/heidenhain/words.hpp"

#include "base/text.hpp"

namespace obrys::format::heidenhain {

using base::is_blank;
using base::is_digit;

namespace {

bool is_axis(char upper) {
    return upper != '\0' && std::string_view("XYZABCUVW").find(upper) != std::string_view::npos;
}

/// X10, IX+5, PA+30, IPR 3: true where such a word stood here and is written.
bool coordinate(Scan& in, std::string& word) {
    const std::size_t before = in.at();
    if (in.upper() == 'I') word = 'I', in.step();
    if (in.upper() == 'P' && (in.upper(1) == 'A' || in.upper(1) == 'R')) {
        word += 'P';
        word += in.upper(1);
        in.step(2);
    } else if (is_axis(in.upper())) {
        word += in.upper();
        in.step();
    } else {
        in.go_to(before);
        return false;
    }
    if (in.value(word, Sign::always)) return true;
    in.go_to(before);
    return false;
}

/// FMAX, F MAX, FAUTO, F500, FU0.1, FZ 0.2, F alone.
bool feed(Scan& in, std::string& word) {
    in.step();
    word = "F";
    for (const std::string_view constant : {"MAX", "AUTO"})
        if (in.take_word(constant)) {
            word += constant;
            return true;
        }
    if (in.upper() == 'U' || in.upper() == 'Z') {
        word += in.upper();
        in.step();
        return in.value(word, Sign::as_written);
    }
    if (in.value(word, Sign::as_written)) return true;
    return is_blank(in.peek()) || in.peek() == '\0';  // the key was pressed and nothing entered
}

/// R0 RL RR R+ R-, R alone; with a value where the block has radii.
bool radius(Scan& in, WordKind kind, std::string& word) {
    in.step();
    word = "R";
    const char c = in.upper();
    if (c == 'L' || c == 'R') {
        word += c;
        in.step();
        return true;
    }
    std::string value;
    if (in.value(value, Sign::as_written)) {
        if (kind == WordKind::corner) return word += value, true;
        const bool zero = value.find_first_not_of("+-0.,") == std::string::npos;
        if (zero) return word += '0', value == "0";
        if (kind != WordKind::circle) return false;
        if (value[0] != '+' && value[0] != '-') word += '+';
        word += value;
        return true;
    }
    if (c == '+' || c == '-') {
        word += c;
        in.step();
        return true;
    }
    return is_blank(c) || c == '\0';
}

/// M8, M alone, and the LA and MB of M120 and M140.
bool function(Scan& in, std::string& word) {
    in.step();
    word = "M";
    if (in.upper() == 'B') {
        in.step();
        word = "MB";
        if (in.take_word("MAX")) return word += " MAX", true;
        return in.value(word, Sign::as_written);
    }
    if (is_blank(in.peek()) || in.peek() == '\0') return true;
    return in.value(word, Sign::as_written);
}

/// DR+ DR- of arcs; DL DR DR2 of tools.
bool letter_d(Scan& in, WordKind kind, std::string& word) {
    const char c = in.upper(1);
    if (kind == WordKind::tool_call) {
        if (c != 'L' && c != 'R') return false;
        word = c == 'L' ? "DL" : "DR";
        in.step(2);
        if (c == 'R' && in.peek() == '2') word += '2', in.step();
        return in.value(word, Sign::always);
    }
    if (c != 'R' || (in.peek(2) != '+' && in.peek(2) != '-')) return false;
    word = c == 'R' && in.peek(2) == '+' ? "DR+" : "DR-";
    in.step(3);
    return true;
}

bool tool_word(Scan& in, WordKind kind, std::string& word) {
    const char c = in.upper();
    if (kind == WordKind::tool_definition) {
        if (c != 'L' && c != 'R') return false;
        word = c;
        in.step();
        return in.value(word, Sign::always);
    }
    if (c == 'X' || c == 'Y' || c == 'Z') {
        word = c;
        in.step();
        return is_blank(in.peek()) || in.peek() == '\0' || base::is_letter(in.peek());
    }
    if (c == 'S') {
        word = c;
        in.step();
        return in.value(word, Sign::as_written);
    }
    if (c == 'D') return letter_d(in, kind, word);
    if (c == 'F') return feed(in, word);
    return c == 'M' && function(in, word);
}

bool known_word(Scan& in, WordKind kind, std::string& word) {
    const char c = in.upper();
    if (kind == WordKind::tool_call || kind == WordKind::tool_definition) return tool_word(in, kind, word);
    if (coordinate(in, word)) return true;
    word.clear();
    if (kind == WordKind::blank_form) {  // the tool axis
        if (!is_axis(c) || !(is_blank(in.peek(1)) || in.peek(1) == '\0')) return false;
        word = c;
        in.step();
        return true;
    }
    if (kind == WordKind::corner && (is_digit(c) || c == 'Q')) return in.value(word, Sign::as_written);
    if (c == 'F') return feed(in, word);
    if (c == 'R') return radius(in, kind, word);
    if (c == 'M') return function(in, word);
    if (c == 'D') return letter_d(in, kind, word);
    if (c == 'L' && in.upper(1) == 'A') {  // of M120
        word = "LA";
        in.step(2);
        return in.value(word, Sign::as_written);
    }
    return false;
}

}  // namespace

bool known_words(Scan& in, WordKind kind, std::string& out) {
    while (!in.at_end()) {
        std::string word;
        if (!known_word(in, kind, word)) return false;
        append_word(out, word);
    }
    return true;
}

bool generic_words(Scan& in, Decimal decimal, std::string& out) {
    while (!in.at_end()) {
        const std::string_view rest = in.rest();
        const std::string_view token = rest.substr(0, std::min(rest.size(), rest.find_first_of(" \t")));
        for (const char c : token)
            if (!base::is_letter(c) && !is_digit(c) && std::string_view("+-.,").find(c) == std::string_view::npos)
                return false;
        std::string word;
        Scan one(token, decimal);
        if (coordinate(one, word) && one.at_end()) {
            in.step(token.size());
        } else if (base::equals_ignoring_case(token, "F")) {
            if (!feed(in, word)) return false;
        } else {
            word = with_decimals(base::to_upper(token), decimal);
            in.step(token.size());
        }
        append_word(out, word);
    }
    return true;
}

}  // namespace obrys::format::heidenhain
