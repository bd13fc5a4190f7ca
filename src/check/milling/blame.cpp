/// Which block a gouge, or material that is left, is found at.

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "base/codes.hpp"
#include "check/milling/milling.hpp"
#include "check/milling_tool.hpp"
#include "check/words.hpp"

namespace obrys::check {

namespace codes = base::codes;
namespace milling = sim::milling;

namespace {

constexpr std::size_t most_blocks = 8;  ///< that a finding names beside its own

/// What a block cut of a place.
struct BlockShare {
    const MilledMove* move = nullptr;
    double area = 0;  ///< mm2
};

/// Where the material lies, for the block at which the finding stands and so many others.
std::string extent_text(const MilledMove& at, bool cut_there, std::size_t others) {
    const std::string more =
        others == 0 ? "" : " and " + std::to_string(others) + (others == 1 ? " more block" : " more blocks");
    const std::string here = at.along ? "this contour element" : "this block";
    if (!cut_there) return "; no move has cut at that point, " + here + more + " beside it";
    return at.along || others > 0 ? (at.along ? ", along " : ", in the cuts of ") + here + more : "";
}

/// Of a place without an area the shares are depths.
std::string share_text(const BlockShare& block, bool area) {
    return (block.move->along ? "along this contour element, too: " : "in the cut of this block, too: ") +
           (area ? mm2(block.area) : mm(block.area) + " deep");
}

constexpr double farthest = 10;        ///< tolerances: farther off no tool was to take what is left
constexpr double along_surface = 0.9;  ///< cosine between surfaces along each other
constexpr double shared = 0.6;         ///< of the largest area: blocks that share a place evenly

/// The move that cut most of the surface that lies nearly as far off as the worst point, of the block that did so. (The
/// worst point itself may as well belong to the block before, whose surface ends in it.) Of what is left between two
/// blocks the later one. Nothing where that was not cut.
const MilledMove* owner_of(const Milled& milled, const mesh::Place& p, bool gouge) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, double> areas;
    double most = 0;
    const auto move_of = [&](std::uint32_t tag) {
        return tag > 0 && tag <= milled.moves.size() ? &milled.moves[tag - 1] : nullptr;
    };
    const auto block_of = [&](const MilledMove* m) {
        return m == nullptr ? std::pair{nowhere.file, nowhere.begin} : std::pair{m->where.file, m->where.begin};
    };
    for (const mesh::TagShare& s : p.peak) most = std::max(most, areas[block_of(move_of(s.tag))] += s.area);
    const MilledMove* owner = nullptr;
    for (const mesh::TagShare& s : p.peak) {  // the largest first
        const MilledMove* m = move_of(s.tag);
        const double area = areas[block_of(m)];
        if (gouge && area == most) return m;
        if (!gouge && area >= shared * most && m != nullptr && (owner == nullptr || m->index > owner->index)) owner = m;
        if (!gouge && area == most && m == nullptr) return nullptr;
    }
    return owner;
}

/// A time during which a tool stayed near a place: the move that came nearest to it, along it.
struct Visit {
    std::uint32_t last = 0;  ///< index in the moves
    std::uint32_t move = 0;
    double distance = INFINITY;
};

}  // namespace

/// Material is left by the last tool that was to take it: one that came back later than the move which cut the surface,
/// and ran along it nearer than it is high, but missed it. A tap is not to take a hole's wall: what it cuts of one is
/// left by the last tool before it that ran along the wall within the thread's depth.
const MilledMove* Milling::left_by(const Milled& milled, const mesh::Place& p, const MilledMove* owner) const {
    if (owner == nullptr || setup_.milling->part == nullptr) return owner;
    const auto taps = [&](std::uint32_t move) { return is_tap(milled.moves[move]); };
    const bool tapped = is_tap(*owner);
    double limit = std::min(std::abs(p.deviation), farthest * setup_.milling->tolerance);
    if (tapped) {
        const shop::Tool& tap = setup_.tools[*out_.result().tools[owner->tool - 1].listed];
        limit = std::max(limit, tap.radius + tap.delta_radius - core_radius(tap));
    }
    const geom::Vec3 way = p.at - setup_.milling->part->nearest(p.at).at, around{limit, limit, limit};
    const milling::Air air = simulation_->air_in({p.at - around, p.at + around});
    std::vector<Visit> visits;
    for (std::size_t body = 1; body < air.bodies(); ++body) {
        const double off = air.outside(body, p.at);
        if (off > limit) continue;
        const std::uint32_t move = move_of_pass_[simulation_->pass_of(air.cut(body))];
        if (visits.empty() || move > visits.back().last + 1) visits.push_back({});
        Visit& v = visits.back();
        v.last = move;
        const bool along = geom::dot(air.normal(body, p.at), way) < -along_surface * geom::length(way);
        if (along && off < v.distance && !taps(move)) v.distance = off, v.move = move;
    }
    constexpr double again = 1e-6;  // mm: it went the same way once more
    for (auto v = visits.rbegin(); v != visits.rend(); ++v) {
        const MilledMove& m = milled.moves[v->move];
        if (v->distance > limit) continue;
        if (tapped) return m.index < owner->index ? &m : owner;
        const bool own = milled.moves[v->last].index >= owner->index && m.index <= owner->index;
        return own || v->distance < again || m.index < owner->index ? owner : &m;
    }
    return owner;
}

/// Places a finding at the block to blame, or beside that, and names the other blocks of it, those with most of
/// its area first.
void Milling::found(const Milled& milled, const mesh::Place& p, Finding f) {
    const auto move_of = [&](std::uint32_t tag) {
        return tag > 0 && tag <= milled.moves.size() ? &milled.moves[tag - 1] : nullptr;
    };
    std::vector<BlockShare> blocks;
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::size_t> known;
    for (const mesh::TagShare& s : p.shares) {
        const MilledMove* m = move_of(s.tag);
        if (m == nullptr) continue;
        const auto [at, added] = known.try_emplace({m->where.file, m->where.begin}, blocks.size());
        if (added) blocks.push_back({m, 0});
        blocks[at->second].area += s.area;
    }
    if (blocks.empty()) {
        f.text += "; no move has cut there";
        const cl::Record nothing{cl::Stop{}, nowhere, 0};
        return out_.finding(nothing, std::move(f));
    }
    std::stable_sort(blocks.begin(), blocks.end(),
                     [](const BlockShare& a, const BlockShare& b) { return a.area > b.area; });
    const bool gouge = f.code == codes::gouge;
    const MilledMove* worst = owner_of(milled, p, gouge);
    if (!gouge) worst = left_by(milled, p, worst);
    const MilledMove& at = worst != nullptr ? *worst : *blocks.front().move;
    std::erase_if(blocks, [&](const BlockShare& b) { return b.move->where == at.where; });
    f.text += extent_text(at, worst != nullptr, blocks.size());
    for (std::size_t i = 0; i < blocks.size() && i < most_blocks; ++i)
        f.related.push_back({blocks[i].move->where, share_text(blocks[i], p.area > 0)});
    found(at, std::move(f));
}

}  // namespace obrys::check
