#include "check/words.hpp"

#include <algorithm>
#include <cmath>

#include "base/number.hpp"

namespace obrys::check {

std::string mm(double value) { return base::fixed(value, 3) + " mm"; }
std::string mm2(double value) { return base::fixed(value, 3) + " mm2"; }
std::string point(geom::Vec2 p) { return "Z " + base::fixed(p.x, 3) + " X " + base::fixed(p.y, 3) + " (radius)"; }
std::string point(geom::Vec3 p) {
    return "X " + base::fixed(p.x, 3) + " Y " + base::fixed(p.y, 3) + " Z " + base::fixed(p.z, 3);
}
std::string plain(double value) { return base::fixed(value, std::abs(value - std::round(value)) < 5e-4 ? 0 : 3); }

std::string tool_name(std::uint32_t number, std::string_view name, std::uint32_t edge) {
    std::string out = "tool";
    if (number != 0 || name.empty()) out += " T" + std::to_string(number);
    if (!name.empty()) out += " \"" + std::string(name) + "\"";
    return out + (edge != 0 ? " D" + std::to_string(edge) : "");
}

void Box::add(geom::Vec2 p) {
    min_z = std::min(min_z, p.x);
    max_z = std::max(max_z, p.x);
    min_x = std::min(min_x, p.y);
    max_x = std::max(max_x, p.y);
}

void Box::cover(const Box& other) {
    if (other.empty()) return;
    add({other.min_z, other.min_x});
    add({other.max_z, other.max_x});
}

bool Box::meets(const Box& other, double margin) const {
    return min_z <= other.max_z + margin && other.min_z <= max_z + margin && min_x <= other.max_x + margin &&
           other.min_x <= max_x + margin;
}

}  // namespace obrys::check
