#include "report/cutting/data.hpp"

#include <array>
#include <cmath>
#include <nlohmann/json.hpp>

#include "base/codes.hpp"
#include "base/number.hpp"
#include "report/cutting/rows.hpp"

namespace obrys::report::cutting {

using sim::cutting::Asked;
using sim::cutting::Data;
using sim::cutting::Process;
using sim::cutting::Value;
using OrderedJson = nlohmann::ordered_json;

namespace {

struct Words {
    Value value;
    const char *name, *unit, *key, *needs;
};
constexpr std::array words{
    Words{Value::diameter, "diameter", "mm", "diameter_mm", "--diameter"},
    Words{Value::effective_diameter, "effective diameter", "mm", "d_eff_mm", "--diameter, of a round tool --ap"},
    Words{Value::teeth, "teeth", "", "teeth", "--teeth"},
    Words{Value::cutting_speed, "cutting speed", "m/min", "vc_m_min", "--vc, or --rpm and the diameter"},
    Words{Value::speed, "speed", "1/min", "n_rpm", "--rpm, or --vc and the diameter"},
    Words{Value::feed_per_tooth, "feed per tooth", "mm", "fz_mm", "--fz, or --vf and --teeth"},
    Words{Value::feed, "feed", "mm/min", "vf_mm_min", "--vf, or --fz and --teeth"},
    Words{Value::depth, "depth of cut", "mm", "ap_mm", "--ap"},
    Words{Value::width, "width of cut", "mm", "ae_mm", "--ae"},
    Words{Value::chip, "mean chip thickness", "mm", "hm_mm", "--ae and the feed per tooth, or --hm"},
    Words{Value::removal, "removal rate", "cm3/min", "removal_cm3_min", "--ap, --ae and the feed, or --removal"},
};

bool applies(const Asked& a, Value v) {
    if (v == Value::width) return a.process == Process::milling;
    if (v == Value::depth) return a.process != Process::drilling;
    if (v == Value::teeth) return a.process != Process::turning;
    return true;
}

/// Is said to be not known; others that nobody gave are left out of the text.
bool matters(Value v) {
    return v == Value::cutting_speed || v == Value::speed || v == Value::feed_per_tooth || v == Value::feed;
}

std::string name_of(const Asked& a, const Words& w) {
    if (a.process == Process::turning && w.value == Value::feed_per_tooth) return "feed per revolution";
    return w.name;
}

const Words& words_of(Value v) { return words[static_cast<std::size_t>(v)]; }

std::string difference_text(const Asked& a, const sim::cutting::Difference& d) {
    const Words& w = words_of(d.value);
    return name_of(a, w) + " is given as " + figure(d.given) + " " + w.unit + ", and " + figure(d.computed) + " " +
           w.unit + " follows from the others";
}

std::string implausible_text(const DataSubject& s) {
    const bool turning = s.asked.process == Process::turning;
    return "no tool" + std::string(turning || !std::isfinite(s.data[Value::diameter]) ? "" : " of this diameter") +
           " cuts " + figure(s.data[Value::feed_per_tooth]) + " mm a " + (turning ? "revolution" : "tooth") +
           ": see where the decimal point stands";
}

std::string needed(const Asked& a) {
    return a.material == nullptr ? "needs --material" : "needs feed per tooth, --ap and --ae";
}

std::string remark(const DataSubject& s, Value v) {
    const double given = s.asked[v], is = s.data[v];
    if (!std::isfinite(is)) return std::string("not known: needs ") + words_of(v).needs;
    if (!std::isfinite(given)) return "";
    return given == is ? "given" : "given " + figure(given) + ", held by the machine";
}

std::string tool_text(const Asked& a) {
    if (a.process == Process::turning) return "turning";
    if (a.process == Process::drilling) return "drill";
    return a.ball ? "ball end mill" : a.corner_radius > 0 ? "bull nose end mill" : "end mill";
}

void put_force(std::string& out, const DataSubject& s) {
    const Data& d = s.data;
    if (!std::isfinite(d.power)) {
        out += row("power", "?", "W", "not known: " + needed(s.asked));
        return;
    }
    out += row("power", figure(d.power), "W", "at the spindle; " + d.law);
    out += row("torque", figure(d.torque), "Nm");
    out += row("specific force", figure(d.specific_force), "N/mm2",
               d.extrapolated ? "chips are outside of those that the law was found for [" +
                                    std::string(base::codes::force_extrapolated) + "]"
                              : "");
}

}  // namespace

std::string as_text(const DataSubject& s) {
    std::string out = tool_text(s.asked);
    if (s.asked.material != nullptr)
        out += " in " + s.asked.material->text +
               (s.asked.material->vdi > 0 ? " (VDI 3323 group " + std::to_string(s.asked.material->vdi) + ")" : "");
    if (!s.machine.empty()) out += " on " + s.machine;
    out += "\n";
    for (const Words& w : words)
        if (applies(s.asked, w.value) && (std::isfinite(s.data[w.value]) || matters(w.value)))
            out += row(name_of(s.asked, w), figure(s.data[w.value]), w.unit, remark(s, w.value));
    if (std::isfinite(s.data.thickest_chip)) out += row("thickest chip", figure(s.data.thickest_chip), "mm");
    put_force(out, s);
    if (std::isfinite(s.data.rz)) {
        out += row("Rz", figure(s.data.rz, 3), "um", "of the tool's form alone");
        out += row("Ra", figure(s.data.ra, 3), "um");
    }
    for (const std::string& key : s.data.clamped_by) out += "held by the machine: " + key + "\n";
    if (s.data.impossible) out += "the spindle does not turn so slowly that its power would do\n";
    if (s.data.feed_implausible) out += implausible_text(s) + " [" + std::string(base::codes::feed_implausible) + "]\n";
    for (const auto& d : s.data.differences)
        out += difference_text(s.asked, d) + " [" + std::string(base::codes::feed_differs) + "]\n";
    return out;
}

std::string as_json(const DataSubject& s) {
    const Data& d = s.data;
    OrderedJson out{{"format", "obrys-data"}, {"version", 1}, {"tool", tool_text(s.asked)}};
    out["material"] = s.asked.material == nullptr ? OrderedJson(nullptr) : OrderedJson(s.asked.material->name);
    out["machine"] = s.machine.empty() ? OrderedJson(nullptr) : OrderedJson(s.machine);
    for (const Words& w : words)
        if (applies(s.asked, w.value)) out[w.key] = number(d[w.value]);
    out["h_max_mm"] = number(d.thickest_chip);
    out["power_W"] = number(d.power);
    out["torque_Nm"] = number(d.torque);
    out["kc_N_mm2"] = number(d.specific_force);
    out["law"] = d.law.empty() ? OrderedJson(nullptr) : OrderedJson(d.law);
    out["extrapolated"] = d.extrapolated;
    out["Rz_um"] = number(d.rz);
    out["Ra_um"] = number(d.ra);
    out["clamped_by"] = d.clamped_by;
    out["possible"] = !d.impossible;
    out["findings"] = OrderedJson::array();
    for (const auto& f : d.differences)
        out["findings"].push_back({{"code", base::codes::feed_differs},
                                   {"value", words_of(f.value).key},
                                   {"given", f.given},
                                   {"computed", f.computed},
                                   {"message", difference_text(s.asked, f)}});
    if (d.feed_implausible)
        out["findings"].push_back({{"code", base::codes::feed_implausible},
                                   {"value", words_of(Value::feed_per_tooth).key},
                                   {"given", d[Value::feed_per_tooth]},
                                   {"message", implausible_text(s)}});
    out["not_known"] = OrderedJson::array();
    for (const Words& w : words)
        if (applies(s.asked, w.value) && !std::isfinite(d[w.value])) out["not_known"].push_back(w.key);
    if (!std::isfinite(d.power)) out["not_known"].push_back("power_W");
    return out.dump(2) + "\n";
}

std::string materials_as_text(const std::vector<shop::WorkMaterial>& all) {
    constexpr std::size_t names = 30, groups = 6, laws = 14;
    std::string out = padded("material", names) + padded("ISO", groups) + padded("VDI", groups) +
                      padded("kc1.1", laws) + padded("mc", groups) + padded("Ktc, Kte", laws) + "what it is\n";
    std::vector<std::string> sources;
    for (const shop::WorkMaterial& m : all) {
        out += padded(m.name, names) + padded(std::string(1, m.iso), groups) +
               padded(m.vdi > 0 ? std::to_string(m.vdi) : "", groups) +
               padded(m.kienzle ? figure(m.kienzle->kc11) : "", laws) +
               padded(m.kienzle ? figure(m.kienzle->mc) : "", groups) +
               padded(m.linear ? figure(m.linear->tangential) + ", " + figure(m.linear->edge_tangential) : "", laws) +
               m.text;
        std::string separator = ": ";
        for (const std::string& name : m.names) out += separator + name, separator = ", ";
        out += "\n";
    }
    return out + "where each value comes from: --format json\n";
}

std::string materials_as_json(const std::vector<shop::WorkMaterial>& all) {
    OrderedJson out{{"format", "obrys-materials"}, {"version", 1}, {"materials", OrderedJson::array()}};
    const auto optional = [](const std::optional<double>& v) { return v ? OrderedJson(*v) : OrderedJson(nullptr); };
    for (const shop::WorkMaterial& m : all) {
        OrderedJson one{{"name", m.name}, {"names", m.names}, {"text", m.text}};
        one["iso"] = m.iso == ' ' ? OrderedJson(nullptr) : OrderedJson(std::string(1, m.iso));
        one["vdi"] = m.vdi == 0 ? OrderedJson(nullptr) : OrderedJson(m.vdi);
        one["hb"] = optional(m.hardness);
        one["density_kg_m3"] = optional(m.density);
        one["E_N_mm2"] = optional(m.elasticity);
        if (const auto& k = m.kienzle)
            one["kienzle"] = {{"kc11_N_mm2", k->kc11},
                              {"mc", k->mc},
                              {"rake_deg", k->rake},
                              {"h_mm", {number(k->thinnest), number(k->thickest)}},
                              {"source", k->source}};
        if (const auto& l = m.linear)
            one["linear"] = {{"Ktc", l->tangential},      {"Krc", l->radial},      {"Kac", l->axial},
                             {"Kte", l->edge_tangential}, {"Kre", l->edge_radial}, {"Kae", l->edge_axial},
                             {"tool", l->tool},           {"source", l->source}};
        out["materials"].push_back(std::move(one));
    }
    return out.dump(2) + "\n";
}

}  // namespace obrys::report::cutting
