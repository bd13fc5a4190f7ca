#pragma once
/// A contour to be turned as LinuxCNC's G70 … G72.2 work on it: laid so that it runs towards smaller Z and, on the
/// whole, larger X; corners finished; at a distance. Facts about the algorithm: LinuxCNC 2.9, interpreter, lathe
/// contour cycles. Its tolerances are in the unit of the program, so all lengths in here are.

#include <optional>
#include <string>
#include <vector>

#include "cycles/turn/turning.hpp"

namespace obrys::cycles {

namespace profile {
inline constexpr double touch = 1e-6;  ///< points that count as one
inline constexpr double slack = 1e-3;  ///< against the direction of the contour; shorter pieces are dropped
inline constexpr double gap = 1e-2;    ///< between shifted pieces: wider ones get an arc
}  // namespace profile

enum class Corner : std::uint8_t { none, fillet, chamfer };

struct Piece {
    geom::Vec2 from, to, centre;
    int turn = 0;  ///< as of TurningElement
    Corner corner = Corner::none;
    double corner_size = 0;   ///< of a corner that is still to be made
    std::size_t element = 0;  ///< of the contour, from which it comes
};

/// What is wrong with a contour; nothing: it is well.
using Fault = std::optional<std::string>;

/// The contour, and how it was turned and mirrored.
struct Profile {
    std::vector<Piece> pieces;  ///< the first leads from the start point to the contour
    bool quarter_turn = false, mirrored_u = false, mirrored_v = false;

    void turn_quarter();
    /// Mirrors so that it ends at the larger v and the smaller u.
    void lay();
    [[nodiscard]] geom::Vec2 as_programmed(geom::Vec2 p) const;
    [[nodiscard]] geom::Vec2 laid(geom::Vec2 p) const;  ///< the other way round
    [[nodiscard]] bool same_sense() const { return mirrored_u == mirrored_v; }
};

[[nodiscard]] Profile profile_of(const std::vector<TurningElement>& contour, geom::Vec2 start, double unit);
/// Length of a line; of an arc the smaller of chord and radius.
[[nodiscard]] double extent(const Piece& p);
/// Runs towards smaller u all the way.
[[nodiscard]] bool falls(const Piece& p);
void shift_sideways(Piece& p, double distance);
/// Makes the end of `a` and the start of `b` one point.
[[nodiscard]] Fault join(Piece& a, Piece& b);

/// Puts in the fillets and chamfers.
[[nodiscard]] Fault finish_corners(Profile& p);
/// A start point on the wrong side of the contour's start is moved; everything must run towards smaller u.
[[nodiscard]] Fault check_falling(Profile& p);
/// All but the first piece to a distance, on the side of the start point.
[[nodiscard]] Fault keep_distance(Profile& p, double distance);

}  // namespace obrys::cycles
