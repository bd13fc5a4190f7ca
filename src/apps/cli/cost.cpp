/// obrys cost.

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "commands.hpp"
#include "driver/cutting/tables.hpp"
#include "driver/files.hpp"
#include "driver/timing/time_program.hpp"
#include "milled.hpp"
#include "report/cutting/cost.hpp"
#include "session.hpp"
#include "shop/files/cutting/cost_file.hpp"

namespace obrys::cli {

namespace {

namespace times = sim::time;

/// How long a program takes; nothing where it cannot be read, after a complaint.
std::optional<times::Times> time_of(const Arguments& a, const std::string& program, std::vector<std::string>& gaps) {
    driver::Session s;
    driver::Request request = with_outputs(a);
    request.input = program;
    if (!driver::open(request, s)) {
        print_diagnostics(s, base::Severity::warning);
        return std::nullopt;
    }
    const driver::Timing timing{driver::dynamics_of(s), {}};
    times::Times t = std::move(driver::time_program(s, {&timing, 1}).front().times);
    const int code = driver::exit_code_of_run(s);
    print_diagnostics(s, base::Severity::warning);
    if (code == 2) return std::nullopt;
    if (code == 1) gaps.push_back(program + " would stop with an alarm: the time is that of its beginning");
    if (code == 3) gaps.push_back("not all of " + program + " was understood or run");
    if (!t.is_understood()) gaps.push_back("not all of " + program + " could be timed: see obrys time");
    return t;
}

/// How long the tools of the table cut in the program.
void set_cutting_times(shop::CostTable& table, const times::Times& t) {
    for (shop::CostTool& tool : table.tools) {
        if (tool.cut_s || !tool.number) continue;
        const auto spent = t.tools.find(*tool.number);
        tool.cut_s = spent == t.tools.end() ? 0 : spent->second[static_cast<std::size_t>(times::Cause::feed)];
    }
}

/// False: the input cannot be used.
bool cost_of(const Arguments& a, report::cutting::CostColumn& c) {
    const bool own = c.variant.time_s || !c.variant.program.empty();
    const std::string program = !c.variant.program.empty()
                                    ? driver::beside(a.request.input, c.variant.program).generic_string()
                                : own ? std::string{}
                                      : a.cutting.program;
    if (c.variant.time_s || (!own && std::isfinite(a.cutting.seconds))) {
        c.seconds = c.variant.time_s ? *c.variant.time_s : a.cutting.seconds;
        c.time_from = "given";
    } else if (!program.empty()) {
        const auto t = time_of(a, program, c.not_whole);
        if (!t) return false;
        c.seconds = times::sum(t->all);
        c.time_from = program;
        set_cutting_times(c.variant.table, *t);
    } else {
        c.not_whole.emplace_back("the time of a piece is not known: --time, --program, or 'time' of the variant");
        return true;
    }
    c.cost = sim::cost::cost_of(c.variant.table, *c.seconds);
    return true;
}

}  // namespace

int cost(const Arguments& a) {
    if (std::isfinite(a.cutting.seconds) && !a.cutting.program.empty()) {
        std::fputs("obrys cost: --time and --program are one too many: each says how long a piece takes\n", stderr);
        return 2;
    }
    driver::cutting::Texts texts;
    std::vector<driver::fs::path> inputs{a.request.input};
    for (const std::string& file : {a.cutting.program, a.request.machine})
        if (!file.empty()) inputs.emplace_back(file);
    if (!may_write(a, inputs)) return 2;
    const auto file = driver::cutting::text_of(a.request.input, texts);
    std::vector<shop::CostVariant> variants;
    if (file) variants = shop::read_costs(*file, texts.sources, texts.diagnostics);
    print_diagnostics(texts);
    if (!file || texts.diagnostics.has_errors()) return 2;
    std::vector<report::cutting::CostColumn> columns;
    for (shop::CostVariant& v : variants) {
        report::cutting::CostColumn column;
        column.variant = std::move(v);
        if (!cost_of(a, column)) return 2;
        columns.push_back(std::move(column));
    }
    const std::string text = a.format == "json" ? report::cutting::as_json(columns) : report::cutting::as_text(columns);
    if (!deliver(a.output, text)) return 2;
    return std::all_of(columns.begin(), columns.end(), [](const auto& c) { return c.is_whole(); }) ? 0 : 3;
}

}  // namespace obrys::cli
