#include "check/milling_rapids.hpp"

#include <algorithm>
#include <cmath>

#include "check/certify_shapes.hpp"

namespace obrys::check {

namespace certify = sim::certify;
namespace milling = sim::milling;

using geom::Vec3;

namespace {

constexpr double round_share = 0.25;            ///< of what is allowed: chords of a round stock
constexpr double hidden = 4;                    ///< times the rays' distance: what is deeper they see
constexpr std::size_t most_searches = 1000;     ///< for the deepest place
constexpr std::size_t most_looks = 20'000'000;  ///< at sweeps
constexpr double chords = 0.1;                  ///< of the tolerance: curves were cut as chords

}  // namespace

RapidGuard::RapidGuard(const milling::Stock& stock, double allowed, double apart, double tolerance, int threads)
    : stock_(mesh_of(stock, round_share * allowed)),
      allowed_(allowed),
      apart_(apart),
      tolerance_(tolerance),
      threads_(threads),
      judge_(stock_, allowed) {}

void RapidGuard::add_tool(const milling::ToolShape& tool) {
    Tool t{certified_shape(tool.cutting, round_share * allowed_), {}};
    for (const milling::Piece& p : tool.cutting.pieces) {
        t.end.push_back({p.r0, p.z0});
        if (p.r1 >= tool.cutting.radius) {
            t.end.push_back({p.r1, p.z1});
            break;
        }
    }
    tools_.push_back(std::move(t));
}

void RapidGuard::add(std::uint32_t pass, const geom::PathElement& path, Vec3 axis, std::uint32_t tool) {
    if (tool < tools_.size() && !tools_[tool].shape.empty()) queued_.push_back({pass, tool, path, axis});
}

/// Its end at some places, and the deepest of all.
RapidGuard::Places RapidGuard::places_of(const Queued& q) {
    Places places;
    const milling::Orientation frame = milling::orientation_of(q.axis);
    constexpr int stops = 4, round = 4;
    for (int i = stops; i >= 0; --i) {
        const Vec3 tip = geom::point_at(q.path, static_cast<double>(i) / stops);
        for (const geom::Vec2& end : tools_[q.tool].end)
            for (int k = 0; k < (end.x > 0 ? round : 1); ++k) {
                const double turn = geom::pi / 2 * k;
                places.all.push_back(tip + end.x * std::cos(turn) * frame.x + end.x * std::sin(turn) * frame.y +
                                     end.y * frame.z);
            }
    }
    if (searches_ >= most_searches || judge_.rough(move_of(q)) > hidden * apart_) return places;
    ++searches_;
    places.deepest = judge_.deepest(move_of(q));
    if (places.deepest.depth > 0) places.all.push_back(places.deepest.at);
    return places;
}

/// The place that lies farthest within what was material then.
RapidGuard::Hit RapidGuard::deepest(const Queued& q, const Places& places,
                                    const milling::Simulation& simulation) const {
    mesh::Box box;
    for (const Vec3& p : places.all) box.add(p);
    const double most = hidden * apart_;  // what lies farther off is not asked
    const Vec3 around{most, most, most};
    const milling::Air air = simulation.air_in({box.lo - around, box.hi + around});
    Hit hit;
    hit.depth = std::max(allowed_, chords * tolerance_);
    if (!air.known()) return {};
    const double least = hit.depth;
    const auto uncut = [&](Vec3 p, double depth, double enough) {
        for (std::size_t body = air.bodies(); body > 1 && depth > enough; --body)
            if (simulation.pass_of(air.cut(body - 1)) < q.pass) depth = std::min(depth, air.outside(body - 1, p));
        return depth;
    };
    for (const Vec3& p : places.all)
        if (const double depth = uncut(p, std::min(most, air.outside(0, p)), hit.depth); depth > hit.depth)
            hit = {depth, p};
    // Beside an edge that no cut has come near, its own depth in the tool counts.
    const certify::Depth& d = places.deepest;
    if (d.depth > hit.depth && 2 * d.depth < most && uncut(d.at, most, 2 * d.depth) > 2 * d.depth)
        hit = {d.depth, d.at};
    return hit.depth > least ? hit : Hit{};
}

void RapidGuard::carry_out(const milling::Simulation& simulation) {
    std::vector<char> clear(queued_.size());
    for_all(queued_.size(), threads_, [&](std::size_t i) { clear[i] = judge_.is_clear(move_of(queued_[i])) ? 1 : 0; });
    for (std::size_t i = 0; i < queued_.size() && looks_ < most_looks; ++i) {
        if (clear[i] != 0) continue;
        looks_ += simulation.sweeps() + 1000;
        const Hit hit = deepest(queued_[i], places_of(queued_[i]), simulation);
        if (hit.depth > 0) hits_[queued_[i].pass] = hit;
    }
    queued_.clear();
}

RapidGuard::Hit RapidGuard::hit_by(std::uint32_t pass) const {
    const auto at = hits_.find(pass);
    return at == hits_.end() ? Hit{} : at->second;
}

}  // namespace obrys::check
