/// obrys calibrate.

#include <cstdio>
#include <memory>

#include "commands.hpp"
#include "driver/files.hpp"
#include "driver/timing/calibration_text.hpp"
#include "driver/timing/test_program.hpp"
#include "driver/translate.hpp"
#include "milled.hpp"
#include "session.hpp"
#include "shop/files/obrys/machine_file.hpp"

namespace obrys::cli {

namespace {

/// The test program by a post.
int write_test_program(const Arguments& arguments) {
    Arguments a = arguments;
    if (a.to.empty()) {
        std::fputs("obrys calibrate: --program needs --to: a control or a post (obrys post list)\n", stderr);
        return 2;
    }
    a.request.input = "calibrate.ngc";
    a.request.control = "linuxcnc";
    a.request.text = std::make_shared<const std::string>(driver::test_program(a.size, a.feed));
    driver::Session s;
    if (!open(a, s)) return 2;
    const std::optional<write::Post> post = driver::find_post(a.to, s);
    if (!post || post->is_canon) {
        print_diagnostics(s, base::Severity::warning);
        if (post) std::fputs("obrys calibrate: canonical calls are no program of a control\n", stderr);
        return 2;
    }
    const std::string name = driver::said_name_in(*post, "CALIBRATE", s);
    const driver::Settled settled = driver::translate(s, *post, a.request, {name, false}, {});
    print_diagnostics(s, base::Severity::warning);
    if (settled.translated.ledger.has_lost() || settled.proved.differs) {
        std::fputs("obrys calibrate: by this post the program would not be what it is to be: nothing is written\n",
                   stderr);
        return 1;
    }
    return may_write(a, s) && deliver(a.output, *settled.translated.text) ? 0 : 2;
}

/// Texts that were read, and what is wrong with them.
struct Read {
    base::Sources sources;
    base::Diagnostics diagnostics;
    /// For people; the exit code is then 2.
    int failed() const {
        for (const base::Diagnostic& d : diagnostics.all()) std::fputs(base::render(d, sources).c_str(), stderr);
        return 2;
    }
};

bool may_write(const std::vector<driver::fs::path>& inputs, const Arguments& a) {
    std::vector<driver::Wanted> wanted;
    if (!a.output.empty()) wanted.push_back({"--output", a.output});
    const std::vector<std::string> refused = driver::refusals(wanted, inputs, a.request.force);
    for (const std::string& why : refused) std::fprintf(stderr, "obrys: %s\n", why.c_str());
    return refused.empty();
}

int fit_machine(const Arguments& a) {
    Read read;
    const driver::Storage& storage = *a.request.folders->storage();
    const auto machine = driver::load(storage, a.inputs[0], read.sources, read.diagnostics);
    const auto table = driver::load(storage, a.inputs[1], read.sources, read.diagnostics);
    if (!machine || !table) return read.failed();
    const shop::Machine as_it_is = shop::read_machine(*machine, read.sources, read.diagnostics);
    if (read.diagnostics.has_errors()) return read.failed();
    const auto runs = driver::read_runs(*table, read.sources, read.diagnostics);
    if (!runs) return read.failed();
    driver::Request request = a.request;
    request.machine = a.inputs[0];
    driver::Recorded recorded;
    if (!recorded.open(request, *table, *runs, read.sources, read.diagnostics)) {
        if (!recorded.programs().empty()) print_diagnostics(*recorded.programs().back(), base::Severity::warning);
        return read.failed();
    }
    std::vector<driver::fs::path> inputs(a.inputs.begin(), a.inputs.end());
    for (const auto& program : recorded.programs())
        for (driver::fs::path& path : driver::inputs_of(*program)) inputs.push_back(std::move(path));
    if (!may_write(inputs, a)) return 2;
    const driver::Calibration c = recorded.calibrate();
    int code = 0;
    for (const driver::FittedRun& run : c.runs)
        if (!run.not_whole.empty()) code = 3;
    const std::string shown = a.format == "json" ? as_json(c, a.inputs[0]) : as_text(c, a.inputs[0]);
    std::fputs(shown.c_str(), stdout);
    if (a.output.empty() || code == 3) {
        if (code == 3 && !a.output.empty())
            std::fputs("obrys: nothing is written, since a program is not timed fully\n", stderr);
        return code;
    }
    const auto text = shop::with_values(*machine, read.sources, new_values(c, as_it_is, a.inputs[1]));
    return text && deliver(a.output, *text) ? 0 : 2;
}

}  // namespace

int calibrate(const Arguments& a) {
    if (a.test_program) return write_test_program(a);
    if (a.inputs.size() == 2) return fit_machine(a);
    std::fputs(
        "obrys calibrate: needs a machine file and a table of runs (.csv), or --program\n"
        "  how it is called: obrys help calibrate\n",
        stderr);
    return 2;
}

}  // namespace obrys::cli
