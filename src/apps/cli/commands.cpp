#include "commands.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "base/codes.hpp"
#include "base/number.hpp"
#include "check/result.hpp"
#include "cl/text.hpp"
#include "cl/totals.hpp"
#include "driver/canon.hpp"
#include "driver/check_program.hpp"
#include "driver/documents/plot_path.hpp"
#include "driver/documents/stream_table.hpp"
#include "milled.hpp"
#include "report/milling_report.hpp"
#include "report/report.hpp"
#include "session.hpp"

namespace obrys::cli {

namespace {

std::string counts(const interp::Outcome& outcome, const cl::Totals& t) {
    return std::to_string(outcome.blocks_executed) + " blocks, " + std::to_string(t.moves) + " moves (" +
           std::to_string(t.rapid_moves) + " rapid, " + std::to_string(t.feed_moves) + " feed), rapid " +
           base::fixed(t.rapid_length_mm, 3) + " mm, feed " + base::fixed(t.feed_length_mm, 3) + " mm\n";
}

interp::Outcome print_stream(const Arguments& a, driver::Session& s, driver::OutputFile& out) {
    const auto write = [&](std::string_view text) { out.write(text); };
    if (a.format == "csv") {
        driver::CsvWriter writer(s.sources, write);
        return driver::interpret(s, writer);
    }
    if (a.request.stand_alone)
        return driver::print_canon(s, write, !a.request.configuration.empty(), [](const cl::Record&) {});
    if (a.format == "json") {
        driver::JsonWriter writer(s.sources, write);
        const interp::Outcome outcome = driver::interpret(s, writer);
        writer.finish();
        return outcome;
    }
    cl::TextWriter writer(write);
    return driver::interpret(s, writer);
}

void print_parameters(const interp::Outcome& outcome, driver::OutputFile& out) {
    for (const interp::ParameterValue& p : outcome.parameters)
        out.write(p.name + "=" + (std::isnan(p.value) ? std::string("?") : base::shortest(p.value)) + "\n");
}

/// The path by itself: of programs whose removal is not simulated, and with an interpolator's deviations.
int plot_path(const Arguments& a, driver::Session& s) {
    const bool table = a.interpolation > 0;
    driver::OutputFile out(table ? a.output : "");
    driver::PlotOptions options;
    options.plane = s.job.machine.kind == shop::MachineKind::lathe ? report::PlotPlane::zx : report::PlotPlane::xy;
    options.unit = a.interpolation;
    const auto row = [&](const report::InterpolatedMove& m) {
        out.write(report::table_row(m, s.sources, a.interpolation));
    };
    driver::PathPlotter plotter(options, row);
    if (table) out.write(report::table_head(a.interpolation));
    static_cast<void>(driver::interpret(s, plotter));
    if (driver::refused(s)) {
        print_diagnostics(s, base::Severity::warning);
        return 2;
    }
    report::PathPlot plot = plotter.finish();
    plot.program = s.program;
    plot.control = s.control;
    plot.machine = s.job.machine.name;
    if (table) out.write(report::table_end(*plot.interpolation, s.sources));
    print_diagnostics(s, base::Severity::warning);
    if (!may_write(a, s)) return 2;
    if (table && !deliver(a.output, out)) return 2;
    const int done = s.files->failed() ? 2 : 0;
    if (table && a.svg.empty()) return done;
    return deliver(a.svg.empty() ? a.output : a.svg, report::to_svg(plot, s.sources)) ? done : 2;
}

}  // namespace

int plot(const Arguments& a) {
    driver::Session s;
    if (!open(a, s)) return 2;
    if (a.interpolation > 0 || s.job.machine.kind != shop::MachineKind::lathe) return plot_path(a, s);
    const driver::Checked checked = driver::check_program(s, report::moves_on_page);
    if (driver::refused(s)) {
        print_diagnostics(s, base::Severity::warning);
        return 2;
    }
    std::fputs((report::verdict_line(checked.result) + "\n").c_str(), stderr);
    if (!may_write(a, s)) return 2;
    const bool written = deliver(a.svg.empty() ? a.output : a.svg, report::to_svg(subject_of(s, checked)));
    return written && !s.files->failed() ? 0 : 2;
}

int run(const Arguments& a) {
    driver::Session s;
    if (!open(a, s)) return 2;
    driver::OutputFile out(a.output);
    cl::Totals totals;
    if (a.quiet || a.parameters) {
        const interp::Outcome outcome = driver::interpret(s, totals);
        if (a.quiet) out.write(counts(outcome, totals));
        if (a.parameters) print_parameters(outcome, out);
    } else {
        static_cast<void>(print_stream(a, s, out));
    }
    print_diagnostics(s);
    const bool written = may_write(a, s) && deliver(a.output, out) && !s.files->failed();
    return written ? driver::exit_code_of_run(s) : 2;
}

}  // namespace obrys::cli
