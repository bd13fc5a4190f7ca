#include "mesh/distance.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "mesh/topology.hpp"

namespace obrys::mesh {

using geom::Vec3;

namespace {

constexpr std::uint32_t in_leaf = 4;                ///< triangles at most
constexpr double surely_farther = 1 + 1e-9;         ///< times a distance, whatever was rounded

double axis_value(Vec3 v, int axis) { return axis == 0 ? v.x : axis == 1 ? v.y : v.z; }

double square(Vec3 v) { return dot(v, v); }

/// Square of the distance from a box; 0 within.
double square_to(const Box& b, Vec3 p) {
    const auto beyond = [](double v, double lo, double hi) { return std::max({lo - v, v - hi, 0.0}); };
    return square({beyond(p.x, b.lo.x, b.hi.x), beyond(p.y, b.lo.y, b.hi.y), beyond(p.z, b.lo.z, b.hi.z)});
}

/// Nearest place on the sides; used where a triangle has no area, and where the place is not inside.
Nearest nearest_on_sides(Vec3 p, const std::array<Vec3, 3>& c) {
    Nearest best;
    for (std::size_t i = 0; i < 3; ++i) {
        const Vec3 a = c[i], along = c[(i + 1) % 3] - a;
        const double size = square(along), t = size > 0 ? dot(p - a, along) / size : 0;
        const std::size_t end = t <= 0 ? i : (i + 1) % 3;
        const bool at_corner = !(t > 0 && t < 1);
        const Vec3 at = at_corner ? c[end] : a + t * along;
        const double d = square(p - at);
        if (!(d < best.distance)) continue;
        best = {at, d, 0, static_cast<std::uint8_t>(at_corner ? 4 + end : 1 + i)};
    }
    best.distance = std::sqrt(best.distance);
    return best;
}

}  // namespace

Nearest nearest_on_triangle(Vec3 p, const std::array<Vec3, 3>& c) {
    const Vec3 normal = cross(c[1] - c[0], c[2] - c[0]);
    const double size = square(normal);
    const auto inside_of = [&](std::size_t i) { return dot(cross(c[(i + 1) % 3] - c[i], p - c[i]), normal) > 0; };
    if (!(size > 0) || !inside_of(0) || !inside_of(1) || !inside_of(2)) return nearest_on_sides(p, c);
    const double height = dot(p - c[0], normal) / size;
    return {p - height * normal, std::abs(height) * std::sqrt(size), 0, 0};
}

Distance::Distance(Mesh mesh) : mesh_(std::move(mesh)) {
    order_.resize(mesh_.triangles.size());
    std::iota(order_.begin(), order_.end(), 0U);
    if (!order_.empty()) build();
    weigh_normals();
}

/// Splits at the median of the centres along the longest side, so the tree is never deeper than 30 or so.
void Distance::build() {
    struct Task {
        std::uint32_t begin, end, parent;
        bool second;
    };
    std::vector<Vec3> centres(order_.size());
    for (std::size_t t = 0; t < centres.size(); ++t) centres[t] = centre(mesh_, t);
    std::vector<Task> tasks{{0, static_cast<std::uint32_t>(order_.size()), 0, false}};
    while (!tasks.empty()) {
        const Task task = tasks.back();
        tasks.pop_back();
        const auto here = static_cast<std::uint32_t>(nodes_.size());
        if (task.second) nodes_[task.parent].first = here;
        Node node;
        Box middles;
        for (std::uint32_t i = task.begin; i < task.end; ++i) {
            for (const Vec3& corner : corners(mesh_, order_[i])) node.box.add(corner);
            middles.add(centres[order_[i]]);
        }
        const std::uint32_t count = task.end - task.begin, half = task.begin + count / 2;
        if (count <= in_leaf) node.first = task.begin, node.count = count;
        nodes_.push_back(node);
        if (count <= in_leaf) continue;
        const Vec3 size = middles.size();
        const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
        const auto at = [&](std::uint32_t i) { return order_.begin() + static_cast<std::ptrdiff_t>(i); };
        std::nth_element(at(task.begin), at(half), at(task.end), [&](std::uint32_t a, std::uint32_t b) {
            const double va = axis_value(centres[a], axis), vb = axis_value(centres[b], axis);
            return va != vb ? va < vb : a < b;
        });
        tasks.push_back({half, task.end, here, true});
        tasks.push_back({task.begin, half, here, false});
    }
}

void Distance::weigh_normals() {
    const std::size_t n = mesh_.triangles.size();
    face_.resize(n);
    corner_.assign(mesh_.vertices.size(), {});
    for (std::size_t t = 0; t < n; ++t) {
        const Vec3 normal = area_vector(mesh_, t);
        const double size = length(normal);
        if (!(size > 0)) continue;
        face_[t] = (1 / size) * normal;
        const auto c = corners(mesh_, t);
        for (std::size_t i = 0; i < 3; ++i) {
            const Vec3 a = c[(i + 1) % 3] - c[i], b = c[(i + 2) % 3] - c[i];
            const double angle = std::atan2(length(cross(a, b)), dot(a, b));
            Vec3& sum = corner_[mesh_.triangles[t][i]];
            sum = sum + angle * face_[t];
        }
    }
    beside_ = neighbours(mesh_);
}

void Distance::visit_leaf(const Node& node, Vec3 p, Nearest& best) const {
    for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
        const std::uint32_t t = order_[i];
        // Its plane alone is farther off: so with most of a few large triangles.
        const double off = std::abs(dot(p - mesh_.vertices[mesh_.triangles[t][0]], face_[t]));
        if (off > surely_farther * best.distance + 1e-9) continue;
        Nearest found = nearest_on_triangle(p, corners(mesh_, t));
        found.triangle = t;
        const bool nearer = found.distance < best.distance || (found.distance == best.distance && t < best.triangle);
        if (nearer) best = found;
    }
}

Nearest Distance::nearest(Vec3 p, double reach) const {
    Nearest best;
    best.distance = reach;
    best.triangle = 0xffffffff;
    const Nearest nothing;
    if (nodes_.empty() || !is_finite(p)) return nothing;
    std::array<std::uint32_t, 64> stack;  // halved at each level, and 2^32 triangles at most
    std::size_t waiting = 0;
    stack[waiting++] = 0;
    while (waiting > 0) {
        const std::uint32_t here = stack[--waiting];
        const Node& node = nodes_[here];
        if (square_to(node.box, p) > best.distance * best.distance) continue;
        if (node.count > 0) {
            visit_leaf(node, p, best);
            continue;
        }
        const std::uint32_t a = here + 1, b = node.first;
        const bool a_first = square_to(nodes_[a].box, p) <= square_to(nodes_[b].box, p);
        stack[waiting++] = a_first ? b : a;
        stack[waiting++] = a_first ? a : b;
    }
    return best.triangle == 0xffffffff ? nothing : best;
}

bool Distance::is_inside(Vec3 p, const Nearest& place) const {
    const Triangle& t = mesh_.triangles[place.triangle];
    Vec3 normal = face_[place.triangle];
    if (place.feature >= 4) {
        normal = corner_[t[place.feature - 4U]];
    } else if (place.feature >= 1) {
        normal = normal + face_[beside_[3 * std::size_t{place.triangle} + place.feature - 1U]];
    }
    return dot(p - place.at, normal) < 0;
}

double Distance::signed_distance(Vec3 p, double reach) const {
    const Nearest place = nearest(p, reach);
    return std::isfinite(place.distance) && is_inside(p, place) ? -place.distance : place.distance;
}

}  // namespace obrys::mesh
