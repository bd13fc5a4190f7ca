/// Chamfer and corner R, and the angle of a straight line. Sources: FANUC series 0i-T, 16i-T, 30i-T operator's manuals,
/// "Chamfering and corner R" (G1 Z_ I±i: from Z towards ±X; G1 X_ K±k: from X towards ±Z; G1 X_ or Z_ R±r; with bit CCR
/// of parameter 3405 C, R and A without comma) and "Direct drawing dimension programming" (,C ,R ,A) [-]; Haas lathe
/// operator's manual, G01 corner rounding and chamfering [-].

#include <algorithm>

#include "read/rs274/fanuc/state.hpp"

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

/// `reason` has to live on.
void refuse_word(FanucState& s, const Address& a, std::string_view reason) {
    add_problem(s, Code::unsupported, a.begin, a.end, reason);
}

/// Notes the corner of the block; false after a complaint.
bool begin_corner(FanucState& s, const Address& a) {
    if (s.facts.refused) return true;  // the block's motion is not run
    const bool taper = !a.comma && has_axis(s, "XU") && has_axis(s, "ZW");
    if (s.corner)
        return refuse_word(s, a, s.control.haas ? "the block has two corners" : "the block has two corners (alarm 53)"),
               false;
    if (taper && !s.draws)
        return refuse_word(s, a,
                           s.control.haas
                               ? "without a comma it stands in a block along one axis: write ,C or ,R"
                               : "without a comma it stands in a block along one axis (alarm 54), unless the control "
                                 "takes it as direct drawing input: write ,C or ,R"),
               false;
    s.corner = a;
    return true;
}

/// Of lathes, without comma.
bool lathe_corner(FanucState& s, const Address& a) {
    const bool x = has_axis(s, "XU"), z = has_axis(s, "ZW");
    if (!x && !z && a.letter != 'A') return false;
    const Value v = scaled(s, a.value, a.letter == 'A' ? Quantity::angle : Quantity::length);
    switch (a.letter) {
        case 'I':
            if (x) return false;
            return begin_corner(s, a) ? signed_size(s, Code::chamfer_leg, v, a) : void(), true;
        case 'K':
            if (z) return false;
            return begin_corner(s, a) ? signed_size(s, Code::chamfer_leg, v, a) : void(), true;
        case 'R': return begin_corner(s, a) ? size(s, Code::round, a) : void(), true;
        case 'A': return put_value(s, Order::value, Code::line_angle, v, a), true;
        case 'C':
            if (s.c_is_axis) return false;
            say_chamfer(s, a);
            return begin_corner(s, a) ? size(s, Code::chamfer_leg, a) : void(), true;
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
        if ((a.letter == 'C' || a.letter == 'R') && !begin_corner(s, a)) return true;
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

bool uses_line_angles(std::string_view text) {
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t end = std::min(text.find_first_of("\r\n", at), text.size());
        const std::string line = squeezed(text.substr(at, end - at));
        at = end + 1;
        if (!has_word(line, 'A') || has_word(line, 'M') || has_word(line, 'P')) continue;
        if (!has_word(line, 'X') && !has_word(line, 'Z') && !has_word(line, 'U') && !has_word(line, 'W')) continue;
        const std::size_t g = line.find("G1");
        const bool straight = line.find("G01") != std::string::npos ||
                              (g != std::string::npos && (g + 2 == line.size() || !base::is_digit(line[g + 2])));
        if (straight || !has_word(line, 'G')) return true;
    }
    return false;
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

namespace {

constexpr std::string_view lone = "a corner needs a straight or circular block at feed before and behind it";

/// The block's coordinates are run straight or as an arc, at feed.
bool goes_at_feed(const FanucState& s) {
    const auto in_machine = [](const Address& a) { return a.letter == 'G' && g_tenths(a) == 530; };
    if (!s.special.empty() || hole_of(s) != 0 || (s.turning != 0 && !s.own_motion)) return false;
    if (std::any_of(s.addresses.begin(), s.addresses.end(), in_machine)) return false;
    const Modal m = s.motion;
    return m == Modal::linear || m == Modal::arc_cw || m == Modal::arc_ccw;
}

/// A coordinate, an angle of a straight line or what makes an arc.
const Address* first_way(const FanucState& s) {
    for (const Address& a : s.addresses) {
        if (a.comma ? a.letter == 'A' : std::string_view("XYZUVW").find(a.letter) != std::string_view::npos) return &a;
        if (a.comma) continue;
        if (a.letter == 'A' && s.draws) return &a;
        if (std::string_view("IJKR").find(a.letter) != std::string_view::npos &&
            (s.motion == Modal::arc_cw || s.motion == Modal::arc_ccw))
            return &a;
    }
    return nullptr;
}

/// Straight along the one axis.
bool goes_along(const FanucState& s, Corner c) {
    if (s.motion != Modal::linear || has_axis(s, "YV")) return false;
    return has_axis(s, c == Corner::then_x ? "XU" : "ZW") && !has_axis(s, c == Corner::then_x ? "ZW" : "XU");
}

std::string_view due_behind(const FanucState& s, Corner c) {
    if (s.control.haas)
        return c == Corner::then_x
                   ? "behind a chamfer or rounding without comma a straight block along X alone is due: write ,C or ,R"
                   : "behind a chamfer or rounding without comma a straight block along Z alone is due: write ,C or ,R";
    return c == Corner::then_x
               ? "behind a chamfer or rounding without comma a straight block along X alone is due (alarms 51, 52), "
                 "unless the control takes C and R as direct drawing input: write ,C or ,R"
               : "behind a chamfer or rounding without comma a straight block along Z alone is due (alarms 51, 52), "
                 "unless the control takes C and R as direct drawing input: write ,C or ,R";
}

/// G4 may come between; behind the program's end the run says that no corner follows.
bool waits_on(const FanucState& s) {
    return std::any_of(s.addresses.begin(), s.addresses.end(), [](const Address& a) {
        const auto m = a.letter == 'M' ? as_integer(a.value) : std::nullopt;
        return (a.letter == 'G' && g_tenths(a) == 40) || m == 2 || m == 30;
    });
}

}  // namespace

void judge_block_behind_corner(FanucState& s) {
    if (s.addresses.empty() || s.corner_waits == Corner::none || waits_on(s)) return;
    const Corner waits = s.corner_waits;
    s.corner_waits = Corner::none;
    const Address* way = first_way(s);
    if (way == nullptr)
        return refuse_word(s, s.addresses.front(),
                           s.control.haas
                               ? "the block before ends with a corner, behind which a block has to move, or to dwell"
                               : "the block before ends with a corner, behind which a block has to move, or to dwell "
                                 "(alarm 51)");
    if (!goes_at_feed(s)) return refuse_word(s, *way, lone);
    if (waits != Corner::at_feed && !goes_along(s, waits)) refuse_word(s, *way, due_behind(s, waits));
}

void judge_call_behind_corner(FanucState& s, const Address& call) {
    as_piece(s, [&] {
        if (s.corner_waits == Corner::none) return;
        s.corner_waits = Corner::none;
        s.build().statement(program::StatementKind::block, s.line.begin());
        s.build().problem(Code::unsupported, call.begin, call.end,
                          "a corner waits for the next block: which one of another program the control takes for it is "
                          "not known");
        s.build().end_statement(s.line.end());
    });
}

void judge_corner(FanucState& s) {
    if (!s.corner) return;
    if (!goes_at_feed(s)) return refuse_word(s, *s.corner, lone);
    if (s.corner->comma || s.draws)
        s.corner_waits = Corner::at_feed;
    else
        s.corner_waits = has_axis(s, "ZW") ? Corner::then_x : Corner::then_z;
}

}  // namespace obrys::read::rs274
