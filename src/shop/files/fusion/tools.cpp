// Tool library of Autodesk Fusion as it exports it (JSON). Names of dimensions follow ISO 13399: DC cutting diameter,
// RE corner radius, SIG point angle, LCF length of the flutes, LB length below the holder, SFDM shank diameter, NOF
// teeth, TP pitch, TA angle of a flank against the axis (45 of a 90 degree chamfer mill). Segments of shaft and holder
// begin below. The assembly's gauge length is LB and the holder's gauge length. Taken from libraries that users have
// published.
#include "shop/files/fusion/tools.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "base/codes.hpp"
#include "base/number.hpp"
#include "base/text.hpp"
#include "base/whole.hpp"
#include "shop/files/dropped.hpp"
#include "shop/files/json_document.hpp"
#include "shop/files/section.hpp"
#include "shop/files/taper.hpp"

namespace obrys::shop {

namespace {

/// What a `type` stands for. Kinds that are not here (probe, thread mill, barrel …) are `other`; turning tools, holders
/// and what cuts without an edge are no tools of a mill.
struct FusionType {
    std::string_view name;
    ToolKind kind;
};
constexpr std::array fusion_types{FusionType{"flat end mill", ToolKind::end_mill},
                                  FusionType{"ball end mill", ToolKind::ball},
                                  FusionType{"bull nose end mill", ToolKind::bull_nose},
                                  FusionType{"face mill", ToolKind::end_mill},
                                  FusionType{"drill", ToolKind::drill},
                                  FusionType{"spot drill", ToolKind::centre_drill},
                                  FusionType{"center drill", ToolKind::centre_drill},
                                  FusionType{"counter sink", ToolKind::countersink},
                                  FusionType{"counter bore", ToolKind::end_mill},
                                  FusionType{"chamfer mill", ToolKind::chamfer},
                                  FusionType{"tap right hand", ToolKind::tap},
                                  FusionType{"tap left hand", ToolKind::tap},
                                  FusionType{"reamer", ToolKind::reamer},
                                  FusionType{"boring bar", ToolKind::reamer},
                                  FusionType{"boring head", ToolKind::reamer},
                                  FusionType{"slot mill", ToolKind::t_slot},
                                  FusionType{"tapered mill", ToolKind::form},
                                  FusionType{"dovetail mill", ToolKind::form},
                                  FusionType{"lollipop mill", ToolKind::form},
                                  FusionType{"radius mill", ToolKind::form}};
constexpr std::array<std::string_view, 7> no_mills{"turning", "holder",     "laser", "waterjet",
                                                   "plasma",  "deposition", "block"};

/// Keys that are taken, or that say nothing about the tool itself.
const std::set<std::string, std::less<>> keys_taken{"type",
                                                    "unit",
                                                    "description",
                                                    "geometry",
                                                    "holder",
                                                    "shaft",
                                                    "post-process",
                                                    "geometry.DC",
                                                    "geometry.RE",
                                                    "geometry.SIG",
                                                    "geometry.LCF",
                                                    "geometry.LB",
                                                    "geometry.SFDM",
                                                    "geometry.NOF",
                                                    "geometry.TA",
                                                    "geometry.TP",
                                                    "geometry.HAND",
                                                    "geometry.tip-diameter",
                                                    "geometry.shoulder-length",
                                                    "geometry.shoulder-diameter",
                                                    "geometry.assemblyGaugeLength",
                                                    "holder.segments",
                                                    "holder.gaugeLength",
                                                    "holder.unit",
                                                    "shaft.segments",
                                                    "shaft.type",
                                                    "post-process.number"};

const Value* member(const Value& table, std::string_view key, ValueKind kind) {
    const Entry* e = find(table, key);
    return e && e->value.kind == kind ? &e->value : nullptr;
}

std::string text_of(const Value& table, std::string_view key) {
    const Value* v = member(table, key, ValueKind::text);
    return v ? v->text : std::string{};
}

/// A finite number, also one written as text; nothing otherwise.
std::optional<double> number_of(const Value& table, std::string_view key) {
    const Entry* e = find(table, key);
    if (!e) return std::nullopt;
    std::optional<double> v;
    if (e->value.kind == ValueKind::number || e->value.kind == ValueKind::integer) v = e->value.number;
    if (e->value.kind == ValueKind::text) v = base::parse_double(e->value.text);
    return v && std::isfinite(*v) ? v : std::nullopt;
}

/// The dimensions of one tool in mm.
struct Geometry {
    const Value& table;
    double unit = 1;

    [[nodiscard]] double length(std::string_view key) const { return number_of(table, key).value_or(0) * unit; }
    [[nodiscard]] double plain(std::string_view key) const { return number_of(table, key).value_or(0); }
};

class FusionReader {
public:
    explicit FusionReader(base::Diagnostics& diagnostics) : diagnostics_(diagnostics) {}

    void library(const Value& root);
    std::vector<Tool> tools;

private:
    /// A tool that is left out is missing only where a program calls it, so it does not make a check incomplete.
    void warn(const base::Span& where, std::string text) {
        base::Diagnostic d;
        d.severity = base::Severity::warning;
        d.code = base::codes::no_effect;
        d.where = where;
        d.text = std::move(text);
        diagnostics_.add(std::move(d));
    }
    void item(const Value& v);
    void count_dropped(const Value& tool);
    std::optional<std::uint32_t> number(const Value& tool);
    [[nodiscard]] double unit_of(const Value& table, double otherwise, std::string& assumed) const;

    base::Diagnostics& diagnostics_;
    Dropped dropped_;
};

std::vector<ToolBody> segments(const Value* of, double unit) {
    std::vector<ToolBody> out;
    const Value* list = of ? member(*of, "segments", ValueKind::array) : nullptr;
    if (!list) return out;
    for (const Value& v : list->items) {
        const Geometry g{v, unit};
        const ToolBody b{g.length("lower-diameter"), g.length("upper-diameter"), g.length("height")};
        if (b.lower_diameter > 0 && b.upper_diameter > 0 && b.length > 0) out.push_back(b);
    }
    return out;
}

/// Neck, shaft and plain shank from the end of the cutting edges up to the holder.
void take_shank(Tool& t, const Geometry& g, const Value* shaft) {
    const double end = g.length("LB"), shoulder = g.length("shoulder-length");
    double at = cutting_height(t).value_or(0);
    const auto add = [&](double lower, double upper, double length) {
        if (!(lower > 0 && upper > 0) || !(length > 1e-9) || at > end - 1e-9) return;
        const double kept = std::min(length, end - at);
        t.shank.push_back({lower, lower + (upper - lower) * kept / length, kept});
        at += kept;
    };
    const double neck = g.length("shoulder-diameter");
    if (shoulder > at) add(neck > 0 ? neck : 2 * t.radius, neck > 0 ? neck : 2 * t.radius, shoulder - at);
    for (const ToolBody& b : segments(shaft, g.unit)) add(b.lower_diameter, b.upper_diameter, b.length);
    add(g.length("SFDM"), g.length("SFDM"), end - at);
}

void take_angle(Tool& t, const Geometry& g, double otherwise) {
    const double full = g.plain("SIG"), flank = g.plain("TA");
    if (full > 0)
        t.point_angle = full;
    else if (flank > 0)
        t.point_angle = 2 * flank;
    if (t.point_angle) return;
    t.point_angle = otherwise;
    assume(t.assumed, "point angle " + base::shortest(otherwise) + " degrees");
}

void take_profile(Tool& t, const Geometry& g, std::string_view type) {
    const double re = g.length("RE"), height = g.length("LCF"), angle = g.plain("TA"),
                 neck = g.length("shoulder-diameter") / 2;
    if (type == "tapered mill") t.profile = tapered_profile(t.radius, re, angle, height);
    if (type == "dovetail mill") t.profile = tapered_profile(t.radius, 0, -angle, height);
    if (type == "lollipop mill") t.profile = lollipop_profile(t.radius, neck > 0 ? neck : g.length("SFDM") / 2);
    if (type == "radius mill") {
        const double tip = g.length("tip-diameter") / 2;
        t.profile = hollow_profile(tip > 0 ? tip : t.radius - re, re, std::max(height, re));
    }
    for (const geom::Vertex& v : t.profile) t.radius = std::max(t.radius, v.p.x);
    t.cutting_length.reset();
}

void take_dimensions(Tool& t, const Geometry& g, std::string_view type) {
    t.radius = g.length("DC") / 2;
    t.teeth = base::clipped<int>(g.plain("NOF"), 0, 99);
    if (const Value* hand = member(g.table, "HAND", ValueKind::boolean)) t.left_hand = !hand->boolean;
    if (const double l = g.length("LCF"); l > 0) t.cutting_length = l;
    if (t.kind == ToolKind::tap || t.kind == ToolKind::other)
        if (const double p = g.length("TP"); p > 0) t.pitch = p;
    const double re = g.length("RE");
    if (t.kind == ToolKind::ball) t.corner_radius = t.radius;
    if (t.kind == ToolKind::bull_nose || t.kind == ToolKind::t_slot) t.corner_radius = re;
    if (t.kind == ToolKind::end_mill && re > 0) t.kind = ToolKind::bull_nose, t.corner_radius = re;
    if (t.kind == ToolKind::drill) take_angle(t, g, 118);
    if (t.kind == ToolKind::centre_drill || t.kind == ToolKind::countersink || t.kind == ToolKind::chamfer)
        take_angle(t, g, 90);
    if (t.kind == ToolKind::countersink || t.kind == ToolKind::chamfer) t.tip_diameter = g.length("tip-diameter");
    if (t.kind == ToolKind::form) take_profile(t, g, type);
    if (t.kind != ToolKind::t_slot) return;
    t.width = g.length("LCF");
    t.cutting_length.reset();
    t.neck_diameter = g.length("shoulder-diameter");
    if (!(t.neck_diameter > 0)) t.neck_diameter = g.length("SFDM");
}

double FusionReader::unit_of(const Value& table, double otherwise, std::string& assumed) const {
    std::string unit = text_of(table, "unit");
    const Value* expressions = member(table, "expressions", ValueKind::table);
    if (unit.empty() && expressions) unit = text_of(*expressions, "tool_unit");
    if (unit.find("inch") != std::string::npos) return 25.4;
    if (unit.find("millimeter") != std::string::npos) return 1;
    if (otherwise == 0) assume(assumed, "lengths in mm");
    return otherwise == 0 ? 1 : otherwise;
}

std::optional<std::uint32_t> FusionReader::number(const Value& tool) {
    const Value* post = member(tool, "post-process", ValueKind::table);
    const auto n = post ? number_of(*post, "number") : std::nullopt;
    const base::Span where = head(tool);
    const auto number = n ? base::whole<std::uint32_t>(*n, 0, 999'999'999) : std::nullopt;
    if (!number) {
        warn(where, "a tool without a number (post-process, number) is left out: " + text_of(tool, "description"));
        return std::nullopt;
    }
    const std::uint32_t whole = *number;
    const auto same = [&](const Tool& t) { return t.number == whole; };
    if (std::none_of(tools.begin(), tools.end(), same)) return whole;
    warn(where, "tool " + std::to_string(whole) + " is there already: this one is left out");
    return std::nullopt;
}

void FusionReader::count_dropped(const Value& tool) {
    for (const Entry& e : tool.entries) {
        if (!keys_taken.contains(e.key)) dropped_.add(e.key, e.where);
        if (e.value.kind != ValueKind::table || !keys_taken.contains(e.key)) continue;
        for (const Entry& inner : e.value.entries)
            if (const std::string name = e.key + "." + inner.key; !keys_taken.contains(name))
                dropped_.add(name, inner.where);
    }
}

void FusionReader::item(const Value& v) {
    if (v.kind != ValueKind::table)
        return warn(v.where, "a tool must be an object, not " + std::string(kind_name(v.kind)));
    const std::string type = text_of(v, "type");
    const auto starts = [&](std::string_view t) { return std::string_view(type).starts_with(t); };
    if (std::any_of(no_mills.begin(), no_mills.end(), starts))
        return dropped_.add("tools of type \"" + type + "\"", head(v));
    const auto n = number(v);
    const Value* geometry = member(v, "geometry", ValueKind::table);
    if (!n) return;
    if (!geometry) return warn(head(v), "tool " + std::to_string(*n) + " has no 'geometry': left out");
    Tool t;
    t.number = *n;
    t.name = text_of(v, "description");
    t.type = type;
    t.where = head(v);
    const auto known =
        std::find_if(fusion_types.begin(), fusion_types.end(), [&](const FusionType& o) { return o.name == type; });
    if (known != fusion_types.end()) t.kind = known->kind;
    const Geometry g{*geometry, unit_of(v, 0, t.assumed)};
    take_dimensions(t, g, type);
    const Value* holder = member(v, "holder", ValueKind::table);
    std::string unused;
    const double holder_unit = holder ? unit_of(*holder, g.unit, unused) : g.unit;
    t.holder = segments(holder, holder_unit);
    take_shank(t, g, member(v, "shaft", ValueKind::table));
    t.length = g.length("assemblyGaugeLength");
    if (!(t.length > 0)) t.length = g.length("LB") + height_of(t.holder);
    if (!t.assumed.empty()) t.assumed = "tool " + std::to_string(*n) + ": " + t.assumed;
    const DimensionFault fault = dimension_fault(t);
    if (!fault.ok()) return warn(head(*geometry), "tool " + std::to_string(*n) + " is left out: " + fault.text);
    count_dropped(v);
    tools.push_back(std::move(t));
}

void FusionReader::library(const Value& root) {
    const Value* list = root.kind == ValueKind::array ? &root : member(root, "data", ValueKind::array);
    if (!list) {
        base::Diagnostic d;
        d.code = base::codes::job_file;
        d.where = head(root);
        d.text = "this is no Fusion tool library: it has no array 'data'";
        diagnostics_.add(std::move(d));
        return;
    }
    for (const Value& v : list->items) item(v);
    dropped_.report(diagnostics_);
    std::stable_sort(tools.begin(), tools.end(), [](const Tool& a, const Tool& b) { return a.number < b.number; });
}

}  // namespace

std::vector<Tool> read_fusion_tools(std::uint32_t file, const base::Sources& sources, base::Diagnostics& diagnostics) {
    const auto root = parse_json(file, sources, diagnostics);
    if (!root) return {};
    base::Diagnostics found;
    FusionReader reader(found);
    reader.library(*root);
    add_in_order(found, diagnostics);
    return std::move(reader.tools);
}

}  // namespace obrys::shop
