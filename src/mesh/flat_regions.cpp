#include "mesh/flat_regions.hpp"

#include <algorithm>
#include <cmath>

namespace obrys::mesh {

namespace {

using geom::Vec3;

constexpr double same_way = 0.9;  ///< cosine between a region's normal and a triangle's
constexpr double exactly = 1e-3;  ///< of what is allowed: how flat it is where regions are begun first

struct Plane {
    Vec3 normal;
    double at = 0;
    [[nodiscard]] double off(Vec3 p) const { return std::abs(dot(normal, p) - at); }
};

class Finder {
public:
    Finder(const Mesh& m, const CornerTable& corners, double off, std::size_t fewest)
        : m_(m), corners_(corners), off_(off), fewest_(fewest) {
        found_.of.assign(m.triangles.size(), no_region);
    }

    FlatRegions run() {
        // Large planes first: else what bends away from them only a little would take their rims.
        for (const bool among_flat : {true, false})
            for (std::uint32_t t = 0; t < m_.triangles.size(); ++t)
                if (found_.of[t] == no_region) begin(t, among_flat);
        return std::move(found_);
    }

private:
    void begin(std::uint32_t t, bool among_flat) {
        const Vec3 area = area_vector(m_, t);
        const double size = length(area);
        if (!(size > off_ * off_)) return;
        const Plane plane{(1 / size) * area, dot(area, m_.vertices[m_.triangles[t][0]]) / size};
        if (among_flat && !all_beside(t, plane)) return;
        const auto number = static_cast<std::uint32_t>(found_.normal.size());
        grow(t, number, plane);
        if (grown_.size() < fewest_) {
            for (const std::uint32_t back : grown_) found_.of[back] = no_region;
            return;
        }
        found_.normal.push_back(plane.normal);
    }

    [[nodiscard]] bool all_beside(std::uint32_t t, const Plane& plane) const {
        for (std::uint32_t c = 3 * t; c < 3 * t + 3; ++c) {
            const std::uint32_t beyond = corners_.opposite(c);
            if (beyond == CornerTable::none || m_.tag(beyond / 3) != m_.tag(t) ||
                !(plane.off(m_.vertices[corners_.vertex(beyond)]) <= exactly * off_))
                return false;
        }
        return true;
    }

    void grow(std::uint32_t seed, std::uint32_t number, const Plane& plane) {
        grown_.assign(1, seed);
        found_.of[seed] = number;
        for (std::size_t i = 0; i < grown_.size(); ++i)
            for (std::uint32_t c = 3 * grown_[i]; c < 3 * grown_[i] + 3; ++c) {
                const std::uint32_t beyond = corners_.opposite(c);
                if (beyond == CornerTable::none) continue;
                const std::uint32_t t = beyond / 3;
                if (found_.of[t] != no_region || m_.tag(t) != m_.tag(seed)) continue;
                if (!(plane.off(m_.vertices[corners_.vertex(beyond)]) <= off_)) continue;
                const Vec3 area = area_vector(m_, t);
                const double facing = dot(area, plane.normal);
                if (!(facing > 0 && facing * facing > same_way * same_way * dot(area, area))) continue;
                found_.of[t] = number;
                grown_.push_back(t);
            }
    }

    const Mesh& m_;
    const CornerTable& corners_;
    double off_;
    std::size_t fewest_;
    FlatRegions found_;
    std::vector<std::uint32_t> grown_;
};

/// The borders at a vertex of two regions: the vertices they lead to.
struct Borders {
    std::uint32_t one = CornerTable::none, other = CornerTable::none;
};

/// Where straight stretches of a chain of vertices end.
class Straightener {
public:
    Straightener(const Mesh& m, double off) : m_(m), off_(off) {}

    /// Makes the vertices at the ends of straight stretches fixed; the first and the last one are.
    void run(const std::vector<std::uint32_t>& chain, std::vector<Role>& roles) const {
        for (std::size_t from = 0; from + 1 < chain.size();) {
            std::size_t good = from + 1, bad = chain.size();
            for (std::size_t reach = 2; from + reach < bad; reach *= 2) {
                if (!straight(chain, from, from + reach)) {
                    bad = from + reach;
                    break;
                }
                good = from + reach;
            }
            if (bad == chain.size() && straight(chain, from, chain.size() - 1)) return;
            while (good + 1 < bad) {
                const std::size_t middle = good + (bad - good) / 2;
                (straight(chain, from, middle) ? good : bad) = middle;
            }
            from = good;
            roles[chain[from]] = Role::fixed;
        }
    }

private:
    [[nodiscard]] bool straight(const std::vector<std::uint32_t>& chain, std::size_t from, std::size_t to) const {
        const Vec3 a = m_.vertices[chain[from]], way = m_.vertices[chain[to]] - a;
        const double size = length(way);
        if (!(size > 0)) return false;
        const Vec3 e = (1 / size) * way;
        double before = 0;
        for (std::size_t i = from + 1; i < to; ++i) {
            const Vec3 p = m_.vertices[chain[i]] - a;
            const double along = dot(p, e);
            if (!(along > before && along < size) || length(p - along * e) > off_) return false;
            before = along;
        }
        return true;
    }

    const Mesh& m_;
    double off_;
};

}  // namespace

FlatRegions flat_regions(const Mesh& m, const CornerTable& corners, double off, std::size_t fewest) {
    return Finder(m, corners, off, fewest).run();
}

std::vector<Role> roles_of(const Mesh& m, const CornerTable& corners, const FlatRegions& regions, double off) {
    std::vector<Role> roles(m.vertices.size(), Role::fixed);
    std::vector<Borders> borders(m.vertices.size());
    std::vector<std::uint32_t> ring;
    std::vector<bool> curved(m.vertices.size(), false);
    for (std::size_t t = 0; t < m.triangles.size(); ++t)
        if (regions.of[t] == no_region)
            for (const std::uint32_t v : m.triangles[t]) curved[v] = true;
    for (std::uint32_t v = 0; v < m.vertices.size(); ++v) {
        if (curved[v]) continue;
        corners.ring(v, ring);
        std::size_t changes = 0;
        for (std::size_t i = 0; i < ring.size(); ++i) {
            const std::uint32_t last = ring[i == 0 ? ring.size() - 1 : i - 1];
            if (regions.of[ring[i] / 3] == regions.of[last / 3]) continue;
            (changes++ == 0 ? borders[v].one : borders[v].other) = corners.vertex(CornerTable::next(ring[i]));
        }
        if (ring.empty() || (changes != 0 && changes != 2)) continue;
        roles[v] = changes == 0 ? Role::inside : Role::border;
    }
    const Straightener straightener(m, off);
    std::vector<bool> seen(m.vertices.size(), false);
    std::vector<std::uint32_t> chain;
    // From an end of a border onwards; borders that close upon themselves get their first vertex as an end.
    const auto follow = [&](std::uint32_t from, std::uint32_t to) {
        chain = {from, to};
        while (roles[chain.back()] == Role::border && !seen[chain.back()]) {
            const std::uint32_t v = chain.back(), last = chain[chain.size() - 2];
            seen[v] = true;
            chain.push_back(borders[v].one == last ? borders[v].other : borders[v].one);
        }
        straightener.run(chain, roles);
    };
    const std::vector<Role> first = roles;
    for (std::uint32_t v = 0; v < roles.size(); ++v) {
        if (first[v] != Role::border || seen[v]) continue;
        for (const std::uint32_t end : {borders[v].one, borders[v].other})
            if (first[end] == Role::fixed && !seen[v]) follow(end, v);
    }
    for (std::uint32_t v = 0; v < roles.size(); ++v) {
        if (roles[v] != Role::border || seen[v]) continue;
        roles[v] = Role::fixed;
        follow(v, borders[v].one);
    }
    return roles;
}

}  // namespace obrys::mesh
