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
#include "driver/tool_files.hpp"
#include "shop/files/document.hpp"
#include "shop/files/linuxcnc/ini.hpp"
#include "shop/files/linuxcnc/parameters.hpp"
#include "shop/files/obrys/job_file.hpp"
#include "shop/files/obrys/machine_file.hpp"
#include "shop/files/obrys/machine_name.hpp"

namespace obrys::driver {

namespace codes = base::codes;

namespace {

bool is_job(const fs::path& path) { return base::equals_ignoring_case(path.extension().string(), ".toml"); }

/// What a TOML file is, by its keys: somebody gave it as the program.
std::string kind_of_toml(std::uint32_t file, const base::Sources& sources) {
    base::Diagnostics unread;
    const auto root = shop::parse_toml(file, sources, unread);
    const auto has = [&](std::initializer_list<std::string_view> keys) {
        return root && std::any_of(keys.begin(), keys.end(),
                                   [&](std::string_view key) { return shop::find(*root, key) != nullptr; });
    };
    return has({"program", "stock", "part"}) ? "a job file"
           : has({"axis", "kind"})           ? "a machine file"
           : has({"tool"})                   ? "a list of tools"
                                             : "a TOML file";
}

bool is_no_program(Session& s, const fs::path& path, std::uint32_t file) {
    if (!is_job(path)) return false;
    complain(s.diagnostics, codes::job_value, s.job.program_where,
             s.sources[file].name + " is " + kind_of_toml(file, s.sources) + " and no NC program",
             "name the NC program; a job file is checked by itself");
    return true;
}

/// A job that names no program is about the one beside it that is called like it: ball.ngc of ball.job.toml.
std::string program_beside(const Storage& storage, const fs::path& job) {
    fs::path stem = job.stem();
    if (base::equals_ignoring_case(stem.extension().string(), ".job")) stem = stem.stem();
    std::vector<std::string> found;
    for (const fs::path& path : storage.list(job.parent_path())) {
        const std::string suffix = base::to_upper(path.extension().string());
        const auto is_program = [&](const Control& c) {
            return std::find(c.program_suffixes.begin(), c.program_suffixes.end(), suffix) != c.program_suffixes.end();
        };
        if (path.stem() == stem && std::any_of(all_controls().begin(), all_controls().end(), is_program))
            found.push_back(path.filename().string());
    }
    return found.size() == 1 ? found.front() : std::string{};
}

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

bool load_machine(Session& s, const fs::path& base_path, const std::string& name, const base::Span& where) {
    if (auto shipped = shop::shipped_machine(name)) {
        shop::use_machine(s.job, *shipped);
        return true;
    }
    if (s.storage->look(beside(base_path, name)).kind == StoredEntry::Kind::nothing &&
        !shop::names_machine_file(name)) {
        complain(s.diagnostics, codes::job_value, where, shop::no_shipped_machine(name),
                 shop::machine_name_remedy(name));
        return false;
    }
    const auto file = load(*s.storage, beside(base_path, name), s.sources, s.diagnostics, where);
    if (!file) return false;
    shop::use_machine(s.job, shop::read_machine(*file, s.sources, s.diagnostics));
    return true;
}

/// The machine that the call or the job names; false where it cannot be read. `named`: there is one.
bool load_named_machine(Session& s, const Request& request, const fs::path& job_path, bool& named) {
    const std::string name = !request.machine.empty() ? request.machine
                             : s.job.machine_is_file  ? s.job.machine_name
                                                      : std::string{};
    named = !name.empty() || (s.has_job && !s.job.machine_name.empty());
    const bool by_call = !request.machine.empty();
    return name.empty() ||
           load_machine(s, by_call ? fs::path{} : job_path, name, by_call ? nowhere : s.job.machine_where);
}

/// Tables and forms lie where called programs do, or where the job says.
void find_shop_files(Session& s, const Request& request, const fs::path& program) {
    s.files = std::make_unique<ShopFiles>(s.sources, s.diagnostics, request.folders);
    s.files->add_folder(program.parent_path());
    for (const std::string& folder : request.search) s.files->add_folder(folder);
    for (const shop::NamedFile& folder : s.job.search) s.files->add_folder(beside(request.input, folder.path));
    for (const shop::NamedFile& f : s.job.datum_tables) s.files->add_file(beside(request.input, f.path));
    s.files->set_force(request.force);
    s.files->keep(request.inputs, request.outputs);
    if (request.prints_nowhere) return;
    if (!request.prints.empty())
        s.files->print_to(request.prints);
    else if (!s.job.prints.empty())
        s.files->print_to(beside(request.input, s.job.prints));
}

/// Configuration and parameter file of a LinuxCNC machine. Without a configuration its stand-alone interpreter, which
/// canonical calls are compared with, takes a machine in inches.
void load_configuration(Session& s, const Request& request) {
    s.canon = request.canon;
    s.for_these_values = request.for_these_values;
    if (request.canon) s.machine_unit = 25.4;
    bool keeps_g92 = true;
    if (const auto file = request.configuration.empty()
                              ? std::nullopt
                              : load(*s.storage, request.configuration, s.sources, s.diagnostics)) {
        const shop::LinuxcncIni ini = shop::read_linuxcnc_ini(*file, s.sources, s.diagnostics);
        const shop::LinuxcncSettings set = shop::settings_of(ini, s.diagnostics);
        const double unit = set.mm_per_unit;
        keeps_g92 = set.g92_stays;
        s.spindle_goes_on = set.spindle_goes_on;
        if (!request.canon || shop::find(ini, "TRAJ", "LINEAR_UNITS") != nullptr) s.machine_unit = unit;
        for (const shop::IniEntry& e : ini.entries)
            s.settings.emplace(base::to_upper(e.section) + "/" + base::to_upper(e.key), e.value);
    }
    if (const auto file =
            request.stored.empty() ? std::nullopt : load(*s.storage, request.stored, s.sources, s.diagnostics)) {
        for (const auto& [n, v] : shop::values_of(shop::read_linuxcnc_parameters(*file, s.sources, s.diagnostics)))
            s.stored.emplace(static_cast<std::uint32_t>(n), keeps_g92 || n < 5210 || n > 5219 ? v : 0);
        s.has_stored = true;
    }
}

/// The program of the main file that the job names; a number without leading zeros is its name, too. False after a
/// complaint.
bool start_with_named(Session& s) {
    std::string all;
    for (const program::Unit* unit : s.programs->of_file(s.main->file)) {
        if (is_called(*unit, s.job.start)) {
            s.main = unit;
            return true;
        }
        all += (all.empty() ? "" : ", ") + unit->name;
    }
    complain(s.diagnostics, codes::job_value, s.job.start_where, "the program's file holds no \"" + s.job.start + '"',
             "programs in it: " + all);
    return false;
}

/// Bodies are read when they are needed; that they are there is seen at once.
void check_bodies(Session& s) {
    const auto look = [&](const shop::Solid& solid) {
        if (const auto* file = std::get_if<shop::SolidFile>(&solid))
            check_readable(*s.storage, beside(s.input, file->path), s.diagnostics, file->where);
    };
    if (s.job.solid_stock) look(s.job.solid_stock->solid);
    if (s.job.solid_part) look(shop::Solid(s.job.solid_part->file));
    for (const shop::Clamp& c : s.job.clamps) look(c.solid);
}

/// Backups of the control's variables that the job names; LinuxCNC's parameter file has a form of its own.
void load_backups(Session& s, const Request& request) {
    for (const shop::NamedFile& f : s.job.variables_files) {
        const fs::path path = beside(request.input, f.path);
        const auto file = load(*s.storage, path, s.sources, s.diagnostics, f.where);
        if (!file) continue;
        if (!base::equals_ignoring_case(path.extension().string(), ".var")) {
            s.programs->read_backup(*file);
            continue;
        }
        for (const auto& [n, v] : shop::values_of(shop::read_linuxcnc_parameters(*file, s.sources, s.diagnostics)))
            s.stored.emplace(static_cast<std::uint32_t>(n), v);
        s.has_stored = true;
    }
}

bool read_main(Session& s, const Request& request, const fs::path& path) {
    const auto file = request.text ? std::optional(s.sources.add(path.string() + " (as written)", *request.text))
                                   : load(*s.storage, path, s.sources, s.diagnostics, s.job.program_where);
    if (!file) return false;
    s.program = s.sources[*file].name;
    if (is_no_program(s, path, *file)) return false;
    bool named = false;
    if (!load_named_machine(s, request, request.input, named)) return false;
    // A job with turned stock, part or tools says that it is for a lathe.
    const bool lathe = s.job.machine.kind == shop::MachineKind::lathe, told = named || (s.has_job && lathe);
    const Control* control = choose_control(s, request, *file, told ? std::optional(lathe) : std::nullopt);
    if (control == nullptr) return false;
    s.programs = std::make_unique<Programs>(*control, s.sources, s.diagnostics, request.folders);
    s.programs->set_machine(told ? &s.job.machine : nullptr);
    s.programs->add_folder(path.parent_path());
    for (const std::string& folder : request.search) s.programs->add_folder(folder);
    for (const shop::NamedFile& folder : s.job.search) s.programs->add_folder(beside(request.input, folder.path));
    find_shop_files(s, request, path);
    s.main = s.programs->read(*file);
    if (s.main != nullptr && !s.job.start.empty() && !start_with_named(s)) return false;
    s.programs->read_definitions();
    if (s.main == nullptr) complain(s.diagnostics, codes::syntax, {*file, 0, 0}, "this file holds no program");
    if (s.main != nullptr && !named) choose_machine(s, request);
    return s.main != nullptr;
}

/// Every folder that the call or the job names is one.
bool folders_are_there(Session& s, const Request& request, const fs::path& input) {
    bool good = true;
    const auto require = [&](const fs::path& folder, const base::Span& where, const std::string& what) {
        if (s.storage->look(folder).kind == StoredEntry::Kind::folder) return;
        complain(s.diagnostics, codes::file_missing, where, what + " is not a folder");
        good = false;
    };
    for (const std::string& folder : request.search) require(folder, nowhere, "--search " + folder);
    for (const shop::NamedFile& folder : s.job.search)
        require(beside(input, folder.path), folder.where, "search: " + folder.path);
    const bool by_call = !request.prints.empty();
    if (by_call || !s.job.prints.empty())
        require(by_call ? fs::path(request.prints) : beside(input, s.job.prints),
                by_call ? nowhere : s.job.prints_where,
                (by_call ? request.prints : s.job.prints) + ", where programs shall print to,");
    return good;
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
      canon(shares->canon),
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

int exit_code_of_run(const Session& s) {
    bool finding = false, unchecked = false;
    for (const base::Diagnostic& d : s.diagnostics.all()) {
        finding = finding || base::kind_of(d.code) == base::CodeKind::finding;
        unchecked = unchecked || base::kind_of(d.code) == base::CodeKind::unchecked;
    }
    return refused(s) ? 2 : unchecked ? 3 : finding ? 1 : 0;
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
                  s.canon,
                  s.canon ? std::optional(geom::Vec3{}) : std::nullopt,
                  s.has_stored ? &s.stored : nullptr,
                  s.machine_unit,
                  &s.settings,
                  s.programs->searched(),
                  &read_text_,
                  std::max(s.job.tolerances.gouge, s.job.tolerances.simulation.value_or(0)),
                  &s.programs->backups(),
                  s.job.tool_lengths,
                  s.job.first_tool,
                  s.looked_ahead_in_vain} {}

namespace {
Session& with_settings(Session& s) {
    if (s.spindle_goes_on && !s.job.machine.tool_change_stops_spindle) s.job.machine.tool_change_stops_spindle = false;
    return s;
}
}  // namespace

Interpretation::Interpretation(Session& session, cl::Sink sink)
    : session_(with_settings(session)),
      parts_(session),
      machine_(*session.main, parts_.environment, session.stacks, sink, session.diagnostics) {}

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

interp::Outcome interpret(Session& s, cl::Sink sink) {
    Interpretation run(s, sink);
    while (run.step()) {
    }
    return run.finish();
}

}  // namespace obrys::driver
