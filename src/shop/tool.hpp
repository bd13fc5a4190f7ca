#pragma once
/// Tools as the shop lists them. File format: docs/job-file.md.

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "base/source.hpp"
#include "geom/contour.hpp"

namespace obrys::shop {

enum class ToolKind : std::uint8_t {
    groove,   ///< grooving or parting insert: width, corner radii, reference corner
    turning,  ///< ISO insert: nose radius, cutting edge orientation 1-9, entering angle, tip angle
    other,    ///< named and numbered only: its removal is not simulated
};
enum class ReferenceCorner : std::uint8_t { left, right };  ///< smaller or larger z

struct Tool {
    std::uint32_t number = 0;
    std::string name;
    std::uint32_t edge = 1;             ///< D
    ToolKind kind = ToolKind::other;
    // grooving insert, mm
    double width = 0;
    double corner_radius = 0;           ///< both corners, unless the next two say otherwise
    double corner_radius_left = 0, corner_radius_right = 0;
    ReferenceCorner reference = ReferenceCorner::left;
    double cutting_depth = 0;           ///< length of the blade, 0 = not limited
    // turning insert
    double nose_radius = 0;             ///< mm
    int orientation = 3;                ///< 1-9, position of the imaginary tip P as seen by the nose centre
    double tip_angle = 80;              ///< degrees
    double entering_angle = 95;         ///< degrees, main cutting edge to the feed direction
    double edge_length = 12;            ///< mm
    // any
    double radius = 0;                  ///< mm, milling tools
    double length = 0;                  ///< mm
    std::map<int, double> parameters;   ///< $TC_DPn as read, n = 1 … 25, from TOA files
    base::Span where;                   ///< where it is defined
};

/// Outline of the cutting part in the (z, x) plane relative to the programmed point, mm: counter-clockwise, closed.
/// x points away from the turning axis. An empty contour where the kind has none.
[[nodiscard]] geom::Contour outline(const Tool& tool);

}  // namespace obrys::shop
