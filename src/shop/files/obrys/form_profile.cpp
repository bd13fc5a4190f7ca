#include "shop/files/obrys/form_profile.hpp"

#include <cmath>

#include "base/codes.hpp"
#include "base/number.hpp"
#include "shop/contour_check.hpp"
#include "shop/files/obrys/profile_point.hpp"

namespace obrys::shop {

namespace {

using base::codes::job_value;

std::optional<ProfilePoint> read_pair(const Value& v, base::Diagnostics& diagnostics) {
    const auto r = finite_number(v.items[0], "the radius of a profile point", Range::not_negative, diagnostics);
    const auto h = finite_number(v.items[1], "the height of a profile point", Range::any, diagnostics);
    if (!r || !h) return std::nullopt;
    return ProfilePoint{{*r, *h}, std::nullopt, false, v.where, v.where};
}

std::optional<ProfilePoint> read_point(const Value& v, const Section& s) {
    if (v.kind == ValueKind::array && v.items.size() == 2) return read_pair(v, s.diagnostics());
    if (v.kind == ValueKind::table) {
        auto out = read_profile_point(v, false, s.diagnostics());
        if (out) out->p = {out->p.y, out->p.x};
        return out;
    }
    s.error(job_value, v.where, "a point of a tool's profile must be [radius, height] or {x, z}");
    return std::nullopt;
}

/// Whether the edge goes down somewhere: an arc's direction turns by its sweep, so up to a half turn its ends tell.
bool goes_down(const geom::Vertex& a, geom::Vec2 b) {
    if (std::abs(a.bulge) > 1 + 1e-9) return true;  // more than a half turn
    const geom::Vec2 d = b - a.p;
    const double turn = 2 * std::atan(a.bulge);  // from the chord back to the start, ahead to the end
    const double slack = -1e-9 * geom::length(d);
    const double c = std::cos(turn), s = std::sin(turn);
    return d.y * c - d.x * s < slack || d.y * c + d.x * s < slack;
}

/// Complains about an edge that no turning tool can have; true where it did.
bool bad_edge(const geom::Vertex& a, geom::Vec2 b, base::Span where, const Section& s) {
    if (geom::distance(a.p, b) < same_point) {
        s.error(job_value, where, "this point is the same as the next one");
    } else if (goes_down(a, b)) {
        s.error(job_value, where, "the profile goes down behind this point",
                "its heights begin at 0 and never decrease; an arc is not more than a half circle");
    } else if (lowest_y({{a.p.y, a.p.x}, -a.bulge}, {b.y, b.x}) < -chord_slack) {
        s.error(job_value, where, "the arc from this point crosses the tool's axis");
    } else {
        return false;
    }
    return true;
}

}  // namespace

std::vector<geom::Vertex> read_form_profile(Section& tool) {
    const Entry* e = tool.take("profile");
    if (!e) return {};
    if (e->value.kind != ValueKind::array) {
        tool.error(job_value, e->value.where,
                   "'profile' must be an array of points, not " + std::string(kind_name(e->value.kind)));
        return {};
    }
    std::vector<ProfilePoint> points;
    for (const Value& v : e->value.items)
        if (const auto p = read_point(v, tool)) points.push_back(*p);
    if (points.size() != e->value.items.size()) return {};
    if (points.size() < 2) {
        tool.error(job_value, e->where, points.empty() ? "the profile is empty" : "the profile has only one point");
        return {};
    }
    if (points.front().p.y != 0) {
        tool.error(job_value, points.front().where,
                   "the profile begins at height 0, the tip, not at " + base::shortest(points.front().p.y));
        return {};
    }
    std::vector<geom::Vertex> out;
    for (std::size_t i = 0; i < points.size(); ++i) {
        out.push_back({points[i].p, 0});
        if (i + 1 == points.size()) break;
        const auto bulge = bulge_of(points[i], points[i + 1].p, tool);
        if (!bulge) return {};
        out.back().bulge = *bulge;
        if (bad_edge(out.back(), points[i + 1].p, points[i].where, tool)) return {};
    }
    if (points.back().radius) {
        tool.error(job_value, points.back().radius_where, "'r' on the last point: no edge follows it");
        return {};
    }
    if (out.back().p.y > 0) return out;
    tool.error(job_value, e->where, "the profile has no height");
    return {};
}

}  // namespace obrys::shop
