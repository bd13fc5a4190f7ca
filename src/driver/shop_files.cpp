#include "driver/shop_files.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>

#include "base/codes.hpp"
#include "base/text.hpp"
#include "driver/output_file.hpp"

namespace obrys::driver {

namespace codes = base::codes;

namespace {

constexpr std::size_t longest_print = 64'000'000, most_files = 1000;

bool has_ending(const fs::path& path, std::string_view ending) {
    return base::equals_ignoring_case(path.extension().string(), ending);
}

/// The name of a file in the folder: no folders, nothing that leads out of it.
std::string safe_name(std::string_view name) {
    std::string safe;
    for (const char c : name) {
        const bool plain = base::is_letter(c) || base::is_digit(c) || c == '.' || c == '_' || c == '-';
        safe += plain ? c : '_';
    }
    while (!safe.empty() && safe.front() == '.') safe.erase(0, 1);
    return safe.empty() ? "PRINT.TXT" : safe.substr(0, 100);
}

}  // namespace

ShopFiles::ShopFiles(const ShopFiles& prepared, base::Sources& sources, base::Diagnostics& diagnostics)
    : sources_(sources),
      diagnostics_(diagnostics),
      listings_(prepared.listings_),
      files_(prepared.files_),
      named_(prepared.named_),
      prints_(prepared.prints_),
      inputs_(prepared.inputs_),
      outputs_(prepared.outputs_),
      force_(prepared.force_) {}

void ShopFiles::add_folder(const fs::path& folder) {
    const Folders::Paths found = listings_->shop_files(folder);
    files_.insert(files_.end(), found->begin(), found->end());
}

void ShopFiles::add_file(const fs::path& path) {
    files_.insert(files_.begin() + static_cast<std::ptrdiff_t>(named_), path);
    ++named_;
}

std::optional<fs::path> ShopFiles::path_of(std::string_view name) const {
    for (const fs::path& path : files_)
        if (full_name(path) == name) return path;
    return std::nullopt;
}

/// The first that the job names, else the only one that there is.
std::optional<fs::path> ShopFiles::usual_datum_table() const {
    std::vector<fs::path> others;
    for (std::size_t i = 0; i < files_.size(); ++i) {
        if (!has_ending(files_[i], ".d")) continue;
        if (i < named_) return files_[i];
        others.push_back(files_[i]);
    }
    return others.size() == 1 ? std::optional(others.front()) : std::nullopt;
}

const interp::DatumTable* ShopFiles::datum_table(std::string_view name) {
    std::string key = base::to_upper(name);
    if (!key.empty() && key.find('.') == std::string::npos) key += ".D";
    if (const auto known = datums_.find(key); known != datums_.end()) return known->second.get();
    auto& slot = datums_[key];
    std::optional<fs::path> path = path_of(key);
    if (key.empty()) {
        path = usual_datum_table();
        if (path)
            diagnostics_.add({base::Severity::note,
                              codes::assumption,
                              nowhere,
                              "the program selects no datum table: " + path->filename().string() + " is taken",
                              "write SEL TABLE before the first datum shift",
                              {},
                              {}});
    }
    const auto file = path ? load(*listings_->storage(), *path, sources_, diagnostics_) : std::nullopt;
    if (!file) return nullptr;
    const shop::HeidenhainTable read = shop::read_heidenhain_table(*file, sources_, diagnostics_);
    slot = std::make_unique<interp::DatumTable>(
        interp::DatumTable{path->filename().string(), shop::datums_of(read, diagnostics_)});
    return slot.get();
}

shop::HeidenhainTable* ShopFiles::table(std::string_view name) {
    const std::string key = base::to_upper(name);
    if (const auto known = tables_.find(key); known != tables_.end()) return known->second.get();
    auto& slot = tables_[key];
    const auto path = path_of(key);
    if (const auto file = path ? load(*listings_->storage(), *path, sources_, diagnostics_) : std::nullopt)
        slot = std::make_unique<shop::HeidenhainTable>(shop::read_heidenhain_table(*file, sources_, diagnostics_));
    return slot.get();
}

const std::string* ShopFiles::form(std::string_view name) {
    const std::string key = base::to_upper(name);
    if (const auto known = forms_.find(key); known != forms_.end()) return known->second.get();
    auto& slot = forms_[key];
    const auto path = path_of(key);
    if (const auto file = path ? load(*listings_->storage(), *path, sources_, diagnostics_) : std::nullopt)
        slot = std::make_unique<std::string>(base::as_utf8(sources_[*file].text));
    return slot.get();
}

bool ShopFiles::print(std::string_view name, std::string_view text, bool again) {
    if (!prints_) return false;
    const std::string file = safe_name(name);
    const auto known = printed_.find(file);
    if (known == printed_.end() && printed_.size() >= most_files) return false;
    if (known == printed_.end() && !again) {  // M_APPEND: behind what the file holds
        std::ifstream in(*prints_ / file, std::ios::binary);
        printed_[file].text = std::string(std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>());
    }
    std::string& content = printed_[file].text;
    printed_[file].replaces = printed_[file].replaces || again;
    if (again) content.clear();
    if (content.size() + text.size() > longest_print) return false;
    content += text;
    return true;
}

/// A program may print into any file of the folder, but not over what the run was made of.
bool ShopFiles::may_write(const fs::path& path, const Printed& printed) {
    std::vector<fs::path> inputs = inputs_;
    for (std::uint32_t i = 0; i < sources_.size(); ++i) inputs.emplace_back(sources_[i].name);
    auto why = refusals({{"printing", path.generic_string()}}, inputs, force_ || !printed.replaces);
    for (const fs::path& output : outputs_)
        if (is_same_file(path, output))
            why.push_back("printing: " + path.generic_string() + " is an output of this call (" +
                          output.generic_string() + "), which would replace the print");
    for (const std::string& text : why)
        diagnostics_.add({base::Severity::error, codes::file_missing, nowhere, text, {}, {}, {}});
    return why.empty();
}

bool ShopFiles::write_printed() {
    bool good = true;
    for (const auto& [name, printed] : printed_)
        good = may_write(*prints_ / name, printed) && store(*prints_ / name, printed.text, diagnostics_) && good;
    printed_.clear();
    failed_ = failed_ || !good;
    return good;
}

void add_presets(const Storage& storage, const fs::path& path, const base::Span& where, base::Sources& sources,
                 base::Diagnostics& diagnostics, shop::Machine& machine) {
    const auto file = load(storage, path, sources, diagnostics, where);
    if (!file) return;
    const auto presets = shop::datums_of(shop::read_heidenhain_table(*file, sources, diagnostics), diagnostics);
    for (const auto& [number, row] : presets) {
        const std::uint32_t datum = shop::first_preset + number;
        // Points could not be placed by it: better not known than known in part.
        const bool turned =
            std::any_of(row.rotary.begin(), row.rotary.end(), [](double v) { return v != 0 && !std::isnan(v); });
        if (turned && !machine.datums.contains(datum)) {
            diagnostics.add({base::Severity::note,
                             base::codes::assumption,
                             row.where,
                             "preset " + std::to_string(number) +
                                 " moves the zero of rotary axes, which is not followed: it counts as not known",
                             "",
                             {},
                             {}});
            continue;
        }
        if (!machine.datums.emplace(datum, row.position).second) continue;
        if (row.rotation != 0) machine.datum_rotations[datum] = row.rotation;
    }
}

}  // namespace obrys::driver
