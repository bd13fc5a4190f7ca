// A surface of triangles can leave the exact one by more than the tolerance where an edge, a tip or a step narrower
// than the rays' distance lies in a cell. So what was found is looked at again on rays that lie nearer to each other:
// points on rays are exact. What they do not show either is thrown away only where it is proved not to be there.

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <utility>
#include <vector>

#include "base/parallel.hpp"
#include "base/whole.hpp"
#include "check/gouge/confirm.hpp"
#include "check/gouge/proof.hpp"

namespace obrys::check {

namespace milling = sim::milling;

namespace {

constexpr double most_rays = 40'000;      ///< for a place
constexpr double fewer_rays = 4'000;      ///< for those behind the worst
constexpr std::size_t worst_places = 24;  ///< of a kind
constexpr double finest_step = 1.0 / 16;  ///< of the lattice's step
constexpr double coarsest = 0.5;          ///< the same; a place so large is not an edge's

/// How far apart rays may be in a box; 0: too many would be needed.
double step_in(const milling::Box3& box, double step) {
    const geom::Vec3 s = box.max - box.min;
    const double fine = std::sqrt((s.x * s.y + s.y * s.z + s.x * s.z) / most_rays);
    return fine > coarsest * step ? 0 : std::max(fine, finest_step * step);
}

/// How far apart for the n-th of many places, the worst first: its amount matters less.
double step_of(const milling::Box3& box, double step, std::size_t n) {
    const double fine = step_in(box, step);
    if (n < worst_places || !(fine > 0)) return fine;
    return std::min(fine * std::sqrt(most_rays / fewer_rays), coarsest * step);
}

constexpr double most_cells = 2'000'000;       ///< of all proofs
constexpr double doubtful_cells = 10'000;      ///< of each of those that decide about a doubtful place
constexpr std::size_t most_doubtful = 40;      ///< of a kind
constexpr std::size_t most_looks = 4'000'000;  ///< at sweeps, for all doubtful places of a kind
constexpr double least_cells = 20'000;         ///< of each

constexpr double patch_steps = 6;          ///< of the lattice: side of a patch
constexpr std::size_t most_patches = 200;  ///< of a kind
constexpr double as_good = 0.05;           ///< of what is allowed: no worse

constexpr double among_worst = 0.9;
constexpr double as_worst = 0.999;
constexpr double as_large = 0.01;

struct Worst {
    double deviation = 0;
    geom::Vec3 at;
    std::vector<mesh::TagShare> peak;
};

/// Of the points that lie as far off as the worst the one in their middle: at its rim another cut may end.
geom::Vec3 middle_of(const std::vector<milling::SurfacePoint>& points, const std::vector<double>& off,
                     const Worst& worst) {
    std::vector<geom::Vec3> same;
    geom::Vec3 sum;
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (!std::isfinite(off[i]) || !(off[i] / worst.deviation >= as_worst)) continue;
        same.push_back(points[i].at);
        sum = sum + points[i].at;
    }
    if (same.empty()) return worst.at;
    const geom::Vec3 middle = (1 / static_cast<double>(same.size())) * sum;
    return *std::min_element(same.begin(), same.end(), [&](geom::Vec3 a, geom::Vec3 b) {
        return geom::distance(a, middle) < geom::distance(b, middle);
    });
}

Worst worst_of(const std::vector<milling::SurfacePoint>& points, const Machined& m, const mesh::CompareOptions& options,
               bool gouge) {
    std::vector<double> off(points.size());
    base::in_pieces(points.size(), 256, [&](const base::Piece& some) {
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
    worst.at = middle_of(points, off, worst);
    std::map<std::uint32_t, double> tags;
    for (std::size_t i = 0; i < points.size(); ++i)
        if (std::isfinite(off[i]) && off[i] / worst.deviation >= among_worst) ++tags[m.tag_of(points[i].cut)];
    for (const auto& [tag, count] : tags) worst.peak.push_back({tag, count});
    std::stable_sort(worst.peak.begin(), worst.peak.end(),
                     [](const mesh::TagShare& a, const mesh::TagShare& b) { return a.area > b.area; });
    return worst;
}

bool is_worse(const mesh::Place& a, const mesh::Place& b) { return std::abs(a.deviation) > std::abs(b.deviation); }

/// What rays do not show: whether it is there all the same, and how far off.
Proof::Outcome outcome_of(mesh::Place& p, const milling::Box3& box, const Machined& m, double allowed, bool gouge,
                          double cells) {
    const milling::Air air = m.simulation.whole_air_in(box);
    Claim claim{m.part, air, gouge, allowed, {}, m.stop};
    if (!m.threads.empty())
        claim.more = [&](geom::Vec3 at, double radius) { return m.threads.more(at, radius, gouge); };
    const Proof proof =
        decide(claim, box, base::clipped<std::size_t>(cells, 0, std::numeric_limits<std::size_t>::max()));
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
        if (m.stop && m.stop()) break;
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

/// A part of a place that is too large to be looked at in one.
struct SurfacePatch {
    milling::Box3 box;
    double claimed = 0;  ///< by its triangles
};

/// Triangles that leave the part by more than is allowed, and which of them touch each other.
class Leaving {
public:
    Leaving(const mesh::Comparison& found, const Machined& m, double allowed, bool gouges)
        : surface_(m.surface), parent_(m.surface.vertices.size()) {
        std::iota(parent_.begin(), parent_.end(), 0U);
        for (std::uint32_t t = 0; t < found.deviation.size(); ++t) {
            const double off = gouges ? -found.deviation[t] : found.deviation[t];
            if (!(off > allowed)) continue;
            all_.push_back({t, off});
            for (const std::uint32_t v : surface_.triangles[t])
                parent_[root(v)] = std::min(root(v), root(surface_.triangles[t][0]));
        }
    }
    /// Of a place, in cubes of a side, the worst first.
    [[nodiscard]] std::vector<SurfacePatch> patches(const mesh::Place& p, geom::Vec3 step) {
        const std::uint32_t own = root(surface_.triangles[p.triangle][0]);
        std::map<std::array<long, 3>, std::pair<mesh::Box, double>> cubes;
        for (const auto& [t, off] : all_) {
            if (root(surface_.triangles[t][0]) != own) continue;
            const geom::Vec3 at = mesh::centre(surface_, t) - p.extent.lo;
            std::array<long, 3> cube{};
            for (int k = 0; k < 3; ++k)
                cube[static_cast<std::size_t>(k)] = base::clipped<long>(
                    milling::component(at, k) / (patch_steps * milling::component(step, k)), 0, 1'000'000);
            auto& [box, claimed] = cubes[cube];
            for (const geom::Vec3& c : mesh::corners(surface_, t)) box.add(c);
            claimed = std::max(claimed, off);
        }
        std::vector<SurfacePatch> all;
        for (const auto& [cube, patch] : cubes)
            all.push_back({{patch.first.lo - step, patch.first.hi + step}, patch.second});
        std::stable_sort(all.begin(), all.end(),
                         [](const SurfacePatch& a, const SurfacePatch& b) { return a.claimed > b.claimed; });
        return all;
    }

private:
    [[nodiscard]] std::uint32_t root(std::uint32_t v) {
        while (parent_[v] != v) v = parent_[v] = parent_[parent_[v]];
        return v;
    }
    const mesh::Mesh& surface_;
    std::vector<std::uint32_t> parent_;
    std::vector<std::pair<std::uint32_t, double>> all_;
};

/// Of the patches, the worst first, that claim at least so much.
const SurfacePatch& middle_patch(const std::vector<SurfacePatch>& patches, double least) {
    const auto end =
        std::find_if(patches.begin() + 1, patches.end(), [&](const SurfacePatch& p) { return p.claimed < least; });
    const auto centre = [](const SurfacePatch& p) { return 0.5 * (p.box.min + p.box.max); };
    geom::Vec3 sum;
    for (auto p = patches.begin(); p != end; ++p) sum = sum + centre(*p);
    const geom::Vec3 middle = (1 / static_cast<double>(end - patches.begin())) * sum;
    return *std::min_element(patches.begin(), end, [&](const SurfacePatch& a, const SurfacePatch& b) {
        return geom::distance(centre(a), middle) < geom::distance(centre(b), middle);
    });
}

/// Of a place too large to be looked at in one: patch by patch, until no other one claims more than was found. False:
/// it is not there.
bool confirm_patches(mesh::Place& p, const std::vector<SurfacePatch>& patches, const Machined& m,
                     const mesh::CompareOptions& options, bool gouges, std::size_t& budget) {
    const geom::Vec3 step = m.simulation.dexels().lattice().step;
    const double allowed = gouges ? options.gouge : options.excess;
    if (patches.empty()) return true;
    Worst best;
    double open = 0;  // what could not be decided
    for (const SurfacePatch& patch : patches) {
        if (patch.claimed <= std::max(std::abs(best.deviation), open) + as_good * allowed) break;
        const double fine = step_of(patch.box, std::min({step.x, step.y, step.z}), most_patches - budget);
        if (budget == 0 || !(fine > 0) || (m.stop && m.stop())) {
            open = patch.claimed;
            break;
        }
        --budget;
        Worst worst = worst_of(m.simulation.surface_points(patch.box, fine), m, options, gouges);
        if (!(std::abs(worst.deviation) > allowed)) {
            mesh::Place part = p;
            const auto outcome = outcome_of(part, patch.box, m, allowed, gouges, least_cells);
            if (outcome == Proof::Outcome::open) open = std::max(open, patch.claimed);
            if (outcome != Proof::Outcome::present) continue;
            worst = {part.deviation, part.at, part.peak};
        }
        if (std::abs(worst.deviation) > std::abs(best.deviation)) best = std::move(worst);
    }
    const bool there = std::abs(best.deviation) > allowed;
    if (there && budget > 0) {  // of many that are as bad the one in their middle
        const SurfacePatch& middle = middle_patch(patches, std::abs(best.deviation) - as_good * allowed);
        const double fine = step_in(middle.box, std::min({step.x, step.y, step.z}));
        Worst worst;
        if (fine > 0) worst = worst_of(m.simulation.surface_points(middle.box, fine), m, options, gouges);
        if (std::abs(worst.deviation) > std::abs(best.deviation) - as_good * allowed)
            best.at = worst.at, best.peak = worst.peak;
    }
    // A corner that stands out lies between the rays: what they say is a little less.
    const double claimed = std::abs(p.deviation), most = std::abs(best.deviation);
    const bool lower = open <= most && most < (1 - as_large) * claimed;
    if (there && (lower || most >= claimed - as_good * allowed)) p.at = best.at;
    if (there && lower) p.deviation = best.deviation;
    if (there) p.peak = best.peak;
    return there || open > 0;
}

bool holds(const mesh::Box& b, geom::Vec3 p) {
    return p.x >= b.lo.x && p.y >= b.lo.y && p.z >= b.lo.z && p.x <= b.hi.x && p.y <= b.hi.y && p.z <= b.hi.z;
}

/// Of a place lower than cells are wide the triangles know its corners alone: over the middle of a groove that was not
/// cut more may stand. What is a worse place of its own does not count.
bool is_more_of_place(const Worst& worst, const mesh::Place& place, const std::vector<mesh::Place>& worse, double wide,
                      double allowed) {
    if (!(std::abs(place.deviation) < wide) ||
        !(std::abs(worst.deviation) > std::abs(place.deviation) + as_good * allowed) || !holds(place.extent, worst.at))
        return false;
    return std::none_of(worse.begin(), worse.end(), [&](const mesh::Place& p) { return holds(p.extent, worst.at); });
}

/// Gives back the boxes of the places that are not there.
std::vector<mesh::Box> confirm_places(const mesh::Comparison& found, std::vector<mesh::Place>& places,
                                      const Machined& m, const mesh::CompareOptions& options, bool gouges) {
    if (places.empty()) return {};
    const geom::Vec3 step = m.simulation.dexels().lattice().step;
    const double allowed = gouges ? options.gouge : options.excess;
    std::size_t budget = most_patches;
    Leaving leaving(found, m, allowed, gouges);
    const double cells = std::max(least_cells, most_cells / static_cast<double>(places.size() + 1));
    std::vector<mesh::Box> dropped;
    std::vector<mesh::Place> kept;
    for (std::size_t n = 0; n < places.size(); ++n) {
        mesh::Place& p = places[n];
        if (m.stop && m.stop()) {
            kept.push_back(std::move(p));
            continue;
        }
        if (gouges && m.is_none && m.is_none(p)) {
            dropped.push_back(p.extent);
            continue;
        }
        const milling::Box3 box{p.extent.lo - step, p.extent.hi + step};
        const double fine = step_of(box, std::min({step.x, step.y, step.z}), n);
        if (fine > 0) {
            const Worst worst = worst_of(m.simulation.surface_points(box, fine), m, options, gouges);
            if (std::abs(worst.deviation) > 0) p.peak = worst.peak;
            if (!(std::abs(worst.deviation) > allowed)) {
                if (outcome_of(p, box, m, allowed, gouges, cells) == Proof::Outcome::absent) {
                    dropped.push_back(p.extent);
                    continue;
                }
            } else if (std::abs(worst.deviation) < std::abs(p.deviation) ||
                       is_more_of_place(worst, p, kept, std::max({step.x, step.y, step.z}), allowed)) {
                // What lies beside the place may be worse and is a place of its own.
                p.deviation = worst.deviation, p.at = worst.at;
            }
        } else if (!confirm_patches(p, leaving.patches(p, step), m, options, gouges, budget)) {
            dropped.push_back(p.extent);
            continue;
        }
        kept.push_back(std::move(p));
    }
    places = std::move(kept);
    std::stable_sort(places.begin(), places.end(), is_worse);
    return dropped;
}

}  // namespace

void confirm(mesh::Comparison& found, const Machined& m, const mesh::CompareOptions& options) {
    const std::vector<mesh::Box> deep = confirm_places(found, found.gouges, m, options, true);
    const std::vector<mesh::Box> high = confirm_places(found, found.excesses, m, options, false);
    add_doubtful(found.gouges, found.doubtful_gouges, m, options, true, found.gouge_count);
    add_doubtful(found.excesses, found.doubtful_excesses, m, options, false, found.excess_count);
    if (deep.empty() && high.empty()) return;
    found.gouge_count -= deep.size();
    found.excess_count -= high.size();
    const auto in_one = [](const std::vector<mesh::Box>& boxes, geom::Vec3 p) {
        return std::any_of(boxes.begin(), boxes.end(), [&](const mesh::Box& b) { return holds(b, p); });
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
