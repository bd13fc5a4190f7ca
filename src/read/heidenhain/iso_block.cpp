/// One block of DIN/ISO: its number, and what its first word and its G codes make of it.

#include <algorithm>

#include "read/heidenhain/blank.hpp"
#include "read/heidenhain/iso.hpp"

namespace obrys::read::heidenhain {

bool IsoBlock::has_any(std::string_view any) const {
    return std::any_of(any.begin(), any.end(), [&](char c) { return has(c); });
}
bool IsoBlock::has_g(int number) const { return std::find(g.begin(), g.end(), number) != g.end(); }

const dialect::heidenhain::GCode* IsoBlock::cycle() const {
    for (const int n : g)
        if (const dialect::heidenhain::GCode* code = dialect::heidenhain::find_g(n);
            code != nullptr && code->cycle != 0)
            return code;
    return nullptr;
}

IsoBlock look_over(State& s) {
    const std::uint32_t from = s.in.at();
    IsoBlock b;
    while (!s.in.at_end()) {
        const char c = base::upper(s.in.peek());
        const bool begins = s.in.at() == from || !base::is_letter(s.in.peek(-1));
        s.in.step();
        if (c == '"') {  // a name: its letters are no words
            while (!s.in.at_end() && s.in.peek() != '"') s.in.step();
            s.in.take('"');
        }
        if (base::is_letter(c) && begins) {
            b.letters |= 1U << (c - 'A');
            if (c == 'F' && s.in.take_word("MAX")) b.rapid = true;
            if (c == 'G')
                if (const int n = s.in.integer(); n >= 0) b.g.push_back(n);
        }
    }
    s.in.go_to(from);
    return b;
}

void dimension(State& s, bool incremental, std::uint32_t begin, bool coordinates) {
    s.iso.incremental = incremental;
    s.iso.uses_incremental = s.iso.uses_incremental || incremental;
    const Modal m = incremental ? Modal::incremental : Modal::absolute;
    if (coordinates)
        s.iso.pending = m;
    else
        s.build.modal(m, begin, s.in.at());
}

namespace {

void modal_statement(State& s, Modal m) {
    s.build.statement(StatementKind::block, s.block);
    s.build.modal(m, s.block, s.block);
    s.build.end_statement(s.block);
}

/// `N10`, `/N10` and `N10 /`.
void read_iso_number(State& s) {
    std::uint8_t skip = s.in.take('/') ? 1 : 0;
    s.in.skip_blanks();
    s.numbered = base::upper(s.in.peek()) == 'N' && base::is_digit(s.in.peek(1));
    if (s.numbered) {
        s.in.step();
        while (base::is_digit(s.in.peek())) s.in.step();
    }
    if (s.in.take('/')) skip = 1;
    s.in.skip_blanks();
    s.build.begin_block(skip);
}

void read_call(State& s) {
    s.in.take(':');
    read_program_call(s, "%", ".I");
}

/// The last block has the name and the unit of the first.
void end_program(State& s, const std::string& name, const IsoBlock& b) {
    s.ended = s.begun;
    if (!s.begun || (name == s.name && b.has_g(70) == s.build.unit().inch)) return;
    s.build.statement(StatementKind::block, s.block);
    fail(s, s.block, "the last block does not have the name and the unit of the first",
         "%" + s.name + (s.build.unit().inch ? " G70" : " G71"));
}

/// `%NAME G71 *` at the beginning and at the end; `%NAME *` calls a program.
void read_percent(State& s) {
    s.in.step();
    const std::uint32_t behind = s.in.at();
    const std::string name = base::to_upper(s.in.path());
    const IsoBlock b = look_over(s);
    const bool first = s.build.unit().statements.empty() && !s.begun;
    const bool frame = b.has_g(70) || b.has_g(71);
    if (!frame && !(first && !s.numbered)) {
        s.in.go_to(behind);
        return read_call(s);
    }
    s.in.skip_block();
    if (!first) return end_program(s, name, b);
    s.begun = true;
    s.name = name;
    if (!frame)
        fail(s, s.block, "G70 or G71 is due behind the program's name", "it says what every length of the program is");
    s.build.unit().inch = b.has_g(70);
    s.build.statement(StatementKind::block, s.block);
    s.build.modal(b.has_g(70) ? Modal::inch_all : Modal::metric_all, s.block, s.in.at());
}

/// L1,0 calls a subprogram, L1,5 repeats a section five times more.
void read_iso_label_call(State& s) {
    s.in.step();
    const ExprId label = read_label_name(s);
    if (s.failed) return;
    ExprId repeats = program::no_expr;
    if (s.in.take(',')) {
        const Value v = read_value(s);
        if (!v.found)
            return fail_here(s, "a number of repeats is due behind the comma, found " + here(s),
                             "L1,0 calls a subprogram");
        if (!v.is_literal() || v.literal.value != 0) repeats = as_expr(s, v);
    } else {
        return fail_here(s, "a comma and a number of repeats are due behind the label, found " + here(s),
                         "L1,0 calls a subprogram, L1,5 repeats a section");
    }
    call_label(s, label, repeats);
    s.iso.motion = -1;
}

/// G30 G17 X+0 Y+0 Z-40, G31 G90 X+100 Y+100 Z+0.
void read_iso_blank(State& s, const IsoBlock& b) {
    const bool least = b.has_g(30);
    s.build.statement(StatementKind::block, s.block);
    program::Blank& blank = blank_of(s.build.unit());
    if (!least && s.iso.uses_incremental && !b.has_g(90) && !b.has_g(91))
        return fail_here(s, "whether the blank's second corner is absolute or incremental is not certain here",
                         "write G90 or G91 in this block");
    bool incremental = false;
    unsigned given = 0;
    while (!s.failed && !s.in.at_end()) {
        const char c = base::upper(s.in.peek());
        const std::uint32_t begin = s.in.at();
        if (c == 'G') {
            const int n = read_code(s);
            if (n >= 17 && n <= 19) blank.tool_axis = 19 - n;
            if (n == 90 || n == 91) dimension(s, incremental = n == 91, begin, false);
            continue;
        }
        const auto axis = std::string_view("XYZ").find(c);
        if (axis == std::string_view::npos) return fail_here(s, "X, Y or Z is due here, found " + here(s));
        s.in.step();
        const Value v = read_value(s);
        if (!v.found || !v.is_literal()) return fail_here(s, "a number is due here, found " + here(s));
        if ((given & (1U << axis)) != 0) return fail(s, begin, "an axis stands twice in the blank");
        given |= 1U << axis;
        if (least)
            blank.min[axis] = v.number();
        else
            blank.max[axis] = v.number() + (incremental ? blank.min[axis] : 0);
    }
    blank.where = s.build.span(s.block, s.in.at());
}

/// G99 T1 L+0 R+5 says what a tool is, G51 T2 which one comes next.
void read_tool_definition(State& s, bool next) {
    const std::uint32_t begin = s.in.at();
    s.build.statement(StatementKind::block, s.block);
    static_cast<void>(read_code(s));
    if (!s.in.take('T')) return fail_here(s, "T and the tool's number are due here, found " + here(s));
    read_tool(s);
    if (s.failed) return;
    if (next) return preselect_tool(s, begin);
    s.build.bare(Code::tool_definition, begin, s.in.at());
    s.build.unit().tool_definitions.push_back(static_cast<std::uint32_t>(s.build.unit().statements.size() - 1));
    while (!s.failed && !s.in.at_end()) {
        const std::uint32_t word = s.in.at();
        const char c = base::upper(s.in.peek());
        if (c != 'L' && c != 'R') return fail_here(s, "L and R of the tool are due here, found " + here(s));
        s.in.step();
        value_word(s, c == 'L' ? Code::tool_length : Code::tool_radius, word);
    }
}

/// G98 L1, and what may follow it.
void read_label(State& s, const IsoBlock& b) {
    const std::uint32_t begin = s.in.at();
    if (base::upper(s.in.peek()) != 'G' || read_code(s) != 98) {
        s.build.statement(StatementKind::block, s.block);
        return fail(s, begin, "G98 stands first in its block", "write the label in a block of its own");
    }
    if (!s.in.take('L'))
        return fail_here(s, "L and the label are due behind G98, found " + here(s), "G98 L1; G98 L0 ends a subprogram");
    read_label_block(s);
    s.iso.motion = -1;
    if (!s.failed && !s.in.at_end()) read_iso_words(s, b);
}

void read_corner_code(State& s) {
    const std::uint32_t begin = s.in.at();
    const int n = base::upper(s.in.peek()) == 'G' ? read_code(s) : 0;
    if (n != 24 && n != 25) {
        s.build.statement(StatementKind::block, s.block);
        return fail(s, begin, "a chamfer or rounding stands in a block of its own", "G24 R2 or G25 R5");
    }
    read_corner(s, n == 24, true, begin);
}

/// F of G26 and G27: that of the approach or departure.
ExprId read_smooth_feed(State& s) {
    s.in.skip_blanks();
    return s.in.take('F') || s.in.take('f') ? value_expr(s) : program::no_expr;
}

/// G26 R5 behind the straight block to the contour's first point: from where the tool stood, by a line and an arc that
/// is tangential to it and to the contour. G27 R5 behind the last contour element: so to the next block's point.
void read_smooth(State& s, bool departure) {
    const std::uint32_t begin = s.in.at();
    const int n = base::upper(s.in.peek()) == 'G' ? read_code(s) : 0;
    const bool joined = s.last_path != program::no_target && s.last_path + 1 == s.build.unit().statements.size();
    const bool straight = s.iso.motion == 0 || s.iso.motion == 1 || s.iso.motion == 10 || s.iso.motion == 11;
    const bool good = n == (departure ? 27 : 26) && (departure || (joined && straight && skipped_with_last(s)));
    if (!good) {
        s.build.statement(StatementKind::block, s.block);
        return fail(s, begin,
                    departure ? "G27 stands in a block of its own"
                              : "G26 stands behind the straight block to the contour's first point",
                    departure ? "write it behind the last contour element"
                              : "write it in a block of its own behind the first one with G41 or G42");
    }
    s.in.take('R');
    const ExprId radius = value_expr(s);
    if (s.failed) return;
    const ExprId feed = read_smooth_feed(s);
    if (s.failed) return;
    if (departure) {
        s.iso.departure = radius;
        s.iso.departure_feed = feed;
        s.iso.departure_skip = s.build.skip();
    } else {
        if (feed != program::no_expr)
            s.build.expression(Code::corner_feed, feed, begin, s.in.at());
        else if (s.iso.motion == 0 || s.iso.motion == 10)  // all of it, as APPR with FMAX
            s.build.modal(Modal::rapid_block, begin, s.in.at());
        add_smooth(s, false, radius, begin);
    }
    s.build.statement(StatementKind::block, s.block);  // the block itself, which counts as one
}

/// A measuring block: its words are its own.
void read_refused(State& s, const dialect::heidenhain::GCode& g) {
    const std::uint32_t begin = s.in.at();
    s.build.statement(StatementKind::block, s.block);
    s.in.skip_block();
    s.build.problem(Code::unsupported, begin, s.in.at(), g.text);
}

void read_by_codes(State& s, const IsoBlock& b) {
    if (b.has_g(98)) return read_label(s, b);
    if (b.has_g(24) || b.has_g(25)) return read_corner_code(s);
    if (b.has_g(26) || b.has_g(27)) return read_smooth(s, b.has_g(27));
    if (b.has_g(30) || b.has_g(31)) return read_iso_blank(s, b);
    if (b.has_g(51) || b.has_g(99)) return read_tool_definition(s, b.has_g(51));
    if (const dialect::heidenhain::GCode* g = b.cycle()) return read_iso_cycle(s, *g);
    for (const int n : b.g)
        if (const dialect::heidenhain::GCode* g = dialect::heidenhain::find_g(n);
            g != nullptr && g->use == dialect::heidenhain::Use::refused && g->block_only)
            return read_refused(s, *g);
    read_iso_words(s, b);
}

/// The block behind G27 moves: behind a label, a call or a jump it is not that one, or not always.
void keep_departure(State& s, char first, const IsoBlock& b) {
    if (s.iso.departure == program::no_expr ||
        (std::string_view("%LD").find(first) == std::string_view::npos && !b.has_g(98)))
        return;
    s.build.statement(StatementKind::block, s.block);
    fail(s, s.block, "a straight block is due directly behind G27", "G00 or G01 to the point off the contour");
    s.build.end_statement(s.in.at());
    s.iso.departure = s.iso.departure_feed = program::no_expr;
    s.failed = false;
}

void read_content(State& s, const IsoBlock& b) {
    const char c = base::upper(s.in.peek());
    keep_departure(s, c, b);
    if (c == '%') return read_percent(s);
    if (c == 'L') return read_iso_label_call(s);
    if (c == 'D') return read_iso_function(s);
    if (c == 'Q' && stands_parameter(s)) return read_assignment(s);
    if (base::equals_ignoring_case(s.in.letters(), "PLANE"))  // written as in Klartext
        return static_cast<void>(read_special_block(s, s.in.letters()));
    if (base::is_letter(c)) return read_by_codes(s, b);
    s.build.statement(StatementKind::block, s.block);
    const std::uint32_t begin = s.in.at();
    s.in.skip_block();
    s.build.problem(Code::unknown, begin, s.in.at(), "no block begins so");
}

}  // namespace

void flush_pending(State& s) {
    if (!s.iso.pending) return;
    modal_statement(s, *s.iso.pending);
    s.iso.pending.reset();
}

void read_iso_block(State& s) {
    s.block = s.in.at();
    s.failed = false;
    s.rapid_counts = s.machine_counts = true;
    s.rapid_said = s.feed_said = s.exponents = false;
    const IsoBlock b = look_over(s);
    const bool corner = b.has_g(24) || b.has_g(25) || b.has_g(26);
    if (!corner) flush_pending(s);  // a corner belongs to the block before it
    s.statements = s.build.unit().statements.size();
    const std::uint32_t last_path = s.last_path;
    const int motion = s.iso.motion;
    s.iso.incremental.reset();
    const bool after_stop = s.after_stop, ended_by_star = s.iso.ended_by_star;
    read_iso_number(s);
    s.iso.ended_by_star = false;
    if (s.in.peek() == ';') return read_comment(s, after_stop);
    s.after_stop = false;
    if (s.in.peek() == '*' && !s.in.at_star()) return s.in.skip_comment();  // structure block
    const bool goes_on = !s.numbered && !ended_by_star && s.open_cycle != program::no_target && read_cycle_line(s);
    if (!goes_on) {
        s.open_cycle = program::no_target;
        if (!s.in.at_end()) read_content(s, b);
    }
    if (!s.failed && !s.in.at_end()) fail_here(s, "this is left over at the end of the block: " + here(s));
    s.in.skip_block();
    if (s.build.skip() != 0 && s.iso.motion != motion) s.iso.motion = -1;  // the run may not come by it
    if (s.last_path == last_path && !corner) s.last_path = program::no_target;
    if (s.build.unit().statements.size() > s.statements) s.build.end_statement(s.in.at());
    s.iso.ended_by_star = s.in.at_star();
    s.in.leave_block();
}

}  // namespace obrys::read::heidenhain
