#include "driver/cutting/tables.hpp"

#include "base/codes.hpp"
#include "driver/files.hpp"
#include "shop/files/cutting/material_file.hpp"
#include "shop/files/obrys/machine_file.hpp"
#include "shop/files/obrys/machine_name.hpp"

namespace obrys::driver::cutting {

std::optional<std::uint32_t> text_of(const std::string& path, Texts& texts) {
    return load(*disk(), path, texts.sources, texts.diagnostics);
}

std::optional<shop::Machine> machine_named(const std::string& name, Texts& texts) {
    if (auto shipped = shop::shipped_machine(name)) return shipped;
    if (disk()->look(name).kind == StoredEntry::Kind::nothing && !shop::names_machine_file(name)) {
        complain(texts.diagnostics, base::codes::job_value, nowhere, shop::no_shipped_machine(name),
                 shop::machine_name_remedy(name));
        return std::nullopt;
    }
    const auto file = text_of(name, texts);
    if (!file) return std::nullopt;
    shop::Machine machine = shop::read_machine(*file, texts.sources, texts.diagnostics);
    if (texts.diagnostics.has_errors()) return std::nullopt;
    return machine;
}

std::vector<shop::WorkMaterial> materials(const std::vector<MaterialFile>& files, const Storage& storage,
                                          base::Sources& sources, base::Diagnostics& diagnostics) {
    std::vector<shop::WorkMaterial> all;
    for (const MaterialFile& f : files) {
        const auto file = load(storage, f.path, sources, diagnostics, f.where);
        if (!file) continue;
        for (shop::WorkMaterial& m : shop::read_materials(*file, sources, diagnostics)) all.push_back(std::move(m));
    }
    all.insert(all.end(), shop::shipped_materials().begin(), shop::shipped_materials().end());
    return all;
}

std::optional<std::vector<shop::WorkMaterial>> materials(const std::vector<std::string>& files, Texts& texts) {
    std::vector<MaterialFile> named;
    for (const std::string& path : files) named.push_back({path, nowhere});
    auto all = materials(named, *disk(), texts.sources, texts.diagnostics);
    if (texts.diagnostics.has_errors()) return std::nullopt;
    return all;
}

const shop::WorkMaterial* material_named(const std::string& name, const std::vector<shop::WorkMaterial>& all,
                                         base::Diagnostics& diagnostics, const base::Span& where) {
    const shop::WorkMaterial* m = shop::find_material(all, name);
    if (m == nullptr)
        complain(diagnostics, base::codes::job_value, where, "there is no material \"" + name + "\"",
                 shop::material_remedy(all, name));
    return m;
}

}  // namespace obrys::driver::cutting
