#include "check/certify_shapes.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>

#include "base/whole.hpp"
#include "mesh/distance.hpp"
#include "mesh/primitives.hpp"

namespace obrys::check {

namespace certify = sim::certify;
namespace milling = sim::milling;

using geom::Vec3;

namespace {

constexpr std::size_t most_arc_chords = 1000;  ///< of one of them
constexpr double tip_radius = 50;              ///< of how far chords may stand off: of the body that is a point

void add_round(certify::Shape& shape, const milling::Piece& p, double off) {
    if (p.whole) return shape.push_back({p.ring, p.centre, p.ring, p.centre, p.arc});
    const auto angle_at = [&](double z) { return std::asin(std::clamp((z - p.centre) / p.arc, -1.0, 1.0)); };
    const double from = angle_at(p.z0), to = angle_at(p.z1), step = 2 * std::acos(std::max(0.0, 1 - off / p.arc));
    const auto n = base::clipped<std::size_t>(std::ceil((to - from) / step), 1, most_arc_chords);
    double low = p.z0;
    for (std::size_t i = 1; i <= n; ++i) {
        const double part = static_cast<double>(i) / static_cast<double>(n);
        const double high = i == n ? p.z1 : p.centre + p.arc * std::sin(from + part * (to - from));
        shape.push_back({milling::radius_at(p, low), low, milling::radius_at(p, high), high, 0});
        low = high;
    }
}

/// A point is moved along the axis only, which moves the flank beside it by less: it is a body of its own.
void add_cone(certify::Shape& shape, const milling::Piece& p, double off) {
    const double tip = tip_radius * off;
    if (p.r0 == 0 && p.r1 > 2 * tip) {
        const double z = p.z0 + tip / p.r1 * (p.z1 - p.z0);
        shape.push_back({0, p.z0, tip, z, 0});
        shape.push_back({tip, z, p.r1, p.z1, 0});
    } else {
        shape.push_back({p.r0, p.z0, p.r1, p.z1, 0});
    }
}

}  // namespace

certify::Shape certified_shape(const milling::Shape& of, double off) {
    certify::Shape shape;
    for (const milling::Piece& p : of.pieces)
        if (p.kind == milling::PieceKind::cone)
            add_cone(shape, p, off);
        else
            add_round(shape, p, off);
    return shape;
}

mesh::Mesh mesh_of(const milling::Stock& body, double off) {
    if (const auto* b = std::get_if<milling::Box3>(&body)) return mesh::box(b->min, b->max);
    if (const auto* c = std::get_if<milling::CylinderStock>(&body)) {
        mesh::Mesh m = mesh::cylinder({0, 0, 0}, c->radius, c->length, mesh::circle_sides(c->radius, off));
        geom::Frame along;  // z to the axis
        if (c->axis == 0) along.linear = {0, 0, 1, 1, 0, 0, 0, 1, 0};
        if (c->axis == 1) along.linear = {0, 1, 0, 0, 0, 1, 1, 0, 0};
        return mesh::transformed(m, geom::Frame::shift(c->centre) * along);
    }
    const auto& m = std::get<milling::MeshStock>(body);
    mesh::Mesh mesh{m.vertices, {m.triangles.begin(), m.triangles.end()}, {}};
    if (mesh::volume(mesh) < 0) mesh::turn_over(mesh);
    return mesh;
}

namespace {

std::function<double(Vec3)> depth_in_stock(const milling::Stock& stock,
                                           const std::shared_ptr<const mesh::Distance>& surface) {
    if (const auto* b = std::get_if<milling::Box3>(&stock))
        return [box = *b](Vec3 p) {
            const Vec3 low = p - box.min, high = box.max - p;
            return std::min({low.x, low.y, low.z, high.x, high.y, high.z});
        };
    if (const auto* c = std::get_if<milling::CylinderStock>(&stock))
        return [bar = *c](Vec3 p) {
            const Vec3 off = p - bar.centre;
            const double along = milling::component(off, bar.axis);
            const double out = std::sqrt(std::max(0.0, dot(off, off) - along * along));
            return std::min({bar.radius - out, along, bar.length - along});
        };
    return [surface](Vec3 p) { return -surface->signed_distance(p); };
}

}  // namespace

certify::Before before_of(const milling::Stock& stock, double off) {
    const bool round = std::holds_alternative<milling::CylinderStock>(stock);
    certify::Before before;
    before.surface = std::make_shared<const mesh::Distance>(mesh_of(stock, off));
    before.depth = depth_in_stock(stock, before.surface);
    before.off = round ? off : 0;
    before.convex = !std::holds_alternative<milling::MeshStock>(stock);
    return before;
}

}  // namespace obrys::check
