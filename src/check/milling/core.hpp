#pragma once
/// Tools that do not cut at their centre, on their way down: whether the edges clear what the core comes down upon.
///
/// What lies under the core is cut when the tool has moved aside, or not at all: straight down, on a ramp that is too
/// steep or too short, on a helix narrower than the core. So the way is looked at piece by piece: within any disc as
/// wide as the core, along which the core meets material, it may go down by no more than a share of how far it goes
/// aside. Millimetres.

#include <cstdint>
#include <span>
#include <vector>

#include "geom/vec.hpp"

namespace obrys::check {

class CoreDescent {
public:
    /// Of the steepest ramp, tan 30 degrees: tools that do not cut at their centre are given 2 to 15 degrees by their
    /// makers, their cores lie back by part of a millimetre.
    static constexpr double steepest = 0.5773502691896258;

    /// `core`: radius that does not cut; `least`: descents up to this are none.
    void begin(double core, double least);
    /// The tool leaves the place.
    void leave() { pieces_.clear(); }
    [[nodiscard]] double core() const { return core_; }
    /// A piece of its way at feed, of a few points after each other: x and y across the axis, z along it. `met`: the
    /// core's end met material on it. True: it has gone down too steeply, if what stayed under the core all the time
    /// was material: that is for the caller to see (`steep`).
    [[nodiscard]] bool take(std::span<const geom::Vec3> points, bool met, std::uint32_t number = 0);
    /// Of what was too steep.
    struct Steep {
        double down = 0, aside = 0;
        /// What stayed under the core: a disc, from where the way began to where it has come.
        geom::Vec2 middle;
        double radius = 0, top = 0, bottom = 0;
        std::uint32_t first = 0;  ///< number of the first piece
    };
    [[nodiscard]] Steep steep() const { return steep_; }

private:
    struct Piece {
        std::vector<geom::Vec2> points;
        double down = 0;  ///< in material
        double top = 0, bottom = 0;
        std::uint32_t number = 0;
    };
    [[nodiscard]] bool is_steep();

    double core_ = 0, least_ = 0;
    std::vector<Piece> pieces_;
    Steep steep_;
};

}  // namespace obrys::check
