#include "driver/session_files.hpp"

#include <algorithm>

#include "base/codes.hpp"
#include "base/number.hpp"
#include "base/text.hpp"
#include "driver/choose.hpp"
#include "driver/not_run.hpp"
#include "shop/files/document.hpp"
#include "shop/files/linuxcnc/ini.hpp"
#include "shop/files/linuxcnc/parameters.hpp"
#include "shop/files/obrys/machine_file.hpp"
#include "shop/files/obrys/machine_name.hpp"

namespace obrys::driver {

namespace codes = base::codes;

bool is_job(const fs::path& path) { return base::equals_ignoring_case(path.extension().string(), ".toml"); }

namespace {

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

}  // namespace

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

namespace {

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

}  // namespace

bool load_named_machine(Session& s, const Request& request, const fs::path& job_path, bool& named) {
    const std::string name = !request.machine.empty() ? request.machine
                             : s.job.machine_is_file  ? s.job.machine_name
                                                      : std::string{};
    named = !name.empty() || (s.has_job && !s.job.machine_name.empty());
    const bool by_call = !request.machine.empty();
    return name.empty() ||
           load_machine(s, by_call ? fs::path{} : job_path, name, by_call ? nowhere : s.job.machine_where);
}

namespace {

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

}  // namespace

void load_configuration(Session& s, const Request& request) {
    s.stand_alone = request.stand_alone;
    s.homes_at_zero = request.homes_at_zero;
    s.for_these_values = request.for_these_values;
    if (request.stand_alone) s.machine_unit = 25.4;
    bool keeps_g92 = true;
    if (const auto file = request.configuration.empty()
                              ? std::nullopt
                              : load(*s.storage, request.configuration, s.sources, s.diagnostics)) {
        const shop::LinuxcncIni ini = shop::read_linuxcnc_ini(*file, s.sources, s.diagnostics);
        const shop::LinuxcncSettings set = shop::settings_of(ini, s.diagnostics);
        const double unit = set.mm_per_unit;
        keeps_g92 = set.g92_stays;
        s.spindle_goes_on = set.spindle_goes_on;
        if (!request.stand_alone || shop::find(ini, "TRAJ", "LINEAR_UNITS") != nullptr) s.machine_unit = unit;
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

namespace {

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

}  // namespace

void check_bodies(Session& s) {
    const auto look = [&](const shop::Solid& solid) {
        if (const auto* file = std::get_if<shop::SolidFile>(&solid))
            check_readable(*s.storage, beside(s.input, file->path), s.diagnostics, file->where);
    };
    if (s.job.solid_stock) look(s.job.solid_stock->solid);
    if (s.job.solid_part) look(shop::Solid(s.job.solid_part->file));
    for (const shop::Clamp& c : s.job.clamps) look(c.solid);
}

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

namespace {

/// A text that others hold, too: it is there once.
class SharedText final : public base::Store {
public:
    explicit SharedText(std::shared_ptr<const std::string> text) : text_(std::move(text)) {}
    [[nodiscard]] std::string_view bytes() const override { return *text_; }
    void lay_aside(std::size_t, std::size_t) override {}
    bool fetch(std::size_t, std::size_t) override { return false; }

private:
    std::shared_ptr<const std::string> text_;
};

std::uint32_t add_written(Session& s, const Request& request, const fs::path& path) {
    return s.sources.add(path.string() + " (as written)", std::make_unique<SharedText>(request.text));
}

}  // namespace

bool read_main(Session& s, const Request& request, const fs::path& path) {
    const auto file = request.text ? std::optional(add_written(s, request, path))
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
    if (request.keeps_remarks) s.programs->keep_remarks();
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

}  // namespace obrys::driver
