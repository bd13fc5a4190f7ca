#include "shop/files/obrys/holder.hpp"

#include <algorithm>
#include <cmath>

#include "base/codes.hpp"
#include "base/number.hpp"
#include "shop/contour_check.hpp"
#include "shop/files/obrys/profile_point.hpp"

namespace obrys::shop {

namespace {

using base::codes::job_value;
using geom::Contour;
using geom::Vec2;

constexpr double usual_ahead = 1;  ///< mm that the tip stands in front of a boring bar's end

using Range2 = std::pair<double, double>;

Contour rectangle(Range2 z, Range2 x) {
    return {{{{z.first, x.first}, 0}, {{z.second, x.first}, 0}, {{z.second, x.second}, 0}, {{z.first, x.second}, 0}},
            true};
}

/// Two numbers, the smaller one first; nothing where the key is missing or was reported.
std::optional<Range2> read_range(Section& s, std::string_view key) {
    const Entry* e = find(s.table(), key);
    if (e == nullptr) return std::nullopt;
    const std::string what = "'" + std::string(key) + "' of a holder's rectangle";
    if (e->value.kind != ValueKind::array || e->value.items.size() != 2) {
        s.error(job_value, e->value.where, what + " must be two numbers, from and to");
        return std::nullopt;
    }
    const auto a = finite_number(e->value.items[0], what, Range::any, s.diagnostics());
    const auto b = finite_number(e->value.items[1], what, Range::any, s.diagnostics());
    if (!a || !b) return std::nullopt;
    if (std::abs(*b - *a) < same_point) {
        s.error(job_value, e->value.where, what + " has no extent");
        return std::nullopt;
    }
    return Range2{std::min(*a, *b), std::max(*a, *b)};
}

/// The points as a closed contour without crossings.
std::optional<Contour> read_outline(const Entry& e, const Section& s) {
    if (e.value.kind != ValueKind::array || e.value.items.size() < 2) {
        s.error(job_value, e.value.where, "'profile' of a holder must be an array of points round about it");
        return std::nullopt;
    }
    std::vector<ProfilePoint> points;
    for (const Value& v : e.value.items)
        if (const auto p = read_profile_point(v, false, s.diagnostics(), Range::any)) points.push_back(*p);
    if (points.size() != e.value.items.size()) return std::nullopt;
    if (points.size() > 2 && geom::distance(points.front().p, points.back().p) < same_point) points.pop_back();
    Contour out;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const ProfilePoint& next = points[(i + 1) % points.size()];
        if (geom::distance(points[i].p, next.p) < same_point) {
            s.error(job_value, next.where, "this point is the same as the one before it");
            return std::nullopt;
        }
        const auto bulge = bulge_of(points[i], next.p, s);
        if (!bulge) return std::nullopt;
        out.vertices.push_back({points[i].p, *bulge});
    }
    if (const auto pair = first_crossing(out)) {
        s.error(job_value, points[pair->second].where,
                "the holder's profile crosses or touches itself behind this point");
        return std::nullopt;
    }
    if (std::abs(signed_area(out)) <= same_point) {
        s.error(job_value, e.where, "the holder's profile encloses no area");
        return std::nullopt;
    }
    return signed_area(out) > 0 ? out : reversed(out);
}

/// A round bar along z; its axis lies on the side to which the insert goes on from its tip.
std::optional<Contour> read_bar(Section& s, const Tool& tool) {
    const auto diameter = s.number("bar", Range::positive), overhang = s.number("overhang", Range::positive),
               f = s.number("f", Range::not_negative);
    const double ahead = s.number("ahead", Range::not_negative).value_or(usual_ahead);
    for (const std::string_view needed : {"overhang", "f"})
        if (!s.has(needed)) s.missing(needed);
    if (!diameter || !overhang || !f) return std::nullopt;
    if (ahead >= *overhang) {
        const Entry* e = find(s.table(), s.has("ahead") ? "ahead" : "overhang");
        s.error(job_value, e->value.where, "the bar has no length: it ends where the tip stands ahead of it");
        return std::nullopt;
    }
    double low = 0, high = 0;
    for (const geom::Vertex& v : outline(tool).vertices) {
        low = std::min(low, v.p.y);
        high = std::max(high, v.p.y);
    }
    const double axis = -low > high ? -*f : *f;
    return rectangle({ahead, *overhang}, {axis - *diameter / 2, axis + *diameter / 2});
}

std::optional<Contour> read_body(Section& s, const Tool& tool) {
    s.one_of({"profile", "z", "bar"}, true);
    s.take("x");
    const Entry* profile = find(s.table(), "profile");
    const auto z = read_range(s, "z"), x = read_range(s, "x");
    std::optional<Contour> out;
    if (s.has("bar")) out = read_bar(s, tool);
    for (const std::string_view key : {"overhang", "f", "ahead"})
        if (const Entry* e = s.take(key); e != nullptr && !s.has("bar"))
            s.error(job_value, e->where, "'" + std::string(key) + "' means nothing without 'bar'");
    if (const Entry* e = find(s.table(), "x"); e != nullptr && !s.has("z"))
        s.error(job_value, e->where, "'x' means nothing without 'z'");
    s.finish();
    if (profile != nullptr) return read_outline(*profile, s);
    if (!s.has("z")) return out;
    if (!s.has("x")) s.missing("x");
    if (!z || !x) return std::nullopt;
    return rectangle(*z, *x);
}

}  // namespace

std::vector<Contour> read_holder(Section& section, const Tool& tool) {
    std::vector<Contour> out;
    for (const Value* v : section.tables("holder")) {
        Section s(*v, "a body of 'holder'", section.diagnostics());
        if (v->kind != ValueKind::table) continue;
        if (auto body = read_body(s, tool)) out.push_back(std::move(*body));
    }
    return out;
}

}  // namespace obrys::shop
