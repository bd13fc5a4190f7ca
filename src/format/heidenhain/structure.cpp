#include "format/heidenhain/structure.hpp"

#include <algorithm>
#include <array>

#include "base/number.hpp"
#include "base/text.hpp"

namespace obrys::format::heidenhain {

using base::is_digit;
using Text = std::optional<std::string>;

namespace {

struct Opener {
    std::string_view word;
    Shape shape;
    WordKind words = WordKind::path;
};
constexpr std::array openers{
    Opener{"L", Shape::words},
    Opener{"LP", Shape::words},
    Opener{"C", Shape::words},
    Opener{"CC", Shape::words},
    Opener{"CT", Shape::words},
    Opener{"CP", Shape::words},
    Opener{"CTP", Shape::words},
    Opener{"CR", Shape::words, WordKind::circle},
    Opener{"CHF", Shape::words, WordKind::corner},
    Opener{"RND", Shape::words, WordKind::corner},
    Opener{"STOP", Shape::words},
    Opener{"LN", Shape::generic},
    Opener{"APPR", Shape::generic},
    Opener{"DEP", Shape::generic},
    Opener{"FPOL", Shape::generic},
    Opener{"FL", Shape::generic},
    Opener{"FLT", Shape::generic},
    Opener{"FC", Shape::generic},
    Opener{"FCT", Shape::generic},
    Opener{"FSELECT", Shape::generic},
    Opener{"SPL", Shape::generic},
    Opener{"PLANE", Shape::generic},
    Opener{"SEL", Shape::names},
    Opener{"DECLARE", Shape::names},
    Opener{"CONTOUR", Shape::names},
    Opener{"PATTERN", Shape::names},
    Opener{"TRANS", Shape::names},
    Opener{"FUNCTION", Shape::names},
};

Text names(std::string_view code, bool upper_case) {
    if (code.find('~') != std::string_view::npos) return std::nullopt;
    return collapsed(code, upper_case);
}

Text words(Scan& in, std::string out, const Block& block, Decimal decimal) {
    const bool understood =
        block.shape == Shape::generic ? generic_words(in, decimal, out) : known_words(in, block.words, out);
    return understood ? Text(std::move(out)) : std::nullopt;
}

/// Number (its point stays), name in quotes or parameter of a tool.
void tool(Scan& in, std::string& out) {
    in.skip_blanks();
    std::string word;
    if (in.text(word) || in.parameter(word)) return append_word(out, word);
    while (is_digit(in.peek()) || (in.peek() == '.' && !word.empty())) word += in.peek(), in.step();
    if (!word.empty()) append_word(out, word);
}

Text tool_block(Scan& in, Decimal decimal, Block& block) {
    const bool call = in.take_word("CALL");
    if (!call && !in.take_word("DEF")) return std::nullopt;
    block = {Shape::words, call ? WordKind::tool_call : WordKind::tool_definition};
    std::string out = call ? "TOOL CALL" : "TOOL DEF";
    tool(in, out);
    return words(in, std::move(out), block, decimal);
}

Text blank_block(Scan& in, Decimal decimal, Block& block) {
    if (!in.take_word("FORM")) return std::nullopt;
    in.skip_blanks();
    if (in.take_word("CYLINDER")) {
        block = {Shape::generic, WordKind::path};
        return words(in, "BLK FORM CYLINDER", block, decimal);
    }
    const bool corner =
        in.peek() == '0' && (in.peek(1) == '.' || in.peek(1) == ',') && (in.peek(2) == '1' || in.peek(2) == '2');
    if (!corner || is_digit(in.peek(3)) || in.peek(3) == '.') return std::nullopt;
    block = {Shape::words, WordKind::blank_form};
    std::string out = std::string("BLK FORM 0.") + in.peek(2);
    in.step(3);
    return words(in, std::move(out), block, decimal);
}

/// A line of the numbered form: CYCL DEF 7.1 X+10.
Text numbered_cycle(Scan& in, std::string out, int number, Decimal decimal, const Block& block) {
    const std::size_t before = in.at();
    if (number == 7 || number == 19) {
        if (Text t = words(in, out, block, decimal)) return t;
        in.go_to(before);
    }
    Text rest = names(in.rest(), false);
    if (!rest) return rest;
    if (number != 12 && number != 14) rest = with_decimals(*rest, decimal);
    append_word(out, *rest);
    return out;
}

Text cycle_definition(Scan& in, std::string out, Decimal decimal, Block& block) {
    in.skip_blanks();
    std::string number, line;
    while (is_digit(in.peek())) number += in.peek(), in.step();
    if (number.empty() || number.size() > 4) return std::nullopt;
    append_word(out, number);
    block = {Shape::cycle, WordKind::path};
    if (in.peek() == '.' || in.peek() == ',') {
        in.step();
        while (is_digit(in.peek())) line += in.peek(), in.step();
        if (line.empty()) return std::nullopt;
        out += '.' + line;
        block.shape = Shape::generic;
    }
    in.skip_blanks();
    if (in.at_end()) return out;
    if (line.empty() || line.find_first_not_of('0') == std::string::npos) {  // the name, in whatever language
        if (in.rest().find('~') != std::string_view::npos) return std::nullopt;
        append_word(out, in.rest());
        return out;
    }
    return numbered_cycle(in, std::move(out), static_cast<int>(base::parse_integer(number).value_or(0)), decimal,
                          block);
}

Text cycle_block(Scan& in, const std::string& word, Decimal decimal, Block& block) {
    if (in.take_word("DEF")) return cycle_definition(in, word + " DEF", decimal, block);
    if (!in.take_word("CALL")) return std::nullopt;
    std::string out = word + " CALL";
    for (const std::string_view where : {"PAT", "POS"})
        if (in.take_word(where)) append_word(out, where);
    block = {Shape::words, WordKind::path};
    return words(in, std::move(out), block, decimal);
}

Text call_block(Scan& in, Block& block) {
    block = {Shape::names, WordKind::path};
    const bool label = in.take_word("LBL");
    if (!label && !in.take_word("PGM")) return std::nullopt;
    if (in.at_end()) return std::nullopt;
    if (!label) return "CALL PGM " + std::string(in.rest());
    const Text rest = names(in.rest(), true);
    return rest ? Text("CALL LBL " + *rest) : std::nullopt;
}

Text assignment(std::string_view code, Decimal decimal, Block& block) {
    block = {Shape::formula, WordKind::path};
    Scan in(code, decimal);
    std::string out;
    if (code.find('=') == std::string_view::npos) return std::nullopt;
    if (formula_words(in, out)) return out;
    return base::upper(code[1]) == 'S' ? names(code, true) : std::nullopt;
}

Text probe_block(Scan& in, Block& block) {
    block = {Shape::cycle, WordKind::path};
    const Text rest = names(in.rest(), false);
    return rest ? Text("TCH " + *rest) : std::nullopt;
}

Text label_block(Scan& in) {
    const Text rest = names(in.rest(), true);
    if (!rest || rest->empty()) return std::nullopt;
    return "LBL " + *rest;
}

/// BEGIN PGM name MM: the name is kept as it is written, and the blanks.
std::string program_bounds(std::string_view code) {
    std::string out(code);
    const auto raise = [&](std::size_t begin, std::size_t end) {
        std::transform(out.begin() + static_cast<std::ptrdiff_t>(begin), out.begin() + static_cast<std::ptrdiff_t>(end),
                       out.begin() + static_cast<std::ptrdiff_t>(begin), base::upper);
    };
    const auto next = [&](std::size_t from, bool blank) {
        while (from < out.size() && base::is_blank(out[from]) == blank) ++from;
        return from;
    };
    const std::size_t first = next(0, false), second = next(first, true), behind = next(second, false);
    if (base::to_upper(out.substr(second, behind - second)) != "PGM") return out;
    raise(0, behind);
    const std::size_t last = out.find_last_of(" \t") + 1;
    const std::string unit = base::to_upper(out.substr(last));
    if (last > next(next(behind, true), false) && (unit == "MM" || unit == "INCH")) raise(last, out.size());
    return out;
}

/// Blocks with a word of their own; `known` says whether this was one.
Text special_block(Scan& in, const std::string& word, std::string_view code, Decimal decimal, Block& block,
                   bool& known) {
    known = true;
    if (word == "BEGIN" || word == "END") return block.shape = Shape::kept, program_bounds(code);
    if (word == "TOOL") return tool_block(in, decimal, block);
    if (word == "BLK") return blank_block(in, decimal, block);
    if (word == "CYCL" || word == "CYCLE") return cycle_block(in, word, decimal, block);
    if (word == "CALL") return call_block(in, block);
    if (word == "LBL") return in.skip_blanks(), label_block(in);
    if (word == "TCH") return in.skip_blanks(), probe_block(in, block);
    if (word == "FN") return block.shape = Shape::function, function_block(in, decimal);
    known = false;
    return std::nullopt;
}

}  // namespace

Text opening_line(std::string_view code, Decimal decimal, Block& block) {
    Scan in(code, decimal);
    std::string parameter;
    if (in.parameter(parameter)) return assignment(code, decimal, block);
    const std::string word = in.letters();
    in.step(word.size());
    bool known = false;
    if (Text t = special_block(in, word, code, decimal, block, known); known) return t;
    for (const Opener& o : openers) {
        if (o.word != word) continue;
        block = {o.shape, o.words};
        if (word == "C" && (in.peek() == '+' || in.peek() == '-' || is_digit(in.peek()))) break;  // axis C alone
        if (o.shape != Shape::names) return words(in, word, block, decimal);
        const Text rest = names(in.rest(), false);
        if (!rest) return rest;
        return word + (rest->empty() || rest->front() == ' ' ? "" : " ") + *rest;
    }
    block = {Shape::words, WordKind::path};  // axes alone, M, F
    in.go_to(0);
    return words(in, {}, block, decimal);
}

Text further_line(std::string_view code, Decimal decimal, const Block& block) {
    Scan in(code, decimal);
    std::string out;
    switch (block.shape) {
        case Shape::words:
        case Shape::generic: return words(in, {}, block, decimal);
        case Shape::formula: return formula_words(in, out) ? Text(std::move(out)) : std::nullopt;
        case Shape::function: return names(code, false);
        case Shape::cycle: return cycle_line(code, decimal);
        case Shape::names: return names(code, false);
        case Shape::kept: break;
    }
    return std::nullopt;
}

Text cycle_line(std::string_view code, Decimal decimal) {
    Scan in(code, decimal);
    std::string out;
    while (!in.at_end()) {
        std::string word;
        if (!in.parameter(word) || !in.take('=')) return std::nullopt;
        word += '=';
        in.skip_blanks();
        if (!in.text(word) && !in.value(word, Sign::as_written)) return std::nullopt;
        append_word(out, word);
    }
    return out;
}

bool is_cycle_line(std::string_view code) {
    Scan in(code, Decimal::keep);
    std::string word;
    in.skip_blanks();
    return in.parameter(word) && in.take('=');
}

bool opens_cycle(std::string_view code) {
    Scan in(code, Decimal::keep);
    in.skip_blanks();
    const std::string word = in.letters();
    return word == "CYCL" || word == "CYCLE" || word == "TCH";
}

}  // namespace obrys::format::heidenhain
