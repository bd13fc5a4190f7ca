#include "shop/files/obrys/profile_point.hpp"

#include <algorithm>
#include <cmath>

#include "base/codes.hpp"
#include "base/number.hpp"

namespace obrys::shop {

std::optional<ProfilePoint> read_profile_point(const Value& v, bool diameter, base::Diagnostics& diagnostics,
                                               Range radii) {
    Section s(v, "a profile point", diagnostics);
    if (v.kind != ValueKind::table) return std::nullopt;
    ProfilePoint out;
    out.where = v.where;
    const auto z = s.number("z");
    const auto x = s.number("x", radii);
    const auto r = s.number("r");
    const auto turn = s.choice("direction", {"ccw", "cw"});
    out.large = s.boolean("large").value_or(false);
    s.finish();
    if (!s.has("z")) s.missing("z");
    if (!s.has("x")) s.missing("x");
    if (r) {
        out.radius_where = find(v, "r")->value.where;
        if (*r == 0)
            s.error(base::codes::job_value, out.radius_where, "'r' must not be 0", "leave it out for a straight edge");
        if (*r < 0 && turn)
            s.error(base::codes::job_value, out.radius_where, "'r' is negative and 'direction' is given",
                    "use one of the two");
        out.radius = turn.value_or(0) == 1 ? -*r : *r;
    } else if (!s.has("r") && (s.has("direction") || s.has("large"))) {
        s.error(base::codes::job_value, head(v), "'direction' and 'large' need an 'r'");
    }
    if (!z || !x) return std::nullopt;
    out.p = {*z, diameter ? *x / 2 : *x};
    return out;
}

std::optional<double> bulge_of(const ProfilePoint& a, geom::Vec2 b, const Section& s) {
    if (!a.radius || *a.radius == 0) return 0.0;
    const double r = std::abs(*a.radius), chord = geom::distance(a.p, b);
    if (chord > 2 * r + chord_slack) {
        s.error(
            base::codes::job_value, a.radius_where,
            "radius " + base::shortest(r) + " mm is too small: the next point is " + base::fixed(chord, 3) + " mm away",
            "at least " + base::fixed(chord / 2, 3) + " mm");
        return std::nullopt;
    }
    const double half = std::asin(std::min(1.0, chord / (2 * r)));  // half the sweep of the smaller arc
    const double quarter = (a.large ? geom::pi - half : half) / 2;
    return std::copysign(std::tan(quarter), *a.radius);
}

}  // namespace obrys::shop
