/// Contour elements: L C CC CR CT LP CP CTP CHF RND, and axes alone (paraxial blocks).

#include <algorithm>
#include <array>

#include "read/heidenhain/state.hpp"

namespace obrys::read::heidenhain {

namespace {

void angle_word(State& s, std::uint32_t begin, bool incremental, bool arc) {
    // An arc's incremental angle says how far it sweeps, whole turns included; a line's where it ends.
    value_word(s, incremental && arc ? Code::pole_angle : Code::polar_angle, begin, incremental && !arc);
}

void coordinate(State& s, bool arc) {
    const std::uint32_t begin = s.in.at();
    const bool incremental = base::upper(s.in.peek()) == 'I';
    if (incremental) s.in.step();
    const char c = base::upper(s.in.peek()), next = base::upper(s.in.peek(1));
    if (c == 'P' && (next == 'A' || next == 'R')) {
        s.in.step(2);
        if (next == 'A') return angle_word(s, begin, incremental, arc);
        return value_word(s, Code::polar_radius, begin, incremental);
    }
    if (const auto axis = axis_of(c)) {
        s.in.step();
        return value_word(s, *axis, begin, incremental);
    }
    fail_here(s, "an axis (X Y Z A B C U V W, PR, PA) is due behind I, found " + here(s));
}

/// R0 RL RR, R+ R-, and the radius of CR.
void radius_word(State& s, bool circle_by_radius) {
    const std::uint32_t begin = s.in.at();
    s.in.step();
    const char c = base::upper(s.in.peek());
    if (c == 'L' || c == 'R') {
        s.in.step();
        return s.build.modal(c == 'L' ? Modal::compensation_left : Modal::compensation_right, begin, s.in.at());
    }
    const std::uint32_t behind = s.in.at();
    const Value v = read_value(s);
    if (v.found && v.is_literal() && v.literal.value == 0) return s.build.modal(Modal::compensation_off, begin, v.end);
    s.in.go_to(behind);
    if (v.found && circle_by_radius) return value_word(s, Code::radius, begin);
    if (!v.found && (c == '+' || c == '-')) {
        s.in.step();
        return s.build.modal(c == '+' ? Modal::paraxial_longer : Modal::paraxial_shorter, begin, s.in.at());
    }
    if (!v.found && (base::is_blank(c) || s.in.at_end()))
        return s.build.ignored("R without a value", begin, behind);  // what holds goes on
    fail_here(s, "R0, RL, RR, R+ or R- is due here, found " + here(s));
}

bool sense(State& s) {
    const std::uint32_t begin = s.in.at();
    if (!s.in.take_prefix("DR")) return false;
    const char c = s.in.peek();
    if (c != '+' && c != '-') {
        fail(s, begin, "DR needs the sense of rotation", "DR+ is counter-clockwise, DR- clockwise");
        return true;
    }
    s.in.step();
    s.build.modal(c == '+' ? Modal::arc_ccw : Modal::arc_cw, begin, s.in.at());
    return true;
}

void straight(State& s, int path) {
    s.rapid_counts = s.machine_counts = true;
    s.build.modal(has_rapid(s) ? Modal::rapid : Modal::linear, s.block, s.in.at(), path);
}

void pole(State& s) {
    s.build.modal(Modal::pole_given, s.block, s.in.at());
    while (!s.failed && !s.in.at_end()) {
        const char c = base::upper(s.in.peek());
        if (c != 'I' && !axis_of(c)) return fail_here(s, "CC has coordinates alone, found " + here(s));
        read_word(s, false);
    }
}

enum class PathKind : std::uint8_t {
    straight,
    polar_straight,
    about_pole,
    by_radius,
    tangential,
    polar_arc,
    polar_tangential,
    pole,
    chamfer,
    rounding
};

struct PathOpener {
    std::string_view word;
    PathKind kind;
};

constexpr std::array path_openers{
    PathOpener{"L", PathKind::straight},           PathOpener{"LP", PathKind::polar_straight},
    PathOpener{"C", PathKind::about_pole},         PathOpener{"CR", PathKind::by_radius},
    PathOpener{"CT", PathKind::tangential},        PathOpener{"CP", PathKind::polar_arc},
    PathOpener{"CTP", PathKind::polar_tangential}, PathOpener{"CC", PathKind::pole},
    PathOpener{"CHF", PathKind::chamfer},          PathOpener{"RND", PathKind::rounding},
};

/// Points by the pole are LP's, CP's and CTP's. User's Manual Conversational Programming, "Path contours: polar
/// coordinates" (340 49x, page 249: `14 LP PR+25 PA+120`).
void refuse_polar(State& s, std::size_t first_word) {
    const auto& words = s.build.unit().words;
    const bool polar = std::any_of(words.begin() + static_cast<std::ptrdiff_t>(first_word), words.end(), [](auto w) {
        return program::code_of(w) == Code::polar_radius || program::code_of(w) == Code::polar_angle;
    });
    if (polar && !s.failed)
        fail(s, s.block, "PR and PA are no words of this block",
             "write LP before them for a straight line by the pole");
}

void read_element(State& s, PathKind kind) {
    const bool arc = kind != PathKind::straight && kind != PathKind::polar_straight;
    s.build.statement(StatementKind::block, s.block);
    const bool polar =
        kind == PathKind::polar_straight || kind == PathKind::polar_arc || kind == PathKind::polar_tangential;
    const int path = polar ? program::polar_path : 0;
    if (!arc) straight(s, path);
    s.rapid_is_word = arc;
    if (kind == PathKind::tangential || kind == PathKind::polar_tangential)
        s.build.modal(Modal::arc_tangent, s.block, s.in.at(), path);
    if (kind == PathKind::about_pole || kind == PathKind::polar_arc) {
        s.build.modal(Modal::arc_same_sense, s.block, s.in.at(), path);
        s.build.bare(Code::centre_at_pole, s.block, s.in.at());
    }
    if (kind == PathKind::by_radius) s.build.modal(Modal::arc_same_sense, s.block, s.in.at());
    const std::size_t first = s.build.unit().words.size();
    read_words(s, arc);
    if (kind == PathKind::straight) refuse_polar(s, first);
}

void read_word_as_it_is(State& s, bool arc, std::uint32_t begin) {
    const char c = base::upper(s.in.peek()), next = base::upper(s.in.peek(1));
    if (const auto axis = axis_of(c)) {
        s.in.step();
        value_word(s, *axis, begin);
    } else if (c == 'I' || (c == 'P' && (next == 'A' || next == 'R'))) {
        coordinate(s, arc);
    } else if (c == 'F') {
        read_feed(s);
    } else if (c == 'R') {
        radius_word(s, arc);
    } else if (c == 'D' && arc) {
        if (!sense(s)) fail_here(s, "DR+ or DR- is due here, found " + here(s));
    } else if (c == 'M') {
        s.in.step();
        read_m(s, begin);
    } else {
        fail_here(s, "this is no word of a path block: " + here(s));
    }
}

}  // namespace

void read_word(State& s, bool arc) {
    const std::uint32_t begin = s.in.at();
    read_word_as_it_is(s, arc, begin);
    no_exponent(s, begin);
}

void read_words(State& s, bool arc) {
    while (!s.failed && !s.in.at_end()) read_word(s, arc);
}

namespace {

/// X, IX, XQ5, IPA, M, FMAX, RL …: the block has no opener, it begins with one of its words.
bool opens_with_word(std::string_view word) {
    std::string w = base::to_upper(word);
    if (w.empty()) return false;
    for (const std::string_view fixed : {"RL", "RR", "R", "F", "FMAX", "FAUTO", "FU", "FZ", "FT", "M"})
        if (w == fixed) return true;
    if (w.front() == 'I') w.erase(0, 1);
    if (const auto q = w.find('Q'); q != std::string::npos) w.erase(q);  // a parameter is the value
    return w == "PA" || w == "PR" || w == "F" || w == "M" || (w.size() == 1 && axis_of(w.front()));
}

}  // namespace

bool read_path_block(State& s, std::string_view word) {
    for (const PathOpener& o : path_openers) {
        if (!base::equals_ignoring_case(o.word, word)) continue;
        const std::uint32_t begin = s.in.at();
        const char next = s.in.peek(static_cast<std::ptrdiff_t>(word.size()));
        if (o.kind == PathKind::about_pole && (next == '+' || next == '-' || base::is_digit(next)))
            break;  // axis C alone
        s.in.step(word.size());
        if (o.kind == PathKind::chamfer || o.kind == PathKind::rounding) {
            read_corner(s, o.kind == PathKind::chamfer, o.kind == PathKind::rounding, begin);
            return true;
        }
        if (o.kind == PathKind::pole) {
            s.build.statement(StatementKind::block, s.block);
            pole(s);
            return true;
        }
        read_element(s, o.kind);
        s.last_path = static_cast<std::uint32_t>(s.build.unit().statements.size() - 1);
        return true;
    }
    const char c = base::upper(s.in.peek());
    if (!opens_with_word(word)) return false;
    s.build.statement(StatementKind::block, s.block);
    if (c == 'M' || c == 'F') return read_functions(s), true;
    straight(s, 0);
    s.build.modal(Modal::paraxial, s.block, s.in.at());
    const std::size_t before = s.build.unit().words.size();
    read_words(s, false);
    refuse_polar(s, before);
    const auto& words = s.build.unit().words;
    const auto axes =
        std::count_if(words.begin() + static_cast<std::ptrdiff_t>(before), words.end(),
                      [](const auto& w) { return program::code_of(w) >= Code::x && program::code_of(w) <= Code::z; });
    if (axes > 1 && !s.failed)
        fail(s, s.block, "a block without path function moves a single axis", "write L before the coordinates");
    return true;
}

}  // namespace obrys::read::heidenhain
