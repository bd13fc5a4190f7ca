#pragma once
/// What the cycles for pockets, slots and studs have in common: their parameters and the order of roughing and
/// finishing.

#include "cycles/mill/figures.hpp"
#include "cycles/mill/milling.hpp"
#include "cycles/shapes.hpp"

namespace obrys::cycles {

/// Parameters of 251 to 254, 256, 257 and the like. Heights absolute, angles in radians.
struct PocketData {
    Heights h;
    double radius = 0;  ///< of the tool
    double side = 0, floor = 0;
    double infeed = 0, finish_infeed = 0;
    double mill = 0, plunge = 0, finish = 0;
    double stepover = 0;
    double lift = 0;  ///< the set-up clearance
    double rotation = 0;
    int operation = 0;  ///< 0 roughing and finishing, 1 roughing, 2 finishing
    int position = 0;   ///< which point of the figure the called position is
    bool climb = true;
    Descent descent;
    geom::Vec2 called;
};
[[nodiscard]] PocketData pocket_data(Course& course, const MilledFigure& cycle, const Situation& situation);

/// A figure in coordinates of its own.
struct PocketFigure {
    geom::Region region;
    Placement where;
    geom::Vec2 start;  ///< where the tool goes down when it roughs; used where `convex`
    bool convex = true;
    geom::Contour middle = {};  ///< of a slot: the path of a tool as wide as the slot; empty otherwise
};
/// Roughing from the inside outwards and finishing, walls first, then the floor, as the operation says.
void mill_pocket(Course& course, const PocketData& p, const PocketFigure& figure);

}  // namespace obrys::cycles
