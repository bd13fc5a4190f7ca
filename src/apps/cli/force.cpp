/// obrys force.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <utility>

#include "commands.hpp"
#include "driver/check_program.hpp"
#include "driver/cutting/tables.hpp"
#include "driver/files.hpp"
#include "driver/program_tools.hpp"
#include "driver/timing/time_program.hpp"
#include "milled.hpp"
#include "report/cutting/force.hpp"
#include "session.hpp"
#include "shop/files/cutting/job_cutting.hpp"

namespace obrys::cli {

namespace {

namespace times = sim::time;

/// How long each place of the program moves at feed, as the machine's profile has it; seconds.
using Planned = std::map<times::Place, double>;

Planned planned_times(const Arguments& a) {
    Planned planned;
    driver::Session s;
    driver::Request request = with_outputs(a);
    request.prints_nowhere = true;  // what the program prints is written once
    if (!driver::open(request, s)) return planned;
    const driver::Timing timing{driver::dynamics_of(s), {}};
    const std::vector<driver::Timed> timed = driver::time_program(s, {&timing, 1});
    for (const times::Spent& spent : timed.front().times.places)
        if (spent.cause < times::Cause::dwell && spent.cause != times::Cause::rapid)
            planned[spent.place] += spent.seconds;
    return planned;
}

/// Of its programmed feed, what each move goes at in the mean of its line.
std::vector<double> shares(const std::vector<check::MilledMove>& moves, const Planned& planned) {
    Planned programmed;
    for (const check::MilledMove& m : moves)
        if (!m.rapid && std::isfinite(m.seconds)) programmed[{m.where.file, m.where.begin}] += m.seconds;
    std::vector<double> all(moves.size(), 1);
    for (std::size_t i = 0; i < moves.size(); ++i) {
        const times::Place place{moves[i].where.file, moves[i].where.begin};
        const auto asked = std::as_const(programmed).find(place), got = planned.find(place);
        if (asked == programmed.end() || got == planned.end() || !(got->second > asked->second)) continue;
        constexpr double slowest = 0.01;
        all[i] = std::max(slowest, asked->second / got->second);
    }
    return all;
}

/// What the job says of its cuts; nothing where it is none.
shop::CuttingJob cutting_job(driver::Session& s, base::Diagnostics& found) {
    if (!s.has_job) return {};
    const auto file = driver::load(*s.storage, s.input, s.sources, found);
    return file ? shop::read_cutting_job(*file, s.sources, found) : shop::CuttingJob{};
}

/// What the workpiece is made of: as the call says, else the job. Nothing, and no complaint: nobody says it.
std::optional<shop::WorkMaterial> find_material(const Arguments& a, const shop::CuttingJob& job, driver::Session& s,
                                                base::Diagnostics& found) {
    std::vector<driver::cutting::MaterialFile> files;
    for (const std::string& path : a.cutting.materials) files.push_back({path, driver::nowhere});
    for (const auto& f : job.materials) files.push_back({driver::beside(s.input, f.path), f.where});
    const auto all = driver::cutting::materials(files, *s.storage, s.sources, found);
    const bool by_call = !a.cutting.material.empty();
    const std::string& name = by_call ? a.cutting.material : job.material;
    if (name.empty()) return std::nullopt;
    const shop::WorkMaterial* m =
        driver::cutting::material_named(name, all, found, by_call ? driver::nowhere : job.material_where);
    return m != nullptr ? std::optional(*m) : std::nullopt;
}

std::vector<std::string> gaps_of(const driver::Session& s, const check::Result& result) {
    std::vector<std::string> gaps;
    if (driver::exit_code_of_run(s) == 1) gaps.emplace_back("the control would stop with an alarm");
    if (result.unchecked.empty()) return gaps;
    const check::Note& first = result.unchecked.front();
    gaps.push_back((result.unchecked.size() == 1 ? "something" : std::to_string(result.unchecked.size()) + " things") +
                   " that the program does could not be run or simulated, the first: " + first.text);
    return gaps;
}

}  // namespace

int force(const Arguments& a) {
    driver::Session s;
    if (!open(a, s)) return 2;
    for (shop::Tool& tool : driver::program_tools(*s.main, s.job.tools, s.diagnostics))
        s.job.tools.push_back(std::move(tool));
    base::Diagnostics found;
    const shop::CuttingJob job = cutting_job(s, found);
    const std::optional<shop::WorkMaterial> material = find_material(a, job, s, found);
    for (const base::Diagnostic& d : found.all()) std::fputs(base::render(d, s.sources).c_str(), stderr);
    if (found.has_errors()) return 2;
    s.job.scope = shop::Scope::collisions;  // forces need no part
    const driver::Checked checked = driver::check_program(s, 0, a.milling);
    print_diagnostics(s, base::Severity::error);
    if (driver::refused(s) || !may_write(a, s) || s.files->failed()) return 2;
    if (checked.result.milled == nullptr) {
        std::fputs(
            "obrys force: not computed: there is no milling stock that was simulated\n"
            "  remedy: a job file with a [stock] of milling; of turning and drilling alone: obrys data --kind "
            "turning\n",
            stderr);
        return 3;
    }
    const Planned times = planned_times(a);
    const std::vector<double> planned = shares(checked.result.milled->moves, times);
    const shop::WorkMaterial* m = material ? &*material : nullptr;
    check::force::ForceResult forces = check::force::forces_of(checked.result, checked.setup, job, m, planned);
    std::vector<check::force::ForceFinding> findings =
        check::force::findings_of(forces, checked.result, checked.setup, job);
    const report::cutting::ForceSubject subject{s.sources,
                                                checked.result,
                                                checked.setup,
                                                job,
                                                s.program,
                                                s.control,
                                                m != nullptr ? m->text : "",
                                                gaps_of(s, checked.result),
                                                times.empty(),
                                                std::move(forces),
                                                std::move(findings)};
    const std::string text =
        a.format == "json" ? report::cutting::as_json(subject) : report::cutting::as_text(subject, {a.lines});
    if (!deliver(a.output, text)) return 2;
    if (!report::cutting::is_whole(subject)) return 3;
    return subject.findings.empty() ? 0 : 1;
}

}  // namespace obrys::cli
