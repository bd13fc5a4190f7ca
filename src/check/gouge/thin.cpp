#include "check/gouge/thin.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <mutex>
#include <numeric>

#include "base/parallel.hpp"
#include "base/whole.hpp"
#include "check/gouge/filled_known.hpp"

namespace obrys::check {

namespace milling = sim::milling;

using geom::Vec3;

namespace {

constexpr double thick = 2;               ///< tolerances: what is thicker the surface holds
constexpr double thinner_is_error = 0.1;  ///< tolerances: what is thinner may be the error of chords
constexpr double nothing = 1e-5;          ///< mm: thinner is none
constexpr std::size_t most_climbs = 100;  ///< places whose highest point is looked for
constexpr double last_climb = 0.1;        ///< tolerances: step at which that ends
constexpr std::size_t most_samples = 2'000'000;

/// A ray through something thin.
struct Sample {
    int axis = 0;
    Vec3 at;  ///< its middle
    double width = 0, off = 0;
    std::uint32_t begin_cut = 0, end_cut = 0;
};

class Thin {
public:
    Thin(const Machined& m, const mesh::CompareOptions& options)
        : m_(m), options_(options), tolerance_(m.simulation.tolerance()), step_(m.simulation.dexels().lattice().step) {}
    void find();
    [[nodiscard]] ThinRest places(std::vector<mesh::Place>& known);

private:
    void find_in_row(int axis, int b, std::vector<Sample>& found) const;
    [[nodiscard]] double off_at(Vec3 p) const {
        const double d = m_.part.signed_distance(p);
        return options_.judged ? options_.judged(p, d) : d;
    }
    [[nodiscard]] std::array<std::int64_t, 3> cell_of(Vec3 p) const;
    [[nodiscard]] std::vector<std::vector<std::size_t>> groups() const;
    [[nodiscard]] Sample climbed(Sample s) const;
    [[nodiscard]] mesh::Place place_of(const std::vector<std::size_t>& group, bool climb) const;

    const Machined& m_;
    const mesh::CompareOptions& options_;
    double tolerance_;
    Vec3 step_;
    std::vector<Sample> samples_;
};

void Thin::find_in_row(int axis, int b, std::vector<Sample>& found) const {
    const milling::Dexels& dexels = m_.simulation.dexels();
    const milling::Lattice& lattice = dexels.lattice();
    for (int a = 0; a < dexels.rays_a(axis); ++a)
        for (const milling::Interval& i : dexels.ray(axis, a, b)) {
            const double width = i.end - i.begin;
            if (!(width < thick * tolerance_ && width > nothing)) continue;
            std::array<int, 3> node{};
            node[static_cast<std::size_t>(milling::first_across(axis))] = a;
            node[static_cast<std::size_t>(milling::second_across(axis))] = b;
            Sample s{axis, lattice.node(node[0], node[1], node[2]), width, 0, i.begin_cut, i.end_cut};
            milling::set_component(s.at, axis, 0.5 * (i.begin + i.end));
            s.off = off_at(s.at);
            if (std::isfinite(s.off) && s.off > options_.excess) found.push_back(s);
        }
}

void Thin::find() {
    const milling::Dexels& dexels = m_.simulation.dexels();
    for (int axis = 0; axis < 3; ++axis) {
        std::vector<std::vector<Sample>> rows(static_cast<std::size_t>(dexels.rays_b(axis)));
        base::for_all(rows.size(), [&](std::size_t b) { find_in_row(axis, static_cast<int>(b), rows[b]); });
        for (const auto& row : rows)
            if (samples_.size() + row.size() <= most_samples) samples_.insert(samples_.end(), row.begin(), row.end());
    }
}

std::array<std::int64_t, 3> Thin::cell_of(Vec3 p) const {
    const Vec3 from = p - m_.simulation.dexels().lattice().origin;
    std::array<std::int64_t, 3> cell{};
    for (int k = 0; k < 3; ++k)
        cell[static_cast<std::size_t>(k)] = base::clipped<std::int64_t>(
            std::floor(milling::component(from, k) / milling::component(step_, k)), -1'000'000'000, 1'000'000'000);
    return cell;
}

/// Samples in cells of the lattice that touch each other, the first one's group first.
std::vector<std::vector<std::size_t>> Thin::groups() const {
    std::map<std::array<std::int64_t, 3>, std::vector<std::size_t>> cells;
    for (std::size_t i = 0; i < samples_.size(); ++i) cells[cell_of(samples_[i].at)].push_back(i);
    std::vector<std::vector<std::size_t>> all;
    while (!cells.empty()) {
        std::vector<std::size_t> group;
        std::vector<std::array<std::int64_t, 3>> next{cells.begin()->first};
        while (!next.empty()) {
            const std::array<std::int64_t, 3> at = next.back();
            next.pop_back();
            const auto cell = cells.find(at);
            if (cell == cells.end()) continue;
            group.insert(group.end(), cell->second.begin(), cell->second.end());
            cells.erase(cell);
            for (std::int64_t i = -1; i <= 1; ++i)
                for (std::int64_t j = -1; j <= 1; ++j)
                    for (std::int64_t k = -1; k <= 1; ++k) next.push_back({at[0] + i, at[1] + j, at[2] + k});
        }
        all.push_back(std::move(group));
    }
    return all;
}

/// The highest place of the same sheet: on lines beside the sample's, cut again there.
Sample Thin::climbed(Sample s) const {
    const int axis = s.axis, u = milling::first_across(axis), v = milling::second_across(axis);
    const double wide = std::max({step_.x, step_.y, step_.z});
    for (double h = 0.5 * wide; h > last_climb * tolerance_;) {
        Sample best = s;
        for (int way = 0; way < 8; ++way) {
            const double turn = geom::pi / 4 * way;
            Vec3 p = s.at;
            milling::set_component(p, u, milling::component(p, u) + h * std::cos(turn));
            milling::set_component(p, v, milling::component(p, v) + h * std::sin(turn));
            const double middle = milling::component(p, axis), window = 4 * h + 4 * thick * tolerance_;
            for (const milling::Interval& i : m_.simulation.line(axis, p, middle - window, middle + window)) {
                const double width = i.end - i.begin, at = 0.5 * (i.begin + i.end);
                if (!(width < 2 * thick * tolerance_ && width > nothing) || !(std::abs(at - middle) < window)) continue;
                milling::set_component(p, axis, at);
                if (const double off = off_at(p); std::isfinite(off) && off > best.off)
                    best.at = p, best.off = off, best.width = width;
            }
        }
        if (best.off > s.off)
            s = best;
        else
            h /= 2;
    }
    return s;
}

mesh::Place Thin::place_of(const std::vector<std::size_t>& group, bool climb) const {
    mesh::Place p;
    const Sample* worst = nullptr;
    std::map<std::uint32_t, double> tags;
    std::array<double, 3> area{};
    for (const std::size_t i : group) {
        const Sample& s = samples_[i];
        if (worst == nullptr || s.off > worst->off) worst = &s;
        const auto across = [&](int k) { return milling::component(step_, k); };
        const double own = 2 * across(milling::first_across(s.axis)) * across(milling::second_across(s.axis));
        area[static_cast<std::size_t>(s.axis)] += own;
        for (const std::uint32_t cut : {s.begin_cut, s.end_cut}) tags[m_.tag_of(cut)] += own / 2;
        p.extent.add(s.at);
    }
    const Sample top = climb ? climbed(*worst) : *worst;
    p.at = top.at, p.deviation = top.off;
    p.area = *std::max_element(area.begin(), area.end());
    for (const auto& [tag, share] : tags) p.shares.push_back({tag, share});
    std::stable_sort(p.shares.begin(), p.shares.end(),
                     [](const mesh::TagShare& a, const mesh::TagShare& b) { return a.area > b.area; });
    p.peak = p.shares;
    p.tag = p.shares.empty() ? 0 : p.shares.front().tag;
    return p;
}

ThinRest Thin::places(std::vector<mesh::Place>& known) {
    ThinRest rest;
    std::size_t climbs = 0;
    for (const std::vector<std::size_t>& group : groups()) {
        double widest = 0;
        for (const std::size_t i : group) widest = std::max(widest, samples_[i].width);
        const bool open = widest < thinner_is_error * tolerance_;
        const mesh::Place p = place_of(group, !open && climbs < most_climbs && !(m_.stop && m_.stop()));
        if (open) {
            rest.open.push_back({p.extent.lo, p.extent.hi});
            continue;
        }
        ++climbs;
        const auto same = std::find_if(known.begin(), known.end(),
                                       [&](const mesh::Place& k) { return holds_widened(k.extent, p.at, step_); });
        if (same == known.end())
            rest.places.push_back(p);
        else if (p.deviation > same->deviation)
            same->deviation = p.deviation, same->at = p.at, same->peak = p.peak;
    }
    std::stable_sort(rest.places.begin(), rest.places.end(),
                     [](const mesh::Place& a, const mesh::Place& b) { return a.deviation > b.deviation; });
    return rest;
}

}  // namespace

ThinRest thin_rest(const Machined& machined, const mesh::CompareOptions& options, std::vector<mesh::Place>& known) {
    Thin thin(machined, options);
    thin.find();
    return thin.places(known);
}

}  // namespace obrys::check
