#include "report/cutting/blade.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "base/number.hpp"
#include "report/cutting/rows.hpp"

namespace obrys::report::cutting {

using OrderedJson = nlohmann::ordered_json;
using sim::beam::BladeResult;
using sim::beam::Excitation;
using sim::beam::Stage;

namespace {

std::string percent(double part) { return base::fixed(100 * part, 0) + " %"; }

void put_stages(std::string& out, const BladeSubject& s) {
    constexpr std::size_t width = 10;
    const auto cell = [&](const std::string& text) { out += padded(text, width, true); };
    for (const char* head : {"finished", "f1 Hz", "f2 Hz", "f3 Hz", "tip N/mm", "cut N/mm", "mass g", "bending"})
        cell(head);
    out += "\n";
    for (const Stage& stage : s.result.stages) {
        cell(percent(stage.finished));
        for (const double f : stage.frequencies) cell(base::fixed(f, 0));
        cell(figure(stage.tip_stiffness));
        cell(figure(stage.cut_stiffness));
        cell(figure(stage.mass_g, 3));
        cell(base::fixed(stage.stress_ratio, 2));
        out += "\n";
    }
    out +=
        "finished from the tip; stiffness at the tip and where the finished part ends; bending stress by a load at "
        "the tip, largest to mean\n";
}

std::string excitation_line(const Stage& stage, const Excitation& e) {
    std::string line = "  " + padded(percent(stage.finished), 6, true) + " finished: harmonic " +
                       std::to_string(e.harmonic) + " of it is " + figure(e.harmonic * e.tooth_passing) +
                       " Hz against " + figure(stage.frequencies.front()) + " Hz: deflections are " +
                       figure(e.amplification, 3) + " times the static ones";
    if (std::isfinite(e.amplitude)) line += ", " + figure(e.amplitude, 3) + " mm at the cut";
    if (e.rings) line += e.better_speed ? "; rings, not at " + base::fixed(*e.better_speed, 0) + " 1/min" : "; rings";
    return line + "\n";
}

void put_excitation(std::string& out, const BladeSubject& s) {
    if (!s.blade.speed || !s.blade.teeth) {
        out += "\nnot known: [cut] speed and teeth, so whether tooth passing makes it ring\n";
        return;
    }
    out += "\ntooth passing: " + base::shortest(*s.blade.speed) + " 1/min, " + std::to_string(*s.blade.teeth) +
           (*s.blade.teeth == 1 ? " tooth: " : " teeth: ") + figure(s.result.stages.front().excitation->tooth_passing) +
           " Hz\n";
    for (const Stage& stage : s.result.stages) out += excitation_line(stage, *stage.excitation);
    if (!any_rings(s.result)) return;
    out += s.result.common_speed
               ? "no stage rings at " + base::fixed(*s.result.common_speed, 0) + " 1/min\n"
               : "no speed from half of it to one and a half suits all stages: change it from stage to stage\n";
}

}  // namespace

bool any_rings(const BladeResult& r) {
    return std::any_of(r.stages.begin(), r.stages.end(),
                       [](const Stage& s) { return s.excitation && s.excitation->rings; });
}

bool is_hollow(const shop::BladeForm& form) { return form.kind == shop::BladeForm::Kind::arc && form.radius < 0; }

std::string as_text(const BladeSubject& s) {
    std::string out = s.name + ": " + figure(s.blade.length) + " mm long, E " + figure(s.blade.elasticity, 6) +
                      " N/mm2, " + figure(s.blade.density) + " kg/m3, root " +
                      (s.blade.root_stiffness ? "held by " + figure(*s.blade.root_stiffness) + " Nm/rad" : "clamped") +
                      "\n";
    put_stages(out, s);
    if (is_hollow(s.blade.blank))
        out +=
            "the sides of the blank are hollow: an arc under the chord loses part of what the thick root is for; "
            "radius above 0 bulges\n";
    put_excitation(out, s);
    return out;
}

namespace {

OrderedJson optional(const std::optional<double>& v) { return v ? OrderedJson(*v) : OrderedJson(nullptr); }

OrderedJson excitation_json(const Excitation& e) {
    return {{"tooth_passing_Hz", e.tooth_passing},
            {"nearest_harmonic", e.harmonic},
            {"ratio", e.ratio},
            {"amplification", e.amplification},
            {"amplitude_mm", number(e.amplitude)},
            {"rings", e.rings},
            {"better_speed_rpm", optional(e.better_speed)}};
}

}  // namespace

std::string as_json(const BladeSubject& s) {
    OrderedJson out{{"format", "obrys-blade"}, {"version", 1}, {"name", s.name}};
    out["length_mm"] = s.blade.length;
    out["E_N_mm2"] = s.blade.elasticity;
    out["density_kg_m3"] = s.blade.density;
    out["hollow"] = is_hollow(s.blade.blank);
    out["stages"] = OrderedJson::array();
    for (const Stage& stage : s.result.stages) {
        OrderedJson one{{"finished", stage.finished}, {"f_Hz", stage.frequencies}};
        one["tip_stiffness_N_per_mm"] = stage.tip_stiffness;
        one["cut_stiffness_N_per_mm"] = stage.cut_stiffness;
        one["mass_g"] = stage.mass_g;
        one["h_root_mid_tip_mm"] = {stage.root, stage.middle, stage.tip};
        one["max_over_mean_bending_stress"] = stage.stress_ratio;
        one["excitation"] = stage.excitation ? excitation_json(*stage.excitation) : OrderedJson(nullptr);
        out["stages"].push_back(std::move(one));
    }
    out["rings"] = s.blade.speed && s.blade.teeth ? OrderedJson(any_rings(s.result)) : OrderedJson(nullptr);
    out["common_speed_rpm"] = optional(s.result.common_speed);
    return out.dump(2) + "\n";
}

}  // namespace obrys::report::cutting
