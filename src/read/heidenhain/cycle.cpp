/// CYCL DEF in its named form (`CYCL DEF 200 DRILLING ~ Q200=2 …`) and its numbered one (`CYCL DEF 1.1 DIST 2`), and
/// CYCL CALL.

#include <algorithm>
#include <utility>

#include "base/number.hpp"
#include "base/whole.hpp"
#include "dialect/heidenhain/cycles.hpp"
#include "read/heidenhain/state.hpp"

namespace obrys::read::heidenhain {

using program::no_expr;

namespace {

constexpr unsigned most_lines = 16;  ///< of a definition in the numbered form

int number_of(const program::CycleDefinition& c) {
    const auto n = base::parse_integer(std::string_view(c.name).substr(c.name.find_last_of(' ') + 1));
    return n && *n >= 0 && *n <= 999 ? static_cast<int>(*n) : 0;
}

/// The cycle has a value for this already.
bool stands_twice(State& s, const dialect::heidenhain::CycleParameter& p, std::uint32_t begin) {
    const auto& settings = open_cycle(s).settings;
    if (std::none_of(settings.begin(), settings.end(), [&](const auto& x) { return x.role == p.role; })) return false;
    fail(s, begin, "this value stands twice in " + open_cycle(s).name);
    return true;
}

}  // namespace

void add_setting(State& s, const dialect::heidenhain::CycleParameter& p, ExprId value, bool incremental,
                 std::uint32_t begin) {
    if (stands_twice(s, p, begin)) return;
    program::CycleSetting setting;
    setting.role = p.role;
    setting.value = value;
    setting.incremental = incremental;
    setting.scales = p.unit == dialect::heidenhain::CycleUnit::length;
    setting.is_feed = p.unit == dialect::heidenhain::CycleUnit::feed;
    setting.where = s.build.span(begin, s.in.at());
    open_cycle(s).settings.push_back(setting);
}

void end_cycle(State& s) {
    const std::uint32_t missing = std::exchange(s.lines_needed, 0) & ~std::exchange(s.lines_read, 0);
    const std::uint32_t ended = std::exchange(s.open_cycle, program::no_target);
    if (missing == 0 || ended == program::no_target) return;
    const program::CycleDefinition& c = s.build.unit().cycles[ended];
    const std::string number = std::to_string(number_of(c));
    std::string lines;
    for (unsigned line = 1; line < most_lines; ++line) {
        if ((missing & 1U << line) == 0) continue;
        if (!lines.empty()) lines += ", ";
        lines += number + "." + std::to_string(line);
    }
    // A block of its own: the definition has been read, and nobody knows what it says.
    s.build.statement(StatementKind::block, s.block);
    s.build.fail(c.where.begin, c.where.end, c.name + ".0 stands without its " + lines,
                 "write the line that is missing, or take the definition out");
    s.build.end_statement(s.block);
    s.statements = s.build.unit().statements.size();
}

void start_cycle(State& s, int number, const dialect::heidenhain::Cycle* cycle, std::uint32_t begin) {
    end_cycle(s);
    program::CycleDefinition c;
    c.name = "CYCL DEF " + std::to_string(number);
    c.where = s.build.span(begin, s.in.at());
    c.use = program::CycleUse::refused;
    if (cycle != nullptr) {
        c.kind = cycle->kind;
        c.call_active = cycle->call_active;
        c.use = static_cast<program::CycleUse>(cycle->use);
        c.reason = cycle->text;
    } else {
        c.reason = "obrys does not know this cycle";
        c.kind = cl::CycleKind::probe;
    }
    s.build.unit().cycles.push_back(std::move(c));
    s.open_cycle = static_cast<std::uint32_t>(s.build.unit().cycles.size() - 1);
    s.build.control(StatementKind::cycle_definition, s.open_cycle, s.block, s.in.at());
}

namespace {

/// A value behind Q206=: a number or parameter, or FMAX, FAUTO, FU0.2, FZ0.1, PREDEF.
void read_setting(State& s, program::CycleSetting& setting) {
    using program::SettingGiven;
    s.in.skip_blanks();
    const std::uint32_t begin = s.in.at();
    const auto stands = [&](std::string_view word, SettingGiven given) {
        if (!s.in.take_word(word)) return false;
        setting.given = given;
        setting.value = s.build.number(0, true, begin, s.in.at());
        return true;
    };
    if (stands("FMAX", SettingGiven::rapid) || stands("FAUTO", SettingGiven::tool_feed) ||
        stands("PREDEF", SettingGiven::set_globally))
        return;
    if (s.in.take_prefix("FU")) setting.given = SettingGiven::per_rev;
    if (setting.given == SettingGiven::number && s.in.take_prefix("FZ")) setting.given = SettingGiven::per_tooth;
    setting.value = value_expr(s);
}

/// A value of GLOBAL DEF, in the unit that the parameter has in the cycles.
void add_global(State& s, program::CycleSetting setting) {
    program::CycleDefinition& c = open_cycle(s);
    if (!dialect::heidenhain::is_global_value(number_of(c), static_cast<int>(setting.parameter)))
        s.build.problem(Code::unsupported, setting.where.begin, setting.where.end,
                        "this parameter does not belong to " + c.name);
    c.settings.push_back(setting);
}

}  // namespace

bool read_parameter_line(State& s) {
    const std::uint32_t begin = s.in.at();
    if (!stands_parameter(s)) return false;
    const ExprId q = read_parameter(s);
    if (!s.in.take('=')) {
        s.in.go_to(begin);
        return false;
    }
    program::CycleSetting setting;
    read_setting(s, setting);
    if (s.failed || q == no_expr) return true;
    const program::Expr& e = s.build.unit().exprs[q];
    program::CycleDefinition& c = open_cycle(s);
    setting.parameter = e.a;
    setting.where = s.build.span(begin, s.in.at());
    const dialect::heidenhain::Cycle* known = dialect::heidenhain::find_cycle(number_of(c));
    const dialect::heidenhain::CycleParameter* p =
        known == nullptr ? nullptr : dialect::heidenhain::find_parameter(*known, static_cast<int>(e.a));
    if (std::any_of(c.settings.begin(), c.settings.end(), [&](const auto& x) { return x.parameter == e.a; }))
        return fail(s, begin, "this parameter stands twice in " + c.name), true;
    if (c.kind == cl::CycleKind::global_values) return add_global(s, setting), true;
    if (p != nullptr) {
        setting.role = p->role;
        setting.scales = p->unit == dialect::heidenhain::CycleUnit::length;
        setting.is_feed = p->unit == dialect::heidenhain::CycleUnit::feed;
        c.settings.push_back(setting);
        return true;
    }
    // The control refuses what does not belong to the cycle; an old or new software version may know it.
    if (known != nullptr)
        s.build.problem(Code::unsupported, begin, s.in.at(), "this parameter does not belong to " + c.name);
    setting.role = cl::CycleRole::probe_input;
    c.settings.push_back(setting);
    return true;
}

namespace {

/// Axes without values: CYCL DEF 8.1 X Y.
void read_axes_alone(State& s, const dialect::heidenhain::Cycle& cycle, int line, const std::string& words,
                     std::uint32_t begin) {
    for (const char c : words) {
        if (base::is_blank(c)) continue;
        const auto* p = cycle.kind == cl::CycleKind::mirror
                            ? dialect::heidenhain::find_parameter(cycle, line, std::string_view(&c, 1))
                            : nullptr;
        if (p == nullptr)
            return fail(s, begin, "the word '" + words + "' has no value: a number or a Q parameter must follow");
        add_setting(s, *p, s.build.number(1, true, begin, s.in.at()), false, begin);
        if (s.failed) return;
    }
}

void read_numbered_line(State& s, const dialect::heidenhain::Cycle& cycle, int line) {
    using cl::CycleKind;
    while (line == 0 && !s.failed && !s.in.at_end()) read_name_word(s);
    if (line == 0) return s.in.skip_block();
    if (cycle.kind == CycleKind::contour_definition) return read_names(s);
    if (cycle.kind == CycleKind::program_call) return read_program_name(s);
    for (std::size_t n = 0; !s.failed && !s.in.at_end(); ++n) {
        const std::uint32_t begin = s.in.at();
        std::string word = read_keyword(s);
        if (s.in.at_end()) return read_axes_alone(s, cycle, line, word, begin);
        if (cycle.kind == CycleKind::mirror)
            return fail(s, begin, "the axes of a mirror image have no values", "CYCL DEF 8.1 X Y");
        const dialect::heidenhain::CycleParameter* p = dialect::heidenhain::find_parameter(cycle, line, word);
        const bool incremental = p == nullptr && word.size() > 1 && word[0] == 'I' &&
                                 dialect::heidenhain::find_parameter(cycle, line, word.substr(1)) != nullptr;
        if (incremental) p = dialect::heidenhain::find_parameter(cycle, line, word.substr(1));
        if (p == nullptr) p = dialect::heidenhain::find_parameter_at(cycle, line, n);
        const ExprId value = p != nullptr && p->role == cl::CycleRole::direction ? read_sense(s) : value_expr(s);
        if (s.failed) return;
        if (p != nullptr)
            add_setting(s, *p, value, incremental, begin);
        else
            s.build.problem(Code::unsupported, begin, s.in.at(), "this value does not belong to " + open_cycle(s).name);
    }
}

void read_cycle_definition(State& s, std::uint32_t begin) {
    s.in.skip_blanks();
    const base::NumberScan n = s.in.number();
    if (n.length == 0 || !n.decimal || n.value >= 1000) {
        s.build.statement(StatementKind::block, s.block);
        fail_here(s, "the number of a cycle is due behind CYCL DEF, found " + here(s));
        return;
    }
    const int number = base::clipped<int>(n.value, 0, 999);
    const dialect::heidenhain::Cycle* cycle = dialect::heidenhain::find_cycle(number);
    if (n.integer) {
        start_cycle(s, number, cycle, begin);
        return read_named(s);
    }
    const int line = static_cast<int>(n.decimal->mantissa % (n.decimal->decimals == 1 ? 10 : 100));
    const bool goes_on =
        s.open_cycle != program::no_target && open_cycle(s).name == "CYCL DEF " + std::to_string(number) && line > 0;
    if (!goes_on)
        start_cycle(s, number, cycle, begin);
    else
        s.build.statement(StatementKind::block, s.block);
    if (line > 0 && !goes_on) {
        fail(s, begin,
             "CYCL DEF " + std::to_string(number) + "." + std::to_string(line) + " stands without its " +
                 std::to_string(number) + ".0");
        return;
    }
    if (cycle == nullptr) return s.in.skip_block();
    if (line == 0) s.lines_needed = dialect::heidenhain::needed_lines(*cycle);
    if (line > 0 && line < static_cast<int>(most_lines)) {
        s.lines_read |= 1U << line;
        s.lines_needed |= (1U << line) - 2;  // those before it
    }
    read_numbered_line(s, *cycle, line);
}

void read_cycle_call(State& s, std::uint32_t begin) {
    s.build.statement(StatementKind::block, s.block);
    const bool pattern = s.in.take_word("PAT");
    if (pattern || s.in.take_word("POS")) {
        s.build.modal(pattern ? Modal::cycle_pattern : Modal::cycle_position, begin, s.in.at());
        s.rapid_counts = true;
        s.build.modal(has_rapid(s) ? Modal::rapid : Modal::linear, begin, s.in.at());
    }
    s.build.bare(Code::cycle_call, begin, s.in.at());
    if (!s.rapid_counts || pattern) return read_functions(s);
    read_words(s, false);
}

}  // namespace

bool read_cycle_line(State& s) {
    if (s.open_cycle == program::no_target || !stands_parameter(s)) return false;
    if (!read_parameter_line(s)) return false;
    read_named(s);
    return true;
}

void read_global_values(State& s) {
    const std::uint32_t begin = s.block;
    s.in.step(std::string_view("GLOBAL").size());
    s.in.take_word("DEF");
    s.in.skip_blanks();
    const int number = s.in.integer();
    start_cycle(s, number, nullptr, begin);
    program::CycleDefinition& c = open_cycle(s);
    c.name = "GLOBAL DEF " + std::to_string(number);
    if (!dialect::heidenhain::global_values_name(number).empty()) {
        c.kind = cl::CycleKind::global_values;
        c.use = program::CycleUse::run;
    }
    read_named(s);
}

void read_cycle_block(State& s) {
    const std::uint32_t begin = s.block;
    if (s.in.take_word("DEF")) return read_cycle_definition(s, begin);
    end_cycle(s);
    if (s.in.take_word("CALL")) return read_cycle_call(s, s.in.at());
    s.build.statement(StatementKind::block, s.block);
    fail_here(s, "DEF or CALL is due behind CYCL, found " + here(s));
}

}  // namespace obrys::read::heidenhain
