#pragma once
/// What a cut has emptied, seen along the tool's axis: over a patch of the plane normal to it, from which height to
/// which. On the safe side: a zone that is given has been taken by this one cut alone. Millimetres, in a frame whose z
/// is the axis.

#include <vector>

#include "sim/milling/cut/air.hpp"

namespace obrys::check {

using Zone = sim::milling::Heights;  ///< along the axis

/// Heights between which all is empty: kept apart from each other, from below.
class Zones {
public:
    void add(Zone z);
    [[nodiscard]] bool cover(Zone z) const;
    [[nodiscard]] const std::vector<Zone>& all() const { return all_; }

private:
    std::vector<Zone> all_;
};

/// A rectangle of the plane, its sides along x and y.
struct Patch {
    geom::Vec2 lo, hi;
};

/// A body upright in the frame: a tool's part, taken as a cylinder, whose tip goes straight.
struct Upright {
    geom::Vec3 from, to;  ///< of the tip
    double radius = 0;
    double bottom = 0, top = 0;                  ///< above the tip
    const sim::milling::Shape* shape = nullptr;  ///< where this is a tool's cutting part as a whole: that
};

class ClearingCut {
public:
    /// `sweep.shape` must outlive it.
    explicit ClearingCut(const sim::milling::Air::Sweep& sweep);

    /// Around what it may have emptied.
    [[nodiscard]] const Patch& around() const { return around_; }
    [[nodiscard]] Zone heights() const { return heights_; }
    /// Whether more of it counts over a part of a patch than over the whole.
    [[nodiscard]] bool is_flat() const { return flat_; }
    /// Adds what of a patch's column it emptied; a place `slack` beside counts as within.
    void add_over(const Patch& patch, double slack, Zones& zones) const;
    /// The same where the body is on a part of its way.
    void add_along(const Upright& body, double slack, Zones& zones) const;

private:
    struct Beside {
        double distance = 0;       ///< in the plane
        double low = 0, high = 0;  ///< of the tip there
    };
    [[nodiscard]] Beside beside(const Patch& patch) const;
    [[nodiscard]] Beside beside(geom::Vec3 a, geom::Vec3 b) const;
    [[nodiscard]] geom::Vec3 tip_at(double u) const { return from_ + u * way_; }
    [[nodiscard]] bool in_wedge(geom::Vec2 from_centre) const;
    void add(const Beside& at, double slack, Zones& zones) const;

    const sim::milling::Shape* shape_;
    geom::Vec3 from_, way_;
    bool circular_ = false, flat_ = false;
    geom::Vec2 centre_, first_, last_;
    double radius_ = 0, turn_ = 1;
    Patch around_;
    Zone heights_;
};

/// Distance in the plane between a straight way and a patch; 0 where they meet.
[[nodiscard]] double distance_between(geom::Vec2 from, geom::Vec2 to, const Patch& patch);

}  // namespace obrys::check
