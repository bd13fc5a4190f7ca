/// obrys sheet.

#include "report/sheet/sheet.hpp"

#include <algorithm>
#include <cstdio>

#include "base/number.hpp"
#include "commands.hpp"
#include "driver/files.hpp"
#include "driver/program_blank.hpp"
#include "driver/program_tools.hpp"
#include "milled.hpp"
#include "session.hpp"

namespace obrys::cli {

namespace {

namespace sheet_of = report::sheet;

std::string mm(double value) { return base::fixed(value, 3); }

std::string in_words(const shop::Solid& solid) {
    if (const auto* box = std::get_if<shop::SolidBox>(&solid)) {
        const geom::Vec3 size = box->max - box->min;
        return "box " + mm(size.x) + " x " + mm(size.y) + " x " + mm(size.z) + " mm from (" + mm(box->min.x) + "; " +
               mm(box->min.y) + "; " + mm(box->min.z) + ")";
    }
    if (const auto* c = std::get_if<shop::SolidCylinder>(&solid))
        return "cylinder, diameter " + mm(2 * c->radius) + " x " + mm(c->max - c->min) + " mm along " +
               std::string(1, "XYZ"[c->axis]) + " from " + mm(c->min);
    return "file " + std::get<shop::SolidFile>(solid).path;
}

/// A turned blank by its largest diameter and its ends.
std::string in_words(const geom::Contour& drawn) {
    double radius = 0, low = INFINITY, high = -INFINITY;
    for (const geom::Vertex& v : drawn.vertices) {
        low = std::min(low, v.p.x);
        high = std::max(high, v.p.x);
        radius = std::max(radius, v.p.y);
    }
    if (!(high > low)) return {};
    return "turned, diameter " + mm(2 * radius) + " x " + mm(high - low) + " mm, Z " + mm(low) + " to " + mm(high);
}

std::string stock_of(driver::Session& s) {
    if (s.job.solid_stock) return in_words(s.job.solid_stock->solid);
    if (s.job.stock) return in_words(s.job.stock->drawn);
    const auto blank = driver::program_blank(*s.main, s.diagnostics);
    return blank ? in_words(blank->solid) : "";
}

/// Exit code of the run; 2: there is no sheet.
int take_program(const Arguments& a, const std::string& input, std::vector<sheet_of::Program>& to) {
    Arguments own = a;
    own.request.input = input;
    driver::Session s;
    if (!open(own, s)) return 2;
    for (shop::Tool& tool : driver::program_tools(*s.main, s.job.tools, s.diagnostics))
        s.job.tools.push_back(std::move(tool));
    const std::string stock = stock_of(s);
    sheet_of::Collector collector(s.job.tools, s.job.machine);
    static_cast<void>(driver::interpret(s, [&](const cl::Record& record) { collector.take(record); }));
    const int code = driver::exit_code_of_run(s);
    sheet_of::Program program = collector.finish();
    program.name = s.program;
    program.control = s.control;
    program.stock = stock;
    for (const shop::Clamp& clamp : s.job.clamps) program.clamps.push_back(clamp.name + ": " + in_words(clamp.solid));
    if (code == 1) program.not_whole = "The control would stop with an alarm: this is not all of the program.";
    if (code == 3) program.not_whole = "Something was not understood or not run: this is not all of the program.";
    print_diagnostics(s, base::Severity::warning);
    if (code == 2 || !may_write(own, s) || s.files->failed()) return 2;
    to.push_back(std::move(program));
    return code;
}

/// As --format says, else the ending of the output's name.
std::string format_of(const Arguments& a) {
    if (!a.format_given)
        for (const std::string format : {"html", "json", "pdf"})
            if (a.output.ends_with("." + format)) return format;
    return a.format;
}

bool load_since(const Arguments& a, const std::vector<sheet_of::Program>& programs,
                std::optional<sheet_of::Since>& since) {
    if (a.since.empty()) return true;
    base::Diagnostics diagnostics;
    const auto text = driver::load_bytes(*driver::disk(), a.since, diagnostics);
    for (const base::Diagnostic& d : diagnostics.all()) std::fprintf(stderr, "obrys: --since: %s\n", d.text.c_str());
    if (!text) return false;
    since = sheet_of::since(a.since, *text, programs);
    if (!since)
        std::fprintf(stderr, "obrys: --since: %s is no sheet that this version has written (--format json)\n",
                     a.since.c_str());
    return since.has_value();
}

}  // namespace

int sheet(const Arguments& a) {
    std::vector<sheet_of::Program> programs;
    int exit = 0;
    for (const std::string& input : a.inputs) {
        const int code = take_program(a, input, programs);
        if (code == 2) return 2;
        exit = std::max(exit, code);
    }
    std::optional<sheet_of::Since> since;
    if (!load_since(a, programs, since)) return 2;
    const std::string format = format_of(a);
    const auto pages = sheet_of::pages(programs, {a.job}, since);
    const std::string text = format == "json"   ? sheet_of::as_json(programs)
                             : format == "html" ? sheet_of::as_html(pages)
                             : format == "pdf"  ? sheet_of::as_pdf(pages)
                                                : sheet_of::as_text(pages);
    return deliver(a.output, text) ? exit : 2;
}

}  // namespace obrys::cli
