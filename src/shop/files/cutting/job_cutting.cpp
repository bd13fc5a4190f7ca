#include "shop/files/cutting/job_cutting.hpp"

#include "base/codes.hpp"
#include "shop/files/section.hpp"

namespace obrys::shop {

namespace {

/// 'key = [least, most]'.
std::optional<std::array<double, 2>> least_and_most(Section& s, std::string_view key) {
    const Entry* e = s.take(key);
    if (!e) return std::nullopt;
    const std::string name = "'" + std::string(key) + "'";
    if (e->value.kind != ValueKind::array || e->value.items.size() != 2) {
        s.error(base::codes::job_value, e->value.where, name + " must be an array of the least and the most");
        return std::nullopt;
    }
    const auto least = finite_number(e->value.items[0], "the least of " + name, Range::positive, s.diagnostics());
    const auto most = finite_number(e->value.items[1], "the most of " + name, Range::positive, s.diagnostics());
    if (!least || !most) return std::nullopt;
    if (*least > *most) {
        s.error(base::codes::job_value, e->value.where, name + " must begin with the least");
        return std::nullopt;
    }
    return std::array{*least, *most};
}

void read_use(const Value& v, base::Diagnostics& diagnostics, CuttingJob& job) {
    Section s(v, "[[cutting]]", diagnostics);
    if (v.kind != ValueKind::table) return;
    ToolUseData t;
    constexpr std::int64_t most_number = 99'999'999, most_teeth = 99;
    if (!s.has("tool")) s.missing("tool");
    if (const auto n = s.integer("tool", 0, most_number)) t.number = static_cast<std::uint32_t>(*n);
    if (const auto n = s.integer("teeth", 1, most_teeth)) t.teeth = static_cast<int>(*n);
    t.helix = s.number("helix", Range::not_negative);
    constexpr double upright = 90;
    if (t.helix && *t.helix >= upright)
        s.error(base::codes::job_value, place(s, "helix"), "'helix' must be less than 90 degrees");
    t.stick_out = s.number("stick_out", Range::positive);
    t.elasticity = s.number("elasticity", Range::positive);
    t.feed_per_tooth = least_and_most(s, "feed_per_tooth");
    t.cutting_speed = least_and_most(s, "cutting_speed");
    s.finish();
    if (find_use(job, t.number) != nullptr)
        s.error(base::codes::job_value, place(s, "tool"), "[[cutting]] of this tool is there twice");
    else
        job.tools.push_back(t);
}

}  // namespace

CuttingJob read_cutting_job(std::uint32_t file, const base::Sources& sources, base::Diagnostics& diagnostics) {
    CuttingJob job;
    const auto root = parse_toml(file, sources, diagnostics);
    if (!root) return job;
    base::Diagnostics found;
    Section s(*root, "the job file", found);
    if (const auto material = s.text("material")) {
        job.material = *material;
        job.material_where = place(s, "material");
    }
    for (const Value* v : s.text_values("materials")) job.materials.push_back({v->text, v->where});
    job.spindle_torque = s.number("spindle_torque", Range::positive);
    for (const Value* v : s.tables("cutting")) read_use(*v, found, job);
    add_in_order(found, diagnostics);
    return job;
}

}  // namespace obrys::shop
