/// One block: its number, and what its first word makes of it.

#include <array>

#include "read/heidenhain/blank.hpp"
#include "read/heidenhain/state.hpp"

namespace obrys::read::heidenhain {

namespace {

/// `12 `, `/12 ` and `12 /`: the block's number and its skip sign.
void read_number(State& s) {
    std::uint8_t skip = 0;
    if (s.in.take('/')) skip = 1;
    s.in.skip_blanks();
    const std::uint32_t from = s.in.at();
    while (base::is_digit(s.in.peek())) s.in.step();
    s.numbered = s.in.at() > from;
    const std::int64_t number = base::parse_integer(s.in.between(from, s.in.at())).value_or(0);
    s.number = number <= 0xFFFFFFFF ? static_cast<std::uint32_t>(number) : 0;
    if (s.in.take('/')) skip = 1;
    s.in.skip_blanks();
    s.build.begin_block(skip);
}

/// INCH; posts write IN, too.
bool take_inch(State& s) { return s.in.take_word("INCH") || s.in.take_word("IN"); }

void begin_program(State& s) {
    s.begun = true;
    s.build.statement(StatementKind::block, s.block);
    const bool whole = s.in.take_word("PGM");
    if (!whole) fail_here(s, "PGM is due behind BEGIN, found " + here(s));
    s.in.skip_blanks();
    s.name = base::to_upper(s.in.token());  // that of the file counts
    s.build.unit().inch = take_inch(s);
    if (!s.failed && !s.build.unit().inch && !s.in.take_word("MM"))
        fail_here(s, "MM or INCH is due behind the program's name, found " + here(s),
                  "it says what every length of the program is");
    const bool inch = s.build.unit().inch;
    s.build.modal(inch ? Modal::inch_all : Modal::metric_all, s.block, s.in.at());
}

/// END PGM with the name and the unit of BEGIN PGM.
void end_program(State& s) {
    const std::uint32_t begin = s.in.at();
    s.in.step(3);
    s.ended = s.begun;
    const bool whole = s.in.take_word("PGM");
    s.in.skip_blanks();
    const std::string name = base::to_upper(s.in.token());
    const bool inch = take_inch(s), unit = inch || s.in.take_word("MM");
    const bool same = !s.begun || (name == s.name && inch == s.build.unit().inch);
    if (whole && unit && same) return;
    s.build.statement(StatementKind::block, s.block);
    s.in.skip_block();
    fail(s, begin, "END PGM does not have the name and the unit of BEGIN PGM",
         "END PGM " + s.name + (s.build.unit().inch ? " INCH" : " MM"));
}

/// One of D R L DIST DI RI and its value; false behind a complaint.
bool cylinder_word(State& s, program::BlankCylinder& c, double& inner) {
    const std::uint32_t begin = s.in.at();
    std::string word;
    for (; base::is_letter(s.in.peek()); s.in.step()) word += base::upper(s.in.peek());
    double* const to = word == "R" || word == "D"     ? &c.radius
                       : word == "L"                  ? &c.length
                       : word == "DIST"               ? &c.top
                       : word == "RI" || word == "DI" ? &inner
                                                      : nullptr;
    if (to == nullptr) {
        s.in.go_to(begin);
        return fail_here(s, "R or D, L, DIST, RI or DI is due here, found " + here(s)), false;
    }
    const Value v = read_value(s);
    if (!v.found || !v.is_literal()) return fail_here(s, "a number is due here, found " + here(s)), false;
    *to = word.starts_with('D') && word != "DIST" ? v.number() / 2 : v.number();
    return true;
}

/// BLK FORM CYLINDER Z R50 L105 DIST+5 RI10. Source: TNC 640 User's Manual, "Defining the blank"; that it goes down
/// from DIST is read from its example.
void read_cylinder(State& s, std::uint32_t begin) {
    program::Blank blank;
    blank.where = s.build.span(begin, s.in.at());
    const auto axis = std::string_view("XYZ").find(base::upper(s.in.peek()));
    if (axis == std::string_view::npos) return fail_here(s, "X, Y or Z is due here, found " + here(s));
    s.in.step();
    s.in.skip_blanks();
    blank.tool_axis = static_cast<int>(axis);
    double inner = 0;
    program::BlankCylinder& c = blank.cylinder.emplace();
    while (!s.failed && !s.in.at_end())
        if (!cylinder_word(s, c, inner)) return;
    if (s.failed) return;
    if (!(c.radius > 0 && c.length > 0)) return fail_here(s, "BLK FORM CYLINDER needs R or D, and L, above 0");
    if (inner != 0) return s.build.problem(Code::unsupported, begin, s.in.at(), "a hollow blank is not taken as stock");
    s.build.unit().blank = blank;
}

/// BLK FORM 0.1 Z X+0 Y+0 Z-40 and 0.2 X+100 Y+100 Z+0; in the second IX counts from the least point.
void read_blank(State& s) {
    const std::uint32_t begin = s.block;
    s.build.statement(StatementKind::block, s.block);
    if (!s.in.take_word("FORM")) return fail_here(s, "FORM is due behind BLK, found " + here(s));
    s.in.skip_blanks();
    if (s.in.take_word("CYLINDER")) return s.in.skip_blanks(), read_cylinder(s, begin);
    const base::NumberScan n = s.in.number();
    const int corner = n.decimal && n.decimal->decimals == 1 ? static_cast<int>(n.decimal->mantissa) : 0;
    if (corner != 1 && corner != 2) {
        s.in.skip_block();
        return s.build.problem(Code::unsupported, begin, s.in.at(),
                               "a blank by a turned contour or a file is not taken as stock");
    }
    program::Blank& blank = blank_of(s.build.unit());
    blank.where = s.build.span(begin, s.in.at());
    unsigned given = 0;
    while (!s.failed && !s.in.at_end()) {
        const bool incremental = corner == 2 && base::upper(s.in.peek()) == 'I';
        if (incremental) s.in.step();
        const auto axis = std::string_view("XYZ").find(base::upper(s.in.peek()));
        if (axis == std::string_view::npos) return fail_here(s, "X, Y or Z is due here, found " + here(s));
        s.in.step();
        const Value v = read_value(s);
        if (v.found && (given & (1U << axis)) != 0) return fail_here(s, "an axis stands twice in BLK FORM");
        if (v.found) given |= 1U << axis;
        if (!v.found && corner == 1)
            blank.tool_axis = static_cast<int>(axis);
        else if (!v.found || !v.is_literal())
            return fail_here(s, "a number is due here, found " + here(s));
        else
            (corner == 1 ? blank.min : blank.max)[axis] = v.number() + (incremental ? blank.min[axis] : 0);
    }
}

/// STOP, and the comment behind it, which the control shows.
void read_stop(State& s) {
    const std::uint32_t begin = s.in.at();
    s.build.statement(StatementKind::block, s.block);
    s.in.step(4);
    const std::size_t words = s.build.unit().words.size();
    s.in.skip_blanks();
    if (base::upper(s.in.peek()) == 'F')
        fail_here(s, "an M function stands behind STOP and nothing else, found " + here(s));
    else
        read_functions(s);
    stop_here(s, words, begin, begin + 4);
}

/// Words that open a block and are known without being run; `what` says what they do.
struct NotRun {
    std::string_view word;
    std::string_view what;
};
constexpr std::array not_run{
    NotRun{"LN", "straight lines with surface normals (3D compensation)"},
    NotRun{"SEL", "selection of a program"},
    NotRun{"TRANS", "mirror, rotation or scaling of a later control"},
    NotRun{"TCH", "touch probe"},
    NotRun{"FUNCTION", "function of a later control"},
};

/// FUNCTION RESET TCPM ends what FUNCTION TCPM began, which is not run.
bool read_tcpm_reset(State& s, std::string_view word) {
    const std::uint32_t begin = s.in.at();
    if (!base::equals_ignoring_case("FUNCTION", word)) return false;
    s.in.step(word.size());
    if (s.in.take_word("RESET") && s.in.take_word("TCPM")) {
        s.build.statement(StatementKind::block, s.block);
        s.build.ignored("FUNCTION RESET TCPM", begin, s.in.at());
        return true;
    }
    s.in.go_to(begin);
    return false;
}

bool read_not_run(State& s, std::string_view word) {
    if (read_tcpm_reset(s, word)) return true;
    for (const NotRun& n : not_run) {
        if (!base::equals_ignoring_case(n.word, word)) continue;
        const std::uint32_t begin = s.in.at();
        s.build.statement(StatementKind::block, s.block);
        s.in.skip_block();
        s.build.problem(Code::unsupported, begin, s.in.at(), n.what);
        return true;
    }
    return false;
}

bool is(std::string_view letters, std::string_view word) { return base::equals_ignoring_case(letters, word); }

/// DECLARE STRING QS5 = "text": an assignment follows.
bool take_declaration(State& s) {
    const std::uint32_t begin = s.in.at();
    if (s.in.take_word("DECLARE") && s.in.take_word("STRING")) return true;
    s.in.go_to(begin);
    return false;
}

bool read_structure(State& s, std::string_view word) {
    const std::size_t n = word.size();
    if (is(word, "BEGIN")) return s.in.step(n), begin_program(s), true;
    if (is(word, "END")) return end_program(s), true;
    if (is(word, "BLK")) return s.in.step(n), read_blank(s), true;
    if (is(word, "TOOL")) {
        const std::uint32_t begin = s.in.at();
        return s.in.step(n), read_tool_block(s, begin), true;
    }
    if (is(word, "LBL")) return s.in.step(n), read_label_block(s), true;
    if (is(word, "CALL")) return s.in.step(n), read_call_block(s), true;
    if (is(word, "CYCL") || is(word, "CYCLE")) return s.in.step(n), read_cycle_block(s), true;
    if (is(word, "STOP")) return read_stop(s), true;
    if (is(word, "GLOBAL")) return read_global_values(s), true;
    if (is(word, "FN")) return read_function(s);
    if (is(word, "DECLARE") && take_declaration(s)) return read_assignment(s), true;
    if (base::upper(word.front()) == 'Q' && stands_parameter(s)) return read_assignment(s), true;
    return false;
}

}  // namespace

void stop_here(State& s, std::size_t words, std::uint32_t begin, std::uint32_t end) {
    bool stops = false;
    for (std::size_t i = words; i < s.build.unit().words.size(); ++i) {
        const program::Word& w = s.build.unit().words[i];
        stops = stops || (program::code_of(w) == Code::m && program::is_literal(w) &&
                          (w.payload == 0 || w.payload == 2 || w.payload == 30));
    }
    if (!stops) s.build.modal(Modal::program_stop, begin, end);
    s.after_stop = true;
}

void read_comment(State& s, bool after_stop) {
    const std::string text = base::as_utf8(s.in.comment());
    const std::uint32_t begin = s.in.at();
    s.in.skip_comment();
    if (!after_stop || text.empty()) return;
    s.after_stop = false;
    program::ProcedureCall call;
    call.arguments = {s.build.text(text, begin, s.in.at())};
    call.where = s.build.span(begin, s.in.at());
    s.build.unit().procedures.push_back(std::move(call));
    s.build.control(StatementKind::procedure, s.build.unit().procedures.size() - 1, s.block, s.in.at());
}

void read_block(State& s) {
    s.block = s.in.at();
    s.rapid_said = s.feed_said = s.exponents = false;
    s.failed = s.rapid_counts = s.rapid_is_word = s.machine_counts = false;
    s.statements = s.build.unit().statements.size();
    const std::uint32_t last_path = s.last_path;
    const bool after_stop = s.after_stop;
    read_number(s);
    s.in.skip_blanks();
    if (s.in.peek() == ';' || s.in.at_end()) return read_comment(s, after_stop);
    s.after_stop = false;
    if (s.in.peek() == '*') return s.in.skip_comment();  // structure block
    if (!s.numbered && s.first_numbered && read_cycle_line(s)) return;
    const std::string_view word = s.in.letters();
    const std::uint32_t begin = s.in.at();
    if (!is(word, "CYCL") && !is(word, "CYCLE") && !is(word, "GLOBAL")) end_cycle(s);
    const bool known =
        !word.empty() && (read_structure(s, word) || read_special_block(s, word) || read_path_block(s, word) ||
                          read_pattern_block(s, word) || read_contour_block(s, word) || read_shop_block(s, word) ||
                          read_not_run(s, word));
    if (!known) {
        s.build.statement(StatementKind::block, s.block);
        s.in.go_to(begin);
        const std::string token = base::as_utf8(s.in.token());
        s.in.skip_block();
        s.build.problem(Code::unknown, begin, s.in.at(), "no block begins with '" + token + "'");
    }
    if (s.in.at_end() || s.failed)
        s.in.skip_block();
    else
        fail_here(s, "this is left over at the end of the block: " + here(s)), s.in.skip_block();
    if (s.last_path == last_path) s.last_path = program::no_target;
    if (s.build.unit().statements.size() > s.statements) s.build.end_statement(s.in.at());
}

}  // namespace obrys::read::heidenhain
