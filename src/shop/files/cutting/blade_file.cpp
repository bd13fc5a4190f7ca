#include "shop/files/cutting/blade_file.hpp"

#include <algorithm>

#include "base/codes.hpp"
#include "shop/files/section.hpp"

namespace obrys::shop {

namespace {

using Kind = BladeForm::Kind;

double size_of(Section& s, std::string_view key) {
    if (!s.has(key)) s.missing(key);
    return s.number(key, Range::positive).value_or(0);
}

void fault(const Section& s, std::string_view key, const std::string& text, const std::string& remedy = {}) {
    s.error(base::codes::job_value, place(s, key), text, remedy);
}

/// 'key = 30' or 'key = {root = 30, tip = 24}'.
BladeForm width_of(Section& s) {
    BladeForm form;
    const Entry* e = find(s.table(), "width");
    if (e != nullptr && e->value.kind == ValueKind::table) {
        s.take("width");
        Section ends(e->value, "'width'", s.diagnostics());
        form.root = size_of(ends, "root");
        form.tip = size_of(ends, "tip");
        ends.finish();
    } else if (const auto width = s.number("width", Range::positive)) {
        form.root = form.tip = *width;
    }
    return form;
}

/// [blank] or [finished].
BladeForm read_form(const Entry& e, double length, base::Diagnostics& diagnostics) {
    BladeForm form;
    Section s(e.value, "[" + e.key + "]", diagnostics);
    if (e.value.kind != ValueKind::table) return form;
    if (const auto kind = s.choice("form", {"linear", "strength", "arc"}))
        form.kind = std::array{Kind::linear, Kind::strength, Kind::arc}[*kind];
    if (s.has("thickness")) {
        form.root = form.tip = size_of(s, "thickness");
        if (s.has("root") || s.has("tip") || form.kind != Kind::linear)
            fault(s, "thickness", "'thickness' is that from root to tip: nothing else goes with it");
    } else {
        form.root = size_of(s, "root");
        form.tip = size_of(s, "tip");
    }
    if (const auto radius = s.number("radius")) {
        form.radius = *radius;
        if (form.kind != Kind::arc) fault(s, "radius", "'radius' belongs to form = \"arc\"");
        constexpr double half = 2;
        const double chord = std::hypot(length, (form.root - form.tip) / half);
        if (form.kind == Kind::arc && std::abs(*radius) < chord / half)
            fault(s, "radius", "no arc of this radius reaches from root to tip",
                  "above 0 it bulges, below 0 it is hollow; a flat one has a large radius");
    } else if (form.kind == Kind::arc) {
        s.missing("radius");
    }
    s.finish();
    const double middle = form.root > 0 && form.tip > 0 ? value_at(form, length / 2, length) : 1;
    if (!(middle > 0)) fault(s, "radius", "an arc this hollow leaves nothing in the middle of the blade");
    return form;
}

struct Stations {
    BladeForm width, blank, finished;
};

Stations read_stations(Section& file, double length) {
    Stations all;
    for (BladeForm* f : {&all.width, &all.blank, &all.finished}) f->kind = Kind::stations;
    double last = -1;
    for (const Value* v : file.tables("station")) {
        Section s(*v, "[[station]]", file.diagnostics());
        if (v->kind != ValueKind::table) continue;
        if (!s.has("at")) s.missing("at");
        const double at = s.number("at", Range::not_negative).value_or(0);
        const double width = size_of(s, "width"), blank = size_of(s, "blank"), finished = size_of(s, "finished");
        s.finish();
        if (at <= last || at > length)
            fault(s, "at", "stations go from the root to the tip, each farther out than the one before");
        last = at;
        all.width.stations.push_back({at, width});
        all.blank.stations.push_back({at, blank});
        all.finished.stations.push_back({at, finished});
    }
    return all;
}

void read_stages(Section& s, Blade& b) {
    const Entry* e = s.take("stages");
    if (!e) return;
    std::vector<double> stages;
    if (e->value.kind == ValueKind::array)
        for (const Value& v : e->value.items)
            if (const auto q = finite_number(v, "an item of 'stages'", Range::not_negative, s.diagnostics())) {
                if (*q > 1 || (!stages.empty() && *q <= stages.back()))
                    s.error(base::codes::job_value, v.where,
                            "'stages' are parts of the length, from 0 to 1, each more than the one before");
                stages.push_back(*q);
            }
    if (stages.empty())
        s.error(base::codes::job_value, e->value.where, "'stages' must be an array of parts of the length",
                "stages = [0, 0.5, 1]");
    else
        b.stages = std::move(stages);
}

void read_cut(Section& file, Blade& b) {
    const Entry* e = file.sub_table("cut");
    if (!e) return;
    Section s(e->value, "[cut]", file.diagnostics());
    b.speed = size_of(s, "speed");
    constexpr std::int64_t most = 1000;
    if (!s.has("teeth")) s.missing("teeth");
    if (const auto teeth = s.integer("teeth", 1, most)) b.teeth = static_cast<int>(*teeth);
    b.most_speed = s.number("max_speed", Range::positive);
    b.force = s.number("force", Range::positive);
    if (const auto n = s.integer("harmonics", 1, most)) b.harmonics = static_cast<int>(*n);
    s.finish();
}

void read_stuff(Section& s, Blade& b) {
    if (const Entry* e = find(s.table(), "material")) {
        b.material_where = e->value.where;
        b.material = s.text("material").value_or("");
        if (s.has("E") || s.has("density"))
            fault(s, s.has("E") ? "E" : "density", "the material says it already", "leave out 'material' or this");
    } else {
        b.elasticity = size_of(s, "E");
        b.density = size_of(s, "density");
    }
}

void read_forms(Section& file, Section& s, Blade& b) {
    if (file.has("station")) {
        Stations all = read_stations(file, b.length);
        b.width = std::move(all.width);
        b.blank = std::move(all.blank);
        b.finished = std::move(all.finished);
        for (const std::string_view key : {"blank", "finished"})
            if (file.has(key)) fault(file, key, "the stations say it already");
        return;
    }
    if (!s.has("width")) s.missing("width");
    b.width = width_of(s);
    for (const auto& [key, form] : {std::pair{"blank", &b.blank}, std::pair{"finished", &b.finished}}) {
        if (const Entry* e = file.sub_table(key))
            *form = read_form(*e, b.length, file.diagnostics());
        else if (!file.has(key))
            file.missing(key);
    }
}

}  // namespace

Blade read_blade(std::uint32_t file, const base::Sources& sources, base::Diagnostics& diagnostics) {
    Blade b;
    const auto root = parse_toml(file, sources, diagnostics);
    if (!root) return b;
    base::Diagnostics found;
    Section s(*root, "the file of a blade", found);
    if (const Entry* e = s.sub_table("blade")) {
        Section t(e->value, "[blade]", found);
        b.length = size_of(t, "length");
        read_stuff(t, b);
        read_forms(s, t, b);
        b.bending_factor = t.number("bending_factor", Range::positive).value_or(1);
        b.root_stiffness = t.number("root_stiffness", Range::positive);
        b.damping = t.number("damping", Range::positive).value_or(b.damping);
        if (b.damping >= 1)
            fault(t, "damping", "'damping' is a part of the critical one: less than 1", "0.002 to 0.01");
        read_stages(t, b);
        t.finish();
    } else if (!s.has("blade")) {
        s.missing("blade");
    }
    read_cut(s, b);
    s.finish_file(diagnostics);
    return b;
}

}  // namespace obrys::shop
