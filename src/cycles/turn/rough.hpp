#pragma once
/// What LinuxCNC's contour cycles for turning share beside the profile: their start, and moves out of the profile's
/// place into the program's.

#include "cycles/turn/path.hpp"
#include "cycles/turn/profile.hpp"

namespace obrys::cycles {

struct ContourStart {
    geom::Vec2 at;    ///< mm
    double unit = 1;  ///< mm per unit of the program
};
/// The contour must not be empty.
[[nodiscard]] ContourStart start_of(TurningPath& path, const TurnedContour& cycle, const TurningDemand& demand);

/// Where a piece meets the height v: u of the meetings, as the control finds them.
[[nodiscard]] std::vector<double> meetings(const Piece& piece, double v);
/// The contour in parallel cuts and its pockets. pockets: 0 all, 1 leaves them, 2 only them.
[[nodiscard]] Fault rough_down(class ProfilePath& out, const std::vector<Piece>& pieces, double infeed, double escape,
                               int pockets);

/// Moves given in a profile's place and unit.
class ProfilePath {
public:
    ProfilePath(TurningPath& path, const Profile& profile, double unit) : path_(path), laid_(profile), unit_(unit) {}
    void rapid(geom::Vec2 to) { path_.rapid(outside(to)); }
    void feed(geom::Vec2 to) { path_.feed(outside(to)); }
    /// Left out where it ends where the tool stands.
    void arc(geom::Vec2 to, geom::Vec2 centre, int turn);
    void along(const Piece& piece);
    [[nodiscard]] TurningPath& path() { return path_; }
    [[nodiscard]] geom::Vec2 laid_at() const { return laid_.laid((1 / unit_) * path_.at()); }

private:
    [[nodiscard]] geom::Vec2 outside(geom::Vec2 p) const { return unit_ * laid_.as_programmed(p); }
    TurningPath& path_;
    const Profile& laid_;
    double unit_;
};

}  // namespace obrys::cycles
