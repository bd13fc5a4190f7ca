#include "driver/session.hpp"

#include <algorithm>

#include "base/codes.hpp"
#include "base/number.hpp"
#include "base/text.hpp"
#include "driver/choose.hpp"
#include "driver/contours.hpp"
#include "driver/first_tool.hpp"
#include "driver/not_run.hpp"
#include "driver/overrides.hpp"
#include "driver/session_files.hpp"
#include "driver/tool_files.hpp"
#include "shop/files/document.hpp"
#include "shop/files/linuxcnc/ini.hpp"
#include "shop/files/linuxcnc/parameters.hpp"
#include "shop/files/obrys/job_file.hpp"

namespace obrys::driver {

namespace codes = base::codes;

namespace {

/// R3=150 of the command line.
bool take_override(Session& s, const std::string& text) {
    const auto equal = text.find('=');
    const std::string name = base::to_upper(base::trim(std::string_view(text).substr(0, equal)));
    const auto value =
        equal == std::string::npos ? std::nullopt : base::parse_double(std::string_view(text).substr(equal + 1));
    if (name.empty() || !value) {
        complain(s.diagnostics, codes::job_value, nowhere, "--set " + text + " is not of the form NAME=NUMBER",
                 "write for example --set R3=150");
        return false;
    }
    auto& all = s.job.overrides;
    std::erase_if(all, [&](const shop::Override& o) { return o.name == name; });
    all.push_back({name, *value, nowhere});
    return true;
}

/// A lathe turns what a profile describes, a mill removes from bodies.
bool fits_machine(Session& s) {
    const bool lathe = s.job.machine.kind == shop::MachineKind::lathe;
    if (lathe && s.job.solid_stock)
        complain(s.diagnostics, codes::job_value, s.job.solid_stock->where,
                 "this stock is one of milling, and the machine is a lathe",
                 "describe it with bar, tube, cone or profile");
    else if (!lathe && s.job.stock)
        complain(s.diagnostics, codes::job_value, s.job.stock->where, "this stock is turned, and the machine is a mill",
                 "describe it with box, cylinder or file, or name a lathe as the machine");
    else
        return true;
    return false;
}

}  // namespace

Session::Session(std::shared_ptr<const Session> opened)
    : shares(std::move(opened)),
      storage(shares->storage),
      sources(shares->sources),
      diagnostics(shares->diagnostics),
      job(shares->job),
      program(shares->program),
      input(shares->input),
      control(shares->control),
      programs(std::make_unique<Programs>(*shares->programs, sources, diagnostics)),
      files(shares->files == nullptr ? nullptr : std::make_unique<ShopFiles>(*shares->files, sources, diagnostics)),
      main(shares->main),
      part(shares->part),
      allowance(shares->allowance),
      right_face(shares->right_face),
      stored(shares->stored),
      settings(shares->settings),
      machine_unit(shares->machine_unit),
      has_stored(shares->has_stored),
      spindle_goes_on(shares->spindle_goes_on),
      stand_alone(shares->stand_alone),
      homes_at_zero(shares->homes_at_zero),
      has_job(shares->has_job),
      looked_ahead_in_vain(shares->looked_ahead_in_vain),
      unusable(shares->unusable) {}

std::vector<std::string> controls() {
    std::vector<std::string> names;
    for (const Control& c : all_controls()) names.emplace_back(c.name);
    return names;
}

bool open(const Request& request, Session& s) {
    const fs::path input(request.input);
    s.storage = request.folders->storage();
    s.input = request.input;
    fs::path program = input;
    if (is_job(input)) {
        const auto file = load(*s.storage, input, s.sources, s.diagnostics, nowhere, Signs::refuse);
        if (!file) return false;
        s.job = shop::read_job(*file, s.sources, s.diagnostics);
        s.has_job = true;
        if (!request.program.empty()) s.job.program = request.program, s.job.control.clear(), s.job.start.clear();
        if (s.job.program.empty()) s.job.program = program_beside(*s.storage, input);
        if (s.job.program.empty() && !s.diagnostics.has_errors())
            complain(s.diagnostics, codes::job_value, s.job.program_where, "the job file has no 'program'",
                     "name it, or put one program with the job's name beside the job");
        if (s.job.program.empty() || s.diagnostics.has_errors()) return false;
        program = request.program.empty() ? beside(input, s.job.program) : fs::path(request.program);
    }
    if (request.text) s.job.overrides.clear(), s.job.variables = request.given, s.job.start.clear();
    bool good = known_control(s, request.control, nowhere) && known_control(s, s.job.control, s.job.control_where);
    for (const std::string& text : request.set) good = take_override(s, text) && good;
    good = folders_are_there(s, request, input) && good;
    if (!good || !read_main(s, request, program) || !fits_machine(s)) return false;
    s.job.skip_levels.insert(s.job.skip_levels.end(), request.skip.begin(), request.skip.end());
    if (request.scope) s.job.scope = *request.scope;
    if (request.diameter) s.job.machine.defaults.diameter_programming = *request.diameter;
    settle_diameters(s, request);
    load_configuration(s, request);
    load_backups(s, request);
    load_tools(s, request, input);
    number_offsets(s.main->traits->edge_is_offset_number, s.job.tools);
    s.job.first_tool = first_tool(s.job, *s.main, s.diagnostics);
    for (const shop::NamedFile& f : s.job.preset_tables)
        add_presets(*s.storage, beside(input, f.path), f.where, s.sources, s.diagnostics, s.job.machine);
    for (const shop::NamedFile& f : s.job.datum_tables)
        check_readable(*s.storage, beside(input, f.path), s.diagnostics, f.where);
    check_bodies(s);
    resolve_contours(s, input);
    return !std::any_of(s.diagnostics.all().begin(), s.diagnostics.all().end(), [](const base::Diagnostic& d) {
        return d.severity == base::Severity::error && base::kind_of(d.code) == base::CodeKind::input;
    });
}

bool refused(const Session& s) {
    return s.unusable ||
           std::any_of(s.diagnostics.all().begin(), s.diagnostics.all().end(), [](const base::Diagnostic& d) {
               return d.severity == base::Severity::error && (d.code == codes::job_value || d.code == codes::job_file);
           });
}

static int exit_code_without(const Session& s, bool (*leaves_out)(const base::Diagnostic&)) {
    bool finding = false, unchecked = false;
    for (const base::Diagnostic& d : s.diagnostics.all()) {
        if (leaves_out != nullptr && leaves_out(d)) continue;
        finding = finding || base::kind_of(d.code) == base::CodeKind::finding;
        unchecked = unchecked || base::kind_of(d.code) == base::CodeKind::unchecked;
    }
    return refused(s) ? 2 : unchecked ? 3 : finding ? 1 : 0;
}

int exit_code_of_run(const Session& s) { return exit_code_without(s, nullptr); }

int exit_code_of_translation(const Session& s) { return exit_code_without(s, is_of_no_run); }

double increment_of(const Session& s) {
    if (s.main == nullptr || !s.main->traits->counts_increments) return 0;
    const double per_mm = s.job.machine.control.increments_per_mm.value_or(s.main->traits->increments_per_mm);
    return per_mm > 0 ? 1 / per_mm : 0;
}

int percent_lines(const Session& s) {
    int found = 0;
    bool first = true;
    const std::uint32_t lines = s.sources.position(s.main->file, s.main->end).line;
    for (std::uint32_t n = 1; n <= lines && found < 2; ++n) {
        const std::string_view line = base::trim(s.sources.line(s.main->file, n));
        if (line.empty()) continue;
        if (line == "%") ++found;
        if (first && found == 0) return 0;
        first = false;
    }
    return found;
}

EnvironmentOf::EnvironmentOf(Session& s)
    : find_([&s](std::string_view name) { return s.programs->find(name); }),
      read_text_([&s](const std::string& text) { return s.programs->read_text(text); }),
      environment{s.sources,
                  s.programs->names(),
                  s.job.machine,
                  s.job.tools,
                  s.job.overrides,
                  s.job.budgets,
                  s.job.skip_levels,
                  find_,
                  s.programs->definitions(),
                  s.job.variables,
                  s.files.get(),
                  s.stand_alone,
                  s.stand_alone ? std::optional(geom::Vec3{}) : std::nullopt,
                  s.has_stored ? &s.stored : nullptr,
                  s.machine_unit,
                  &s.settings,
                  s.programs->searched(),
                  &read_text_,
                  std::max(s.job.tolerances.gouge, s.job.tolerances.simulation.value_or(0)),
                  &s.programs->backups(),
                  s.job.tool_lengths,
                  s.job.first_tool,
                  s.homes_at_zero,
                  s.looked_ahead_in_vain} {}

namespace {

Session& with_settings(Session& s) {
    if (s.spindle_goes_on && !s.job.machine.tool_change_stops_spindle) s.job.machine.tool_change_stops_spindle = false;
    return s;
}

}  // namespace

Interpretation::Interpretation(Session& session, cl::Sink sink, std::optional<interp::Listener> listener)
    : session_(with_settings(session)),
      parts_(session),
      machine_(*session.main, parts_.environment, session.stacks, sink, session.diagnostics, listener) {}

interp::Outcome Interpretation::finish() {
    Session& s = session_;
    interp::Outcome outcome = machine_.finish();
    const auto in_file = s.programs->of_file(s.main->file);
    const bool subs_alone = holds_subprograms_alone(in_file, outcome.entered, *s.main);
    if (outcome.ending == interp::Ending::regular || subs_alone)
        say_what_was_not_run(
            in_file, s.for_these_values ? led_to(in_file, outcome.entered, s.programs->names()) : outcome.entered,
            subs_alone || !outcome.entered.empty(), s.diagnostics);
    check_overrides(s, outcome);
    if (s.files) s.files->write_printed();  // none where a session was put together without files
    return outcome;
}

interp::Outcome interpret(Session& s, cl::Sink sink, std::optional<interp::Listener> listener) {
    Interpretation run(s, sink, listener);
    while (run.step()) {
    }
    return run.finish();
}

}  // namespace obrys::driver
