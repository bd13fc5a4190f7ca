#pragma once
/// A path in pieces. Those of a helix stand at the same angles in all of its turns, so that turns are levels of each
/// other (covered.hpp).

#include <algorithm>
#include <cmath>
#include <variant>

#include "geom/interpolation.hpp"
#include "geom/vec.hpp"

namespace obrys::sim::milling {

struct Pieces {
    double count = 1;
    double each = 1;  ///< part of the path; the last one may be shorter
    /// Where piece number i - 1 ends and number i begins, from 0 to 1.
    [[nodiscard]] double end(double i) const { return i >= count ? 1 : i * each; }
};

/// At least so many; of so few that a turn has less than one, no more.
[[nodiscard]] inline Pieces in_pieces_of_turns(const geom::PathElement& path, double least) {
    const auto* c = std::get_if<geom::Circular>(&path);
    const double turns = c == nullptr ? 0 : std::abs(c->sweep) / (2 * geom::pi);
    if (!(turns > 1) || least < turns) return {least, 1 / least};
    const double of_turn = std::max(1.0, std::ceil(least / turns - 1e-9));
    return {std::max(1.0, std::ceil(turns * of_turn - 1e-9)), 1 / (turns * of_turn)};
}

}  // namespace obrys::sim::milling
