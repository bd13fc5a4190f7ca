#include "shop/files/cutting/material_file.hpp"

#include <cassert>

#include "base/codes.hpp"
#include "shop/files/cutting/shipped_text.hpp"
#include "shop/files/section.hpp"

namespace obrys::shop {

namespace {

constexpr std::string_view iso_letters = "PMKNSH";
constexpr int vdi_groups = 41;

/// Complains about a key without which the table says nothing.
std::optional<double> needed(Section& s, std::string_view key, Range range) {
    if (!s.has(key)) s.missing(key);
    return s.number(key, range);
}

void read_chips(Section& s, KienzleLaw& law) {
    const Entry* e = s.take("h");
    if (!e) return;
    const auto fault = [&](const std::string& why) { s.error(base::codes::job_value, e->value.where, why); };
    if (e->value.kind != ValueKind::array || e->value.items.size() != 2)
        return fault("'h' must be an array of the thinnest and the thickest chip, mm");
    const auto low = finite_number(e->value.items[0], "the thinnest chip", Range::not_negative, s.diagnostics());
    const auto high = finite_number(e->value.items[1], "the thickest chip", Range::positive, s.diagnostics());
    if (!low || !high) return;
    if (*low >= *high) return fault("'h' must begin with the thinner chip");
    law.thinnest = *low;
    law.thickest = *high;
}

void read_kienzle(Section& material, WorkMaterial& m) {
    const Entry* e = material.sub_table("kienzle");
    if (!e) return;
    Section s(e->value, "'kienzle'", material.diagnostics());
    KienzleLaw law;
    const auto kc11 = needed(s, "kc11", Range::positive);
    const auto mc = needed(s, "mc", Range::not_negative);
    law.rake = s.number("rake0").value_or(0);
    read_chips(s, law);
    law.source = s.text("source").value_or("");
    if (!s.has("source")) s.missing("source");
    s.finish();
    if (mc && *mc >= 1)
        s.error(base::codes::job_value, find(e->value, "mc")->value.where, "'mc' must be less than 1",
                "from 0.15 to 0.35 as a rule");
    else if (kc11 && mc)
        law.kc11 = *kc11, law.mc = *mc, m.kienzle = std::move(law);
}

void read_linear(Section& material, WorkMaterial& m) {
    const Entry* e = material.sub_table("linear");
    if (!e) return;
    Section s(e->value, "'linear'", material.diagnostics());
    LinearLaw law;
    const auto tangential = needed(s, "Ktc", Range::positive);
    law.radial = s.number("Krc", Range::not_negative).value_or(0);
    law.axial = s.number("Kac", Range::not_negative).value_or(0);
    law.edge_tangential = needed(s, "Kte", Range::not_negative).value_or(0);
    law.edge_radial = s.number("Kre", Range::not_negative).value_or(0);
    law.edge_axial = s.number("Kae", Range::not_negative).value_or(0);
    law.tool = s.text("tool").value_or("");
    law.source = s.text("source").value_or("");
    if (!s.has("source")) s.missing("source");
    s.finish();
    if (tangential) law.tangential = *tangential, m.linear = std::move(law);
}

WorkMaterial read_material(const Entry& e, base::Diagnostics& diagnostics) {
    WorkMaterial m;
    m.name = e.key;
    m.where = e.where;
    Section s(e.value, "[material." + e.key + "]", diagnostics);
    if (e.value.kind != ValueKind::table) return m;
    m.names = s.texts("names");
    m.text = s.text("text").value_or(m.name);
    if (const auto letter = s.choice("iso", {"P", "M", "K", "N", "S", "H"})) m.iso = iso_letters[*letter];
    if (const auto group = s.integer("vdi", 1, vdi_groups)) m.vdi = static_cast<int>(*group);
    m.hardness = s.number("hb", Range::positive);
    m.density = s.number("density", Range::positive);
    m.elasticity = s.number("E", Range::positive);
    read_kienzle(s, m);
    read_linear(s, m);
    s.finish();
    if (!s.has("kienzle") && !s.has("linear"))
        s.error(base::codes::job_value, e.where, "material '" + e.key + "' has no law of its cutting force",
                "kienzle = {kc11, mc, source} or linear = {Ktc, Kte, source}");
    return m;
}

}  // namespace

std::vector<WorkMaterial> read_materials(std::uint32_t file, const base::Sources& sources,
                                         base::Diagnostics& diagnostics) {
    std::vector<WorkMaterial> all;
    const auto root = parse_toml(file, sources, diagnostics);
    if (!root) return all;
    base::Diagnostics found;
    Section s(*root, "the file of materials", found);
    if (const Entry* e = s.sub_table("material"))
        for (const Entry& material : e->value.entries) {
            WorkMaterial m = read_material(material, found);
            if (m.kienzle || m.linear) all.push_back(std::move(m));
        }
    if (!s.has("material"))
        s.error(base::codes::job_file, head(*root), "there is no material in this file",
                "[material.NAME], see docs/cutting-data.md");
    s.finish_file(diagnostics);
    return all;
}

const std::vector<WorkMaterial>& shipped_materials() {
    static const std::vector<WorkMaterial> all = [] {
        base::Sources sources;
        base::Diagnostics diagnostics;
        std::vector<WorkMaterial> read =
            read_materials(sources.add("materials.toml", std::string(shipped_material_text())), sources, diagnostics);
        assert(!diagnostics.has_errors());
        return read;
    }();
    return all;
}

}  // namespace obrys::shop
