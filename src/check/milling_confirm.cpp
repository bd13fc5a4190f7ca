// A surface of triangles can leave the exact one by more than the tolerance where an edge, a tip or a step narrower
// than the rays' distance lies in a cell. So what was found is looked at again on rays that lie nearer to each other:
// points on rays are exact. What they do not show either is thrown away only where it is proved not to be there.

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

#include "check/milling_confirm.hpp"
#include "check/milling_proof.hpp"

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

constexpr double most_cells = 2'000'000;       ///< of all proofs
constexpr double doubtful_cells = 10'000;      ///< of each of those that decide about a doubtful place
constexpr std::size_t most_doubtful = 40;      ///< of a kind
constexpr std::size_t most_looks = 4'000'000;  ///< at sweeps, for all doubtful places of a kind
constexpr double least_cells = 20'000;         ///< of each

constexpr double near_worst = 0.9;

struct Worst {
    double deviation = 0;
    geom::Vec3 at;
    std::vector<mesh::TagShare> peak;
};

Worst worst_of(const std::vector<milling::SurfacePoint>& points, const Machined& m, const mesh::CompareOptions& options,
               bool gouge) {
    std::vector<double> off(points.size());
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, points.size(), 256),
                      [&](const tbb::blocked_range<std::size_t>& some) {
                          for (std::size_t i = some.begin(); i < some.end(); ++i) {
                              const double d = m.part.signed_distance(points[i].at);
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
        if (std::isfinite(off[i]) && off[i] / worst.deviation >= near_worst) ++tags[m.tag_of(points[i].cut)];
    for (const auto& [tag, count] : tags) worst.peak.push_back({tag, count});
    std::stable_sort(worst.peak.begin(), worst.peak.end(),
                     [](const mesh::TagShare& a, const mesh::TagShare& b) { return a.area > b.area; });
    return worst;
}

bool is_worse(const mesh::Place& a, const mesh::Place& b) { return std::abs(a.deviation) > std::abs(b.deviation); }

/// What rays do not show: whether it is there all the same, and how far off.
Proof::Outcome outcome_of(mesh::Place& p, const milling::Box3& box, const Machined& m, double allowed, bool gouge,
                          double cells) {
    const milling::Air air = m.simulation.air_in(box);
    Claim claim{m.part, air, gouge, allowed};
    if (!m.threads.empty())
        claim.more = [&](geom::Vec3 at, double radius) { return m.threads.more(at, radius, gouge); };
    const Proof proof = decide(claim, box, static_cast<std::size_t>(cells));
    if (proof.outcome == Proof::Outcome::present) {
        p.deviation = gouge ? -proof.deviation : proof.deviation;
        p.at = proof.at;
        if (proof.cut > 0) p.peak = {{m.tag_of(proof.cut), 1}};
    }
    return proof.outcome;
}

/// What the triangles show as less than it is: an edge's crest may lie between their corners. Only what is there for
/// sure becomes a place.
void add_doubtful(std::vector<mesh::Place>& places, std::vector<mesh::Place>& doubtful, const Machined& m,
                  const mesh::CompareOptions& options, bool gouges, std::size_t& count) {
    const geom::Vec3 step = m.simulation.dexels().lattice().step;
    const double allowed = gouges ? options.gouge : options.excess;
    const std::size_t most = std::min(most_doubtful, 1 + most_looks / (1 + m.simulation.sweeps()));
    doubtful.resize(std::min(doubtful.size(), most));
    for (mesh::Place& p : doubtful) {
        const geom::Vec3 around{2 * allowed, 2 * allowed, 2 * allowed};
        const milling::Box3 box{p.extent.lo - around, p.extent.hi + around};
        const double fine = step_in(box, std::min({step.x, step.y, step.z}));
        if (!(fine > 0)) continue;
        if (outcome_of(p, box, m, allowed, gouges, doubtful_cells) != Proof::Outcome::present) continue;
        if (!gouges) p.peak = worst_of(m.simulation.surface_points(box, fine), m, options, gouges).peak;
        places.push_back(std::move(p));
        ++count;
    }
    doubtful.clear();
    std::stable_sort(places.begin(), places.end(), is_worse);
}

/// Gives back the boxes of the places that are not there.
std::vector<mesh::Box> confirm_places(std::vector<mesh::Place>& places, const Machined& m,
                                      const mesh::CompareOptions& options, bool gouges) {
    const geom::Vec3 step = m.simulation.dexels().lattice().step;
    const double allowed = gouges ? options.gouge : options.excess;
    const double cells = std::max(least_cells, most_cells / static_cast<double>(places.size() + 1));
    std::vector<mesh::Box> dropped;
    std::vector<mesh::Place> kept;
    for (mesh::Place& p : places) {
        const milling::Box3 box{p.extent.lo - step, p.extent.hi + step};
        const double fine = step_in(box, std::min({step.x, step.y, step.z}));
        if (fine > 0) {
            const Worst worst = worst_of(m.simulation.surface_points(box, fine), m, options, gouges);
            if (std::abs(worst.deviation) > 0) p.peak = worst.peak;
            if (!(std::abs(worst.deviation) > allowed)) {
                if (outcome_of(p, box, m, allowed, gouges, cells) == Proof::Outcome::absent) {
                    dropped.push_back(p.extent);
                    continue;
                }
            } else if (std::abs(worst.deviation) < std::abs(p.deviation)) {
                // What lies beside the place may be worse and is a place of its own.
                p.deviation = worst.deviation, p.at = worst.at;
            }
        }
        kept.push_back(std::move(p));
    }
    places = std::move(kept);
    std::stable_sort(places.begin(), places.end(), is_worse);
    return dropped;
}

}  // namespace

void confirm(mesh::Comparison& found, const Machined& m, const mesh::CompareOptions& options) {
    const std::vector<mesh::Box> deep = confirm_places(found.gouges, m, options, true);
    const std::vector<mesh::Box> high = confirm_places(found.excesses, m, options, false);
    add_doubtful(found.gouges, found.doubtful_gouges, m, options, true, found.gouge_count);
    add_doubtful(found.excesses, found.doubtful_excesses, m, options, false, found.excess_count);
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
        if (d < -options.gouge && in_one(deep, mesh::centre(m.surface, t))) d = -options.gouge;
        if (d > options.excess && in_one(high, mesh::centre(m.surface, t))) d = options.excess;
        found.largest_gouge = std::max(found.largest_gouge, -d);
        found.largest_excess = std::max(found.largest_excess, d);
    }
}

}  // namespace obrys::check
