#include "mesh/weld.hpp"

#include <cmath>

#include "base/float_chars.hpp"

namespace obrys::mesh {

using geom::Vec3;

Welder::Welder(double tolerance) : tolerance_(tolerance > 0 && std::isfinite(tolerance) ? tolerance : 0) {
    head_.assign(1024, none);
}

std::size_t Welder::bucket(Vec3 key) const {
    std::uint64_t h = 0;
    for (const double c : {key.x, key.y, key.z}) {
        h ^= base::bit_cast<std::uint64_t>(c);
        h *= 0x9e3779b97f4a7c15U;
        h ^= h >> 29U;
    }
    return static_cast<std::size_t>(h) & (head_.size() - 1);
}

/// With a tolerance: the cell of a grid, twice as wide as the tolerance.
Vec3 Welder::key_of(Vec3 p) const {
    if (tolerance_ == 0) return p;
    const double width = 2 * tolerance_;
    return {std::floor(p.x / width) + 0.0, std::floor(p.y / width) + 0.0, std::floor(p.z / width) + 0.0};
}

std::uint32_t Welder::find(Vec3 p) const {
    for (std::uint32_t v = head_[bucket(p)]; v != none; v = next_[v])
        if (vertices_[v] == p) return v;
    return none;
}

std::uint32_t Welder::find_near(Vec3 p) const {
    std::uint32_t best = none;
    double best_distance = tolerance_;
    for (unsigned corner = 0; corner < 8; ++corner) {
        const auto shifted = [&](double c, unsigned bit) {
            return c + ((corner & bit) != 0 ? tolerance_ : -tolerance_);
        };
        const Vec3 key = key_of({shifted(p.x, 1), shifted(p.y, 2), shifted(p.z, 4)});
        for (std::uint32_t v = head_[bucket(key)]; v != none; v = next_[v]) {
            const double d = distance(vertices_[v], p);
            if (d < best_distance || (d == best_distance && v < best)) best = v, best_distance = d;
        }
    }
    return best;
}

void Welder::grow() {
    head_.assign(2 * head_.size(), none);
    for (std::uint32_t v = 0; v < vertices_.size(); ++v) {
        const std::size_t b = bucket(key_of(vertices_[v]));
        next_[v] = head_[b];
        head_[b] = v;
    }
}

std::uint32_t Welder::add(Vec3 p) {
    p = {p.x + 0.0, p.y + 0.0, p.z + 0.0};  // -0 becomes 0
    const std::uint32_t found = tolerance_ == 0 ? find(p) : find_near(p);
    if (found != none) return found;
    if (vertices_.size() >= head_.size()) grow();
    const auto v = static_cast<std::uint32_t>(vertices_.size());
    const std::size_t b = bucket(key_of(p));
    vertices_.push_back(p);
    next_.push_back(head_[b]);
    head_[b] = v;
    return v;
}

}  // namespace obrys::mesh
