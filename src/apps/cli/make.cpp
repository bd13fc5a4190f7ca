/// obrys make.

#include <algorithm>
#include <cstdio>

#include "cl/text.hpp"
#include "commands.hpp"
#include "driver/files.hpp"
#include "driver/stream_file.hpp"
#include "driver/translate.hpp"
#include "make/made.hpp"
#include "milled.hpp"
#include "session.hpp"
#include "translated.hpp"

namespace obrys::cli {

namespace {

/// The job beside a program: GROOVE.job.toml of GROOVE.MPF.
std::string job_path_of(const std::string& program) {
    return driver::fs::path(program).replace_extension(".job.toml").string();
}

bool may_write_files(const Arguments& a, const std::vector<std::string>& files) {
    std::vector<driver::Wanted> wanted;
    for (const std::string& file : files) wanted.push_back({"--output", file});
    const auto refused = driver::refusals(wanted, {a.request.input}, a.request.force);
    for (const std::string& why : refused) std::fprintf(stderr, "obrys: %s\n", why.c_str());
    return refused.empty();
}

int deliver_table(const Arguments& a, const make::Order& order) {
    const std::vector<make::Made> all = make::compare_strategies(order);
    const std::string table = a.format == "json"  ? make::table_as_json(order, all)
                              : a.format == "csv" ? make::table_as_csv(all)
                                                  : make::table_as_text(order, all);
    if (!a.output.empty() && !may_write_files(a, {a.output})) return 2;
    if (!deliver(a.output, table)) return 2;
    // What the first slot alone leaves is no fault of the table.
    const bool unsafe =
        std::any_of(all.begin(), all.end(), [](const make::Made& m) { return !m.refusal && !make::is_safe(m); });
    return unsafe ? 1 : 0;
}

/// The stream as a program of another control, run again there.
int write_program(const Arguments& a, const make::Order& order, const make::Made& made, const std::string& stream) {
    const driver::fs::path output(a.output);
    const std::string name = output.stem().string(), file = name + ".cl";
    const auto memory = std::make_shared<driver::Memory>(driver::disk());
    memory->put(file, stream);
    driver::Request request;
    request.input = file;
    request.machine = "lathe-generic";
    request.folders = std::make_shared<driver::Folders>(memory);
    driver::Session s;
    if (!driver::open_stream(request, s)) return print_diagnostics(s, base::Severity::warning), 2;
    const std::optional<write::Post> post = driver::find_post(a.to, s);
    if (!post) return print_diagnostics(s, base::Severity::warning), 2;
    const driver::Settled settled =
        driver::translate(s, *post, request, {driver::said_name_in(*post, name, s), false}, {});
    print_diagnostics(s, base::Severity::warning);
    const driver::Proved& proved = settled.proved;
    if (proved.differs || settled.translated.ledger.has_lost())
        return std::fputs("obrys: nothing is written, since something is lost or differs\n", stderr), 1;
    std::vector<std::string> files{a.output};
    const auto job = make::job_of(order, made, output.filename().string(), post->control);
    if (job) files.push_back(job_path_of(a.output));
    if (!may_write_files(a, files)) return 2;
    if (!deliver(a.output, *settled.translated.text) || (job && !deliver(files.back(), *job))) return 2;
    if (!job) std::fputs("no job is written: it is for grooves outside\n", stderr);
    if (!proved.why_not.empty()) std::fprintf(stderr, "not compared: %s\n", proved.why_not.c_str());
    return proved.proof == driver::Proof::same ? 0 : 3;
}

}  // namespace

int make_program(const Arguments& a) {
    driver::Session s;
    s.input = s.program = a.request.input;
    const auto file = driver::load(*driver::disk(), a.request.input, s.sources, s.diagnostics, driver::nowhere,
                                   driver::Signs::refuse);
    const std::optional<make::Order> order =
        file ? make::read_order(*file, s.sources, s.diagnostics) : std::optional<make::Order>();
    print_diagnostics(s, base::Severity::warning);
    if (!order) return 2;
    if (a.make.compare) return deliver_table(a, *order);
    auto strategy = cycles::groove::Strategy::side_stepping;
    for (const cycles::groove::Named& n : cycles::groove::strategies())
        if (n.word == a.make.strategy) strategy = n.strategy;
    const make::Made made = make::make_groove(*order, strategy);
    const std::string report = a.format == "json" ? make::as_json(*order, made) : make::as_text(*order, made);
    int code = make::exit_code_of(made);
    if (make::is_safe(made) && !a.output.empty()) {
        const std::string stream = cl::to_text(make::stream_of(*order, made));
        if (!a.to.empty())
            code = std::max(code, write_program(a, *order, made, stream));
        else if (!may_write_files(a, {a.output}) || !deliver(a.output, stream))
            code = 2;
    }
    std::fputs(report.c_str(), stdout);
    return code;
}

}  // namespace obrys::cli
