#include "interp/values/nose_of_tool.hpp"

#include "base/whole.hpp"
#include "interp/values/values.hpp"
#include "shop/orientation.hpp"

namespace obrys::interp {

namespace {

constexpr int point_of_axis = 9;

/// The nose is the rounding at the corner that the program moves.
int blade_orientation(const shop::Tool& t) {
    const bool left = t.reference == shop::ReferenceCorner::left;
    switch (t.direction) {
        case shop::BladeDirection::in: return left ? 2 : 1;
        case shop::BladeDirection::face: return left ? 3 : 2;
        default: return left ? 3 : 4;
    }
}

}  // namespace

std::optional<int> nose_orientation(const shop::Tool& t) {
    if (t.kind == shop::ToolKind::turning) return t.orientation;
    if (t.kind == shop::ToolKind::groove) return blade_orientation(t);
    if (shop::is_milling(t.kind)) return point_of_axis;
    const std::optional<double> said = shop::parameter(t, 2);
    return said ? base::whole<int>(*said, 1, 9) : std::nullopt;
}

std::optional<int> table_orientation(const shop::Tool& t) {
    if (t.table) return t.table->orientation;
    const std::optional<int> orientation = nose_orientation(t);
    return orientation ? std::optional(shop::mirrored_orientation(*orientation)) : std::nullopt;
}

}  // namespace obrys::interp
