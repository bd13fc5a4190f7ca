#pragma once
/// What material in narrow features of the part has to do with places of the result that are known to stand off it: a
/// place that cells could not hold shows there by chance, and less high than it is. Millimetres.

#include <optional>
#include <vector>

#include "mesh/compare.hpp"
#include "mesh/distance.hpp"

namespace obrys::check {

/// Material in a narrow feature: as deep as `place.deviation`, and its parts that touch each other.
struct FilledPlace {
    mesh::Place place;
    std::vector<geom::Vec3> tops;  ///< where the material ends, of each part
    std::vector<mesh::Box> faces;  ///< the part's faces that are covered, of each
};

/// Whether the point lies in the box widened by so much to all sides.
[[nodiscard]] bool holds_widened(const mesh::Box& box, geom::Vec3 p, geom::Vec3 around);

class KnownRest {
public:
    /// Of `found`, which `surface` was compared for; `places` are its excesses.
    KnownRest(const mesh::Comparison& found, const mesh::Mesh& surface, double allowed, geom::Vec3 step,
              std::vector<mesh::Place>& places);
    /// The material ends where the result is known to leave the part.
    [[nodiscard]] bool ends_at(geom::Vec3 top) const;
    /// Whether it is one place with something known. What chance showed becomes as high as it is.
    [[nodiscard]] bool joins(const FilledPlace& filled);

private:
    geom::Vec3 step_;
    double wide_ = 0;
    std::vector<mesh::Place>& places_;
    std::vector<double> shown_;             ///< how far off each was said to be
    std::optional<mesh::Distance> beyond_;  ///< what of the result leaves the part
};

}  // namespace obrys::check
