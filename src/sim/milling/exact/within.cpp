// A triangle is done with where one convex body reaches over all of its corners but for what is allowed; else it is
// halved until it is, or until it is small. The cuts that made it and its neighbours are asked first.

#include "sim/milling/exact/within.hpp"

#include <algorithm>
#include <cmath>

#include "base/parallel.hpp"

namespace obrys::sim::milling {

namespace {

using geom::Vec2;
using geom::Vec3;
using Body = WithinMaterial::Body;

constexpr double smallest_half = 0.03;  ///< of what is allowed: half a triangle's size from which on its middle tells

double longest_side(const Corners& t) {
    return std::max({geom::distance(t[0], t[1]), geom::distance(t[1], t[2]), geom::distance(t[2], t[0])});
}

bool is_outside_by(const Air::Sweep& s, Vec3 p, double allowed) {
    return !sweeps_within(*s.shape, s.track, s.frame.to_tool(p - s.from), allowed);
}

/// From the tool where it stands at a place of its way.
double outside_at(const Air::Sweep& s, Vec3 tip, Vec3 p) {
    return distance_from(*s.shape, s.frame.to_tool(p - s.from) - tip);
}

/// On a circle, over its wedge: the distance from it is convex but for the bend within.
bool holds_in_wedge(const Air::Sweep& s, const Corners& t, double allowed) {
    const Track& track = s.track;
    double nearest = INFINITY;
    for (const Vec3& p : t) {
        const Vec3 own = s.frame.to_tool(p - s.from);
        const Vec2 q = Vec2{own.x, own.y} - track.centre;
        if (!track.passes(q)) return false;
        nearest = std::min(nearest, geom::length(q));
    }
    const double side = longest_side(t), inner = nearest - side;
    const double bend = inner > 0 ? std::min(side, side * side / (6 * inner)) : side;
    if (!(bend < allowed)) return false;
    return std::all_of(t.begin(), t.end(), [&](Vec3 p) { return !is_outside_by(s, p, allowed - bend); });
}

bool holds(const Air::Sweep& s, const Corners& t, double allowed) {
    if (!s.track.circular)
        return std::all_of(t.begin(), t.end(), [&](Vec3 p) { return !is_outside_by(s, p, allowed); });
    if (holds_in_wedge(s, t, allowed)) return true;
    for (const Vec3& tip : {Vec3{}, s.track.v})
        if (std::all_of(t.begin(), t.end(), [&](Vec3 p) { return outside_at(s, tip, p) <= allowed; })) return true;
    return false;
}

class TriangleSearch {
public:
    TriangleSearch(const Exact& exact, double allowed, std::size_t parts)
        : exact_(exact), allowed_(allowed), parts_(parts) {}

    /// A place that lies too deep, or that is hard to be shown not to.
    [[nodiscard]] std::optional<Vec3> find(const Corners& t, std::span<const Body> bodies) {
        std::vector<const Body*> all;
        for (const Body& b : bodies) all.push_back(&b);
        left_ = parts_;
        return find(t, all);
    }

private:
    [[nodiscard]] bool is_held(const Body& body, const Corners& t) const {
        return body.stock ? exact_.most_in_blank(t) <= allowed_ : holds(body.sweep, t, allowed_);
    }

    [[nodiscard]] bool is_beyond(const Body& body, Vec3 p, double allowed) const {
        return body.stock ? exact_.in_blank(p) > allowed : is_outside_by(body.sweep, p, allowed);
    }

    [[nodiscard]] std::optional<Vec3> find(const Corners& t, const std::vector<const Body*>& bodies) {
        if (std::any_of(bodies.begin(), bodies.end(), [&](const Body* b) { return is_held(*b, t); }))
            return std::nullopt;
        const Vec3 middle = centroid_of(t);
        if (left_ == 0) return middle;
        --left_;
        const double reach = farthest_from(middle, t);
        std::vector<const Body*> near;
        bool deep = true;
        for (const Body* b : bodies) {
            if (is_beyond(*b, middle, allowed_ + reach)) continue;
            near.push_back(b);
            deep = deep && is_beyond(*b, middle, allowed_);
        }
        if (deep) return middle;
        if (reach <= smallest_half * allowed_) return std::nullopt;
        const auto [one, two] = halves_of(t);
        if (const auto found = find(one, near)) return found;
        return find(two, near);
    }

    const Exact& exact_;
    double allowed_ = 0;
    std::size_t parts_ = 0;
    std::size_t left_ = 0;  ///< parts that may still be looked at
};

Corners corners_of(const mesh::Mesh& mesh, std::uint32_t triangle) {
    const mesh::Triangle& t = mesh.triangles[triangle];
    return {mesh.vertices[t[0]], mesh.vertices[t[1]], mesh.vertices[t[2]]};
}

std::uint64_t key_of_corners(const Corners& t) { return mixed_of(t, 0) >> 1U; }

/// The cuts that made the triangles about each vertex, up to a few.
class CutsAbout {
public:
    explicit CutsAbout(const mesh::Mesh& mesh) : mesh_(mesh), of_(mesh.vertices.size()) {
        for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
            for (const std::uint32_t v : mesh.triangles[t]) add(of_[v], mesh.tags[t]);
    }
    [[nodiscard]] std::vector<std::uint32_t> around(std::uint32_t triangle) const {
        std::vector<std::uint32_t> all{mesh_.tags[triangle]};
        for (const std::uint32_t v : mesh_.triangles[triangle])
            for (std::uint32_t n = 0; n < of_[v].count; ++n)
                if (std::find(all.begin(), all.end(), of_[v].cut[n]) == all.end()) all.push_back(of_[v].cut[n]);
        return all;
    }

private:
    struct Few {
        std::array<std::uint32_t, 5> cut{};
        std::uint32_t count = 0;
    };
    static void add(Few& few, std::uint32_t cut) {
        for (std::uint32_t n = 0; n < few.count; ++n)
            if (few.cut[n] == cut) return;
        if (few.count < few.cut.size()) few.cut[few.count++] = cut;
    }
    const mesh::Mesh& mesh_;
    std::vector<Few> of_;
};

}  // namespace

WithinMaterial::WithinMaterial(Exact& exact) : exact_(exact) {}

void WithinMaterial::add(const Air::Sweep& sweep, std::vector<Body>& bodies) const {
    for (const Shape* part : exact_.parts_of(sweep.shape)) {
        bodies.push_back({sweep, false});
        bodies.back().sweep.shape = part;
    }
}

std::vector<WithinMaterial::Body> WithinMaterial::bodies_near(const Exact::Near& near) const {
    std::vector<Body> bodies;
    if (near.stock || !near.blank) bodies.push_back({{}, true});
    for (const Air::Sweep& s : near.sweeps) add(s, bodies);
    return bodies;
}

/// Those of which the cuts about them leave something too deep.
std::vector<std::uint32_t> WithinMaterial::not_held_by_own(const mesh::Mesh& mesh, std::span<const std::uint32_t> asked,
                                                           double allowed, std::size_t parts) const {
    const CutsAbout cuts(mesh);
    std::vector<char> held(asked.size());
    base::in_pieces(asked.size(), 64, [&](const base::Piece& some) {
        TriangleSearch search(exact_, allowed, parts);
        std::vector<Body> bodies;
        for (std::size_t i = some.begin(); i < some.end(); ++i) {
            bodies.clear();
            for (const std::uint32_t cut : cuts.around(asked[i]))
                if (cut == 0)
                    bodies.push_back({{}, true});
                else
                    add(exact_.body(cut), bodies);
            held[i] = search.find(corners_of(mesh, asked[i]), bodies) ? 0 : 1;
        }
    });
    std::vector<std::uint32_t> left;
    for (std::size_t i = 0; i < asked.size(); ++i)
        if (held[i] == 0) left.push_back(asked[i]);
    return left;
}

std::vector<WithinMaterial::Deep> WithinMaterial::places(const mesh::Mesh& mesh, double allowed, std::size_t parts) {
    std::vector<std::uint32_t> asked;
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t)
        if (proved_.find(key_of_corners(corners_of(mesh, t))) == KeyMap::none) asked.push_back(t);
    const std::vector<std::uint32_t> left = not_held_by_own(mesh, asked, allowed, parts);
    std::vector<Place> cells(left.size());
    for (std::size_t i = 0; i < left.size(); ++i)
        cells[i] = cell_at(exact_.lattice(), centroid_of(corners_of(mesh, left[i]))).value_or(Place{});
    exact_.prepare(cells);
    std::vector<std::optional<Vec3>> found(left.size());
    base::for_all(left.size(), [&](std::size_t i) {
        const Corners t = corners_of(mesh, left[i]);
        const Vec3 middle = centroid_of(t);
        const std::optional<Exact::Near> near = exact_.about(cells[i], middle, farthest_from(middle, t) + 2 * allowed);
        found[i] = near ? TriangleSearch(exact_, allowed, parts).find(t, bodies_near(*near)) : middle;
    });
    std::vector<Deep> places;
    std::size_t next = 0;
    for (const std::uint32_t t : asked) {
        const bool looked_at = next < left.size() && left[next] == t;
        if (looked_at && found[next])
            places.push_back({*found[next], corners_of(mesh, t)});
        else
            proved_.add(key_of_corners(corners_of(mesh, t)), 1);
        if (looked_at) ++next;
    }
    return places;
}

}  // namespace obrys::sim::milling
