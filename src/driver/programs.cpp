#include "driver/programs.hpp"

#include <algorithm>
#include <set>
#include <utility>

#include "base/codes.hpp"
#include "base/text.hpp"
#include "base/whole.hpp"

namespace obrys::driver {

namespace {

/// The file, with the archive headers of its members ("%_N_UGUD_DEF") turned into comments of the same length.
std::uint32_t without_headers(base::Sources& sources, std::uint32_t file) {
    std::string text(sources[file].text);
    bool changed = false;
    for (std::size_t at = text.find("%_N_"); at != std::string::npos; at = text.find("%_N_", at + 1)) {
        if (at > 0 && text[at - 1] != '\n' && text[at - 1] != '\r') continue;
        text[at] = ';';
        changed = true;
    }
    return changed ? sources.add(sources[file].name, std::move(text)) : file;
}

}  // namespace

void Programs::add_folder(const fs::path& folder) {
    folders_.push_back(folders_.empty() ? "the folder of the program" : folder.generic_string());
    found_.push_back(listings_->programs(folder, control_));
}

const fs::path* Programs::file_of(const std::string& name) const {
    for (const auto& index : found_)
        if (const auto path = index->files.find(name); path != index->files.end()) return &path->second;
    return nullptr;
}

std::string Programs::searched() const {
    std::string text;
    for (std::size_t i = 0; i < folders_.size(); ++i)
        text += (i == 0 ? "" : i + 1 == folders_.size() ? " or " : ", ") + folders_[i];
    for (std::size_t i = 0; i < control_.program_suffixes.size(); ++i)
        text += (i == 0 ? " (" : ", ") + std::string(control_.program_suffixes[i]);
    return control_.program_suffixes.empty() ? text : text + ")";
}

std::vector<std::shared_ptr<const program::Unit>> Programs::units_of(std::uint32_t file) {
    const Language& language = language_of(control_, sources_[file].text, sources_[file].name);
    sources_.set_block_numbers(file, language.numbers);
    std::vector<std::shared_ptr<const program::Unit>> all;
    std::vector<program::Unit> units = language.read(file, sources_, names_, *diagnostics_, machine_);
    const bool remarks = keeps_remarks_ && language.remarks.any();
    if (remarks) sources_.fetch(file);
    for (program::Unit& unit : units) {
        if (remarks) program::add_remarks(unit, sources_[file].text, language.remarks);
        all.push_back(std::make_shared<const program::Unit>(std::move(unit)));
    }
    if (remarks) sources_.lay_aside(file, static_cast<std::uint32_t>(sources_[file].text.size()));
    return all;
}

const program::Unit* Programs::read(std::uint32_t file) { return enter(units_of(file)); }

const program::Unit* Programs::enter(std::vector<std::shared_ptr<const program::Unit>> units) {
    const program::Unit* first = nullptr;
    for (std::shared_ptr<const program::Unit>& unit : units) {
        const fs::path path(sources_[unit->file].name);
        const std::string suffix = base::to_upper(path.extension().string());
        const program::Unit* held = units_.emplace_back(std::move(unit)).get();
        const fs::path* plain = file_of(held->name);  // of PART.H and PART.I one only is called PART
        const bool own = control_.file_stem != nullptr && first != nullptr;  // what a text defines is found there
        if (own || plain == nullptr || full_name(*plain) == full_name(path)) by_name_.emplace(held->name, held);
        by_name_.emplace(held->name + suffix, held);
        if (first == nullptr) first = held;
    }
    return first;
}

const program::Unit* Programs::read_file(const fs::path& path) {
    if (const auto known = ahead_.find(path); known != ahead_.end()) {
        for (base::Diagnostic& d : known->second.said) diagnostics_->add(std::move(d));
        const auto units = std::move(known->second.units);
        ahead_.erase(known);
        return enter(units);
    }
    const auto file = load_program(path);
    return file ? read(*file) : nullptr;
}

std::optional<std::uint32_t> Programs::load_program(const fs::path& path) {
    const auto file = load(*listings_->storage(), path, sources_, *diagnostics_);
    if (file && control_.file_stem == nullptr) say_twin(*file, full_name(path));
    return file;
}

Programs::Programs(const Programs& prepared, base::Sources& sources, base::Diagnostics& diagnostics)
    : control_(prepared.control_),
      sources_(sources),
      diagnostics_(&diagnostics),
      machine_(prepared.machine_),
      keeps_remarks_(prepared.keeps_remarks_),
      names_(&prepared.names_),
      units_(prepared.units_),
      definitions_(prepared.definitions_),
      backups_(prepared.backups_),
      backup_units_(prepared.backup_units_),
      by_name_(prepared.by_name_),
      listings_(prepared.listings_),
      found_(prepared.found_),
      texts_(prepared.texts_),
      folders_(prepared.folders_),
      ahead_(prepared.ahead_) {}

namespace {

/// The program that a call names without anything having been run; empty: it depends on values.
std::string called_name(const program::Unit& unit, const program::Call& call, const program::Names& names) {
    if (call.target == program::no_expr) return names.text(call.name);
    const program::Expr& target = unit.exprs[call.target];
    if (!unit.traits->programs_by_number || target.kind != program::ExprKind::number) return {};
    const auto number = base::whole<std::uint32_t>(unit.numbers[target.a], 0, 99'999'999);
    return number ? "O" + std::to_string(*number) : std::string{};
}

}  // namespace

std::vector<fs::path> Programs::files_of(const std::string& name) const {
    std::vector<std::string> stems{name};
    if (control_.file_stem != nullptr) stems.insert(stems.begin(), control_.file_stem(name));
    const fs::path written(name);
    if (control_.file_stem == nullptr && has_suffix(written, control_.program_suffixes))
        stems.push_back(written.stem().string());
    std::vector<fs::path> files;
    for (const std::string& stem : stems)
        if (const fs::path* path = file_of(stem)) files.push_back(*path);
    return files;
}

void Programs::read_called() {
    std::vector<std::shared_ptr<const program::Unit>> open = units_;
    std::set<fs::path> seen;
    for (std::uint32_t i = 0; i < sources_.size(); ++i) seen.insert(sources_[i].name);
    const auto read = [&](const fs::path& path) {
        if (!seen.insert(path).second) return;
        base::Diagnostics apart;
        base::Diagnostics* const said = std::exchange(diagnostics_, &apart);
        if (const auto file = load_program(path)) {
            Read r{units_of(*file), apart.all()};
            open.insert(open.end(), r.units.begin(), r.units.end());
            ahead_.emplace(path, std::move(r));
        }  // else the run that calls it says why
        diagnostics_ = said;
    };
    while (!open.empty()) {
        const std::shared_ptr<const program::Unit> unit = std::move(open.back());
        open.pop_back();
        for (const program::Call& call : unit->calls)
            if (const std::string name = called_name(*unit, call, names_); !name.empty())
                for (const fs::path& path : files_of(name)) read(path);
    }
}

const program::Unit* Programs::find(std::string_view name) {
    const std::string key(name);
    if (const auto known = by_name_.find(key); known != by_name_.end()) return known->second;
    if (control_.file_stem != nullptr) return find_in_file(key);
    const program::Unit* unit = nullptr;
    if (const fs::path* path = file_of(key); path == nullptr) {
        const fs::path written(key);
        if (has_suffix(written, control_.program_suffixes)) unit = find(written.stem().string());
    } else if (const std::string full = full_name(*path); full != key) {
        unit = find(full);
    } else {
        unit = read_file(*path);
    }
    by_name_[key] = unit;
    return unit;
}

void Programs::say_twin(std::uint32_t file, const std::string& full) {
    for (const auto& index : found_) {
        const auto twin = index->twins.find(full);
        if (index->files.find(full) == index->files.end()) continue;
        if (twin == index->twins.end()) return;
        diagnostics_->add(
            {base::Severity::error,
             base::codes::unknown_value,
             {file, 0, 0},
             fs::path(sources_[file].name).filename().string() + " and " + twin->second.filename().string() +
                 " differ in small and capital letters alone: which of them the control has is not known, "
                 "the first one is run",
             "leave one of them in the folder",
             {},
             {}});
        return;
    }
}

const program::Unit* Programs::read_text(const std::string& text) {
    const auto [known, is_new] = texts_.try_emplace(text, nullptr);
    if (!is_new) return known->second;
    const auto units = units_of(sources_.add("text of the program", text));
    units_.insert(units_.end(), units.begin(), units.end());
    if (!units.empty()) known->second = units.front().get();
    return known->second;
}

const program::Unit* Programs::find_in_file(const std::string& key) {
    const program::Unit* found = nullptr;
    for (const std::string& stem : {control_.file_stem(key), key}) {
        const fs::path* path = file_of(stem);
        if (found != nullptr || path == nullptr || by_name_.contains(full_name(*path))) continue;
        const std::size_t before = units_.size();
        read_file(*path);
        for (std::size_t i = before; i < units_.size(); ++i)  // the last: the first is the file as a whole
            if (units_[i]->name == key) found = units_[i].get();
    }
    by_name_[key] = found;
    return found;
}

std::vector<const program::Unit*> Programs::of_file(std::uint32_t file) const {
    std::vector<const program::Unit*> found;
    for (const auto& unit : units_)
        if (unit->file == file) found.push_back(unit.get());
    return found;
}

void Programs::read_backup(std::uint32_t file) {
    for (const auto& unit : units_of(without_headers(sources_, file))) {
        backup_units_.push_back(unit);
        backups_.push_back(unit.get());
    }
}

void Programs::read_definitions() {
    for (const auto& index : found_)
        for (const fs::path& path : index->definition_files) read_definition(path);
}

void Programs::read_definition(const fs::path& path) {
    const auto file = load(*listings_->storage(), path, sources_, *diagnostics_);
    if (!file) return;
    if (control_.is_definition != nullptr && !control_.is_definition(sources_[*file].text, full_name(path))) {
        diagnostics_->add({base::Severity::note,
                           base::codes::no_effect,
                           {*file, 0, 0},
                           path.filename().string() + " defines no global user data of the control: it is not read",
                           {},
                           {},
                           {}});
        return;
    }
    if (const program::Unit* unit = read(without_headers(sources_, *file))) definitions_.push_back(unit);
}

}  // namespace obrys::driver
