/// Chamfer and corner R, and the angle of a straight line. Sources: FANUC series 0i-T, 16i-T, 30i-T operator's manuals,
/// "Chamfering and corner R" (G1 Z_ I±i: from Z towards ±X; G1 X_ K±k: from X towards ±Z; G1 X_ or Z_ R±r; with bit CCR
/// of parameter 3405 C, R and A without comma) and "Direct drawing dimension programming" (,C ,R ,A) [-]; Haas lathe
/// operator's manual, G01 corner rounding and chamfering [-].

#include <algorithm>

#include "read/rs274/fanuc_state.hpp"

namespace obrys::read::rs274 {

using program::Reference;

namespace {

bool has_axis(const FanucState& s, std::string_view letters) {
    return std::any_of(s.addresses.begin(), s.addresses.end(),
                       [&](const Address& a) { return !a.comma && letters.find(a.letter) != std::string_view::npos; });
}

/// A size whose sign says which way the next block goes.
void signed_size(FanucState& s, Code code, const Value& v, const Address& a) {
    Value by = v;
    by.expr = s.build().with_reference(Reference::incremental, as_expr(s, v), a.begin, a.end);
    put_value(s, Order::value, code, by, a);
}

/// C and R may have a sign, but need none.
void size(FanucState& s, Code code, const Address& a) {
    const Value v = scaled(s, a.value, Quantity::length);
    if (v.is_literal() && v.negative) return signed_size(s, code, v, a);
    put_value(s, Order::value, code, v, a);
}

void say_chamfer(FanucState& s, const Address& a) {
    if (s.corner_said) return;
    s.corner_said = true;
    base::Diagnostic d;
    d.severity = base::Severity::note;
    d.code = base::codes::assumption;
    d.where = s.build().span(a.begin, a.end);
    d.text = s.control.haas ? "C of straight blocks is taken as a chamfer: nothing here uses C as an axis"
                            : "C of straight blocks is taken as a chamfer (bit CCR of parameter 3405 = 1): nothing "
                              "here uses C as an axis";
    d.remedy = "name a machine file with the axis C where it is one";
    s.diagnostics.add(std::move(d));
}

/// Of lathes, without comma.
bool lathe_corner(FanucState& s, const Address& a) {
    const bool x = has_axis(s, "XU"), z = has_axis(s, "ZW");
    if (!x && !z && a.letter != 'A') return false;
    const Value v = scaled(s, a.value, a.letter == 'A' ? Quantity::angle : Quantity::length);
    switch (a.letter) {
        case 'I':
            if (x) return false;
            return signed_size(s, Code::chamfer_leg, v, a), true;
        case 'K':
            if (z) return false;
            return signed_size(s, Code::chamfer_leg, v, a), true;
        case 'R': return size(s, Code::round, a), true;
        case 'A': return put_value(s, Order::value, Code::line_angle, v, a), true;
        case 'C':
            if (s.c_is_axis) return false;
            say_chamfer(s, a);
            return size(s, Code::chamfer_leg, a), true;
        default: return false;
    }
}

/// A line of the text without blanks and comments, in capitals.
std::string squeezed(std::string_view line) {
    std::string out;
    bool comment = false;
    for (const char c : line) {
        if (c == '(') comment = true;
        if (!comment && !base::is_blank(c)) out += base::upper(c);
        if (c == ')') comment = false;
    }
    return out;
}

/// Letter words of a line: is there one of `letters` with a number behind it?
bool has_word(std::string_view line, char letter) {
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
        const bool number =
            base::is_digit(line[i + 1]) || std::string_view("+-.#[").find(line[i + 1]) != std::string_view::npos;
        if (line[i] == letter && number && (i == 0 || (!base::is_letter(line[i - 1]) && line[i - 1] != ',')))
            return true;
    }
    return false;
}

}  // namespace

bool corner_word(FanucState& s, const Address& a) {
    const auto straight = [&] { return s.special.empty() && s.motion == Modal::linear && hole_of(s) == 0; };
    if (a.comma) {
        if (a.letter == 'C')
            return put_value(s, Order::value, Code::chamfer_leg, scaled(s, a.value, Quantity::length), a), true;
        if (a.letter == 'R')
            return put_value(s, Order::value, Code::round, scaled(s, a.value, Quantity::length), a), true;
        if (a.letter == 'A' && straight())
            return put_value(s, Order::value, Code::line_angle, scaled(s, a.value, Quantity::angle), a), true;
        return add_problem(s, Code::unsupported, a.begin, a.end, "a word of direct drawing input"), true;
    }
    constexpr std::string_view letters = "IKRAC";
    if (!s.control.is_lathe() || letters.find(a.letter) == std::string_view::npos) return false;
    return straight() && s.turning == 0 && s.surface == Surface::none && lathe_corner(s, a);
}

bool uses_c_axis(std::string_view text) {
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t end = std::min(text.find_first_of("\r\n", at), text.size());
        const std::string line = squeezed(text.substr(at, end - at));
        at = end + 1;
        for (const std::string_view word : {"G112", "G12.1", "G107", "G7.1", "G07.1", "G28H", "G28C"})
            if (line.find(word) != std::string::npos) return true;
        if (!has_word(line, 'C')) continue;
        const bool turned = has_word(line, 'X') || has_word(line, 'Z') || has_word(line, 'U') || has_word(line, 'W');
        const bool rapid = line.find("G0") != std::string::npos && line.find("G01") == std::string::npos &&
                           line.find("G02") == std::string::npos && line.find("G03") == std::string::npos;
        if (!turned || rapid || line.find("G8") != std::string::npos || line.find("G50") != std::string::npos ||
            line.find("G53") != std::string::npos || line.find("G65") == 0)
            return true;
    }
    return false;
}

}  // namespace obrys::read::rs274
