/// Cycles of DIN/ISO: `G200 Q200=2 …` as in Klartext, the older ones by letters and P numbers (`G83 P01 2 P02 -20`).

#include <algorithm>
#include <bitset>

#include "read/heidenhain/iso.hpp"

namespace obrys::read::heidenhain {

using cl::CycleKind;
using cl::CycleRole;

namespace {

/// Letter, or P and its two digits; moves behind it.
std::string word_name(State& s) {
    const char letter = base::upper(s.in.peek());
    s.in.step();
    if (letter != 'P') return std::string(1, letter);
    const int n = s.in.integer();
    return (n < 10 ? "P0" : "P") + std::to_string(std::clamp(n, 0, 99));
}

void not_of_cycle(State& s, std::uint32_t begin, const std::string& word) {
    s.in.go_to(begin);
    fail_here(s, "the word " + word + " does not belong to " + open_cycle(s).name,
              "take it out, or write it in a block of its own");
}

/// A value that G90 and G91 concern where `counts`: those of this very block, else those that the run has in force.
void add_dimension(State& s, const dialect::heidenhain::CycleParameter& p, ExprId value, bool counts,
                   std::uint32_t begin) {
    add_setting(s, p, value, counts && s.iso.incremental.value_or(false), begin);
    if (s.failed) return;
    if (counts && !s.iso.incremental && !open_cycle(s).settings.empty()) open_cycle(s).settings.back().as_modal = true;
}

/// An axis: with its value, or alone (mirror image).
void read_axis(State& s, const dialect::heidenhain::Cycle& cycle, char letter, std::uint32_t begin) {
    const dialect::heidenhain::CycleParameter* p = nullptr;
    for (int line = 0; line < 10 && p == nullptr; ++line)
        p = dialect::heidenhain::find_parameter(cycle, line, std::string_view(&letter, 1));
    if (p == nullptr) return not_of_cycle(s, begin, std::string(1, letter));
    if (cycle.kind == CycleKind::mirror)
        return add_setting(s, *p, s.build.number(1, true, begin, s.in.at()), false, begin);
    const bool shifts = cycle.kind == CycleKind::datum_shift;
    const ExprId value = value_expr(s);
    if (!s.failed) add_dimension(s, *p, value, shifts, begin);
}

/// P05 X+80: a side of a pocket says its axis.
void read_word(State& s, const dialect::heidenhain::Cycle& cycle, std::uint32_t begin) {
    const std::string name = word_name(s);
    const dialect::heidenhain::CycleParameter* p = dialect::heidenhain::find_iso_parameter(cycle, name);
    if (p == nullptr) {
        if (axis_of(name[0])) return read_axis(s, cycle, name[0], begin);
        return not_of_cycle(s, begin, name);
    }
    s.in.skip_blanks();
    if (name[0] == 'P' && axis_of(s.in.peek())) {
        const char letter = base::upper(s.in.peek());
        s.in.step();
        return read_axis(s, cycle, letter, begin);
    }
    const ExprId value = value_expr(s);
    if (!s.failed) add_dimension(s, *p, value, cycle.kind == CycleKind::rotation, begin);
}

/// G37 P01 1 P02 "POCKET": the labels of a contour. `taken`: the numbers behind P before it, a bit each.
void read_label_word(State& s, std::bitset<100>& taken, std::uint32_t begin) {
    const std::string name = word_name(s);
    if (name[0] != 'P') return not_of_cycle(s, begin, name);
    const auto number = static_cast<std::size_t>(10 * (name[1] - '0') + name[2] - '0');
    if (taken.test(number)) return fail(s, begin, name + " stands twice in " + open_cycle(s).name);
    taken.set(number);
    s.in.skip_blanks();
    const ExprId label = read_label_name(s);
    if (!s.failed) open_cycle(s).texts.push_back(label);
}

void read_program(State& s) {
    s.in.skip_blanks();
    if (base::upper(s.in.peek()) == 'P' && base::is_digit(s.in.peek(1))) {
        s.in.step();
        static_cast<void>(s.in.integer());
        s.in.skip_blanks();
    }
    s.in.take('%');
    s.in.take(':');
    s.in.skip_blanks();
    const std::uint32_t begin = s.in.at();
    const std::string_view path = s.in.path();
    if (path.empty()) return fail_here(s, "the name of a program is due behind G39, found " + here(s));
    open_cycle(s).texts.push_back(s.build.text(called_name(path, ".I"), begin, s.in.at()));
}

void read_words(State& s, const dialect::heidenhain::Cycle& cycle) {
    std::bitset<100> labels;
    while (!s.failed && !s.in.at_end()) {
        const std::uint32_t begin = s.in.at();
        const char c = base::upper(s.in.peek());
        if (c == 'G') {
            const int n = read_code(s);
            if (n == 90 || n == 91)
                dimension(s, n == 91, begin, true);
            else if (n >= 0)
                fail(s, begin, "G" + std::to_string(n) + " does not belong to " + open_cycle(s).name);
            continue;
        }
        if (!base::is_letter(c))
            return fail_here(s, "a word of " + open_cycle(s).name + " is due here, found " + here(s));
        if (cycle.kind == CycleKind::contour_definition)
            read_label_word(s, labels, begin);
        else
            read_word(s, cycle, begin);
    }
}

/// G75 … G78, G58, G59 say the sense of rotation, which Klartext asks for among the other values.
void add_direction(State& s, const dialect::heidenhain::GCode& g, const dialect::heidenhain::Cycle& cycle) {
    const auto known = dialect::heidenhain::find_iso_cycle(g.number);
    if (!known || known->direction == 0) return;
    auto& settings = open_cycle(s).settings;
    bool behind = false;
    for (const dialect::heidenhain::CycleParameter& p : cycle.parameters) {
        if (p.role == CycleRole::direction) {
            const std::uint32_t at = s.in.at();
            add_setting(s, p, s.build.number(known->direction, true, s.block, at), false, s.block);
            behind = true;
            continue;
        }
        const auto place = std::find_if(settings.begin(), settings.end(),
                                        [&](const program::CycleSetting& c) { return c.role == p.role; });
        if (behind && place != settings.end())
            return static_cast<void>(std::rotate(place, settings.end() - 1, settings.end()));
    }
}

bool is_named(const dialect::heidenhain::Cycle& cycle) {
    return !cycle.parameters.empty() && cycle.parameters.front().q >= 0;
}

}  // namespace

void read_iso_cycle(State& s, const dialect::heidenhain::GCode& g) {
    const std::uint32_t begin = s.in.at();
    const dialect::heidenhain::Cycle* cycle = dialect::heidenhain::find_cycle(g.cycle);
    while (base::upper(s.in.peek()) == 'G') {  // G90 and G91 may stand in front
        const std::uint32_t word = s.in.at();
        const int n = read_code(s);
        if (n < 0 || n == g.number) break;
        if (n != 90 && n != 91) return fail(s, word, "G" + std::to_string(n) + " does not belong to a cycle's block");
        dimension(s, n == 91, word, true);
        s.in.skip_blanks();
    }
    if (s.failed) return;
    start_cycle(s, g.cycle, cycle, begin);
    if (cycle == nullptr || cycle->kind == CycleKind::probe || cycle->kind == CycleKind::point_data) {
        s.open_cycle = program::no_target;
        return s.in.skip_block();
    }
    if (is_named(*cycle)) return read_named(s);
    if (cycle->kind == CycleKind::program_call)
        read_program(s);
    else
        read_words(s, *cycle);
    if (!s.failed) add_direction(s, g, *cycle);
    s.open_cycle = program::no_target;
}

}  // namespace obrys::read::heidenhain
