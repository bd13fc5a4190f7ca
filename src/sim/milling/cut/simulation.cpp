#include "sim/milling/cut/simulation.hpp"

#include <algorithm>
#include <cmath>

#include "base/whole.hpp"
#include "sim/milling/cut/job.hpp"
#include "sim/milling/cut/pieces.hpp"
#include "sim/milling/nearest.hpp"

namespace obrys::sim::milling {
namespace {

using geom::Vec3;

constexpr double still = 1e-9;          ///< mm
constexpr double no_way = 1e-11;        ///< mm: rounding
constexpr int most_pieces = 1'000'000;  ///< of one pass
constexpr std::size_t most_sweeps = 0xFFFFFFFE;
constexpr std::size_t batch = 2048;  ///< sweeps carried out together: enough to share out, few enough for the cache

bool known(const geom::PathElement& path) {
    if (const auto* s = std::get_if<geom::Straight>(&path)) return geom::is_finite(s->from) && geom::is_finite(s->to);
    if (const auto* c = std::get_if<geom::Circular>(&path))
        return geom::is_finite(c->from) && geom::is_finite(c->to) && geom::is_finite(c->centre) &&
               geom::is_finite(c->normal) && std::isfinite(c->sweep);
    const auto& k = std::get<geom::Cubic>(path);
    return geom::is_finite(k.k0) && geom::is_finite(k.k1) && geom::is_finite(k.k2) && geom::is_finite(k.k3);
}

double radius_of(const geom::Circular& c) {
    const Vec3 out = c.from - c.centre;
    const double size = length(c.normal);
    if (!(size > 0)) return 0;
    const Vec3 n = (1 / size) * c.normal;
    return length(out - dot(out, n) * n);
}

/// Into how many chords a path is cut so that each stands off it by at most `deviation`.
double chords_of(const geom::PathElement& path, double deviation) {
    if (const auto* c = std::get_if<geom::Circular>(&path)) {
        const double radius = radius_of(*c);
        if (!(radius > deviation)) return std::max(1.0, std::ceil(std::abs(c->sweep)));
        return std::max(1.0, std::ceil(std::abs(c->sweep) / (2 * std::acos(1 - deviation / radius))));
    }
    if (const auto* k = std::get_if<geom::Cubic>(&path)) {
        const double bend = std::max(length(2.0 * k->k2), length(2.0 * k->k2 + 6.0 * k->k3));
        return std::max(1.0, std::ceil(std::sqrt(bend / (8 * deviation))));
    }
    return 1;
}

/// What is missing from the turned start to the end: the rise of a helix, the error of a circle.
Vec3 closing_of(const geom::Circular& c) {
    const Vec3 n = (1 / length(c.normal)) * c.normal, out = c.from - c.centre;
    const Vec3 turned =
        std::cos(c.sweep) * out + std::sin(c.sweep) * cross(n, out) + ((1 - std::cos(c.sweep)) * dot(n, out)) * n;
    return c.to - (c.centre + turned);
}

}  // namespace

Simulation::Simulation(const Stock& stock, const Lattice& lattice, double tolerance, int threads)
    : stock_(std::make_shared<const Stock>(stock)), faces_(stock), tolerance_(tolerance), threads_(threads) {
    Filled filled = fill(stock, lattice);
    dexels_ = std::move(filled.dexels);
    open_rays_ = filled.open_rays;
}

std::uint32_t Simulation::add_tool(ToolShape shape) {
    tools_.push_back(std::move(shape));
    return static_cast<std::uint32_t>(tools_.size() - 1);
}

std::uint32_t Simulation::orientation_for(Vec3 axis) {
    // Programs stay in an orientation for long, or change it with every move: then it is not worth a search.
    constexpr std::size_t looked_at = 8;
    for (std::size_t i = axes_.size(); i > 0 && i + looked_at > axes_.size(); --i)
        if (axes_[i - 1] == axis) return static_cast<std::uint32_t>(i - 1);
    axes_.push_back(axis);
    orientations_.push_back(orientation_of(axis));
    return static_cast<std::uint32_t>(axes_.size() - 1);
}

Taken Simulation::add(const Pass& pass) {
    engagements_.push_back({});
    if (!known(pass.path) || !geom::is_finite(pass.axis) || !(length(pass.axis) > 0)) return Taken::not_known;
    if (pass.tool >= tools_.size()) return Taken::no_tool;
    const double deviation = tolerance_ / 20;
    const auto* arc = std::get_if<geom::Circular>(&pass.path);
    const Pieces chords = in_pieces_of_turns(pass.path, chords_of(pass.path, deviation));
    double pieces = chords.count;
    bool exact = false;
    if (arc != nullptr && length(arc->normal) > 0 && orientations_[orientation_for(pass.axis)].along >= 0) {
        const Vec3 n = (1 / length(arc->normal)) * arc->normal;
        exact = length(cross(n, pass.axis)) <= 1e-12 * length(pass.axis) && length(closing_of(*arc)) <= deviation &&
                std::abs(dot(arc->to - arc->from, n)) <= still && radius_of(*arc) > still;
    }
    if (exact) pieces = std::max(1.0, std::ceil(std::abs(arc->sweep) / (geom::pi / 2) - 1e-9));
    if (!(pieces <= most_pieces) || static_cast<double>(sweeps_.size()) + pieces > static_cast<double>(most_sweeps))
        return Taken::too_long;
    const int count = base::clipped<int>(pieces, 0, most_pieces);
    const std::size_t before = sweeps_.size();
    if (exact) {
        add_circle(pass, *arc, count);
    } else {
        Vec3 at = geom::point_at(pass.path, 0);
        for (int i = 1; i <= count; ++i) {
            const Vec3 next = geom::point_at(pass.path, chords.end(i));
            if (geom::distance(at, next) <= still && i < count) continue;
            add_straight(pass, at, next);
            at = next;
        }
    }
    if (pass.goes_on && sweeps_.size() > before) sweeps_.edit(before).goes_on = true;
    if (sweeps_.size() - done_ >= batch) flush();
    return sweeps_.size() == before ? Taken::no_motion : Taken::taken;
}

void Simulation::add_straight(const Pass& pass, Vec3 from, Vec3 to) {
    if (!(geom::distance(from, to) > still)) return;
    Sweep s;
    s.from = from;
    s.to = to;
    s.tool = pass.tool;
    s.orientation = orientation_for(pass.axis);
    s.pass = static_cast<std::uint32_t>(engagements_.size() - 1);
    s.part = pass.part;
    s.cut = pass.cut;
    sweeps_.push_back(s);
}

/// Quarter turns, each about a centre that lies at the same distance from both its ends.
void Simulation::add_circle(const Pass& pass, const geom::Circular& arc, int pieces) {
    const double turn = (arc.sweep > 0 ? 1 : -1) * (dot(arc.normal, pass.axis) > 0 ? 1 : -1);
    Vec3 at = arc.from;
    for (int i = 1; i <= pieces; ++i) {
        const Vec3 next = i == pieces ? arc.to : geom::point_at(pass.path, static_cast<double>(i) / pieces);
        const std::size_t before = sweeps_.size();
        add_straight(pass, at, next);
        if (sweeps_.size() > before) {
            const Vec3 chord = next - at, off = arc.centre - 0.5 * (at + next);
            const Vec3 centre = arc.centre - (dot(off, chord) / dot(chord, chord)) * chord;
            circles_.push_back({centre, turn});
            sweeps_.edit(before).circle = static_cast<std::uint32_t>(circles_.size());
        }
        at = next;
    }
}

const Shape& Simulation::shape_of(const Sweep& sweep) const {
    const ToolShape& tool = tools_[sweep.tool];
    return sweep.part == Part::cutting ? tool.cutting : sweep.part == Part::shank ? tool.shank : tool.holder;
}

Track Simulation::track_of(const Sweep& sweep) const {
    const Orientation& frame = orientations_[sweep.orientation];
    Track track;
    track.v = frame.to_tool(sweep.to - sweep.from);
    // Turned through rotary axes, ways across or along the tool's axis are so but for their last digits; asked as
    // slanting ones, their bodies cost many times more.
    if (std::abs(track.v.z) <= no_way) track.v.z = 0;
    if (std::abs(track.v.x) <= no_way && std::abs(track.v.y) <= no_way) track.v.x = track.v.y = 0;
    if (sweep.circle == 0) return track;
    const Circle& circle = circles_[sweep.circle - 1];
    const Vec3 centre = frame.to_tool(circle.centre - sweep.from);
    track.v.z = 0;
    track.circular = true;
    track.centre = {centre.x, centre.y};
    track.radius = geom::length(track.centre);
    track.turn = circle.turn;
    track.first = (-1 / track.radius) * track.centre;
    const geom::Vec2 last = geom::Vec2{track.v.x, track.v.y} - track.centre;
    track.last = (1 / geom::length(last)) * last;
    return track;
}

Box3 Simulation::rays_box() const {
    const Lattice& l = dexels_.lattice();
    return {l.origin, l.node(l.count[0] - 1, l.count[1] - 1, l.count[2] - 1)};
}

std::vector<Job> Simulation::jobs_of(std::size_t first, std::size_t end) const {
    const Box3 box = rays_box();
    std::vector<Job> jobs;
    jobs.reserve(end - first);
    for (std::size_t i = first; i < end; ++i) {
        const Sweep& s = sweeps_[i];
        if (shape_of(s).pieces.empty()) continue;
        jobs.push_back(make_job(shape_of(s), orientations_[s.orientation], track_of(s), s.from, box));
        jobs.back().cut = static_cast<std::uint32_t>(i + 1);
        jobs.back().pass = s.pass;
        jobs.back().cuts = s.cut;
    }
    return jobs;
}

Simulation Simulation::at(std::size_t passes) const {
    // Sweeps ascend by their passes.
    std::size_t low = 0, end = done_;
    while (low < end) {
        const std::size_t middle = low + (end - low) / 2;
        (sweeps_[middle].pass < passes ? low : end) = sweeps_[middle].pass < passes ? middle + 1 : middle;
    }
    Simulation then = *this;
    const States::State* state = states_.before(end);
    then.dexels_ = state != nullptr ? state->dexels : fill(*stock_, dexels_.lattice()).dexels;
    for (std::size_t first = state != nullptr ? state->sweeps : 0; first < end; first += batch) {
        const std::vector<Job> jobs = jobs_of(first, std::min(end, first + batch));
        std::vector<Tally> tallies(jobs.size());
        cut_all(then.dexels_, jobs, tallies, threads_);
    }
    then.sweeps_.cut_to(end);
    then.runs_.cut_to(end / in_run);
    then.engagements_.cut_to(passes);
    std::erase_if(then.stacks_, [&](const auto& s) { return s.first >= passes; });
    then.done_ = end;
    then.states_.cut_to(end);
    return then;
}

void Simulation::flush() {
    while (done_ < sweeps_.size()) {
        const std::size_t end = std::min(sweeps_.size(), done_ + batch);
        const std::vector<Job> jobs = jobs_of(done_, end);
        std::vector<Tally> tallies(jobs.size());
        cut_all(dexels_, jobs, tallies, threads_);
        const Vec3 step = dexels_.lattice().step;
        const double cell = step.x * step.y * step.z;
        for (std::size_t i = 0; i < jobs.size(); ++i) {
            const Tally& t = tallies[i];
            if (!t.touched) continue;
            Engagement& e = engagements_.edit(jobs[i].pass);
            e.touched = true;
            e.volume += t.length * cell / component(step, jobs[i].main);
            e.lowest = std::min(e.lowest, t.lowest);
            e.highest = std::max(e.highest, t.highest);
            e.rightmost = std::min(e.rightmost, t.rightmost);
            e.leftmost = std::max(e.leftmost, t.leftmost);
            if (t.depth > e.depth) {
                e.depth = t.depth;
                e.deepest = t.deepest;
            }
            if (!(t.stacks.to_tip.height > 0)) continue;
            Stacks& stacks = stacks_[jobs[i].pass];
            if (t.stacks.to_tip.height > stacks.to_tip.height) stacks.to_tip = t.stacks.to_tip;
            if (t.stacks.seen.height > stacks.seen.height) stacks.seen = t.stacks.seen;
        }
        done_ = end;
        states_.add(done_, dexels_);
    }
    index_runs();
}

Vec3 Simulation::normal_at(std::uint32_t cut, Vec3 p) const {
    return cut == 0 ? faces_.normal_at(p) : normal_at(Whole{cut, cut}, p);
}

Vec3 Simulation::normal_at(Whole whole, Vec3 p) const {
    const Sweep s = sweep_of(whole);
    const Orientation& frame = orientations_[s.orientation];
    const Foot foot = foot_on(shape_of(s), track_of(s), frame.to_tool(p - s.from));
    // Where an edge of the tool has swept the surface, the gradient is the surface's normal and no face's.
    const double size = length(foot.gradient);
    return (-1 / (size > 0 ? size : 1)) * frame.to_stock(size > 0 ? foot.gradient : foot.normal);
}

std::size_t Simulation::bytes() const {
    return dexels_.bytes() + sweeps_.bytes() + circles_.bytes() + engagements_.bytes();
}

Angles engaged_angles(const Engagement& e, double radius) {
    if (!(e.rightmost <= e.leftmost) || !(radius > 0)) return {};
    return {std::asin(std::clamp(e.rightmost / radius, -1.0, 1.0)),
            std::asin(std::clamp(e.leftmost / radius, -1.0, 1.0))};
}

}  // namespace obrys::sim::milling
