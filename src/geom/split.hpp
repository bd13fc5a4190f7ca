#pragma once
/// First step of an arrangement: edges split at each other, ends welded.

#include "geom/arrangement.hpp"

namespace obrys::geom {

struct SplitEdges {
    std::vector<Vec2> vertices;
    std::vector<char> open;  ///< by vertex
    std::vector<Arrangement::Piece> pieces;
};
[[nodiscard]] SplitEdges split(const std::vector<SourceEdge>& sources, const ArrangeOptions& options);

}  // namespace obrys::geom
