#include "commands.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>

#ifndef _WIN32
#include <unistd.h>
#endif

#include "base/codes.hpp"
#include "base/number.hpp"
#include "check/result.hpp"
#include "cl/canon.hpp"
#include "cl/text.hpp"
#include "cl/totals.hpp"
#include "driver/check_program.hpp"
#include "driver/plot_path.hpp"
#include "driver/stream_table.hpp"
#include "milled.hpp"
#include "output.hpp"
#include "progress.hpp"
#include "report/milling_report.hpp"
#include "report/report.hpp"

namespace obrys::cli {

namespace {

constexpr std::size_t moves_on_page = 20'000;
constexpr std::size_t milled_moves_on_page = 200'000;

void print_diagnostics(const driver::Session& s, base::Severity from = base::Severity::note) {
    for (const base::Diagnostic& d : s.diagnostics.all())
        if (d.severity >= from) std::fputs(base::render(d, s.sources).c_str(), stderr);
}

bool standard_output_is_terminal() {
#ifdef _WIN32
    return false;
#else
    return isatty(1) != 0;
#endif
}

/// Exit code of a run: what its complaints say about it.
int exit_code(const driver::Session& s) {
    bool finding = false, unchecked = false;
    for (const base::Diagnostic& d : s.diagnostics.all()) {
        finding = finding || base::kind_of(d.code) == base::CodeKind::finding;
        unchecked = unchecked || base::kind_of(d.code) == base::CodeKind::unchecked;
    }
    return driver::refused(s) ? 2 : unchecked ? 3 : finding ? 1 : 0;
}

report::Subject subject_of(const driver::Session& s, const driver::Checked& c) {
    return {s.sources, c.result, c.setup, s.stacks, s.program, s.control, OBRYS_VERSION, {}};
}

std::string counts(const interp::Outcome& outcome, const cl::Totals& t) {
    return std::to_string(outcome.blocks_executed) + " blocks, " + std::to_string(t.moves) + " moves (" +
           std::to_string(t.rapid_moves) + " rapid, " + std::to_string(t.feed_moves) + " feed), rapid " +
           base::fixed(t.rapid_length_mm, 3) + " mm, feed " + base::fixed(t.feed_length_mm, 3) + " mm\n";
}

interp::Outcome print_stream(const Arguments& a, driver::Session& s, Output& out) {
    const auto write = [&](std::string_view text) { out.write(text); };
    if (a.format == "csv") {
        driver::CsvWriter writer(s.sources, write);
        return driver::interpret(s, writer);
    }
    if (a.request.canon) {
        const auto number = [&](const base::Span& at) {
            const auto n = s.sources.block_number(at.file, at.begin);
            return n ? std::to_string(*n) : std::string{};
        };
        cl::CanonWriter writer(write, number);
        const interp::Outcome outcome = driver::interpret(s, writer);
        // A subprogram that is not there was looked for up to the end of the text.
        const auto& said = s.diagnostics.all();
        const bool searched = std::any_of(said.begin(), said.end(), [](const base::Diagnostic& d) {
            return d.code == base::codes::missing_subprogram;
        });
        writer.finish(driver::percent_lines(s), a.request.configuration.empty() ? 2 : 1,
                      outcome.ending != interp::Ending::regular && !searched);
        return outcome;
    }
    if (a.format == "json") {
        driver::JsonWriter writer(s.sources, write);
        const interp::Outcome outcome = driver::interpret(s, writer);
        writer.finish();
        return outcome;
    }
    cl::TextWriter writer(write);
    return driver::interpret(s, writer);
}

void print_parameters(const interp::Outcome& outcome, Output& out) {
    for (const interp::ParameterValue& p : outcome.parameters)
        out.write(p.name + "=" + (std::isnan(p.value) ? std::string("?") : base::shortest(p.value)) + "\n");
}

/// The path by itself: of programs whose removal is not simulated, and with an interpolator's deviations.
int plot_path(const Arguments& a, driver::Session& s) {
    const bool table = a.interpolation > 0;
    Output out(table ? a.output : "");
    if (!out.good()) {
        std::fprintf(stderr, "obrys: %s cannot be written\n", a.output.c_str());
        return 2;
    }
    driver::PlotOptions options;
    options.plane = s.job.machine.kind == shop::MachineKind::lathe ? report::PlotPlane::zx : report::PlotPlane::xy;
    options.unit = a.interpolation;
    const auto row = [&](const report::InterpolatedMove& m) {
        out.write(report::table_row(m, s.sources, a.interpolation));
    };
    driver::PathPlotter plotter(options, row);
    if (table) out.write(report::table_head(a.interpolation));
    const auto programmed = [&](geom::Vec3 from, const cl::Record& element) { plotter.programmed(from, element); };
    const interp::ContourSink contour(programmed);
    static_cast<void>(driver::interpret(s, plotter, &contour));
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
    if (table && a.svg.empty()) return 0;
    return deliver(s, a.svg.empty() ? a.output : a.svg, report::to_svg(plot, s.sources)) ? 0 : 2;
}

/// Of milling the page with the part in space, where the program was built with it.
std::string page(const report::Subject& subject) {
    if (subject.result.milled != nullptr && report::milling_page_available())
        return report::milling_page(report::milling_page_of(subject));
    return report::to_html(subject);
}

}  // namespace

int check(const Arguments& a) {
    driver::Session s;
    if (!driver::open(a.request, s)) {
        print_diagnostics(s, base::Severity::warning);
        return 2;
    }
    const bool pictures = !a.html.empty() || !a.svg.empty();
    driver::MillingRequest milling = a.milling;
    milling.surface = wants_surface(a) || !a.html.empty();
    milling.keep_moves = a.html.empty() ? 0 : milled_moves_on_page;
    driver::Checked checked;
    {
        Progress progress;
        checked = driver::check_program(s, pictures ? moves_on_page : 0, milling,
                                        [&](std::uint64_t moves) { progress.show(moves); });
    }
    if (driver::refused(s)) {
        print_diagnostics(s, base::Severity::warning);
        return 2;
    }
    const report::Subject subject = subject_of(s, checked);
    bool written = true;
    if (a.format == "json")
        written = deliver(s, a.output, report::to_json(subject, a.all));
    else if (a.format == "sarif")
        written = deliver(s, a.output, report::to_sarif(subject, a.all));
    else
        written = deliver(s, a.output,
                          report::to_text(subject, {a.colours && a.output.empty() && standard_output_is_terminal() &&
                                                        std::getenv("NO_COLOR") == nullptr,
                                                    !a.no_list, a.all}));
    if (!a.html.empty()) written = deliver(s, a.html, page(subject)) && written;
    if (!a.svg.empty()) written = deliver(s, a.svg, report::to_svg(subject)) && written;
    written = write_surface(a, s, checked) && written;
    written = write_engagement(a, subject) && written;
    return written ? check::exit_code(checked.result.verdict) : 2;
}

int plot(const Arguments& a) {
    driver::Session s;
    if (!driver::open(a.request, s)) {
        print_diagnostics(s, base::Severity::warning);
        return 2;
    }
    if (a.interpolation > 0 || s.job.machine.kind != shop::MachineKind::lathe) return plot_path(a, s);
    const driver::Checked checked = driver::check_program(s, moves_on_page);
    if (driver::refused(s)) {
        print_diagnostics(s, base::Severity::warning);
        return 2;
    }
    std::fputs((report::verdict_line(checked.result) + "\n").c_str(), stderr);
    return deliver(s, a.svg.empty() ? a.output : a.svg, report::to_svg(subject_of(s, checked))) ? 0 : 2;
}

int run(const Arguments& a) {
    driver::Session s;
    if (!driver::open(a.request, s)) {
        print_diagnostics(s, base::Severity::warning);
        return 2;
    }
    Output out(a.output);
    if (!out.good()) {
        std::fprintf(stderr, "obrys: %s cannot be written\n", a.output.c_str());
        return 2;
    }
    cl::Totals totals;
    if (a.quiet || a.parameters) {
        const interp::Outcome outcome = driver::interpret(s, totals);
        if (a.quiet) out.write(counts(outcome, totals));
        if (a.parameters) print_parameters(outcome, out);
    } else {
        static_cast<void>(print_stream(a, s, out));
    }
    print_diagnostics(s);
    return exit_code(s);
}

}  // namespace obrys::cli
