#include "shop/files/obrys/profile.hpp"

#include <algorithm>
#include <cmath>

#include "base/codes.hpp"
#include "base/number.hpp"
#include "shop/contour_check.hpp"
#include "shop/files/obrys/profile_point.hpp"

namespace obrys::shop {

namespace {

using geom::Vec2;
using Point = ProfilePoint;

/// The points as one contour; nothing where something was reported.
std::optional<geom::Contour> join(const std::vector<Point>& points, bool closed, const Section& s) {
    geom::Contour out;
    out.closed = closed;
    bool good = true;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const bool last = i + 1 == points.size();
        if (last && !closed && points[i].radius)
            s.error(base::codes::job_value, points[i].radius_where, "'r' on the last point: no edge follows it"),
                good = false;
        const Vec2 next = points[last ? 0 : i + 1].p;
        if ((!last || closed) && geom::distance(points[i].p, next) < same_point) {
            s.error(base::codes::job_value, points[last ? 0 : i + 1].where,
                    "this point is the same as the one before it");
            good = false;
        }
        const auto b = last && !closed ? std::optional(0.0) : bulge_of(points[i], next, s);
        good = good && b.has_value();
        out.vertices.push_back({points[i].p, b.value_or(0)});
    }
    return good ? std::optional(out) : std::nullopt;
}

/// The drawn contour as a closed one; an open profile is led down to the axis and along it.
geom::Contour close(const geom::Contour& drawn) {
    geom::Contour out = drawn;
    out.closed = true;
    if (drawn.closed) return out;
    auto& v = out.vertices;
    const auto on_axis = [&](std::size_t i) { return v[i].p.y == 0; };
    while (v.size() > 2 && on_axis(0) && on_axis(1) && v[0].bulge == 0) v.erase(v.begin());
    while (v.size() > 2 && on_axis(v.size() - 1) && on_axis(v.size() - 2) && v[v.size() - 2].bulge == 0) v.pop_back();
    const Vec2 first = v.front().p, last = v.back().p;
    if (last.y != 0) v.push_back({{last.x, 0}, 0});
    if (first.y != 0 && first.x != last.x) v.push_back({{first.x, 0}, 0});
    return out;
}

/// What makes a contour no boundary of a body; true where something was reported.
bool report_shape(const geom::Contour& contour, const std::vector<Point>& points, bool closed, base::Span where,
                  const Section& s) {
    const std::size_t n = contour.vertices.size();
    // The point a drawn edge begins at; nothing for an edge that only closes the profile to the axis.
    const auto place = [&](std::size_t edge) -> std::optional<base::Span> {
        for (const Point& p : points)
            if (p.p == contour.vertices[edge].p && (closed || &p != &points.back())) return p.where;
        return std::nullopt;
    };
    for (std::size_t i = 0; i < n; ++i) {
        if (lowest_y(contour.vertices[i], contour.vertices[(i + 1) % n].p) < -chord_slack) {
            s.error(base::codes::job_value, place(i).value_or(where),
                    "the arc from this point crosses the turning axis");
            return true;
        }
    }
    if (std::abs(signed_area(contour)) <= same_point) {
        s.error(base::codes::job_value, where, "the profile encloses no area");
        return true;
    }
    if (const auto pair = first_crossing(contour)) {
        const auto first = place(pair->first), second = place(pair->second);
        base::Diagnostic d;
        d.code = base::codes::job_value;
        d.where = second ? *second : first.value_or(where);
        d.text = first && second
                     ? "the profile crosses or touches itself: the edge from this point"
                     : "the edge from this point crosses or touches the one that closes the profile to the axis";
        if (first && second) d.related.push_back({*first, "meets the edge from this point"});
        s.diagnostics().add(std::move(d));
        return true;
    }
    return false;
}

std::optional<Profile> build(const std::vector<Point>& points, bool closed, base::Span where, const Section& s) {
    const auto drawn = join(points, closed, s);
    if (!drawn) return std::nullopt;
    geom::Contour contour = close(*drawn);
    if (report_shape(contour, points, closed, where, s)) return std::nullopt;
    if (signed_area(contour) < 0) contour = reversed(contour);
    Profile out;
    out.region.contours.push_back(std::move(contour));
    out.drawn = *drawn;
    out.where = where;
    return out;
}

/// z range of a blank: two of z_min, z_max, length; with the length alone the right face is z = 0.
std::optional<std::pair<double, double>> z_range(Section& s) {
    const auto length = s.number("length", Range::positive), low = s.number("z_min"), high = s.number("z_max");
    const bool l = s.has("length"), a = s.has("z_min"), b = s.has("z_max");
    if ((l && !length) || (a && !low) || (b && !high)) return std::nullopt;  // reported
    if (l && a && b) {
        s.error(base::codes::job_value, find(s.table(), "length")->where, "'length', 'z_min' and 'z_max' together",
                "leave one out");
    } else if (a && b && *low < *high) {
        return std::pair{*low, *high};
    } else if (a && b) {
        s.error(base::codes::job_value, find(s.table(), "z_max")->value.where, "'z_max' must be greater than 'z_min'");
    } else if (l) {
        const double right = b ? *high : a ? *low + *length : 0;
        return std::pair{a ? *low : right - *length, right};
    } else if (s.table().kind == ValueKind::table) {
        s.missing("length");
    }
    return std::nullopt;
}

std::optional<double> needed(Section& s, std::string_view key, Range range) {
    const auto v = s.number(key, range);
    if (!v && !s.has(key)) s.missing(key);
    return v;
}

std::vector<Point> to_points(std::initializer_list<Vec2> corners, base::Span where) {
    std::vector<Point> out;
    for (const Vec2 c : corners) out.push_back({c, std::nullopt, false, where, where});
    return out;
}

std::optional<Profile> read_bar(const Value& v, base::Diagnostics& diagnostics) {
    Section s(v, "'bar'", diagnostics);
    const auto d = needed(s, "diameter", Range::positive);
    const auto z = z_range(s);
    s.finish();
    if (!d || !z) return std::nullopt;
    return build(to_points({{z->first, *d / 2}, {z->second, *d / 2}}, v.where), false, v.where, s);
}

std::optional<Profile> read_tube(const Value& v, base::Diagnostics& diagnostics) {
    Section s(v, "'tube'", diagnostics);
    const auto outer = needed(s, "outer_diameter", Range::positive),
               inner = needed(s, "inner_diameter", Range::positive);
    const auto z = z_range(s);
    s.finish();
    if (!outer || !inner || !z) return std::nullopt;
    if (*inner >= *outer) {
        s.error(base::codes::job_value, find(v, "inner_diameter")->value.where,
                "'inner_diameter' must be smaller than 'outer_diameter'");
        return std::nullopt;
    }
    const double a = *inner / 2, b = *outer / 2;
    return build(to_points({{z->first, a}, {z->second, a}, {z->second, b}, {z->first, b}}, v.where), true, v.where, s);
}

std::optional<Profile> read_cone(const Value& v, base::Diagnostics& diagnostics) {
    Section s(v, "'cone'", diagnostics);
    const auto left = needed(s, "left_diameter", Range::not_negative),
               right = needed(s, "right_diameter", Range::not_negative);
    const auto z = z_range(s);
    s.finish();
    if (!left || !right || !z) return std::nullopt;
    if (*left == 0 && *right == 0) {
        s.error(base::codes::job_value, head(v), "both diameters of the cone are 0");
        return std::nullopt;
    }
    return build(to_points({{z->first, *left / 2}, {z->second, *right / 2}}, v.where), false, v.where, s);
}

}  // namespace

std::optional<Profile> read_profile(Section& section) {
    const Entry* e = section.take("profile");
    const bool diameter = section.boolean("diameter").value_or(false);
    const bool closed = section.boolean("closed").value_or(false);
    if (!e) {
        for (const std::string_view key : {"diameter", "closed"})
            if (const Entry* alone = find(section.table(), key))
                section.error(base::codes::job_value, alone->where,
                              "'" + std::string(key) + "' means nothing without a 'profile'");
        return std::nullopt;
    }
    if (e->value.kind != ValueKind::array) {
        section.error(base::codes::job_value, e->value.where,
                      "'profile' must be an array of points, not " + std::string(kind_name(e->value.kind)));
        return std::nullopt;
    }
    std::vector<Point> points;
    for (const Value& v : e->value.items)
        if (const auto p = read_profile_point(v, diameter, section.diagnostics())) points.push_back(*p);
    if (points.size() != e->value.items.size()) return std::nullopt;
    // A closed profile may say its first point again at its end.
    if (closed && points.size() > 2 && geom::distance(points.front().p, points.back().p) < same_point)
        points.pop_back();
    if (points.size() < 2) {
        section.error(base::codes::job_value, e->where,
                      points.empty() ? "the profile is empty" : "the profile has only one point");
        return std::nullopt;
    }
    return build(points, closed, e->where, section);
}

std::optional<Profile> read_blank(Section& section) {
    const Entry* bar = section.sub_table("bar");
    const Entry* tube = section.sub_table("tube");
    const Entry* cone = section.sub_table("cone");
    if (bar) return read_bar(bar->value, section.diagnostics());
    if (tube) return read_tube(tube->value, section.diagnostics());
    if (cone) return read_cone(cone->value, section.diagnostics());
    return std::nullopt;
}

}  // namespace obrys::shop
