/// obrys blade.

#include "report/cutting/blade.hpp"
#include "base/codes.hpp"
#include "commands.hpp"
#include "driver/cutting/tables.hpp"
#include "driver/files.hpp"
#include "milled.hpp"
#include "session.hpp"
#include "shop/files/cutting/blade_file.hpp"

namespace obrys::cli {

namespace {

/// False after a complaint.
bool set_material(const Arguments& a, shop::Blade& blade, driver::cutting::Texts& texts) {
    if (blade.material.empty()) return true;
    const auto all = driver::cutting::materials(a.cutting.materials, texts);
    if (!all) return false;
    const shop::WorkMaterial* m =
        driver::cutting::material_named(blade.material, *all, texts.diagnostics, blade.material_where);
    if (m == nullptr) return false;
    if (!m->elasticity || !m->density) {
        driver::complain(texts.diagnostics, base::codes::job_value, blade.material_where,
                         "material '" + m->name + "' says nothing of its " + (m->elasticity ? "density" : "elasticity"),
                         "E = 70000 (N/mm2) and density = 2700 (kg/m3) in the place of 'material'");
        return false;
    }
    blade.elasticity = *m->elasticity;
    blade.density = *m->density;
    return true;
}

}  // namespace

int blade(const Arguments& a) {
    driver::cutting::Texts texts;
    std::vector<driver::fs::path> inputs(a.cutting.materials.begin(), a.cutting.materials.end());
    inputs.emplace_back(a.request.input);
    if (!may_write(a, inputs)) return 2;
    report::cutting::BladeSubject subject{a.request.input, {}, {}};
    const auto file = driver::cutting::text_of(a.request.input, texts);
    if (file) subject.blade = shop::read_blade(*file, texts.sources, texts.diagnostics);
    const bool good = file && !texts.diagnostics.has_errors() && set_material(a, subject.blade, texts);
    print_diagnostics(texts);
    if (!good) return 2;
    subject.result = sim::beam::study(subject.blade);
    const std::string text = a.format == "json" ? report::cutting::as_json(subject) : report::cutting::as_text(subject);
    if (!deliver(a.output, text)) return 2;
    return report::cutting::any_rings(subject.result) ? 1 : 0;
}

}  // namespace obrys::cli
