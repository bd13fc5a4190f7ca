#include "sim/milling/exact/exact.hpp"

#include <algorithm>
#include <cmath>

#include "base/whole.hpp"
#include "sim/milling/cut/covered.hpp"
#include "sim/milling/nearest.hpp"

namespace obrys::sim::milling {

namespace {

using geom::Vec3;

constexpr double beyond_line = 0.05;  ///< of a line's length

/// One ray of a row, as rows of tiles are made (tile_cut.cpp).
Row row_of(const Job& job, int axis, Vec3 from, const Lattice& lattice) {
    const Orientation& f = job.frame;
    const Aims& aims = job.aims[static_cast<std::size_t>(axis)];
    Row row;
    row.d = {component(f.x, axis), component(f.y, axis), component(f.z, axis)};
    const auto normal_part = [&](Vec3 p) { return aims.lie == Lie::skew ? p - dot(p, row.d) * row.d : p; };
    Vec3 start = from - job.from;
    set_component(start, axis, 0);
    // Rows of rays across the tool must be of one height.
    const bool along_b = aims.lie == Lie::across && f.along == first_across(axis);
    const int across = along_b ? second_across(axis) : first_across(axis);
    Vec3 step;
    set_component(step, across, component(lattice.step, across));
    row.p = normal_part(f.to_tool(start));
    row.step = normal_part(f.to_tool(step));
    row.count = 1;
    return row;
}

}  // namespace

Exact::Exact(const Simulation& simulation, const Lattice& lattice)
    : simulation_(simulation), stock_(simulation.stock_body()), lattice_(lattice), wholes_(simulation.wholes()) {
    for (const Simulation::Whole& whole : wholes_) parts_.add(simulation.cutting_of(whole.first));
    whole_of_.resize(simulation.sweeps() + 1);
    covered_ = covered(simulation, wholes_);
    around_.resize(wholes_.size());
    for (std::size_t n = 0; n < wholes_.size(); ++n) {
        const Box3 box = simulation.reach_of(wholes_[n]);
        for (int a = 0; a < 3; ++a) {
            const auto k = static_cast<std::size_t>(a);
            around_[n].low[k] = std::nextafter(static_cast<float>(component(box.min, a)), -HUGE_VALF);
            around_[n].high[k] = std::nextafter(static_cast<float>(component(box.max, a)), HUGE_VALF);
        }
    }
    for (std::uint32_t n = 0; n < wholes_.size(); ++n)
        for (std::uint32_t cut = wholes_[n].first; cut <= wholes_[n].last; ++cut) whole_of_[cut] = n;
}

Vec3 Exact::normal(std::uint32_t cut, Vec3 p) const {
    return cut == 0 ? simulation_.normal_at(0, p) : simulation_.normal_at(wholes_[whole_of_[cut]], p);
}

void Exact::prepare(const std::vector<Place>& cells) {
    const std::size_t known = sweeps_.size();
    Place low{INT32_MAX, INT32_MAX, INT32_MAX}, high{-1, -1, -1};
    for (const Place& c : cells) {
        const Place b = block_of(c);
        const auto number = static_cast<std::uint32_t>(sweeps_.size());
        if (blocks_.add(key_of(b), number) != number) continue;
        sweeps_.emplace_back();
        for (std::size_t a = 0; a < 3; ++a) low[a] = std::min(low[a], b[a]), high[a] = std::max(high[a], b[a]);
    }
    if (sweeps_.size() == known) return;
    for (std::uint32_t whole = 0; whole < wholes_.size(); ++whole) {
        const Box3 box = simulation_.reach_of(wholes_[whole]);
        Place from{}, to{};
        for (int a = 0; a < 3; ++a) {
            const auto n = static_cast<std::size_t>(a);
            const double first = component(lattice_.origin, a), step = component(lattice_.step, a);
            // A block wider on both sides by what `near` looks around.
            from[n] = base::clipped<std::int32_t>(std::floor(((component(box.min, a) - first) / step - margin) / block),
                                                  low[n], high[n] + 1);
            to[n] = base::clipped<std::int32_t>(std::floor(((component(box.max, a) - first) / step + margin) / block),
                                                low[n] - 1, high[n]);
        }
        for (std::int32_t z = from[2]; z <= to[2]; ++z)
            for (std::int32_t y = from[1]; y <= to[1]; ++y)
                for (std::int32_t x = from[0]; x <= to[0]; ++x) {
                    const std::uint32_t b = blocks_.find(key_of({x, y, z}));
                    if (b != KeyMap::none && b >= known) sweeps_[b].push_back(whole);
                }
    }
}

Exact::Near Exact::near(const Place& cell, bool lines) const { return near(cell, middle_of(cell), reach(), lines); }

Exact::Near Exact::near(const Place& cell, Vec3 centre, double reach, bool lines) const {
    Near near;
    const double within = stock_.within(centre);
    near.stock = std::abs(within) < reach;
    near.blank = within > 0;
    for (const std::uint32_t n : sweeps_[blocks_.find(key_of(block_of(cell)))]) {
        if (covered_[n] != 0 && !lines) continue;
        const Around& box = around_[n];
        if (centre.x < box.low[0] - reach || centre.x > box.high[0] + reach || centre.y < box.low[1] - reach ||
            centre.y > box.high[1] + reach || centre.z < box.low[2] - reach || centre.z > box.high[2] + reach)
            continue;
        const Simulation::Whole whole = wholes_[n];
        const Air::Sweep s = simulation_.body_of(whole);
        if (!(foot_on(*s.shape, s.track, s.frame.to_tool(centre - s.from)).outside < reach)) continue;
        if (covered_[n] == 0) near.sweeps.push_back(s);
        if (lines) near.jobs.push_back(simulation_.job_of(whole));
    }
    return near;
}

bool Exact::reaches(const Place& cell, Vec3 p) const { return geom::distance(p, middle_of(cell)) < 0.98 * reach(); }

std::optional<Exact::Near> Exact::about(const Place& cell, Vec3 centre, double radius) const {
    const Place low = block_of(cell);
    for (int a = 0; a < 3; ++a) {
        const double first = static_cast<double>(low[static_cast<std::size_t>(a)]) * block,
                     step = component(lattice_.step, a),
                     at = (component(centre, a) - component(lattice_.origin, a)) / step;
        if (at - radius / step < first - margin || at + radius / step > first + block + margin) return std::nullopt;
    }
    return near(cell, centre, radius, false);
}

bool Exact::is_material(const Near& near, Vec3 p) const {
    if (near.stock ? !(stock_.within(p) > 0) : !near.blank) return false;
    return std::none_of(near.sweeps.begin(), near.sweeps.end(), [&](const Air::Sweep& s) {
        return foot_on(*s.shape, s.track, s.frame.to_tool(p - s.from)).outside < 0;
    });
}

/// Of a fine helix many bodies share a face; of too many all the same those that a point lies deepest in.
void Exact::add_side(const Side& side, std::array<Side, most_around>& around, std::size_t& count) {
    constexpr double one_plane = 1e-3;  // between directions
    Side* shallowest = nullptr;
    for (std::size_t n = 0; n < count; ++n) {
        if (geom::distance(around[n].in, side.in) < one_plane) {
            around[n].outside = std::min(around[n].outside, side.outside);
            return;
        }
        if (around[n].in == Vec3{}) continue;  // the blank, whose direction is not asked for yet
        if (shallowest == nullptr || around[n].outside > shallowest->outside) shallowest = &around[n];
    }
    if (count < most_around)
        around[count++] = side;
    else if (shallowest != nullptr && side.outside < shallowest->outside)
        *shallowest = side;
}

bool Exact::is_on_surface(const Near& near, Vec3 p, double allowed, double in_material) const {
    if (!near.stock && !near.blank) return false;
    const double within = near.stock ? stock_.within(p) : HUGE_VAL;
    if (within < -allowed) return false;
    bool close = within <= in_material, in_air = within < 0;
    std::array<Side, most_around> around;
    std::vector<const Air::Sweep*> beside;
    std::size_t count = 0;
    const bool blank_too = close;
    if (blank_too) around[count++] = {within, {}};
    for (const Air::Sweep& s : near.sweeps) {
        const Vec3 own = s.frame.to_tool(p - s.from);
        const Foot foot = foot_on(*s.shape, s.track, own);
        if (foot.outside > in_material) continue;
        in_air = in_air || foot.outside < 0;
        if (foot.outside < allowed) add_side({foot.outside, s.frame.to_stock(foot.gradient)}, around, count);
        if (!(foot.outside > 0)) {
            if (foot.outside < -allowed || depth_in(*s.shape, own - foot.place) > allowed) return false;
            close = true;
        } else if (!close) {
            // Where the tool is when a face of it is nearest is mostly, beside its edges not quite, where it is.
            close = distance_from(*s.shape, own - foot.place) <= in_material;
            if (!close && !s.track.circular && !s.track.level()) beside.push_back(&s);
        }
    }
    close = close || std::any_of(beside.begin(), beside.end(), [&](const Air::Sweep* s) {
                return sweeps_within(*s->shape, s->track, s->frame.to_tool(p - s->from), in_material);
            });
    if (!close || !in_air || count < 2) return close;
    if (blank_too) {
        around[0] = side(near, 0, p);  // asks a mesh for its normal: where it is needed alone
        // The way out of the other bodies must not leave the stock over an edge.
        for (const StockBody::Face& f : stock_.faces_at(p, allowed))
            if (count < most_around) around[count++] = {f.within, f.in};
    }
    return is_left({around.data(), count}, allowed);
}

bool Exact::is_clear(const Near& near, Vec3 p, double radius) const {
    if (!near.stock && !near.blank) return true;
    const double within = near.stock ? stock_.within(p) : HUGE_VAL;
    bool clear = within > radius;
    if (within < -radius) return true;
    for (const Air::Sweep& s : near.sweeps) {
        const double outside = foot_on(*s.shape, s.track, s.frame.to_tool(p - s.from)).outside;
        if (outside < -radius) return true;
        clear = clear && outside > radius;
    }
    return clear;
}

void Exact::gaps(const Job& job, int axis, Vec3 from, double low, double high, std::vector<Interval>& out) const {
    const int u = first_across(axis), v = second_across(axis);
    if (component(from, u) < component(job.box.min, u) || component(from, u) > component(job.box.max, u) ||
        component(from, v) < component(job.box.min, v) || component(from, v) > component(job.box.max, v) ||
        component(job.box.max, axis) < low || component(job.box.min, axis) > high)
        return;
    const double base = component(job.from, axis);
    cut_row(
        *job.shape, job.track, row_of(job, axis, from, lattice_), job.aims[static_cast<std::size_t>(axis)],
        [](int, double, double) { return true; },
        [&](const Spans& spans) {
            const double begin = base + spans.low[0], end = base + spans.high[0];
            if (end - begin > thinnest && end > low && begin < high) out.push_back({begin, end, job.cut, job.cut});
        });
}

namespace {

/// Where a distance changes its sign between two places, to a millionth of a micron. Where faces are flat the line
/// through both values leads there at once; halving, which it never does worse than, asks a mesh forty times.
template <class F>
double change_of_sign(const F& distance, double low, double high) {
    constexpr double exactly = 1e-12, beside = 0.4 * exactly;
    double at_low = distance(low), at_high = distance(high);
    const bool first = at_low > 0;
    const auto try_at = [&](double at) {
        if (!(at > low && at < high)) return;
        const double value = distance(at);
        if ((value > 0) == first)
            low = at, at_low = value;
        else
            high = at, at_high = value;
    };
    for (int i = 0; i < 60 && high - low > exactly; ++i) {
        const double was = high - low, guess = low + was * at_low / (at_low - at_high);
        try_at(guess - beside);
        try_at(guess + beside);
        if (high - low > 0.5 * was) try_at(0.5 * (low + high));
    }
    return 0.5 * (low + high);
}

}  // namespace

/// A blank's faces on the line, as gaps. Thin parts of it within the line are not seen; a wall that one of its nodes
/// stands in is, however thin: the line goes on a little beyond both.
void Exact::stock_ends(const Near& near, int axis, Vec3 from, double low, double high,
                       std::vector<Interval>& out) const {
    if (!near.stock && near.blank) return;
    if (!near.stock) {
        out.push_back({low - 1, high + 1, 0, 0});
        return;
    }
    const auto within = [&](double at) {
        Vec3 p = from;
        set_component(p, axis, at);
        return stock_.within(p);
    };
    const double node = component(from, axis), beyond = node - low;
    const std::array<double, 4> places{low, node, high - beyond, high};
    bool material = within(low) > 0;
    double begun = low - 1;  // of a gap
    for (std::size_t i = 1; i < places.size(); ++i) {
        if ((within(places[i]) > 0) == material) continue;
        const double face = change_of_sign(within, places[i - 1], places[i]);
        if (material)
            begun = face;
        else
            out.push_back({begun, face, 0, 0});
        material = !material;
    }
    if (!material) out.push_back({begun, high + 1, 0, 0});
}

void Exact::ends(const Near& near, int axis, Vec3 from, double high, std::vector<LineEnd>& out) const {
    out.clear();
    double low = component(from, axis);
    const double more = beyond_line * (high - low);
    low -= more, high += more;
    std::vector<Interval> air;
    stock_ends(near, axis, from, low, high, air);
    for (const Job& job : near.jobs) gaps(job, axis, from, low, high, air);
    std::sort(air.begin(), air.end(), [](const Interval& a, const Interval& b) { return a.begin < b.begin; });
    double reached = -HUGE_VAL, begun = -HUGE_VAL;
    std::uint32_t last = 0;
    for (const Interval& gap : air) {
        if (gap.begin - reached > thinnest) {  // material between them
            if (reached > low) out.push_back({reached, last, true});
            if (gap.begin > low) out.push_back({gap.begin, gap.begin_cut, false});
            begun = gap.begin;
        } else if (gap.begin - begun < thinnest && begun > low) {
            out.back().cut = std::min(out.back().cut, gap.begin_cut);  // of several the first
        }
        if (std::abs(gap.end - reached) < thinnest)
            last = std::min(last, gap.end_cut);
        else if (gap.end > reached)
            last = gap.end_cut;
        reached = std::max(reached, gap.end);
    }
    if (reached > low && reached < high) out.push_back({reached, last, true});
}

}  // namespace obrys::sim::milling
