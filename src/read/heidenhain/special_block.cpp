/// Blocks whose words only they have: APPR and DEP, FK, SPL, PLANE.

#include <algorithm>
#include <array>
#include <initializer_list>
#include <span>

#include "read/heidenhain/state.hpp"

namespace obrys::read::heidenhain {

using program::Datum;
using program::DatumValue;
using program::Special;
using program::SpecialKind;

namespace {

struct SpecialWord {
    std::string_view text;
    Datum datum;
};

// Longer words before their beginnings.
constexpr std::array approach_words{SpecialWord{"LEN", Datum::length}, SpecialWord{"CCA", Datum::centre_angle}};
constexpr std::array free_words{
    SpecialWord{"RCCPR", Datum::block_of_centre_radius},
    SpecialWord{"RCCPA", Datum::block_of_centre_angle},
    SpecialWord{"RCCX", Datum::block_of_centre_x},
    SpecialWord{"RCCY", Datum::block_of_centre_y},
    SpecialWord{"RPR", Datum::block_of_polar_radius},
    SpecialWord{"RPA", Datum::block_of_polar_angle},
    SpecialWord{"RAN", Datum::block_of_gradient},
    SpecialWord{"RX", Datum::block_of_x},
    SpecialWord{"RY", Datum::block_of_y},
    SpecialWord{"CLSD", Datum::closed},
    SpecialWord{"CCPR", Datum::centre_radius},
    SpecialWord{"CCPA", Datum::centre_polar_angle},
    SpecialWord{"CCX", Datum::centre_x},
    SpecialWord{"CCY", Datum::centre_y},
    SpecialWord{"CCA", Datum::centre_angle},
    SpecialWord{"P1X", Datum::point1_x},
    SpecialWord{"P1Y", Datum::point1_y},
    SpecialWord{"P2X", Datum::point2_x},
    SpecialWord{"P2Y", Datum::point2_y},
    SpecialWord{"P3X", Datum::point3_x},
    SpecialWord{"P3Y", Datum::point3_y},
    SpecialWord{"PDX", Datum::beside_x},
    SpecialWord{"PDY", Datum::beside_y},
    SpecialWord{"PAR", Datum::parallel},
    SpecialWord{"PR", Datum::polar_radius},
    SpecialWord{"PA", Datum::polar_angle},
    SpecialWord{"LEN", Datum::length},
    SpecialWord{"AN", Datum::gradient},
    SpecialWord{"DP", Datum::parallel_distance},
    SpecialWord{"DR", Datum::sense},
    SpecialWord{"X", Datum::x},
    SpecialWord{"Y", Datum::y},
    SpecialWord{"D", Datum::beside_distance},
};
constexpr std::array plane_words{
    SpecialWord{"PROPR", Datum::angle_a}, SpecialWord{"PROMIN", Datum::angle_b}, SpecialWord{"EULPR", Datum::angle_a},
    SpecialWord{"EULNU", Datum::angle_b}, SpecialWord{"EULROT", Datum::angle_c}, SpecialWord{"SPA", Datum::angle_a},
    SpecialWord{"SPB", Datum::angle_b},   SpecialWord{"SPC", Datum::angle_c},    SpecialWord{"ROT", Datum::angle_c},
    SpecialWord{"P1X", Datum::point1_x},  SpecialWord{"P1Y", Datum::point1_y},   SpecialWord{"P1Z", Datum::point1_z},
    SpecialWord{"P2X", Datum::point2_x},  SpecialWord{"P2Y", Datum::point2_y},   SpecialWord{"P2Z", Datum::point2_z},
    SpecialWord{"P3X", Datum::point3_x},  SpecialWord{"P3Y", Datum::point3_y},   SpecialWord{"P3Z", Datum::point3_z},
    SpecialWord{"BX", Datum::vector_x},   SpecialWord{"BY", Datum::vector_y},    SpecialWord{"BZ", Datum::vector_z},
    SpecialWord{"NX", Datum::normal_x},   SpecialWord{"NY", Datum::normal_y},    SpecialWord{"NZ", Datum::normal_z},
    SpecialWord{"DIST", Datum::distance}, SpecialWord{"ABST", Datum::distance},  SpecialWord{"SEQ", Datum::side},
    SpecialWord{"A", Datum::angle_a},     SpecialWord{"B", Datum::angle_b},      SpecialWord{"C", Datum::angle_c},
};

void add(State& s, Special& special, Datum datum, ExprId value, bool incremental, std::uint32_t begin, char axis = 0) {
    for (const DatumValue& d : special.data)
        if (d.datum == datum && d.axis == axis && value != program::no_expr)
            return fail(s, begin,
                        "'" + base::as_utf8(base::trim(s.in.between(begin, s.in.at()))) +
                            "': the same is said twice in this block");
    if (value != program::no_expr)
        special.data.push_back({datum, value, incremental, axis, s.build.span(begin, s.in.at())});
}

/// A sign alone, or in front of nothing: DR+, CLSD-, SEQ-.
bool read_sign(State& s, Special& special, Datum datum, std::uint32_t begin) {
    if (datum != Datum::sense && datum != Datum::closed && datum != Datum::side) return false;
    const char c = s.in.peek();
    if (c != '+' && c != '-') {
        fail(s, begin, "'" + base::as_utf8(s.in.between(begin, s.in.at())) + "' needs a sign, + or -");
        return true;
    }
    s.in.step();
    add(s, special, datum, s.build.number(c == '+' ? 1 : -1, true, begin, s.in.at()), false, begin);
    return true;
}

/// Words of a block that only some of its kinds have; the others hold for all.
bool belongs(SpecialKind kind, std::string_view word) {
    const auto any = [&](std::initializer_list<std::string_view> beginnings) {
        return std::any_of(beginnings.begin(), beginnings.end(), [&](auto b) { return word.starts_with(b); });
    };
    const bool everywhere = word == "DIST" || word == "ABST" || word == "SEQ";
    switch (kind) {
        case SpecialKind::plane_spatial:
        case SpecialKind::plane_relative: return everywhere || any({"SP"});
        case SpecialKind::plane_projected: return everywhere || word == "ROT" || any({"PRO"});
        case SpecialKind::plane_euler: return everywhere || any({"EUL"});
        case SpecialKind::plane_vector: return everywhere || (word.size() == 2 && any({"B", "N"}));
        case SpecialKind::plane_points: return everywhere || any({"P1", "P2", "P3"});
        case SpecialKind::plane_axial: return everywhere || word.size() == 1;
        case SpecialKind::plane_reset: return everywhere;
        case SpecialKind::approach_arc:
        case SpecialKind::departure_arc: return word == "CCA";
        case SpecialKind::approach_arc_line:
        case SpecialKind::departure_arc_line: return false;
        case SpecialKind::approach_tangent:
        case SpecialKind::approach_normal:
        case SpecialKind::departure_tangent:
        case SpecialKind::departure_normal: return word == "LEN";
        default: return true;
    }
}

/// One of `words`; false and nothing moved where none stands here.
bool read_datum(State& s, Special& special, std::span<const SpecialWord> words) {
    const std::uint32_t begin = s.in.at();
    const bool incremental = base::upper(s.in.peek()) == 'I';
    if (incremental) s.in.step();
    for (const SpecialWord& w : words) {
        if (!belongs(special.kind, w.text) || !s.in.take_prefix(w.text)) continue;
        if (read_sign(s, special, w.datum, begin)) return true;
        s.in.skip_blanks();
        s.in.take('[');
        const Value v = read_value(s);
        if (!v.found) {
            fail(s, begin,
                 "the word '" + std::string(w.text) + "' has no value: a number or a Q parameter must follow");
            return true;
        }
        const ExprId value = as_expr(s, v);
        s.in.take(']');
        add(s, special, w.datum, value, incremental, begin);
        return true;
    }
    s.in.go_to(begin);
    return false;
}

/// R5 is a radius here, R0 and RL are the compensation.
bool read_radius(State& s, Special& special) {
    if (base::upper(s.in.peek()) != 'R') return false;
    const std::uint32_t begin = s.in.at();
    s.in.step();
    const Value v = read_value(s);
    if (!v.found || (v.is_literal() && v.literal.value == 0)) {
        s.in.go_to(begin);
        return false;
    }
    add(s, special, Datum::radius, as_expr(s, v), false, begin);
    return true;
}

/// K3X-4.688E-002.
bool read_coefficient(State& s, Special& special) {
    if (base::upper(s.in.peek()) != 'K' || !base::is_digit(s.in.peek(1))) return false;
    const std::uint32_t begin = s.in.at();
    const int n = s.in.peek(1) - '0';
    const char axis = base::upper(s.in.peek(2));
    s.in.step(3);
    if (n < 1 || n > 3 || std::string_view("XYZABC").find(axis) == std::string_view::npos) {
        fail(s, begin, "a coefficient of a spline is K1, K2 or K3 with an axis");
        return true;
    }
    const Datum datum = n == 1 ? Datum::k1 : n == 2 ? Datum::k2 : Datum::k3;
    add(s, special, datum, value_expr(s), false, begin, axis);
    return true;
}

/// MOVE, TURN, STAY, and whether a rotary table turns where turning the coordinates alone would do.
bool read_positioning(State& s, Special& special) {
    const std::uint32_t begin = s.in.at();
    int how = -1;
    if (s.in.take_word("STAY")) how = 0;
    if (s.in.take_word("MOVE")) how = 1;
    if (s.in.take_word("TURN")) how = 2;
    if (how >= 0) {
        add(s, special, Datum::positioning, s.build.number(how, true, begin, s.in.at()), false, begin);
        return true;
    }
    if (s.in.take_prefix("MB")) {
        if (!s.in.take_word("MAX")) static_cast<void>(read_value(s));
        s.build.problem(Code::unsupported, begin, s.in.at(), "the tool goes away along its axis before it is tilted");
        return true;
    }
    for (const std::string_view word : {"COORD", "TABLE"})
        if (s.in.take_word(word)) {
            s.in.take_word("ROT");
            add(s, special, Datum::table_turns, s.build.number(word == "TABLE" ? 1 : 0, true, begin, s.in.at()), false,
                begin);
            return true;
        }
    return false;
}

/// Besides its own a PLANE block has F and M alone.
bool not_of_plane(State& s) {
    const char c = base::upper(s.in.peek());
    if (c == 'F' || c == 'M') return false;
    fail_here(s, "this is no word of this PLANE function: " + here(s));
    return true;
}

enum class SpecialFamily : std::uint8_t { approach, free_contour, spline, plane };

bool read_own(State& s, Special& special, SpecialFamily family) {
    switch (family) {
        case SpecialFamily::approach: {
            const bool arc = !belongs(special.kind, "LEN");
            return read_datum(s, special, approach_words) || (arc && read_radius(s, special));
        }
        case SpecialFamily::free_contour:
            return read_datum(s, special, free_words) ||
                   ((special.kind == SpecialKind::free_arc || special.kind == SpecialKind::free_arc_tangential) &&
                    read_radius(s, special));
        case SpecialFamily::spline: return read_coefficient(s, special);
        case SpecialFamily::plane:
            return read_positioning(s, special) || read_datum(s, special, plane_words) || not_of_plane(s);
    }
    return false;
}

void read_special(State& s, SpecialKind kind, SpecialFamily family, std::uint32_t begin) {
    Special special;
    special.kind = kind;
    special.block_number = s.number;
    special.where = s.build.span(begin, s.in.at());
    program::Unit& unit = s.build.unit();
    s.build.control(StatementKind::special, unit.specials.size(), s.block, s.in.at());
    unit.specials.push_back({});
    s.rapid_counts = family == SpecialFamily::plane;
    s.exponents = family == SpecialFamily::spline;
    s.rapid_is_word = family == SpecialFamily::approach || family == SpecialFamily::free_contour;
    if (family == SpecialFamily::spline) s.build.modal(Modal::linear, s.block, s.in.at());
    while (!s.failed && !s.in.at_end())
        if (!read_own(s, special, family)) read_word(s, false);
    special.where.end = s.in.at();
    unit.specials.back() = std::move(special);
}

struct SpecialOpener {
    std::string_view word;
    SpecialKind kind;
    SpecialFamily family;
};
constexpr std::array special_openers{
    SpecialOpener{"FPOL", SpecialKind::free_pole, SpecialFamily::free_contour},
    SpecialOpener{"FL", SpecialKind::free_line, SpecialFamily::free_contour},
    SpecialOpener{"FLT", SpecialKind::free_line_tangential, SpecialFamily::free_contour},
    SpecialOpener{"FC", SpecialKind::free_arc, SpecialFamily::free_contour},
    SpecialOpener{"FCT", SpecialKind::free_arc_tangential, SpecialFamily::free_contour},
    SpecialOpener{"SPL", SpecialKind::spline, SpecialFamily::spline},
};
constexpr std::array planes{
    SpecialOpener{"SPATIAL", SpecialKind::plane_spatial, SpecialFamily::plane},
    SpecialOpener{"PROJECTED", SpecialKind::plane_projected, SpecialFamily::plane},
    SpecialOpener{"EULER", SpecialKind::plane_euler, SpecialFamily::plane},
    SpecialOpener{"VECTOR", SpecialKind::plane_vector, SpecialFamily::plane},
    SpecialOpener{"POINTS", SpecialKind::plane_points, SpecialFamily::plane},
    SpecialOpener{"RELATIV", SpecialKind::plane_relative, SpecialFamily::plane},
    SpecialOpener{"AXIAL", SpecialKind::plane_axial, SpecialFamily::plane},
    SpecialOpener{"RESET", SpecialKind::plane_reset, SpecialFamily::plane},
};

void read_plane(State& s, std::uint32_t begin) {
    for (const SpecialOpener& o : planes)
        if (s.in.take_prefix(o.word)) {
            if (o.kind == SpecialKind::plane_relative) s.in.take_prefix("E");  // RELATIVE
            return read_special(s, o.kind, o.family, begin);
        }
    s.build.statement(StatementKind::block, s.block);
    fail_here(
        s, "SPATIAL, PROJECTED, EULER, VECTOR, POINTS, RELATIV, AXIAL or RESET is due behind PLANE, found " + here(s));
}

void read_select(State& s, std::uint32_t begin) {
    Special special;
    special.kind = SpecialKind::free_select;
    const ExprId n = value_expr(s);
    add(s, special, Datum::number, n, false, begin);
    special.where = s.build.span(begin, s.in.at());
    s.build.control(StatementKind::special, s.build.unit().specials.size(), s.block, s.in.at());
    s.build.unit().specials.push_back(std::move(special));
}

void read_smooth(State& s, bool departure, std::uint32_t begin) {
    const bool polar = s.in.take_prefix("P");
    constexpr std::array<std::string_view, 4> kinds{"LCT", "CT", "LT", "LN"};
    constexpr std::array<SpecialKind, 4> towards{SpecialKind::approach_arc_line, SpecialKind::approach_arc,
                                                 SpecialKind::approach_tangent, SpecialKind::approach_normal};
    constexpr std::array<SpecialKind, 4> away{SpecialKind::departure_arc_line, SpecialKind::departure_arc,
                                              SpecialKind::departure_tangent, SpecialKind::departure_normal};
    for (std::size_t i = 0; i < kinds.size(); ++i)
        if (s.in.take_word(kinds[i]))
            return read_special(s, departure ? away[i] : towards[i], SpecialFamily::approach, begin);
    s.build.statement(StatementKind::block, s.block);
    fail_here(s, std::string(polar ? "P" : "") + "LT, LN, CT or LCT is due behind " + (departure ? "DEP" : "APPR") +
                     ", found " + here(s));
}

}  // namespace

void add_smooth(State& s, bool departure, ExprId radius, std::uint32_t begin) {
    Special special;
    special.kind = departure ? SpecialKind::departure_arc_line : SpecialKind::approach_arc_line;
    add(s, special, Datum::radius, radius, false, begin);
    special.where = s.build.span(begin, s.in.at());
    program::Unit& unit = s.build.unit();
    program::Statement& statement = unit.statements.back();
    statement.kind = StatementKind::special;
    s.build.word(Code::control, program::Form::index, static_cast<std::int32_t>(unit.specials.size()), begin,
                 s.in.at());
    std::rotate(unit.words.begin() + statement.first, unit.words.end() - 1, unit.words.end());
    unit.specials.push_back(std::move(special));
}

bool read_special_block(State& s, std::string_view word) {
    const std::uint32_t begin = s.in.at();
    const auto is = [&](std::string_view w) { return base::equals_ignoring_case(word, w); };
    if (is("APPR") || is("DEP")) return s.in.step(word.size()), read_smooth(s, is("DEP"), begin), true;
    if (is("PLANE")) return s.in.step(word.size()), read_plane(s, begin), true;
    if (is("FSELECT")) return s.in.step(word.size()), read_select(s, begin), true;
    for (const SpecialOpener& o : special_openers)
        if (is(o.word)) {
            s.in.step(word.size());
            read_special(s, o.kind, o.family, begin);
            const bool element = o.family == SpecialFamily::free_contour && o.kind != SpecialKind::free_pole;
            if (element) s.last_path = static_cast<std::uint32_t>(s.build.unit().statements.size() - 1);
            return true;
        }
    return false;
}

}  // namespace obrys::read::heidenhain
