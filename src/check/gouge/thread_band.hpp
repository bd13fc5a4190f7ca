#pragma once
/// Tapped holes. A tap is simulated with the core of its thread; a part's model shows such a hole with the core, with
/// the outer diameter, or with anything between. Where the wall of a tapped hole stands off the part's by one and the
/// same amount within the thread's depth, that is how the part shows the thread and no rest material or gouge. That
/// amount is the difference of two radii: of the part's wall about the tap's axis, and of the hole that was made
/// before, about its own. So a hole beside its thread, which the tap then cuts on one side, does not pass for another
/// thread; nor does one that a move has made wider on some sides only: of the circles that moves have cut the narrowest
/// is the hole. A hole too wide for its thread is none: it is held to the part as it is.

#include <array>
#include <functional>
#include <vector>

#include "check/gouge/hole_wall.hpp"
#include "geom/vec.hpp"
#include "mesh/distance.hpp"
#include "mesh/mesh.hpp"

namespace obrys::check {

/// Radii of a thread, mm.
struct ThreadRadii {
    double core = 0, outer = 0;
    double widest_hole = 0;  ///< before tapping: a wider one leaves too little of the thread
};

class ThreadBands {
public:
    /// A tap's way along its axis. Strokes of one thread that meet become one.
    void add(geom::Vec3 from, geom::Vec3 to, geom::Vec3 axis, const ThreadRadii& radii);
    [[nodiscard]] bool empty() const { return bands_.empty(); }
    /// Finds out how the part shows each hole; `allowed`: what a wall may stand off anyway, mm; `tapped`: whether a
    /// triangle with this tag is a tap's.
    void fit(const mesh::Mesh& result, const mesh::Distance& part, double allowed,
             const std::function<bool(std::uint32_t)>& tapped = {});
    /// How much more than else the surface may lie within the part (`gouge`) or outside of it, everywhere in a ball.
    [[nodiscard]] double more(geom::Vec3 p, double radius, bool gouge) const;
    /// How much deeper than else a tool may go into the part all over a triangle of it.
    [[nodiscard]] double deeper(const std::array<geom::Vec3, 3>& triangle) const;
    /// Whether a place lies in a thread.
    [[nodiscard]] bool holds(geom::Vec3 p) const;
    /// What is left of the deviation at a place of the surface. From several threads at once.
    [[nodiscard]] double judged(geom::Vec3 p, double deviation) const;

private:
    struct Band {
        geom::Vec3 foot, axis;  ///< lower end on the axis; unit vector
        double height = 0;
        ThreadRadii radii;
        double left_over = 0, deeper = 0;  ///< how far the part's wall lies outside, or inside, of the hole's
        double left = 0;                   ///< of the box around it: smallest x
    };
    /// A place as a band sees it.
    struct Place {
        double height = 0, radius = 0;
    };
    [[nodiscard]] static Place place_in(const Band& band, geom::Vec3 p);
    static void fit_one(Band& band, const std::vector<WallPoint>& wall, const mesh::Distance& part, double allowed);
    [[nodiscard]] bool holds(const Band& band, geom::Vec3 p, double ball = 0) const;
    [[nodiscard]] bool holds(const Band& band, const std::array<geom::Vec3, 3>& triangle) const;
    template <class Visit>
    void each_near(geom::Vec3 p, Visit&& visit) const;

    std::vector<Band> bands_;  ///< after `fit` in the order of `left`
    double widest_ = 0;        ///< along x
    double allowed_ = 0;
};

}  // namespace obrys::check
