#include "path/compensation/preset.hpp"

#include "path/nose.hpp"

namespace obrys::path {

Setting held_move_preset(double unit) {
    Setting s;
    s.method = Method::held_move;
    s.limits.sweep_growth = unit == 25.4 ? 0.001 : 0.0254;
    s.limits.radius_change = 0.01 * unit;
    return s;
}

std::optional<geom::Vec2> table_nose_offset(int orientation, double radius) {
    if (orientation == 0) return geom::Vec2{};
    auto tip = nose_offset(orientation, radius);
    if (tip) tip->y = -tip->y;
    return tip;
}

}  // namespace obrys::path
