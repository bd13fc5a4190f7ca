#pragma once
/// Places of the exact surface, and how far others lie from it.

#include <random>

#include "solid.hpp"

namespace exact {

using Random = std::mt19937_64;
[[nodiscard]] double uniform(Random& random, double low, double high);
[[nodiscard]] V direction(Random& random);

/// How far a place lies from the surface: exactly in the solid; outside an upper bound, that of a place that was found,
/// looked for until one nearer than `enough` is.
struct Off {
    double found = 0;
    V nearest;
    bool within = false;  ///< in the solid
};
[[nodiscard]] Off off_surface(const Solid& solid, V p, double enough, Random& random);

/// Whether there is material behind a place of the surface, more than a skin of `skin`.
[[nodiscard]] bool has_material(const Solid& solid, V p, double skin);

/// Random places of the surface: faces, edges and corners of what was swept and of the stock, sharp rings and points of
/// tools. `each` to a constraint, of rings and points ten times that, and as many again along lines through the stock.
[[nodiscard]] std::vector<V> samples(const Solid& solid, std::size_t each, double skin, Random& random);

}  // namespace exact
