// The result is held to the part where the result's triangles are, and these lie as far apart as the cells are wide:
// a flat face over a slot that was never cut does not know of it. So the part's own faces are asked, where something
// faces them nearer than the cells are wide: how deep a place lies in what is left is the least distance from all that
// is not there, exact and no faster than the way from place to place. A place of the part may lie deeper than any
// material stands off it: in a corner that a tool has left round, by 1 / sin of half the corner's angle. Three times is
// 39 degrees; below that it is a gap, and a gap that is filled deeper than three times what is allowed is rest however
// narrow it is.

#include "check/gouge/filled.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <optional>

#include "base/parallel.hpp"
#include "base/whole.hpp"
#include "check/gouge/filled_depth.hpp"
#include "check/gouge/filled_known.hpp"
#include "check/gouge/proof.hpp"
#include "check/gouge/touching.hpp"
#include "mesh/narrow.hpp"

namespace obrys::check {

namespace milling = sim::milling;

using geom::Vec3;

namespace {

constexpr double facing_steps = 2;  ///< steps: what lies nearer to each other the surface may not hold
constexpr double spacing = 0.4;     ///< steps between places, at most
constexpr double filled_gap = 3;    ///< of what is allowed
constexpr double narrowest = 0.1;   ///< the same: a narrower gap is none, two bodies that touch
constexpr std::size_t most_narrow_faces = 1'000'000;
constexpr double coarsest_steps = 2;  ///< steps
constexpr double side = 8;            ///< steps: places are looked at together in cubes of this size
constexpr std::size_t batch_of_cubes = 256;
constexpr std::size_t most_measured = 12;  ///< places of a cube
constexpr int most_looks_through = 2000;   ///< on a way out
constexpr double same_way = 1e-6;          ///< mm
constexpr std::size_t most_ways_out = 40;  ///< of a place, the shortest first
constexpr int most_steps = 2000;
constexpr std::size_t proof_cells = 3000;
constexpr std::size_t most_proofs = 100;

/// The deepest place of a cube, and how much of the part's surface there is covered.
struct Covered {
    Cube cube{};
    Vec3 at, top;  ///< on the part; where the material above it ends
    double depth = 0, area = 0;
    std::uint32_t cut = 0, face = 0;
    mesh::Box faces;  ///< that are covered
};

/// A place in material, and the face it is on.
struct Deep {
    Vec3 at;
    std::uint32_t face = 0;
};

class Filled {
public:
    Filled(const mesh::Comparison& found, const Machined& m, const mesh::CompareOptions& options)
        : found_(found),
          m_(m),
          options_(options),
          step_(m.simulation.dexels().lattice().step),
          wide_(std::max({step_.x, step_.y, step_.z})) {}
    [[nodiscard]] bool find();
    [[nodiscard]] std::vector<mesh::Place> places(std::vector<mesh::Place>& known);

private:
    using Some = std::vector<std::uint32_t>;  ///< numbers in `faces_`
    [[nodiscard]] bool find_faces();
    [[nodiscard]] Cube cube_of(Vec3 p) const;
    [[nodiscard]] milling::Box3 box_of(const Some& some, double more) const;
    [[nodiscard]] std::optional<Covered> look(const Some& some) const;
    [[nodiscard]] bool counts(const mesh::NarrowFace& f) const;
    struct Deepest {
        Deep place;
        FilledDepth depth;
    };
    [[nodiscard]] std::vector<Deepest> deepest_of(const milling::Air& air, const std::vector<Deep>& deep,
                                                  double reach) const;
    struct Top {
        Vec3 at;
        std::size_t body = 0;
    };
    [[nodiscard]] bool leads_through(Vec3 from, Vec3 to) const;
    [[nodiscard]] std::optional<Top> beside_part(const milling::Air& air, Vec3 at, double reach) const;
    [[nodiscard]] Top top_of(const milling::Air& air, const Deepest& d, double reach) const;
    void measure(Covered& c, const std::vector<Deep>& deep, const Some& some) const;
    [[nodiscard]] bool stands_off(const Covered& c) const;
    [[nodiscard]] Vec3 before(const mesh::NarrowFace& f) const;
    [[nodiscard]] bool is_rest(const Covered& c);
    [[nodiscard]] FilledPlace place_of(const std::vector<const Covered*>& group) const;

    const mesh::Comparison& found_;
    const Machined& m_;
    const mesh::CompareOptions& options_;
    Vec3 step_;
    double wide_;
    std::vector<mesh::NarrowFace> faces_;
    std::vector<Covered> covered_;
    std::size_t proofs_ = 0;
};

Vec3 middle_of(const mesh::NarrowFace& f) { return (1.0 / 3) * (f.corners[0] + f.corners[1] + f.corners[2]); }

/// Places of a face.
std::array<Vec3, 4> places_of(const mesh::NarrowFace& f) {
    return {f.corners[0], f.corners[1], f.corners[2], middle_of(f)};
}

bool Filled::find_faces() {
    for (double apart = spacing; apart <= coarsest_steps; apart *= 1.5) {
        auto faces = mesh::narrow_faces(m_.part, facing_steps * wide_, apart * wide_, most_narrow_faces);
        if (!faces) continue;
        faces_ = std::move(*faces);
        return true;
    }
    return false;
}

Cube Filled::cube_of(Vec3 p) const {
    const Vec3 from = p - m_.simulation.dexels().lattice().origin;
    Cube cube{};
    for (int k = 0; k < 3; ++k)
        cube[static_cast<std::size_t>(k)] = base::clipped<long>(
            std::floor(milling::component(from, k) / (side * wide_)), -1'000'000'000, 1'000'000'000);
    return cube;
}

milling::Box3 Filled::box_of(const Some& some, double more) const {
    mesh::Box box;
    for (const std::uint32_t f : some)
        for (const Vec3& c : faces_[f].corners) box.add(c);
    const Vec3 around{more, more, more};
    return {box.lo - around, box.hi + around};
}

/// A place that lies in what the face bounds.
Vec3 Filled::before(const mesh::NarrowFace& f) const {
    return middle_of(f) + narrowest * options_.excess * m_.part.normal(f.triangle);
}

/// What lies before the face is outside of the part.
bool Filled::counts(const mesh::NarrowFace& f) const { return mesh::winding(m_.part, before(f)) == 0; }

/// Of each triangle the deepest of these places.
std::vector<Filled::Deepest> Filled::deepest_of(const milling::Air& air, const std::vector<Deep>& deep,
                                                double reach) const {
    std::map<std::uint32_t, Deepest> of;
    std::size_t first = 0;
    for (const Deep& p : deep) {
        Deepest& best = of[faces_[p.face].triangle];
        const FilledDepth d = depth_at(air, p.at, best.depth.depth, reach, first);
        first = d.body;
        if (d.depth > best.depth.depth) best = {p, d};
    }
    std::vector<Deepest> all;
    for (const auto& [triangle, best] : of) all.push_back(best);
    std::stable_sort(all.begin(), all.end(),
                     [](const Deepest& a, const Deepest& b) { return a.depth.depth > b.depth.depth; });
    if (all.size() > most_measured) all.resize(most_measured);
    return all;
}

/// Somewhere between two places is the part: by steps as long as nothing of it can lie in between.
bool Filled::leads_through(Vec3 from, Vec3 to) const {
    const double length = geom::distance(from, to), least = 2 * options_.excess;
    double way = 0;
    for (int k = 0; k < most_looks_through && way < length; ++k) {
        const double off = m_.part.signed_distance(from + (way / length) * (to - from));
        if (off < -options_.excess) return true;
        way += std::max(off, least);
    }
    return way < length;
}

/// The shortest way out that does not lead through the part, as through a wall into the pocket behind it.
std::optional<Filled::Top> Filled::beside_part(const milling::Air& air, Vec3 at, double reach) const {
    // Of bodies as far away as each other the first: a tool drawn back the way it came has cut nothing there.
    std::vector<std::pair<double, std::size_t>> ways;
    for (std::size_t body = 0; body < air.bodies(); ++body)
        if (const double outside = air.outside(body, at, reach); outside > 0 && outside < reach)
            ways.emplace_back(std::round(outside / same_way), body);
    const std::size_t some = std::min(ways.size(), most_ways_out);
    std::partial_sort(ways.begin(), ways.begin() + static_cast<std::ptrdiff_t>(some), ways.end());
    for (std::size_t i = 0; i < some; ++i) {
        const std::size_t body = ways[i].second;
        const Vec3 out = at + air.outside(body, at) * way_out(air, body, at);
        if (!leads_through(at, out)) return Top{out, body};
    }
    return std::nullopt;
}

/// Where the material above a place ends: the shortest way out beside the part, else the way along the face's normal.
Filled::Top Filled::top_of(const milling::Air& air, const Deepest& d, double reach) const {
    const Vec3 at = d.place.at, out = at + d.depth.depth * way_out(air, d.depth.body, at);
    if (!leads_through(at, out)) return {out, d.depth.body};
    if (const auto beside = beside_part(air, at, reach)) return *beside;
    const Vec3 normal = m_.part.normal(faces_[d.place.face].triangle);
    const double least = options_.excess / 4;
    double way = 0;
    for (int k = 0; k < most_steps && way < reach; ++k) {
        const Vec3 p = at + way * normal;
        const double depth = depth_at(air, p, 0, reach, 0).depth, off = m_.part.signed_distance(p);
        if (!(depth > 0) || (way > least && off < -least)) break;
        way += std::max(std::min(depth, off + least), least / 50);  // no wall is stepped over
    }
    return {at + way * normal, depth_at(air, at + way * normal, -HUGE_VAL, reach, 0).body};
}

/// FilledDepth and end of the deepest of these places.
void Filled::measure(Covered& c, const std::vector<Deep>& deep, const Some& some) const {
    c.depth = 0;
    for (double reach = 4 * filled_gap * options_.excess; c.depth == 0; reach *= 4) {
        const milling::Air air = m_.simulation.whole_air_in(box_of(some, reach));
        const std::vector<Deepest> all = deepest_of(air, deep, reach);
        if (!(all.front().depth.depth < reach)) continue;
        for (const Deepest& d : all) {
            const Top top = top_of(air, d, reach);
            const double depth = geom::distance(top.at, d.place.at);
            if (depth <= c.depth && c.depth > 0) continue;
            c.depth = std::max(depth, options_.excess), c.at = d.place.at, c.top = top.at, c.face = d.place.face;
            c.cut = air.cut(top.body);
        }
    }
}

std::optional<Covered> Filled::look(const Some& some) const {
    const double allowed = options_.excess, enough = 1.01 * filled_gap * allowed;
    const milling::Air air = m_.simulation.whole_air_in(box_of(some, enough));
    std::vector<Deep> deep;
    std::size_t first = 0;
    for (const std::uint32_t f : some) {
        if (!m_.threads.empty() && m_.threads.holds(before(faces_[f]))) continue;
        for (const Vec3& p : places_of(faces_[f])) {
            const FilledDepth d = depth_at(air, p, allowed, enough, first);
            first = d.body;
            if (d.depth > allowed) deep.push_back({p, f});
        }
    }
    Covered c;
    c.cube = cube_of(middle_of(faces_[some.front()]));
    // Mostly all faces count, or none: then one is enough to tell.
    for (const bool all : {false, true}) {
        if (all) std::erase_if(deep, [&](const Deep& p) { return !counts(faces_[p.face]); });
        if (deep.empty()) return std::nullopt;
        measure(c, deep, some);
        if (all || counts(faces_[c.face])) break;
    }
    for (const Deep& p : deep) {
        const auto& [a, b, d] = faces_[p.face].corners;
        c.area += 0.5 * length(cross(b - a, d - a)) / 4;
        for (const Vec3& corner : faces_[p.face].corners) c.faces.add(corner);
    }
    return c;
}

bool Filled::find() {
    if (!find_faces()) return false;
    std::map<Cube, Some> cubes;
    for (std::uint32_t f = 0; f < faces_.size(); ++f) cubes[cube_of(middle_of(faces_[f]))].push_back(f);
    std::vector<const Some*> all;
    for (const auto& [cube, some] : cubes) all.push_back(&some);
    for (std::size_t from = 0; from < all.size() && !(m_.stop && m_.stop()); from += batch_of_cubes) {
        std::vector<std::optional<Covered>> some(std::min(batch_of_cubes, all.size() - from));
        base::for_all(some.size(), [&](std::size_t k) { some[k] = look(*all[from + k]); });
        for (const auto& c : some)
            if (c) covered_.push_back(*c);
    }
    return true;
}

/// Somewhere above the place material stands off the part by more than is allowed.
bool Filled::stands_off(const Covered& c) const {
    constexpr double nearly = 0.999;
    if (m_.part.signed_distance(c.at + nearly * (c.top - c.at)) > options_.excess) return true;
    const Vec3 around{c.depth, c.depth, c.depth};
    const milling::Box3 box{c.at - around, c.at + around};
    const milling::Air air = m_.simulation.whole_air_in(box);
    const Claim claim{m_.part, air, false, options_.excess, {}, m_.stop};
    return decide(claim, box, proof_cells).outcome == Proof::Outcome::present;
}

bool Filled::is_rest(const Covered& c) {
    if (c.depth > filled_gap * options_.excess) return true;
    return proofs_++ < most_proofs && stands_off(c);
}

FilledPlace Filled::place_of(const std::vector<const Covered*>& group) const {
    FilledPlace whole;
    mesh::Place& p = whole.place;
    std::map<std::uint32_t, double> tags;
    for (const Covered* c : group) {
        if (c->depth > p.deviation) p.deviation = c->depth, p.at = c->top;
        p.area += c->area;
        tags[m_.tag_of(c->cut)] += c->area;
        p.extent.add(c->at), p.extent.add(c->top);
        whole.tops.push_back(c->top), whole.faces.push_back(c->faces);
    }
    for (const auto& [tag, area] : tags) p.shares.push_back({tag, area});
    std::stable_sort(p.shares.begin(), p.shares.end(),
                     [](const mesh::TagShare& a, const mesh::TagShare& b) { return a.area > b.area; });
    p.peak = p.shares;
    p.tag = p.shares.front().tag;
    return whole;
}

std::vector<mesh::Place> Filled::places(std::vector<mesh::Place>& known) {
    std::vector<mesh::Place> out;
    if (covered_.empty()) return out;
    KnownRest rest(found_, m_.surface, options_.excess, step_, known);
    for (std::vector<const Covered*>& group : touching(covered_)) {
        if (rest.joins(place_of(group))) continue;
        std::erase_if(group, [&](const Covered* c) { return rest.ends_at(c->top) || !is_rest(*c); });
        if (!group.empty()) out.push_back(place_of(group).place);
    }
    std::stable_sort(out.begin(), out.end(),
                     [](const mesh::Place& a, const mesh::Place& b) { return a.deviation > b.deviation; });
    return out;
}

}  // namespace

FilledRest filled_rest(const mesh::Comparison& found, const Machined& machined, const mesh::CompareOptions& options,
                       std::vector<mesh::Place>& known) {
    FilledRest rest;
    // Without a closed stock nothing is known of what lies outside of it.
    if (!machined.simulation.stock_body().closed()) return rest;
    Filled filled(found, machined, options);
    rest.whole = filled.find();
    rest.places = filled.places(known);
    return rest;
}

}  // namespace obrys::check
