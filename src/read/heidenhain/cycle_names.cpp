/// Names, keywords and labels of cycle definitions.

#include <algorithm>

#include "base/number.hpp"
#include "base/whole.hpp"
#include "dialect/heidenhain/cycles.hpp"
#include "read/heidenhain/state.hpp"

namespace obrys::read::heidenhain {

using program::no_expr;

namespace {

/// X+7, IZ-3, R5, F100, M8: no word of a cycle's name.
bool is_coordinate(std::string_view word) {
    constexpr std::string_view others = "RFSTMGDLH";
    if (word.size() > 1 && base::upper(word[0]) == 'I') word.remove_prefix(1);
    if (word.size() < 2) return false;
    if (!axis_of(word[0]) && others.find(base::upper(word[0])) == std::string_view::npos) return false;
    const bool sign = word[1] == '+' || word[1] == '-';
    return base::is_digit(word[1]) || (sign && word.size() > 2 && base::is_digit(word[2]));
}

}  // namespace

void read_name_word(State& s) {
    const std::uint32_t begin = s.in.at();
    const std::string_view word = s.in.token();
    if (word.size() > 1 && word.ends_with('~')) s.in.go_to(s.in.at() - 1);  // the block goes on
    if (word.empty())
        s.in.step();
    else if (is_coordinate(word))
        fail(s, begin, std::string(word.substr(0, word.find('*'))) + " has no meaning behind the name of a cycle",
             "write it in a line of its own");
}

void read_named(State& s) {
    bool named = open_cycle(s).settings.empty();
    while (!s.failed && !s.in.at_end()) {
        const bool parameter = stands_parameter(s);
        if (read_parameter_line(s)) {
            named = false;
        } else if (named) {
            read_name_word(s);
        } else if (parameter) {
            const std::uint32_t begin = s.in.at();
            static_cast<void>(read_parameter(s));
            fail(s, begin, "'=' is due behind " + base::to_upper(s.in.between(begin, s.in.at())));
        } else {
            fail_here(s, "this is no parameter of a cycle: " + here(s));
        }
    }
}

std::string read_keyword(State& s) {
    std::string word;
    while (!s.in.at_end()) {
        const char c = s.in.peek(), next = s.in.peek(1);
        const bool sign = c == '+' || c == '-';
        const bool number =
            base::is_digit(c) || ((c == '.' || c == ',') && base::is_digit(next)) ||
            (sign && (base::is_digit(next) || next == '.' || base::upper(next) == 'Q' || base::is_blank(next)));
        const bool sense = sign && base::trim(word) == "DR";
        if (number || sense || stands_parameter(s) || c == '"') break;
        word += base::upper(c);
        s.in.step();
        if (base::is_blank(s.in.peek())) word += ' ';
    }
    return std::string(base::trim(word));
}

void read_names(State& s) {
    static_cast<void>(read_keyword(s));
    while (!s.failed && !s.in.at_end()) {
        const std::uint32_t begin = s.in.at();
        if (s.in.peek() == '/') {
            s.in.step();
            continue;
        }
        if (s.in.peek() == '"' || stands_parameter(s)) {
            if (const ExprId text = read_text(s); text != no_expr) open_cycle(s).texts.push_back(text);
            continue;
        }
        const base::NumberScan n = s.in.number();
        if (n.length == 0) {
            static_cast<void>(s.in.token());
            continue;
        }
        open_cycle(s).texts.push_back(s.build.text(base::shortest(n.value), begin, s.in.at()));
    }
}

void read_program_name(State& s) {
    s.in.take_word("PGM");
    s.in.skip_blanks();
    const std::uint32_t begin = s.in.at();
    const std::string_view path = s.in.token();
    if (!path.empty()) open_cycle(s).texts.push_back(s.build.text(program_name(path), begin, s.in.at()));
}

ExprId read_sense(State& s) {
    const std::uint32_t begin = s.in.at();
    const char sign = s.in.peek();
    if ((sign != '+' && sign != '-') || base::is_digit(s.in.peek(1))) return value_expr(s);
    s.in.step();
    return s.build.number(sign == '+' ? 1 : -1, true, begin, s.in.at());
}

}  // namespace obrys::read::heidenhain
