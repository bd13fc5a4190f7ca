// Places that the mesh does not show.

#include <algorithm>

#include "sim/milling/surface/fine.hpp"

namespace obrys::sim::milling {

namespace {

using geom::Vec3;

constexpr int ways = 4;              ///< into which the way from a place to the mesh is divided
constexpr double long_triangle = 3;  ///< diagonals of the leaf that a place of it lies in

}  // namespace

std::vector<Unshown> Fine::show(const std::vector<Unshown>& places) {
    std::vector<Leaf> next;
    std::vector<Unshown> left;
    for (const Unshown& u : places) {
        const std::size_t before = next.size();
        add_leaves_at_corners(u, next);
        for (int i = 0; i <= ways && next.size() == before; ++i)
            add_leaf(u.at + (static_cast<double>(i) / ways) * (u.nearest - u.at), next);
        // Its triangles may reach in from larger leaves beside it.
        for (const Vec3 p : {u.at, u.nearest})
            if (Leaf leaf; next.size() == before && leaf_of(p, leaf)) add_leaves_beside(p, leaf, next);
        if (next.size() == before) left.push_back(u);
    }
    if (is_full()) return places;
    halve(std::move(next));
    return left;
}

/// The leaf there, if it can be halved.
void Fine::add_leaf(Vec3 p, std::vector<Leaf>& out) const {
    if (Leaf leaf; leaf_of(p, leaf) && leaf.size > 1) out.push_back(leaf);
}

/// A triangle that is long for the leaf about its place belongs to an edge elsewhere: vertices reach out to tips. Of
/// its corners one is that edge's crossing, which lies between leaves.
void Fine::add_leaves_at_corners(const Unshown& u, std::vector<Leaf>& out) const {
    Leaf leaf;
    if (!leaf_of(u.nearest, leaf)) return;
    const Vec3 size = leaves_.node({leaf.size, leaf.size, leaf.size}) - leaves_.node({0, 0, 0}),
               aside = 0.01 * (leaves_.node({1, 1, 1}) - leaves_.node({0, 0, 0}));
    const Corners& t = u.triangle;
    const double longest =
        std::max({geom::distance(t[0], t[1]), geom::distance(t[1], t[2]), geom::distance(t[2], t[0])});
    if (longest < long_triangle * length(size)) return;
    for (const Vec3& corner : t)
        for (int c = 0; c < 8; ++c)
            add_leaf(corner + Vec3{(c & 1) != 0 ? aside.x : -aside.x, (c & 2) != 0 ? aside.y : -aside.y,
                                   (c & 4) != 0 ? aside.z : -aside.z},
                     out);
}

void Fine::add_leaves_beside(Vec3 p, const Leaf& leaf, std::vector<Leaf>& out) const {
    const Vec3 size = leaves_.node({leaf.size, leaf.size, leaf.size}) - leaves_.node({0, 0, 0});
    for (int a = 0; a < 3; ++a)
        for (const double way : {-1.0, 1.0}) {
            Vec3 beside = p;
            set_component(beside, a, component(p, a) + way * component(size, a));
            add_leaf(beside, out);
        }
}

}  // namespace obrys::sim::milling
