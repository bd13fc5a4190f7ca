#include "check/gouge/places.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace obrys::check {

namespace certify = sim::certify;

using geom::Vec3;

namespace {

constexpr double same_depth = 0.1;  ///< of what is allowed: no deeper
constexpr double similar = 1.2;     ///< times as deep: still the same place

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

MoveGroups::MoveGroups(std::size_t n) : parent_(n) { std::iota(parent_.begin(), parent_.end(), std::size_t{0}); }

std::size_t MoveGroups::root(std::size_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
}

void MoveGroups::join(std::size_t a, std::size_t b) {
    const std::size_t ra = root(a), rb = root(b);
    parent_[std::max(ra, rb)] = std::min(ra, rb);
}

GougePlaces::GougePlaces(const std::vector<Certificate::Found>& found, const std::vector<mesh::Place>& rays,
                         const std::vector<MilledMove>& moves, double allowed)
    : found_(found),
      rays_(rays),
      allowed_(allowed),
      groups_(found.size()),
      seen_(found.size()),
      first_(rays.size(), found.size()) {
    for (std::size_t i = 0; i < found.size(); ++i) of_move_[found[i].move].push_back(i);
    join(moves);
}

const std::vector<std::size_t>* GougePlaces::by_tag(std::uint32_t tag) const {
    const auto at = tag > 0 ? of_move_.find(tag - 1) : of_move_.end();
    return at == of_move_.end() ? nullptr : &at->second;
}

void GougePlaces::join(const std::vector<MilledMove>& moves) {
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

void GougePlaces::measure() {
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

void GougePlaces::add_rays(std::size_t place) {
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
void GougePlaces::add_unseen(std::size_t i) {
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

std::vector<std::vector<std::uint32_t>> GougePlaces::groups() {
    std::map<std::size_t, std::vector<std::uint32_t>> by_root;
    for (std::size_t i = 0; i < found_.size(); ++i) by_root[groups_.root(i)].push_back(found_[i].move);
    std::vector<std::vector<std::uint32_t>> all;
    for (auto& [root, moves] : by_root) all.push_back(std::move(moves));
    return all;
}

std::vector<Gouge> GougePlaces::taken() {
    measure();
    std::vector<Gouge> out;
    for (auto& [root, g] : all_) {
        if (g.place.tag == 0) continue;
        add_shares(g.place.shares, {{g.place.tag, 0}});
        sort_shares(g.place.shares);
        sort_shares(g.place.peak);
        out.push_back(std::move(g));
    }
    return out;
}

void sort_gouges(std::vector<Gouge>& gouges) {
    std::stable_sort(gouges.begin(), gouges.end(), [](const Gouge& a, const Gouge& b) {
        return std::abs(a.place.deviation) > std::abs(b.place.deviation);
    });
}

}  // namespace obrys::check
