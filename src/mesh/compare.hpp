#pragma once
/// A machined surface held against the finished part: how far each triangle lies from it, and where the worst places
/// are. Millimetres.

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "mesh/colour.hpp"
#include "mesh/distance.hpp"

namespace obrys::mesh {

struct CompareOptions {
    double gouge = 0.01;       ///< the result may lie this far inside the part, mm
    double excess = 0.01;      ///< and this far outside
    std::size_t places = 100;  ///< at most so many of each kind are listed
    double doubt = 1;          ///< of what is allowed: from here on places are listed as doubtful
    /// What counts of a deviation at a place, where the part is known to be another one there than its mesh (threads).
    /// Asked where more than allowed was found; from several threads at once. Empty: all of it.
    std::function<double(geom::Vec3, double)> judged = {};
};

/// How much of a place has one tag.
struct TagShare {
    std::uint32_t tag = 0;
    double area = 0;  ///< mm2
};

/// Triangles that touch each other and all lie too deep, or all too high.
struct Place {
    geom::Vec3 at;               ///< where the deviation is largest
    double deviation = 0;        ///< there; negative within the part
    std::uint32_t triangle = 0;  ///< to which that point belongs
    std::uint32_t tag = 0;       ///< of that triangle: the cut
    std::size_t triangles = 0;
    double area = 0;  ///< of all its triangles, mm2
    Box extent;
    std::vector<TagShare> shares;  ///< all its tags, the largest area first
    std::vector<TagShare> peak;    ///< the same of the triangles that lie nearly as far off as the worst
};

struct Comparison {
    /// For each triangle the deviation of its centre or a corner, whichever is largest: negative where it lies within
    /// the part (gouge), positive where material is left (excess). Infinite where there is no part.
    std::vector<double> deviation;
    std::vector<Place> gouges, excesses;                    ///< the worst first
    std::vector<Place> doubtful_gouges, doubtful_excesses;  ///< those that lie between `doubt` and what is allowed
    std::size_t gouge_count = 0, excess_count = 0;          ///< of all places, the listed ones among them
    double largest_gouge = 0, largest_excess = 0;           ///< of all triangles, whatever is allowed; not negative
};

/// The part must be closed (`topology`), else the signs mean nothing. What the result lacks wholly, so that no triangle
/// of it lies near, does not show as such: it is found from the result's side only. Does not depend on the number of
/// threads.
[[nodiscard]] Comparison compare(const Mesh& result, const Distance& part, const CompareOptions& options = {});

/// Deviations as tags and their colours: grey within what is allowed, from yellow to red for gouges, from light to dark
/// blue for excess, in `steps` steps up to `full` mm.
struct DeviationColours {
    std::vector<std::uint32_t> tags;
    std::vector<Colour> palette;
};
[[nodiscard]] DeviationColours deviation_colours(std::span<const double> deviation, const CompareOptions& allowed,
                                                 double full, std::size_t steps = 8);

}  // namespace obrys::mesh
