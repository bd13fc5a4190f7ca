#include "shop/files/obrys/solid_file.hpp"

#include <array>

#include "base/codes.hpp"
#include "base/number.hpp"
#include "base/text.hpp"

namespace obrys::shop {

namespace {

constexpr std::array<std::string_view, 3> axis_names{"x", "y", "z"};

/// So many numbers in an array; nothing where the key is missing or was reported.
std::optional<std::vector<double>> read_numbers(Section& s, std::string_view key, std::size_t count,
                                                std::string_view say) {
    const Entry* e = s.take(key);
    if (!e) return std::nullopt;
    const std::string what = "'" + std::string(key) + "'";
    if (e->value.kind != ValueKind::array || e->value.items.size() != count) {
        s.error(base::codes::job_value, e->value.where, what + " must be " + std::string(say));
        return std::nullopt;
    }
    std::vector<double> out;
    for (const Value& v : e->value.items)
        if (const auto n = finite_number(v, "a coordinate of " + what, Range::any, s.diagnostics())) out.push_back(*n);
    return out.size() == count ? std::optional(out) : std::nullopt;
}

double in_axis(const geom::Vec3& v, int axis) { return axis == 0 ? v.x : axis == 1 ? v.y : v.z; }

std::optional<Solid> read_box(const Value& v, const geom::Vec3& offset, base::Diagnostics& diagnostics) {
    Section s(v, "'box'", diagnostics);
    const auto min = read_vector(s, "min"), max = read_vector(s, "max");
    s.finish();
    for (const std::string_view key : {"min", "max"})
        if (!s.has(key)) s.missing(key);
    if (!min || !max) return std::nullopt;
    for (int axis = 0; axis < 3; ++axis) {
        if (in_axis(*min, axis) < in_axis(*max, axis)) continue;
        const auto i = static_cast<std::size_t>(axis);
        s.error(base::codes::job_value, find(v, "max")->value.items[i].where,
                "'max' must be greater than 'min' in " + std::string(axis_names[i]) + ": " +
                    base::shortest(in_axis(*max, axis)) + " is not greater than " +
                    base::shortest(in_axis(*min, axis)));
        return std::nullopt;
    }
    return SolidBox{*min + offset, *max + offset};
}

std::optional<double> read_radius(Section& s) {
    if (!s.one_of({"diameter", "radius"}, false)) {
        s.missing("diameter");
        return std::nullopt;
    }
    const auto diameter = s.number("diameter", Range::positive), radius = s.number("radius", Range::positive);
    if (diameter) return *diameter / 2;
    return radius;
}

std::optional<Solid> read_cylinder(const Value& v, const geom::Vec3& offset, base::Diagnostics& diagnostics) {
    Section s(v, "'cylinder'", diagnostics);
    if (v.kind != ValueKind::table) return std::nullopt;
    SolidCylinder out;
    const auto radius = read_radius(s), min = s.number("min"), max = s.number("max");
    if (const auto axis = s.choice("axis", {"x", "y", "z"})) out.axis = static_cast<int>(*axis);
    const auto centre = read_numbers(s, "centre", 2, "an array of two numbers: the centre in the two other axes");
    s.finish();
    for (const std::string_view key : {"min", "max"})
        if (!s.has(key)) s.missing(key);
    if (!radius || !min || !max || (s.has("centre") && !centre)) return std::nullopt;
    if (*min >= *max) {
        s.error(base::codes::job_value, place(s, "max"), "'max' must be greater than 'min'");
        return std::nullopt;
    }
    if (centre) {
        const double first = (*centre)[0], second = (*centre)[1];
        out.centre = out.axis == 0   ? geom::Vec3{0, first, second}
                     : out.axis == 1 ? geom::Vec3{first, 0, second}
                                     : geom::Vec3{first, second, 0};
    }
    const double along = in_axis(offset, out.axis);
    const geom::Vec3 unit{out.axis == 0 ? 1.0 : 0, out.axis == 1 ? 1.0 : 0, out.axis == 2 ? 1.0 : 0};
    out.centre = out.centre + offset - along * unit;
    out.radius = *radius;
    out.min = *min + along;
    out.max = *max + along;
    return out;
}

std::optional<SolidFile> read_file(Section& s, const geom::Vec3& offset) {
    const auto path = s.text("file");
    const auto unit = s.choice("unit", {"mm", "inch"});
    if (!s.has("file")) {
        if (s.has("unit")) s.error(base::codes::job_value, place(s, "unit"), "'unit' means nothing without a 'file'");
        return std::nullopt;
    }
    if (!path || (s.has("unit") && !unit)) return std::nullopt;
    if (unit && is_step_name(*path)) {
        s.error(base::codes::job_value, place(s, "unit"),
                "'unit' does not go with a STEP file, which says its unit itself");
        return std::nullopt;
    }
    SolidFile out;
    out.path = *path;
    out.unit = unit.value_or(0) == 1 ? 25.4 : 1;
    out.unit_known = unit || is_step_name(*path);
    out.offset = offset;
    out.where = place(s, "file");
    return out;
}

/// Where a body stands that is drawn somewhere else; nothing where that was reported.
std::optional<geom::Vec3> read_offset(Section& s) {
    const auto offset = read_vector(s, "offset");
    if (offset || !s.has("offset")) return offset.value_or(geom::Vec3{});
    return std::nullopt;
}

}  // namespace

std::optional<geom::Vec3> read_vector(Section& section, std::string_view key) {
    const auto numbers = read_numbers(section, key, 3, "an array of three numbers: x, y, z");
    if (!numbers) return std::nullopt;
    return geom::Vec3{(*numbers)[0], (*numbers)[1], (*numbers)[2]};
}

std::optional<Solid> read_solid(Section& section) {
    const auto offset = read_offset(section);
    const Entry* box = section.sub_table("box");
    const Entry* cylinder = section.sub_table("cylinder");
    const geom::Vec3 by = offset.value_or(geom::Vec3{});
    std::optional<Solid> out;
    if (auto file = read_file(section, by)) out = std::move(*file);
    if (box) out = read_box(box->value, by, section.diagnostics());
    if (cylinder) out = read_cylinder(cylinder->value, by, section.diagnostics());
    return offset ? out : std::nullopt;
}

std::optional<Part> read_part_file(Section& section) {
    const auto offset = read_offset(section);
    const auto file = read_file(section, offset.value_or(geom::Vec3{}));
    if (!file || !offset) return std::nullopt;
    return Part{*file};
}

std::vector<Clamp> read_clamps(Section& file) {
    std::vector<Clamp> out;
    std::size_t number = 0;
    for (const Value* v : file.tables("clamp")) {
        ++number;
        Section s(*v, "[[clamp]]", file.diagnostics());
        if (v->kind != ValueKind::table) continue;
        const auto name = s.text("name");
        s.one_of({"box", "cylinder", "file"}, true);
        auto solid = read_solid(s);
        s.finish();
        if (solid) out.push_back({name.value_or("clamp " + std::to_string(number)), std::move(*solid), v->where});
    }
    return out;
}

}  // namespace obrys::shop
