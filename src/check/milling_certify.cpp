#include "check/milling_certify.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <utility>

#include "check/certify_shapes.hpp"

namespace obrys::check {

namespace certify = sim::certify;
namespace milling = sim::milling;

using geom::Vec3;

namespace {

constexpr double chord_share = 0.02;          ///< of what is allowed: chords that stand for a form tool's arcs
constexpr std::size_t moves_looked_at = 400;  ///< moves whose depth is found to the end
constexpr double same_depth = 0.1;            ///< of what is allowed: no deeper
constexpr double similar = 1.2;               ///< times as deep: still the same place

/// Length of a way as it is seen along a direction.
double way_beside(const geom::PathElement& path, Vec3 direction) {
    constexpr int chords = 16;
    double way = 0;
    for (int i = 0; i < chords; ++i) {
        const Vec3 step = geom::point_at(path, double(i + 1) / chords) - geom::point_at(path, double(i) / chords);
        way += geom::length(step - dot(step, direction) * direction);
    }
    return way;
}

/// Moves that belong to one place.
class Groups {
public:
    explicit Groups(std::size_t n) : parent_(n) { std::iota(parent_.begin(), parent_.end(), std::size_t{0}); }
    std::size_t root(std::size_t i) {
        while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
        return i;
    }
    void join(std::size_t a, std::size_t b) {
        const std::size_t ra = root(a), rb = root(b);
        parent_[std::max(ra, rb)] = std::min(ra, rb);
    }

private:
    std::vector<std::size_t> parent_;
};

bool lies_in(const mesh::Box& b, Vec3 p, double more) {
    return p.x >= b.lo.x - more && p.y >= b.lo.y - more && p.z >= b.lo.z - more && p.x <= b.hi.x + more &&
           p.y <= b.hi.y + more && p.z <= b.hi.z + more;
}

void add_shares(std::vector<mesh::TagShare>& to, const std::vector<mesh::TagShare>& from) {
    for (const mesh::TagShare& s : from) {
        const auto at = std::find_if(to.begin(), to.end(), [&](const mesh::TagShare& t) { return t.tag == s.tag; });
        if (at == to.end())
            to.push_back(s);
        else
            at->area += s.area;
    }
}

void sort_shares(std::vector<mesh::TagShare>& shares) {
    std::stable_sort(shares.begin(), shares.end(),
                     [](const mesh::TagShare& a, const mesh::TagShare& b) { return a.area > b.area; });
}

}  // namespace

Certificate::Certificate(const MillingSetup& setup, double allowed)
    : threads_(setup.threads), allowed_(allowed), part_(setup.part), judge_(*part_, allowed, depth_in(setup.stock)) {}

void Certificate::add_tool(const milling::ToolShape& tool) {
    shapes_.push_back(certified_shape(tool.cutting, chord_share * allowed_));
}

void Certificate::add(std::uint32_t move, const geom::PathElement& path, Vec3 axis, std::uint32_t tool) {
    if (tool < shapes_.size()) queued_.push_back({move, tool, path, axis});
}

void Certificate::carry_out() {
    std::vector<char> clear(queued_.size());
    for_all(queued_.size(), threads_, [&](std::size_t i) { clear[i] = judge_.is_clear(move_of(queued_[i])) ? 1 : 0; });
    for (std::size_t i = 0; i < queued_.size(); ++i)
        if (clear[i] == 0) suspects_.push_back(std::move(queued_[i]));
    queued_.clear();
}

/// Of very many moves that are too deep only the deepest are looked at to the end.
void Certificate::measure(const ThreadBands& threads, const std::function<bool()>& stop) {
    std::vector<Found> found(suspects_.size());
    const bool many = suspects_.size() > moves_looked_at;
    for_all(found.size(), threads_, [&](std::size_t i) {
        found[i].move = suspects_[i].move;
        if (stop && stop()) return;
        found[i].depth.depth = many ? judge_.rough(move_of(suspects_[i])) : INFINITY;
    });
    std::vector<std::size_t> order(found.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return found[a].depth.depth > found[b].depth.depth; });
    for_all(order.size(), threads_, [&](std::size_t i) {
        Found& f = found[order[i]];
        if (stop && stop()) f.depth.depth = 0;
        if (!(f.depth.depth > 0)) return;
        if (i >= moves_looked_at && f.depth.depth > allowed_) return;
        f.depth = judge_.deepest(move_of(suspects_[order[i]]));
        f.beside = way_beside(suspects_[order[i]].path, f.depth.normal);
    });
    if (!threads.empty())
        for (Found& f : found) {
            // What an edge is of a thread that the part shows is no depth; the deepest place is known.
            if (f.depth.edge) f.depth.depth = geom::distance(f.depth.at, f.depth.surface);
            f.depth.edge = false;
            f.depth.depth = std::abs(threads.judged(f.depth.at, -f.depth.depth));
        }
    std::erase_if(found, [&](const Found& f) { return !(f.depth.depth > allowed_); });
    found_ = std::move(found);
}

namespace {

/// Gouging moves and what the rays saw of them, put together to places.
class Places {
public:
    Places(const std::vector<Certificate::Found>& found, const std::vector<mesh::Place>& rays, double allowed)
        : found_(found),
          rays_(rays),
          allowed_(allowed),
          groups_(found.size()),
          seen_(found.size()),
          first_(rays.size(), found.size()) {
        for (std::size_t i = 0; i < found.size(); ++i) of_move_[found[i].move].push_back(i);
    }
    void join(const std::vector<MilledMove>& moves);
    void measure();
    [[nodiscard]] std::vector<Gouge> taken();

private:
    [[nodiscard]] const std::vector<std::size_t>* by_tag(std::uint32_t tag) const {
        const auto at = tag > 0 ? of_move_.find(tag - 1) : of_move_.end();
        return at == of_move_.end() ? nullptr : &at->second;
    }
    void add_rays(std::size_t place);
    void add_unseen(std::size_t i);

    const std::vector<Certificate::Found>& found_;
    const std::vector<mesh::Place>& rays_;
    double allowed_ = 0;
    Groups groups_;
    std::vector<char> seen_;          ///< by the rays
    std::vector<std::size_t> first_;  ///< of each place of the rays: one of the moves found; else their number
    std::map<std::uint32_t, std::vector<std::size_t>> of_move_;
    std::map<std::size_t, std::size_t> worst_;  ///< by the root of a group
    std::map<std::size_t, Gouge> all_;          ///< the same
};

void Places::join(const std::vector<MilledMove>& moves) {
    for (const auto& [move, all] : of_move_)
        for (const std::size_t i : all) groups_.join(all.front(), i);
    // What the rays see as one place is one.
    for (std::size_t p = 0; p < rays_.size(); ++p)
        for (const mesh::TagShare& s : rays_[p].shares) {
            const auto* all = by_tag(s.tag);
            if (all == nullptr) continue;
            if (first_[p] < found_.size()) groups_.join(first_[p], all->front());
            first_[p] = all->front();
            for (const std::size_t i : *all) seen_[i] = 1;
        }
    // What they do not see, such as the way back: moves one after another.
    for (std::size_t i = 0; i + 1 < found_.size(); ++i) {
        const std::uint32_t a = found_[i].move, b = found_[i + 1].move;
        if ((seen_[i] == 0 || seen_[i + 1] == 0) && b == a + 1 && geom::distance(moves[a].to, moves[b].from) < 1e-6)
            groups_.join(i, i + 1);
    }
}

void Places::measure() {
    const auto deeper = [&](std::size_t a, std::size_t b) {
        return found_[a].depth.depth > found_[b].depth.depth * (1 + 1e-6) + 1e-9;
    };
    for (std::size_t i = 0; i < found_.size(); ++i) {
        const auto [at, first] = worst_.try_emplace(groups_.root(i), i);
        if (!first && deeper(i, at->second)) at->second = i;
    }
    for (const auto& [root, worst] : worst_) {
        const certify::Depth& d = found_[worst].depth;
        Gouge& g = all_[root];
        g.place.at = d.at;
        g.place.deviation = -d.depth;
        g.place.tag = found_[worst].move + 1;
        g.width = d.width;
        g.edge = d.edge;
    }
    for (std::size_t p = 0; p < rays_.size(); ++p)
        if (first_[p] < found_.size()) add_rays(p);
    for (std::size_t i = 0; i < found_.size(); ++i) add_unseen(i);
    for (auto& [root, g] : all_)
        if (g.place.peak.empty()) g.place.peak.push_back({g.place.tag, 0});
}

void Places::add_rays(std::size_t place) {
    const mesh::Place& p = rays_[place];
    Gouge& g = all_[groups_.root(first_[place])];
    // Where all is as deep, the rays' place is as good: it lies where most is taken.
    if (std::abs(p.deviation - g.place.deviation) < allowed_ * same_depth) g.place.at = p.at;
    g.place.area += p.area;
    g.place.extent.add(p.extent);
    add_shares(g.place.shares, p.shares);
    std::vector<mesh::TagShare> peak = p.peak;
    std::erase_if(peak, [&](const mesh::TagShare& s) {
        const auto* all = by_tag(s.tag);
        return all == nullptr || std::none_of(all->begin(), all->end(), [&](std::size_t i) {
                   return found_[i].depth.depth * similar >= -g.place.deviation;
               });
    });
    add_shares(g.place.peak, peak);
}

/// A move that went through a place before another one cut it as deep is no place of its own.
void Places::add_unseen(std::size_t i) {
    const std::size_t root = groups_.root(i);
    Gouge& g = all_[root];
    if (g.place.area > 0) return;
    const bool hosted = std::any_of(all_.begin(), all_.end(), [&](const auto& entry) {
        const mesh::Place& p = entry.second.place;
        return p.area > 0 && lies_in(p.extent, found_[i].depth.at, allowed_) &&
               -g.place.deviation <= similar * -p.deviation + allowed_;
    });
    if (hosted && worst_[root] == i) g.place.tag = 0;
    if (hosted) return;
    add_shares(g.place.shares, {{found_[i].move + 1, found_[i].depth.depth}});
    // Of those that are about as deep the one that goes along the surface is to blame, before the way down and back.
    if (found_[i].depth.depth * similar >= -g.place.deviation)
        add_shares(g.place.peak, {{found_[i].move + 1, found_[i].beside}});
}

std::vector<Gouge> Places::taken() {
    std::vector<Gouge> out;
    for (const mesh::Place& p : rays_)
        if (std::all_of(p.shares.begin(), p.shares.end(), [](const mesh::TagShare& s) { return s.tag == 0; }))
            out.push_back({p, 0, false});
    for (auto& [root, g] : all_) {
        if (g.place.tag == 0) continue;
        add_shares(g.place.shares, {{g.place.tag, 0}});
        sort_shares(g.place.shares);
        sort_shares(g.place.peak);
        out.push_back(std::move(g));
    }
    std::stable_sort(out.begin(), out.end(), [](const Gouge& a, const Gouge& b) {
        return std::abs(a.place.deviation) > std::abs(b.place.deviation);
    });
    return out;
}

}  // namespace

bool Certificate::may_be(const mesh::Place& rays) const {
    const auto is_of = [&](std::uint32_t tag) {
        return std::any_of(found_.begin(), found_.end(), [&](const Found& f) { return f.move + 1 == tag; });
    };
    bool moved = false;
    for (const mesh::TagShare& s : rays.shares) {
        if (s.tag > 0 && is_of(s.tag)) return true;
        moved = moved || s.tag > 0;
    }
    return !moved;
}

std::vector<Gouge> Certificate::gouges(const std::vector<MilledMove>& moves,
                                       const std::vector<mesh::Place>& rays) const {
    Places places(found_, rays, allowed_);
    places.join(moves);
    places.measure();
    return places.taken();
}

}  // namespace obrys::check
