#pragma once
/// Figures as messages show them.

#include <cstdint>
#include <string>
#include <string_view>

#include "geom/vec.hpp"

namespace obrys::check {

/// What is left by a run that did not come to its end is not judged.
inline constexpr const char* rest_of_a_part_run = "rest material is not judged: the run ended before the program's end";

[[nodiscard]] std::string mm(double value);   ///< "9.475 mm"
[[nodiscard]] std::string mm2(double value);  ///< "5.328 mm2"
/// "Z 166.908 X 46.500 (radius)", a point of the (z, x) plane.
[[nodiscard]] std::string point(geom::Vec2 p);
/// "X 1.000 Y 2.000 Z 3.000"
[[nodiscard]] std::string point(geom::Vec3 p);
/// A whole number where it is one, else three decimals.
[[nodiscard]] std::string plain(double value);

/// "tool T3 D1".
[[nodiscard]] std::string tool_name(std::uint32_t number, std::string_view name, std::uint32_t edge);
/// Of a selection (cl::ToolChange) or a use (ToolUse).
template <class Tool>
[[nodiscard]] std::string tool_name(const Tool& tool) {
    return tool_name(tool.number, tool.name, tool.edge);
}

/// Smallest box around points of the (z, x) plane; empty until a point is added.
struct Box {
    double min_z = INFINITY, max_z = -INFINITY, min_x = INFINITY, max_x = -INFINITY;
    void add(geom::Vec2 p);
    void cover(const Box& other);
    [[nodiscard]] bool empty() const { return min_z > max_z; }
    [[nodiscard]] bool meets(const Box& other, double margin) const;
};

}  // namespace obrys::check
