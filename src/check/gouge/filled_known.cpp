#include "check/gouge/filled_known.hpp"

#include <algorithm>
#include <utility>

namespace obrys::check {

using geom::Vec3;

namespace {

constexpr double held_by_cells = 1;  ///< steps: what is lower than that may have been seen by chance
constexpr double much_less = 0.5;    ///< of a depth: what is known to be no higher is not that place
constexpr double of_a_gap = 3;       ///< times as deep as material stands off: no corner that a tool has left round

mesh::Mesh triangles_beyond(const mesh::Comparison& found, const mesh::Mesh& surface, double allowed) {
    mesh::Mesh high;
    for (std::size_t t = 0; t < found.deviation.size(); ++t) {
        if (!(found.deviation[t] > allowed)) continue;
        const auto n = static_cast<std::uint32_t>(high.vertices.size());
        for (const std::uint32_t v : surface.triangles[t]) high.vertices.push_back(surface.vertices[v]);
        high.triangles.push_back({n, n + 1, n + 2});
    }
    return high;
}

mesh::Place widened(const mesh::Place& seen, mesh::Place whole) {
    whole.triangle = seen.triangle, whole.triangles = seen.triangles;
    whole.area = std::max(whole.area, seen.area);
    whole.extent.add(seen.extent.lo), whole.extent.add(seen.extent.hi);
    return whole;
}

}  // namespace

bool holds_widened(const mesh::Box& box, Vec3 p, Vec3 around) {
    return p.x >= box.lo.x - around.x && p.y >= box.lo.y - around.y && p.z >= box.lo.z - around.z &&
           p.x <= box.hi.x + around.x && p.y <= box.hi.y + around.y && p.z <= box.hi.z + around.z;
}

KnownRest::KnownRest(const mesh::Comparison& found, const mesh::Mesh& surface, double allowed, Vec3 step,
                     std::vector<mesh::Place>& places)
    : step_(step), wide_(std::max({step.x, step.y, step.z})), places_(places) {
    for (const mesh::Place& p : places) shown_.push_back(p.deviation);
    if (mesh::Mesh beyond = triangles_beyond(found, surface, allowed); !beyond.empty())
        beyond_.emplace(std::move(beyond));
}

bool KnownRest::ends_at(Vec3 top) const { return beyond_ && beyond_->nearest(top, wide_).distance <= wide_; }

/// False, too, where the deepest of it is another place than all that is known: much deeper, and not known itself.
bool KnownRest::joins(const FilledPlace& filled) {
    const double depth = filled.place.deviation;
    if (std::none_of(filled.tops.begin(), filled.tops.end(), [&](Vec3 top) { return ends_at(top); })) return false;
    bool joined = ends_at(filled.place.at);
    std::optional<std::size_t> raised;
    for (std::size_t i = 0; i < places_.size();) {
        mesh::Place& p = places_[i];
        const bool as_high = !(shown_[i] < much_less * depth);
        const bool here = std::any_of(filled.faces.begin(), filled.faces.end(),
                                      [&](const mesh::Box& box) { return holds_widened(box, p.at, step_); });
        const bool by_chance = here && !as_high && (shown_[i] < held_by_cells * wide_ || depth > of_a_gap * shown_[i]);
        joined = joined || (here && as_high) || by_chance;
        if (by_chance && raised) {
            places_[*raised] = widened(p, places_[*raised]);
            places_.erase(places_.begin() + static_cast<std::ptrdiff_t>(i));
            shown_.erase(shown_.begin() + static_cast<std::ptrdiff_t>(i));
            continue;
        }
        if (by_chance && p.deviation < depth) p = widened(p, filled.place), raised = i;
        ++i;
    }
    return joined;
}

}  // namespace obrys::check
