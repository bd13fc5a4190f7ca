// What was cut is cut again in a small part of the stock, on rays that lie as near to each other as is asked for.

#include <algorithm>
#include <cmath>

#include "sim/milling/job.hpp"
#include "sim/milling/simulation.hpp"

namespace obrys::sim::milling {
namespace {

using geom::Vec3;

/// False where the sweep surely misses the box; long tools make it worth to be asked before a Job is made.
bool may_meet(const Simulation::Sweep& s, const Shape& shape, Vec3 axis, const Box3& box) {
    // A quarter of a circle stands off its chord by less than a quarter of that.
    const double bulge = s.circle == 0 ? 0 : 0.25 * geom::distance(s.from, s.to);
    for (int k = 0; k < 3; ++k) {
        const double along = component(axis, k);
        const double beside = shape.radius * std::sqrt(std::max(0.0, 1 - along * along)) + bulge;
        const double from = component(s.from, k), to = component(s.to, k);
        const double one = shape.bottom * along, other = shape.top * along;
        if (std::max(from, to) + std::max(one, other) + beside < component(box.min, k) ||
            std::min(from, to) + std::min(one, other) - beside > component(box.max, k))
            return false;
    }
    return true;
}

}  // namespace

std::vector<Job> Simulation::jobs_in(const Box3& box) const {
    std::vector<Job> jobs;
    for (std::size_t i = 0; i < done_; ++i) {
        const Sweep& s = sweeps_[i];
        if (!s.cut || shape_of(s).pieces.empty() || !may_meet(s, shape_of(s), orientations_[s.orientation].z, box))
            continue;
        jobs.push_back(make_job(shape_of(s), orientations_[s.orientation], track_of(s), s.from, rays_box()));
        jobs.back().cut = static_cast<std::uint32_t>(i + 1);
    }
    return jobs;
}

const StockBody& Simulation::body() const {
    if (!body_) body_ = std::make_shared<const StockBody>(*stock_);
    return *body_;
}

Air Simulation::air_in(const Box3& box) const {
    std::vector<Air::Sweep> sweeps;
    for (std::size_t i = 0; i < done_; ++i) {
        const Sweep& s = sweeps_[i];
        const Orientation& frame = orientations_[s.orientation];
        if (!s.cut || shape_of(s).pieces.empty() || !may_meet(s, shape_of(s), frame.z, box)) continue;
        sweeps.push_back({&shape_of(s), frame, track_of(s), s.from, static_cast<std::uint32_t>(i + 1)});
    }
    return {body(), std::move(sweeps)};
}

std::vector<Interval> Simulation::line(int axis, Vec3 through, double low, double high) const {
    // One ray along the axis; its ends' nodes lie beside the part that is asked for, as those of any lattice do.
    Lattice one;
    one.origin = through;
    set_component(one.origin, axis, low - (high - low));
    set_component(one.step, axis, high - low);
    one.count = {1, 1, 1};
    one.count[static_cast<std::size_t>(axis)] = 4;
    Box3 box{through, through};
    set_component(box.min, axis, low);
    set_component(box.max, axis, high);
    Dexels again = fill(*stock_, one).dexels;
    const std::vector<Job> jobs = jobs_in(box);
    std::vector<Tally> tallies(jobs.size());
    for (std::uint32_t n = 0; n < jobs.size(); ++n)
        cut_tile(again.tile(axis, 0, 0), one, axis, 0, 0, jobs, std::span(&n, 1), std::span(tallies).subspan(n, 1));
    const std::span<const Interval> ray = again.ray(axis, 0, 0);
    return {ray.begin(), ray.end()};
}

std::vector<SurfacePoint> Simulation::surface_points(const Box3& box, double step) const {
    std::vector<SurfacePoint> points;
    const auto lattice = make_lattice(box, step);
    if (!lattice) return points;
    Dexels again = fill(*stock_, *lattice).dexels;
    const std::vector<Job> jobs = jobs_in(box);
    std::vector<Tally> tallies(jobs.size());
    cut_all(again, jobs, tallies, threads_);
    for (int axis = 0; axis < 3; ++axis) {
        const int first = first_across(axis), second = second_across(axis);
        const double low = component(box.min, axis), high = component(box.max, axis);
        for (int b = 0; b < again.rays_b(axis); ++b)
            for (int a = 0; a < again.rays_a(axis); ++a) {
                Vec3 p = lattice->origin;
                set_component(p, first, component(p, first) + a * component(lattice->step, first));
                set_component(p, second, component(p, second) + b * component(lattice->step, second));
                for (const Interval& v : again.ray(axis, a, b))
                    for (const auto& [at, cut] : {std::pair{v.begin, v.begin_cut}, std::pair{v.end, v.end_cut}}) {
                        if (at < low || at > high) continue;
                        set_component(p, axis, at);
                        points.push_back({p, cut});
                    }
            }
    }
    return points;
}

}  // namespace obrys::sim::milling
