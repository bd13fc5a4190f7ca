#include "shop/files/obrys/milling_keys.hpp"

#include <algorithm>
#include <array>

#include "base/codes.hpp"
#include "base/number.hpp"
#include "shop/files/obrys/form_profile.hpp"

namespace obrys::shop {

namespace {

using base::codes::job_value;

using enum ToolKind;

/// Keys that belong to some of the kinds, and to which; `other` fills up.
struct Key {
    std::string_view name;
    std::array<ToolKind, 4> kinds{other, other, other, other};
};
constexpr std::array some_kinds{Key{"corner_radius", {bull_nose, t_slot, other, other}},
                                Key{"point_angle", {drill, centre_drill, countersink, chamfer}},
                                Key{"tip_diameter", {countersink, chamfer, other, other}},
                                Key{"width", {t_slot, other, other, other}},
                                Key{"neck_diameter", {t_slot, other, other, other}},
                                Key{"pitch", {tap, form, other, other}},
                                Key{"forming", {tap, other, other, other}},
                                Key{"profile", {form, other, other, other}}};
constexpr std::array all_kinds{"diameter", "cutting_length", "teeth", "plunges", "rotation", "shank", "holder"};

void foreign(const Section& s, std::string_view key, std::string_view kind) {
    if (const Entry* e = find(s.table(), key))
        s.error(job_value, e->where,
                "'" + std::string(key) + "' means nothing for a tool of kind \"" + std::string(kind) + "\"");
}

std::vector<ToolBody> read_bodies(Section& tool, std::string_view key) {
    std::vector<ToolBody> out;
    for (const Value* v : tool.tables(key)) {
        Section s(*v, "a body of '" + std::string(key) + "'", tool.diagnostics());
        if (v->kind != ValueKind::table) continue;
        const auto diameter = s.number("diameter", Range::positive), length = s.number("length", Range::positive);
        const auto upper = s.number("upper_diameter", Range::positive);
        s.finish();
        for (const std::string_view needed : {"diameter", "length"})
            if (!s.has(needed)) s.missing(needed);
        if (diameter && length) out.push_back({*diameter, upper.value_or(*diameter), *length});
    }
    return out;
}

/// What the kind lets one leave out; said in docs/job-file.md.
void fill_in(Tool& t) {
    if (t.kind == ball) t.corner_radius = t.radius;
    if (t.kind == drill && !t.point_angle) t.point_angle = 118;
    if ((t.kind == centre_drill || t.kind == countersink || t.kind == chamfer) && !t.point_angle) t.point_angle = 90;
    if (t.kind == t_slot && t.neck_diameter == 0 && !t.shank.empty()) t.neck_diameter = t.shank.front().lower_diameter;
    if (t.kind == form && t.radius == 0)
        for (const geom::Vertex& v : t.profile) t.radius = std::max(t.radius, v.p.x);
}

void check_needed(const Section& s, const Tool& t) {
    const auto need = [&](std::string_view key) {
        if (!s.has(key)) s.missing(key);
    };
    if (t.kind == form)
        need("profile");
    else if (!s.has("radius"))
        need("diameter");
    if (t.kind == bull_nose) need("corner_radius");
    if (t.kind == t_slot) need("width");
    if (t.kind == t_slot && !s.has("shank")) need("neck_diameter");
}

}  // namespace

void read_milling_keys(Section& s, Tool& t) {
    if (const auto d = s.number("diameter", Range::positive)) t.radius = *d / 2;
    t.point_angle = s.number("point_angle", Range::positive);
    t.tip_diameter = s.number("tip_diameter", Range::not_negative).value_or(0);
    t.neck_diameter = s.number("neck_diameter", Range::positive).value_or(0);
    t.pitch = s.number("pitch", Range::positive);
    t.cutting_length = s.number("cutting_length", Range::positive);
    if (const auto n = s.integer("teeth", 1, 99)) t.teeth = static_cast<int>(*n);
    t.plunges = s.boolean("plunges");
    if (s.boolean("forming").value_or(false)) t.type = "FORMING TAP";  // as tables name one
    t.left_hand = s.choice("rotation", {"right", "left"}) == std::optional<std::size_t>(1);
    t.profile = read_form_profile(s);
    t.shank = read_bodies(s, "shank");
    if (t.kind != groove && t.kind != turning) t.holder = read_bodies(s, "holder");
}

void refuse_milling_keys(const Section& s, std::string_view kind) {
    for (const std::string_view key : all_kinds)
        if (key != "holder" || kind == kind_word(other)) foreign(s, key, kind);
    for (const Key& key : some_kinds)
        if (key.name != "corner_radius" && key.name != "width") foreign(s, key.name, kind);  // blades have these two
}

void check_milling_keys(const Section& s, Tool& t, bool plain) {
    for (const Key& key : some_kinds)
        if (std::find(key.kinds.begin(), key.kinds.end(), t.kind) == key.kinds.end() &&
            !(plain && key.name == "corner_radius"))
            foreign(s, key.name, plain ? "mill" : kind_word(t.kind));
    if (s.has("radius") && s.has("diameter"))
        s.error(job_value, find(s.table(), "radius")->where, "[[tool]] has both 'diameter' and 'radius'");
    check_needed(s, t);
    fill_in(t);
}

void check_dimensions(const Section& s, const Tool& t) {
    if (is_milling(t.kind) && t.length >= least_gauge_length && t.cutting_length.value_or(0) > t.length)
        s.error(job_value, place(s, "cutting_length"),
                "the cutting edges (" + base::shortest(*t.cutting_length) +
                    " mm) are longer than the tool, which reaches " + base::shortest(t.length) +
                    " mm from the gauge plane to the tip ('length')");
    const DimensionFault fault = dimension_fault(t);
    if (fault.ok()) return;
    const std::string_view key = fault.key == "diameter" && s.has("radius") ? "radius" : fault.key;
    s.error(job_value, place(s, key), fault.text);
}

}  // namespace obrys::shop
