#include "driver/folders.hpp"

#include <algorithm>
#include <iterator>

#include "base/text.hpp"

namespace obrys::driver {

namespace {

/// "O20" of O0020.nc and of O0020 without an ending; empty for other names.
std::string program_number(const fs::path& path) {
    std::string stem = base::to_upper(path.stem().string());
    if (stem.size() < 2 || stem[0] != 'O' || stem.find_first_not_of("0123456789", 1) != std::string::npos) return {};
    const std::size_t digits = std::min(stem.find_first_not_of('0', 1), stem.size() - 1);
    return stem.erase(1, digits - 1);
}

bool is_shop_file(const fs::path& path) {
    const std::string ending = path.extension().string();
    for (const std::string_view one : {".d", ".tab", ".a", ".pnt"})
        if (base::equals_ignoring_case(ending, one)) return true;
    return false;
}

ProgramIndex index_of(const std::vector<fs::path>& found, const Control& control) {
    ProgramIndex index;
    const auto add = [&](std::string name, const fs::path& path) {
        index.files.emplace(std::move(name), path);
        const auto [first, is_new] = index.files.emplace(full_name(path), path);
        if (!is_new && first->second != path) index.twins.emplace(first->first, path);
    };
    for (const std::string_view suffix : control.program_suffixes)
        for (const fs::path& path : found)
            if (has_suffix(path, {&suffix, 1})) add(base::to_upper(path.stem().string()), path);
    for (const fs::path& path : found) {
        const std::string number = program_number(path);
        if (!number.empty() && (!path.has_extension() || has_suffix(path, control.program_suffixes))) add(number, path);
    }
    for (const fs::path& path : found)
        if (has_suffix(path, control.definition_suffixes)) index.definition_files.push_back(path);
    return index;
}

}  // namespace

bool has_suffix(const fs::path& path, std::span<const std::string_view> suffixes) {
    const std::string suffix = base::to_upper(path.extension().string());
    return std::find(suffixes.begin(), suffixes.end(), suffix) != suffixes.end();
}

std::string full_name(const fs::path& path) { return base::to_upper(path.filename().string()); }

Folders::Listed& Folders::listed(const fs::path& named) {
    const fs::path folder = named.empty() ? fs::path(".") : named;
    const std::optional<std::int64_t> changed = storage_->changed(folder);
    Listed& l = folders_[folder];
    if (l.paths != nullptr && changed && l.changed == changed) return l;
    std::vector<fs::path> found = storage_->list(folder);
    std::sort(found.begin(), found.end());
    l = {changed, std::make_shared<const std::vector<fs::path>>(std::move(found)), nullptr, {}};
    return l;
}

Folders::Paths Folders::list(const fs::path& folder) { return listed(folder).paths; }

std::shared_ptr<const ProgramIndex> Folders::programs(const fs::path& folder, const Control& control) {
    Listed& l = listed(folder);
    auto& index = l.programs[&control];
    if (index == nullptr) index = std::make_shared<const ProgramIndex>(index_of(*l.paths, control));
    return index;
}

Folders::Paths Folders::shop_files(const fs::path& folder) {
    Listed& l = listed(folder);
    if (l.shop_files == nullptr) {
        std::vector<fs::path> found;
        std::copy_if(l.paths->begin(), l.paths->end(), std::back_inserter(found), is_shop_file);
        l.shop_files = std::make_shared<const std::vector<fs::path>>(std::move(found));
    }
    return l.shop_files;
}

}  // namespace obrys::driver
