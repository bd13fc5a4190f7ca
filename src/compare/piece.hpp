#pragma once
/// The same way cut at other places: a move that is the beginning of another one.

#include <optional>

#include "compare/likeness.hpp"

namespace obrys::compare {

/// A move, or what is left of one, with where it begins; NaN where that is not known, or is counted from another zero.
struct Piece {
    geom::Vec3 from{NAN, NAN, NAN};
    geom::Vec3 tool{NAN, NAN, NAN};  ///< its axis there
    cl::Step step;
};

/// What is left of `whole` behind `part`, where that is the beginning of it; else nothing. Lines and arcs only; lines
/// at rapid only along an axis: along others a machine may go another way to each point.
[[nodiscard]] std::optional<Piece> behind(const Piece& whole, const Piece& part, const Likeness& like);

}  // namespace obrys::compare
