/// PATTERN DEF and SEL PATTERN: the points at which CYCL CALL PAT calls a cycle.

#include <algorithm>
#include <array>
#include <span>

#include "read/heidenhain/state.hpp"

namespace obrys::read::heidenhain {

using program::FigureKind;
using program::FigureRole;
using program::no_expr;

namespace {

struct PatternWord {
    std::string_view text;
    FigureRole role;
};
// Longer words before their beginnings.
constexpr std::array position_words{PatternWord{"X", FigureRole::x}, PatternWord{"Y", FigureRole::y},
                                    PatternWord{"Z", FigureRole::z}};
constexpr std::array row_words{PatternWord{"NUM", FigureRole::count}, PatternWord{"ROT", FigureRole::rotation},
                               PatternWord{"D", FigureRole::spacing}};
constexpr std::array grid_words{
    PatternWord{"NUMX", FigureRole::columns},    PatternWord{"NUMY", FigureRole::rows},
    PatternWord{"ROTX", FigureRole::rotation_x}, PatternWord{"ROTY", FigureRole::rotation_y},
    PatternWord{"ROT", FigureRole::rotation},    PatternWord{"DX", FigureRole::spacing_x},
    PatternWord{"DY", FigureRole::spacing_y}};
constexpr std::array circle_words{PatternWord{"START", FigureRole::start_angle}, PatternWord{"NUM", FigureRole::count},
                                  PatternWord{"D", FigureRole::diameter}};
constexpr std::array arc_words{PatternWord{"START", FigureRole::start_angle},
                               PatternWord{"STEP", FigureRole::angle_step}, PatternWord{"NUM", FigureRole::count},
                               PatternWord{"D", FigureRole::diameter}};

struct Form {
    std::string_view name;
    FigureKind kind;
    std::span<const PatternWord> words;
};
constexpr std::array forms{
    Form{"PITCHCIRC", FigureKind::arc, arc_words}, Form{"CIRC", FigureKind::circle, circle_words},
    Form{"FRAME", FigureKind::frame, grid_words},  Form{"PAT", FigureKind::grid, grid_words},
    Form{"ROW", FigureKind::row, row_words},       Form{"POS", FigureKind::position, {}},
};

bool is_needed(FigureRole r) {
    return r != FigureRole::z && r != FigureRole::rotation && r != FigureRole::rotation_x &&
           r != FigureRole::rotation_y && r != FigureRole::start_angle;
}

/// One value of the figure; false where none stands here.
bool read_setting(State& s, program::PatternFigure& figure, std::span<const PatternWord> words, bool first) {
    const std::uint32_t begin = s.in.at();
    const bool incremental = base::upper(s.in.peek()) == 'I';
    if (incremental) s.in.step();
    for (const PatternWord& w : words) {
        if (!s.in.take_prefix(w.text)) continue;
        const bool place = w.role == FigureRole::x || w.role == FigureRole::y;
        if (incremental && (!place || first)) {
            fail(s, begin,
                 first && place ? "the first figure of a pattern has nothing to be incremental to"
                                : "only X and Y may be incremental in a pattern");
            return true;
        }
        const ExprId value = value_expr(s);
        const bool twice = std::any_of(figure.settings.begin(), figure.settings.end(),
                                       [&](const program::FigureSetting& have) { return have.role == w.role; });
        if (twice && !s.failed) fail(s, begin, std::string(w.text) + " is given twice");
        if (!s.failed) figure.settings.push_back({w.role, value, incremental});
        return true;
    }
    s.in.go_to(begin);
    return false;
}

void require(State& s, const program::PatternFigure& figure, std::span<const PatternWord> words, std::uint32_t begin) {
    for (const PatternWord& w : words) {
        const bool given = std::any_of(figure.settings.begin(), figure.settings.end(),
                                       [&](const program::FigureSetting& have) { return have.role == w.role; });
        if (!given && is_needed(w.role) && !s.failed)
            fail(s, begin, "this figure of the pattern needs " + std::string(w.text));
    }
}

void read_figure(State& s, program::Pattern& pattern) {
    s.in.skip_blanks();
    const std::uint32_t begin = s.in.at();
    const std::string_view word = s.in.letters();
    const auto form = std::find_if(forms.begin(), forms.end(),
                                   [&](const Form& f) { return base::equals_ignoring_case(f.name, word); });
    if (form == forms.end())
        return fail_here(s, "POS, ROW, PAT, FRAME, CIRC or PITCHCIRC is due here, found " + here(s));
    program::PatternFigure figure;
    figure.kind = form->kind;
    s.in.step(word.size());
    static_cast<void>(s.in.integer());
    if (!s.in.take('(')) return fail_here(s, "'(' is due here, found " + here(s));
    const bool first = pattern.figures.empty();
    while (!s.failed && !s.in.take(')')) {
        if (s.in.at_end()) return fail(s, begin, "this figure of the pattern is not closed: ')' is missing");
        if (!read_setting(s, figure, form->words, first) && !read_setting(s, figure, position_words, first))
            return fail_here(s, "this is no word of " + std::string(form->name) + ": " + here(s));
    }
    require(s, figure, position_words, begin);
    require(s, figure, form->words, begin);
    figure.where = s.build.span(begin, s.in.at());
    pattern.figures.push_back(std::move(figure));
}

void read_pattern_definition(State& s) {
    s.build.control(StatementKind::pattern, s.build.unit().patterns.size(), s.block, s.in.at());
    s.build.unit().patterns.push_back({});
    program::Pattern pattern;
    if (!s.in.take_word("DEF")) return fail_here(s, "DEF is due behind PATTERN, found " + here(s));
    if (s.in.at_end()) return fail_here(s, "a pattern needs a figure: POS, ROW, PAT, FRAME, CIRC or PITCHCIRC");
    while (!s.failed && !s.in.at_end()) read_figure(s, pattern);
    if (s.failed) pattern.figures.clear();
    pattern.where = s.build.span(s.block, s.in.at());
    s.build.unit().patterns.back() = std::move(pattern);
}

void read_selection(State& s) {
    s.build.control(StatementKind::pattern, s.build.unit().patterns.size(), s.block, s.in.at());
    program::Pattern pattern;
    pattern.table = read_file_name(s, "the name of a point table is due behind SEL PATTERN");
    pattern.where = s.build.span(s.block, s.in.at());
    s.build.unit().patterns.push_back(std::move(pattern));
}

}  // namespace

ExprId read_file_name(State& s, std::string_view due) {
    s.in.skip_blanks();
    if (stands_parameter(s) || s.in.peek() == '"') return read_text(s);
    const std::uint32_t begin = s.in.at();
    const std::string_view path = s.in.at_end() ? std::string_view{} : s.in.path();
    if (path.empty()) {
        fail_here(s, std::string(due) + ", found " + here(s));
        return no_expr;
    }
    return s.build.text(std::string(path), begin, s.in.at());
}

bool read_pattern_block(State& s, std::string_view word) {
    const std::uint32_t begin = s.in.at();
    if (base::equals_ignoring_case(word, "PATTERN")) return s.in.step(word.size()), read_pattern_definition(s), true;
    if (s.in.take_word("SEL") && s.in.take_word("PATTERN")) return read_selection(s), true;
    s.in.go_to(begin);
    return false;
}

}  // namespace obrys::read::heidenhain
