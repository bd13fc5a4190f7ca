#include "sim/milling/exact/convex_parts.hpp"

namespace obrys::sim::milling {

void ConvexParts::add(const Shape* shape) {
    const auto [at, is_new] = parts_.try_emplace(shape);
    if (!is_new) return;
    const std::vector<Piece>& pieces = shape->pieces;
    for (std::size_t first = 0; first < pieces.size();) {
        const std::size_t end = convex_end(pieces, first);
        if (first == 0 && end == pieces.size()) {
            at->second.push_back(shape);
            break;
        }
        const auto from = pieces.begin() + static_cast<std::ptrdiff_t>(first);
        shapes_.push_back(make_shape({from, pieces.begin() + static_cast<std::ptrdiff_t>(end)}));
        at->second.push_back(&shapes_.back());
        first = end;
    }
}

}  // namespace obrys::sim::milling
