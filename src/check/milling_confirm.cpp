// A surface of triangles can leave the exact one by more than the tolerance where an edge, a tip or a step narrower
// than the rays' distance lies in a cell. So what was found is looked at again on rays that lie nearer to each other:
// points on rays are exact.

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

#include "check/milling_confirm.hpp"

namespace obrys::check {

namespace milling = sim::milling;

namespace {

constexpr double most_rays = 40'000;  ///< for a place
constexpr double finest = 1.0 / 16;   ///< of the lattice's step
constexpr double coarsest = 0.5;      ///< the same; a place so large is not an edge's

/// How far apart rays may be in a box; 0: too many would be needed.
double step_in(const milling::Box3& box, double step) {
    const geom::Vec3 s = box.max - box.min;
    const double fine = std::sqrt((s.x * s.y + s.y * s.z + s.x * s.z) / most_rays);
    return fine > coarsest * step ? 0 : std::max(fine, finest * step);
}

using TagOf = std::function<std::uint32_t(std::uint32_t cut)>;

constexpr double near_worst = 0.9;

struct Worst {
    double deviation = 0;
    geom::Vec3 at;
    std::vector<mesh::TagShare> peak;
};

Worst worst_of(const std::vector<milling::SurfacePoint>& points, const mesh::Distance& part,
               const mesh::CompareOptions& options, const TagOf& tag_of, bool gouge) {
    std::vector<double> off(points.size());
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, points.size(), 256),
                      [&](const tbb::blocked_range<std::size_t>& some) {
                          for (std::size_t i = some.begin(); i < some.end(); ++i) {
                              const double d = part.signed_distance(points[i].at);
                              off[i] = options.judged ? options.judged(points[i].at, d) : d;
                          }
                      });
    Worst worst;
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (!std::isfinite(off[i]) || !(gouge ? off[i] < worst.deviation : off[i] > worst.deviation)) continue;
        worst.deviation = off[i];
        worst.at = points[i].at;
    }
    std::map<std::uint32_t, double> tags;
    for (std::size_t i = 0; i < points.size(); ++i)
        if (std::isfinite(off[i]) && off[i] / worst.deviation >= near_worst) ++tags[tag_of(points[i].cut)];
    for (const auto& [tag, count] : tags) worst.peak.push_back({tag, count});
    std::stable_sort(worst.peak.begin(), worst.peak.end(),
                     [](const mesh::TagShare& a, const mesh::TagShare& b) { return a.area > b.area; });
    return worst;
}

/// Gives back the boxes of the places that were not found again.
std::vector<mesh::Box> confirm_places(std::vector<mesh::Place>& places, const milling::Simulation& simulation,
                                      const mesh::Distance& part, const mesh::CompareOptions& options,
                                      const TagOf& tag_of, bool gouges) {
    const geom::Vec3 step = simulation.dexels().lattice().step;
    std::vector<mesh::Box> dropped;
    std::vector<mesh::Place> kept;
    for (mesh::Place& p : places) {
        const milling::Box3 box{p.extent.lo - step, p.extent.hi + step};
        const double fine = step_in(box, std::min({step.x, step.y, step.z}));
        if (fine > 0) {
            const Worst worst = worst_of(simulation.surface_points(box, fine), part, options, tag_of, gouges);
            if (!(std::abs(worst.deviation) > (gouges ? options.gouge : options.excess))) {
                dropped.push_back(p.extent);
                continue;
            }
            // What lies beside the place may be worse and is a place of its own.
            if (std::abs(worst.deviation) < std::abs(p.deviation)) p.deviation = worst.deviation, p.at = worst.at;
            p.peak = worst.peak;
        }
        kept.push_back(std::move(p));
    }
    std::stable_sort(kept.begin(), kept.end(), [](const mesh::Place& a, const mesh::Place& b) {
        return std::abs(a.deviation) > std::abs(b.deviation);
    });
    places = std::move(kept);
    return dropped;
}

}  // namespace

void confirm(mesh::Comparison& found, const mesh::Mesh& surface, const milling::Simulation& simulation,
             const mesh::Distance& part, const mesh::CompareOptions& options, const TagOf& tag_of) {
    const std::vector<mesh::Box> deep = confirm_places(found.gouges, simulation, part, options, tag_of, true);
    const std::vector<mesh::Box> high = confirm_places(found.excesses, simulation, part, options, tag_of, false);
    if (deep.empty() && high.empty()) return;
    found.gouge_count -= deep.size();
    found.excess_count -= high.size();
    const auto in_one = [](const std::vector<mesh::Box>& boxes, geom::Vec3 p) {
        return std::any_of(boxes.begin(), boxes.end(), [&](const mesh::Box& b) {
            return p.x >= b.lo.x && p.y >= b.lo.y && p.z >= b.lo.z && p.x <= b.hi.x && p.y <= b.hi.y && p.z <= b.hi.z;
        });
    };
    found.largest_gouge = found.largest_excess = 0;
    for (std::size_t t = 0; t < found.deviation.size(); ++t) {
        double& d = found.deviation[t];
        if (d < -options.gouge && in_one(deep, mesh::centre(surface, t))) d = -options.gouge;
        if (d > options.excess && in_one(high, mesh::centre(surface, t))) d = options.excess;
        found.largest_gouge = std::max(found.largest_gouge, -d);
        found.largest_excess = std::max(found.largest_excess, d);
    }
}

}  // namespace obrys::check
