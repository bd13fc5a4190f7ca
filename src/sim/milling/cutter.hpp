#pragma once
/// Milling and drilling tools by their dimensions, and the solids that follow from them.

#include <cstdint>
#include <string>
#include <vector>

#include "geom/contour.hpp"
#include "sim/milling/shape.hpp"

namespace obrys::sim::milling {

enum class CutterKind : std::uint8_t {
    end_mill,     ///< diameter
    ball,         ///< diameter; round end
    bull_nose,    ///< diameter, corner_radius (at most half the diameter: then a ball)
    drill,        ///< diameter, point_angle; tap, reamer and centre drill are drills here (point_angle pi: flat)
    countersink,  ///< diameter, tip_diameter, point_angle
    chamfer,      ///< as countersink
    t_slot,       ///< diameter, width of the disc; above it a neck of neck_diameter; corner_radius on both rims
    form,         ///< profile
};

/// One of a shank's or holder's stacked bodies, from below: cylinder where the diameters agree, else cone.
struct Body {
    double lower_diameter = 0, upper_diameter = 0, length = 0;
};

/// Plain dimensions, mm and radians. What a kind does not use is not looked at.
struct Cutter {
    CutterKind kind = CutterKind::end_mill;
    double diameter = 0;
    double cutting_length = 0;  ///< from the tip to the end of the cutting edges
    double corner_radius = 0;
    double tip_diameter = 0;   ///< flat at the tip of countersink and chamfer
    double point_angle = 0;    ///< between the flanks, below pi; drills also pi
    double width = 0;          ///< of a T-slot cutter's disc
    double neck_diameter = 0;  ///< T-slot
    /// Form tools: half section, x the radius and y the height, from the tip upwards; edges may be arcs. Heights may
    /// not decrease. The radius at the first corner may be above 0: a flat end.
    std::vector<geom::Vertex> profile;
    double deviation = 0.001;  ///< how far frustums may stand off concave arcs of the profile
    std::vector<Body> shank;   ///< from the end of the cutting edges upwards
    std::vector<Body> holder;  ///< from the end of the shank upwards
};

/// What cuts and what must not touch. Of a T-slot cutter the neck belongs to the shank.
struct ToolShape {
    Shape cutting, shank, holder;
};
struct MadeShape {
    ToolShape shape;
    std::string problem;  ///< what makes no tool of it, for the user ("diameter is not positive"); empty: nothing
    [[nodiscard]] bool ok() const { return problem.empty(); }
};
[[nodiscard]] MadeShape shape_of(const Cutter& cutter);

/// Smallest radius that the cutting part leaves in a surface, for `step_for`: of ball, corner, profile arcs or, where
/// there is none that matters at this tolerance, of the tool itself.
[[nodiscard]] double smallest_radius(const ToolShape& shape, double tolerance);

}  // namespace obrys::sim::milling
