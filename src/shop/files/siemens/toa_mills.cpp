// Types: list of tool types, SINUMERIK 840D sl Programming Manual Job Planning, chapter "Tool offsets"; which of R, r
// and a counts for which mill: 6FC5398-2BP10-1BA0 (03/2006), section 8.5.3. 110 is the cylindrical die-sinking cutter,
// a ball of the tool's radius; 111 ends in a ball of the corner radius, which is larger; 155 to 157 are cones.
#include "shop/files/siemens/toa_mills.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/number.hpp"
#include "shop/files/dropped.hpp"
#include "shop/files/taper.hpp"

namespace obrys::shop {

namespace {

struct MillType {
    int number;
    ToolKind kind;
    double point_angle;  ///< degrees, assumed; 0: it has none
};
constexpr std::array mill_types{MillType{100, ToolKind::end_mill, 0},      MillType{110, ToolKind::ball, 0},
                                MillType{111, ToolKind::ball, 0},          MillType{120, ToolKind::end_mill, 0},
                                MillType{121, ToolKind::bull_nose, 0},     MillType{130, ToolKind::end_mill, 0},
                                MillType{131, ToolKind::bull_nose, 0},     MillType{140, ToolKind::end_mill, 0},
                                MillType{150, ToolKind::t_slot, 0},        MillType{151, ToolKind::t_slot, 0},
                                MillType{155, ToolKind::form, 0},          MillType{156, ToolKind::form, 0},
                                MillType{157, ToolKind::form, 0},          MillType{200, ToolKind::drill, 118},
                                MillType{205, ToolKind::drill, 180},       MillType{210, ToolKind::reamer, 0},
                                MillType{220, ToolKind::centre_drill, 90}, MillType{230, ToolKind::countersink, 90},
                                MillType{231, ToolKind::end_mill, 0},      MillType{240, ToolKind::tap, 0},
                                MillType{241, ToolKind::tap, 0},           MillType{242, ToolKind::tap, 0},
                                MillType{250, ToolKind::reamer, 0}};

double sum(const Tool& t, std::initializer_list<int> numbers) {
    double s = 0;
    for (const int n : numbers)
        if (const auto p = t.parameters.find(n); p != t.parameters.end()) s += p->second;
    return s;
}

std::string number(double v) { return base::shortest(v); }

void take_disc(Tool& t, double width) {
    t.width = width;
    t.neck_diameter = t.radius;
    if (width > 0)
        assume(t.assumed, "neck diameter " + number(t.neck_diameter) + " mm");
    else
        t.kind = ToolKind::other;
}

/// A spherical end of a radius above the tool's: the cap that the shank cuts out of it.
void take_cap(Tool& t, double corner) {
    t.corner_radius = t.radius;
    if (!(corner > t.radius)) return;
    const double height = corner - std::sqrt(corner * corner - t.radius * t.radius);
    const double top = std::max(t.length, height + t.radius);
    t.kind = ToolKind::form;
    t.profile = {{{0, 0}, std::tan(std::asin(t.radius / corner) / 4)}, {{t.radius, height}, 0}, {{t.radius, top}, 0}};
    assume(t.assumed, "cutting edge up to the height of " + number(top) + " mm");
}

void take_cone(Tool& t, int type, double corner, double angle) {
    const double height = t.length > 0 ? t.length : 5 * t.radius;
    t.profile = tapered_profile(t.radius, type == 156 ? corner : 0, angle, height);
    if (t.profile.empty()) {
        t.kind = ToolKind::other;
        return;
    }
    assume(t.assumed,
           "radius " + number(t.radius) + " mm at the tip, cutting edge up to the height of " + number(height) + " mm");
}

}  // namespace

void take_mill(Tool& t, int type) {
    const auto found =
        std::find_if(mill_types.begin(), mill_types.end(), [&](const MillType& o) { return o.number == type; });
    if (found == mill_types.end() || !(t.radius > 0)) return;
    const double corner = std::max(0.0, sum(t, {7, 16}));
    t.kind = found->kind;
    if (found->point_angle > 0) {
        t.point_angle = found->point_angle;
        assume(t.assumed, "point angle " + number(found->point_angle) + " degrees");
    }
    if (t.kind == ToolKind::t_slot) return take_disc(t, corner);
    if (t.kind == ToolKind::form) return take_cone(t, type, corner, sum(t, {11, 20}));
    if (t.kind == ToolKind::ball) return take_cap(t, type == 111 ? corner : 0);
    if (t.kind != ToolKind::end_mill && t.kind != ToolKind::bull_nose) return;
    const bool rounded = type == 121 || type == 131 || type == 100 || type == 140;  // of others it is not evaluated
    t.corner_radius = rounded ? corner : 0;
    t.kind = ToolKind::other;
    t.kind = assumed_kind(t);
}

}  // namespace obrys::shop
