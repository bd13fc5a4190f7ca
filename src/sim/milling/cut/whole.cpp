// Moves are added in pieces where the way in the material is to be measured. Their bodies are one: asked of the pieces,
// a question costs as many times more, and between them lie faces that are none.

#include <algorithm>
#include <cmath>
#include <numeric>

#include "sim/milling/cut/job.hpp"
#include "sim/milling/cut/simulation.hpp"

namespace obrys::sim::milling {

namespace {

using geom::Vec3;

constexpr double same_point = 1e-9;    ///< mm
constexpr double same_circle = 0.002;  ///< of the tolerance: ends of arcs are rounded to decimals

}  // namespace

/// A cut goes on where others have ended: the same tool on the same line, or within the same quarter of a circle.
bool Simulation::is_one(Whole whole, std::uint32_t next) const {
    const Sweep &first = sweeps_[whole.first - 1], &last = sweeps_[whole.last - 1], &s = sweeps_[next - 1];
    if (!s.goes_on || s.tool != first.tool || s.part != first.part || s.orientation != first.orientation ||
        (s.circle == 0) != (first.circle == 0) || geom::distance(s.from, last.to) > same_point)
        return false;
    if (s.circle == 0) {
        const Vec3 way = s.to - first.from, on = s.from - first.from;
        return dot(way, on) > 0 && dot(s.to - s.from, on) > 0 && length(cross(way, on)) <= same_point * length(way);
    }
    const Circle &own = circles_[s.circle - 1], &begun = circles_[first.circle - 1];
    const Vec3 from = first.from - begun.centre, to = s.to - begun.centre;
    const double same = std::max(same_point, same_circle * tolerance_);
    return own.turn == begun.turn && geom::distance(own.centre, begun.centre) <= same &&
           std::abs(length(from) - length(to)) <= same && dot(from, to) >= -same_point * length(to);
}

std::vector<Simulation::Whole> Simulation::wholes(std::span<const std::uint32_t> cuts) const {
    std::vector<Whole> all;
    for (const std::uint32_t cut : cuts)
        if (cutting_of(cut) == nullptr)
            continue;
        else if (!all.empty() && is_one(all.back(), cut))
            all.back().last = cut;
        else
            all.push_back({cut, cut});
    return all;
}

std::vector<Simulation::Whole> Simulation::wholes() const {
    std::vector<std::uint32_t> cuts(done_);
    std::iota(cuts.begin(), cuts.end(), 1U);
    return wholes(cuts);
}

Simulation::Sweep Simulation::sweep_of(Whole whole) const {
    Sweep s = sweeps_[whole.first - 1];
    s.to = sweeps_[whole.last - 1].to;
    return s;
}

Air::Sweep Simulation::body_of(Whole whole) const {
    const Sweep s = sweep_of(whole);
    return {&shape_of(s), orientations_[s.orientation], track_of(s), s.from, whole.first};
}

Job Simulation::job_of(Whole whole) const {
    const Sweep s = sweep_of(whole);
    Job job = make_job(shape_of(s), orientations_[s.orientation], track_of(s), s.from, rays_box());
    job.cut = whole.first;
    return job;
}

}  // namespace obrys::sim::milling
