#pragma once
/// Milling of areas and walls level by level: what pockets, slots and contour cycles have in common.
///
/// Paths are of the tool's centre. `room` is where the centre may be at full depth: the finished contour inset by the
/// tool's radius and the allowance. No path here leaves it below the surface.

#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "cycles/course.hpp"
#include "cycles/shapes.hpp"
#include "geom/region.hpp"

namespace obrys::cycles {

/// How the tool gets into the material.
enum class Plunge : std::uint8_t { straight, helix, reciprocate };
struct Descent {
    Plunge how = Plunge::straight;
    double angle = 0;   ///< radians, below a quarter turn; of helix and reciprocation
    double length = 0;  ///< of a reciprocation at most; 0: two tool diameters
    double feed = 0;
};
/// Of the tool: known, above 0 and of a size that mills.
[[nodiscard]] double milling_radius(Course& course, const Situation& situation);
/// Complains of a contour that lies out of any machine's reach or is not known.
void check_size(Course& course, const geom::Region& region);

/// Adds the tool's plunging angle to a descent. 0 (the tool table says that it cannot) is a complaint; not known, or
/// 90 degrees: straight down.
void set_angle(Course& course, const Situation& situation, Descent& descent);

inline constexpr double rapid_retract = std::numeric_limits<double>::infinity();

/// The heights of one machining, absolute w.
struct Cuts {
    double top = 0;              ///< of the material
    double clearance = 0;        ///< above it, where the tool may move at rapid traverse
    std::vector<double> levels;  ///< downwards
    double lift = 0;      ///< above a level that is cut, at which the tool may move at rapid traverse within the room
    bool direct = false;  ///< the room is convex: the tool returns to its start within it, not above the clearance
    double retract = 0;   ///< feed of the retraction; or rapid_retract
    double safe =
        -std::numeric_limits<double>::infinity();  ///< height of the ways between parts, if above the clearance
};

/// Centre paths that clear the region of all that a tool of the radius reaches, `side` left standing; none after a
/// complaint. A part of the region where the tool does not fit is complained of with its place: fatal where it fits
/// nowhere.
struct AreaPaths {
    std::vector<geom::Contour> tours;  ///< open; geom::clearing_tours
    geom::Region room;
};
struct AreaOptions {
    double radius = 0, side = 0, stepover = 0, rounding = 0;
    bool climb = true;     ///< with the spindle turning clockwise
    Placement where = {};  ///< of the region; the paths are placed
};
[[nodiscard]] AreaPaths area_paths(Course& course, const geom::Region& region, const AreaOptions& options);

/// Complains of parts of the region in which the tool finds no room; `nowhere`: in none, which is fatal.
void complain_of_room(Course& course, const geom::Region& region, const AreaOptions& options, bool nowhere);

/// Along an edge that starts where the tool stands, to height `w`; an arc that leaves its chord by less than 1e-7 mm is
/// run as a line.
void run_edge(Course& course, const geom::Edge& e, double w, double feed);
/// Along a chain that starts where the tool stands, at height `w`.
void follow(Course& course, const geom::Contour& chain, double w, double feed);
/// Down from where the tool stands, the start of the chain. A helix within the room; where there is none, along the
/// chain's first stretch to and fro. Ends at the start of the chain.
void descend(Course& course, const geom::Contour& chain, const geom::Region& room, double to, double radius,
             const Descent& descent);
/// Each tour on each level, a tour to its full depth before the next. Ends at the clearance.
void mill_tours(Course& course, const AreaPaths& paths, const Cuts& cuts, double radius, const Descent& descent,
                double feed);

/// A closed run along a wall with tangential arcs to and from it, whole discs of which lie in the room; without them
/// where there is no room for any.
struct Wall {
    geom::Contour run;  ///< open: starts and ends at the same point
    geom::Vec2 from, to;
    geom::Vec2 centre;  ///< of the arcs
    double turn = 0;    ///< of each arc, radians, signed; 0: no arcs
};
struct WallOptions {
    double arc = 0;           ///< radius at most
    bool semicircle = false;  ///< half circles instead of quarters
    bool climb = true;
    Placement where = {};  ///< of the room; the walls are placed
};
/// One for each contour of the room (which lies left of it).
[[nodiscard]] std::vector<Wall> walls_of(const geom::Region& room, const WallOptions& options);
/// Of the outside of a stud grown by the tool's radius: the tool runs around it.
[[nodiscard]] std::vector<Wall> walls_around(const geom::Region& stud, const WallOptions& options);
/// Each wall on each level. The tool goes down at the start of the arc. Ends at the clearance.
void mill_walls(Course& course, const std::vector<Wall>& walls, const Cuts& cuts, double plunge_feed, double feed);

/// Levels of equal infeeds; the last one is what remains.
[[nodiscard]] std::vector<double> even_levels(Course& course, double top, double bottom, double infeed);

/// "u 12.5 v 3" for complaints.
[[nodiscard]] std::string place_text(geom::Vec2 p);

}  // namespace obrys::cycles
