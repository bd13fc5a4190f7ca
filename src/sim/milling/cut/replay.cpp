// What was cut is cut again in a small part of the stock, on rays that lie as near to each other as is asked for.

#include <algorithm>
#include <cmath>
#include <limits>

#include "sim/milling/cut/job.hpp"
#include "sim/milling/cut/simulation.hpp"

namespace obrys::sim::milling {
namespace {

using geom::Vec3;

/// Around all that the sweep takes.
Box3 box_of(const Simulation::Sweep& s, const Shape& shape, Vec3 axis) {
    // A quarter of a circle stands off its chord by less than a quarter of that.
    const double bulge = s.circle == 0 ? 0 : 0.25 * geom::distance(s.from, s.to);
    Box3 box;
    for (int k = 0; k < 3; ++k) {
        const double along = component(axis, k);
        const double beside = shape.radius * std::sqrt(std::max(0.0, 1 - along * along)) + bulge;
        const double from = component(s.from, k), to = component(s.to, k);
        const double one = shape.bottom * along, other = shape.top * along;
        set_component(box.max, k, std::max(from, to) + std::max(one, other) + beside);
        set_component(box.min, k, std::min(from, to) + std::min(one, other) - beside);
    }
    return box;
}

bool meet(const Box3& a, const Box3& b) {
    return a.max.x >= b.min.x && a.min.x <= b.max.x && a.max.y >= b.min.y && a.min.y <= b.max.y && a.max.z >= b.min.z &&
           a.min.z <= b.max.z;
}

}  // namespace

/// Boxes of the runs that are complete.
void Simulation::index_runs() {
    for (std::size_t first = runs_.size() * in_run; first + in_run <= done_; first += in_run) {
        Box3 all{{never, never, never}, {-never, -never, -never}};
        for (std::size_t i = first; i < first + in_run; ++i) {
            const Sweep& s = sweeps_[i];
            if (!s.cut || shape_of(s).pieces.empty()) continue;
            const Box3 own = box_of(s, shape_of(s), orientations_[s.orientation].z);
            all.min = {std::min(all.min.x, own.min.x), std::min(all.min.y, own.min.y), std::min(all.min.z, own.min.z)};
            all.max = {std::max(all.max.x, own.max.x), std::max(all.max.y, own.max.y), std::max(all.max.z, own.max.z)};
        }
        runs_.push_back(all);
    }
}

std::vector<std::uint32_t> Simulation::cuts_in(const Box3& box, std::uint32_t behind, std::uint32_t last) const {
    std::vector<std::uint32_t> found;
    const std::size_t end = std::min<std::size_t>(last, done_);
    for (std::size_t i = behind; i < end; ++i) {
        if (i / in_run < runs_.size() && !meet(runs_[i / in_run], box)) {
            i = (i / in_run + 1) * in_run - 1;
            continue;
        }
        const Sweep& s = sweeps_[i];
        if (!s.cut || shape_of(s).pieces.empty()) continue;
        if (meet(box_of(s, shape_of(s), orientations_[s.orientation].z), box))
            found.push_back(static_cast<std::uint32_t>(i + 1));
    }
    return found;
}

Air::Sweep Simulation::body_of(std::uint32_t cut) const { return body_of(Whole{cut, cut}); }

Job Simulation::job_of(std::uint32_t cut) const { return job_of(Whole{cut, cut}); }

const Shape* Simulation::cutting_of(std::uint32_t cut) const {
    const Sweep& s = sweeps_[cut - 1];
    return !s.cut || cut > done_ || shape_of(s).pieces.empty() ? nullptr : &shape_of(s);
}

Box3 Simulation::reach_of(Whole whole) const {
    const Sweep s = sweep_of(whole);
    return box_of(s, shape_of(s), orientations_[s.orientation].z);
}

std::vector<Job> Simulation::jobs_in(const Box3& box) const {
    std::vector<Job> jobs;
    for (const std::uint32_t cut : cuts_in(box)) jobs.push_back(job_of(cut));
    return jobs;
}

const StockBody& Simulation::body() const {
    if (!body_) body_ = std::make_shared<const StockBody>(*stock_);
    return *body_;
}

Air Simulation::air_in(const Box3& box) const {
    std::vector<Air::Sweep> sweeps;
    for (const std::uint32_t cut : cuts_in(box)) sweeps.push_back(body_of(cut));
    return {body(), std::move(sweeps)};
}

Air Simulation::whole_air_in(const Box3& box) const {
    std::vector<Air::Sweep> sweeps;
    for (const Whole& whole : wholes(cuts_in(box))) sweeps.push_back(body_of(whole));
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
