#include "driver/increments.hpp"

#include <algorithm>
#include <cmath>

#include "write/lesser.hpp"

namespace obrys::driver {

double spread_of(const cl::Frame& frame) {
    geom::Vec3 sum;
    for (const geom::Vec3& axis : {geom::Vec3{1, 0, 0}, geom::Vec3{0, 1, 0}, geom::Vec3{0, 0, 1}}) {
        geom::Vec3 v = axis;
        for (auto part = frame.parts.rbegin(); part != frame.parts.rend(); ++part)
            v = geom::apply_direction(part->frame, v);
        sum = sum + geom::Vec3{std::abs(v.x), std::abs(v.y), std::abs(v.z)};
    }
    const double most = std::max({sum.x, sum.y, sum.z});
    return most > 1 ? most : 1;  // one that is not known says nothing
}

compare::Tolerance as_control_counts(const write::Post& post, compare::Tolerance tolerance, double spread) {
    constexpr double slack = 1 + 1e-6;
    tolerance.increment = write::least_arc(post);
    tolerance.length = std::max(tolerance.length, 0.5 * post.increment * spread * slack);
    return tolerance;
}

}  // namespace obrys::driver
