#include "sim/milling/stock.hpp"

#include <algorithm>
#include <cmath>

#include "sim/milling/mesh_rays.hpp"

namespace obrys::sim::milling {
namespace {

using geom::Vec3;

std::string problem_of_box(const Box3& b) {
    if (!geom::is_finite(b.min) || !geom::is_finite(b.max)) return "the box has a corner that is not known";
    for (int axis = 0; axis < 3; ++axis)
        if (!(component(b.min, axis) < component(b.max, axis))) return "the box has no volume";
    return {};
}

std::string problem_of_cylinder(const CylinderStock& c) {
    if (!geom::is_finite(c.centre) || !std::isfinite(c.radius) || !std::isfinite(c.length) || c.axis < 0 || c.axis > 2)
        return "the cylinder has a dimension that is not known";
    if (!(c.radius > 0 && c.length > 0)) return "the cylinder has no volume";
    return {};
}

std::string problem_of_mesh(const MeshStock& m) {
    if (m.triangles.empty()) return "the mesh has no triangles";
    for (const Vec3& v : m.vertices)
        if (!geom::is_finite(v)) return "the mesh has a vertex that is not known";
    for (const auto& t : m.triangles)
        for (const std::uint32_t corner : t)
            if (corner >= m.vertices.size()) return "the mesh names a vertex that it does not have";
    return problem_of_box(box_of(m)).empty() ? "" : "the mesh has no volume";
}

/// Sets one interval on the rays of a direction: where `part(u, v)` gives low < high.
template <class Part>
void fill_direction(Dexels& dexels, int axis, Part&& part) {
    const Lattice& l = dexels.lattice();
    const int first = first_across(axis), second = second_across(axis);
    for (int b = 0; b < dexels.rays_b(axis); ++b) {
        for (int a = 0; a < dexels.rays_a(axis); ++a) {
            const double u = component(l.origin, first) + a * component(l.step, first);
            const double v = component(l.origin, second) + b * component(l.step, second);
            const auto [low, high] = part(u, v);
            if (!(high - low > thinnest)) continue;
            const Interval all{low, high, 0, 0};
            dexels.set(axis, a, b, {&all, 1});
        }
    }
}

void fill_box(Dexels& dexels, const Box3& box) {
    for (int axis = 0; axis < 3; ++axis) {
        const int first = first_across(axis), second = second_across(axis);
        fill_direction(dexels, axis, [&](double u, double v) {
            const bool inside = u > component(box.min, first) && u < component(box.max, first) &&
                                v > component(box.min, second) && v < component(box.max, second);
            return inside ? std::pair{component(box.min, axis), component(box.max, axis)} : std::pair{0.0, 0.0};
        });
    }
}

void fill_cylinder(Dexels& dexels, const CylinderStock& c) {
    const double from = component(c.centre, c.axis), to = from + c.length;
    for (int axis = 0; axis < 3; ++axis) {
        const int first = first_across(axis), second = second_across(axis);
        fill_direction(dexels, axis, [&](double u, double v) {
            const double du = u - component(c.centre, first), dv = v - component(c.centre, second);
            if (axis == c.axis)
                return du * du + dv * dv < c.radius * c.radius ? std::pair{from, to} : std::pair{0.0, 0.0};
            // One of the two is the height along the cylinder, the other one the distance beside it.
            const double height = first == c.axis ? u : v, beside = first == c.axis ? dv : du;
            const double square = c.radius * c.radius - beside * beside;
            if (!(height > from && height < to && square > 0)) return std::pair{0.0, 0.0};
            const double half = std::sqrt(square), middle = component(c.centre, axis);
            return std::pair{middle - half, middle + half};
        });
    }
}

Vec3 box_normal(const Box3& box, Vec3 p) {
    double nearest = std::numeric_limits<double>::infinity();
    Vec3 normal;
    for (int axis = 0; axis < 3; ++axis) {
        for (const double sign : {-1.0, 1.0}) {
            const double away = std::abs(component(p, axis) - component(sign < 0 ? box.min : box.max, axis));
            if (!(away < nearest)) continue;
            nearest = away;
            normal = {};
            set_component(normal, axis, sign);
        }
    }
    return normal;
}

Vec3 cylinder_normal(const CylinderStock& c, Vec3 p) {
    Vec3 out = p - c.centre;
    const double height = component(out, c.axis);
    set_component(out, c.axis, 0);
    const double distance = length(out);
    Vec3 end;
    set_component(end, c.axis, height < c.length / 2 ? -1 : 1);
    const double to_end = std::min(std::abs(height), std::abs(c.length - height));
    return std::abs(distance - c.radius) <= to_end && distance > 0 ? (1 / distance) * out : end;
}

}  // namespace

std::string problem_of(const Stock& stock) {
    if (const auto* box = std::get_if<Box3>(&stock)) return problem_of_box(*box);
    if (const auto* bar = std::get_if<CylinderStock>(&stock)) return problem_of_cylinder(*bar);
    return problem_of_mesh(std::get<MeshStock>(stock));
}

Box3 box_of(const Stock& stock) {
    if (const auto* box = std::get_if<Box3>(&stock)) return *box;
    if (const auto* bar = std::get_if<CylinderStock>(&stock)) {
        Vec3 half{bar->radius, bar->radius, bar->radius};
        set_component(half, bar->axis, 0);
        Box3 box{bar->centre - half, bar->centre + half};
        set_component(box.max, bar->axis, component(bar->centre, bar->axis) + bar->length);
        return box;
    }
    constexpr double far = std::numeric_limits<double>::infinity();
    Box3 box{{far, far, far}, {-far, -far, -far}};
    const auto& mesh = std::get<MeshStock>(stock);
    for (const auto& t : mesh.triangles) {
        for (const std::uint32_t corner : t) {
            const Vec3 v = mesh.vertices[corner];
            box.min = {std::min(box.min.x, v.x), std::min(box.min.y, v.y), std::min(box.min.z, v.z)};
            box.max = {std::max(box.max.x, v.x), std::max(box.max.y, v.y), std::max(box.max.z, v.z)};
        }
    }
    return box;
}

Filled fill(const Stock& stock, const Lattice& lattice) {
    Filled filled{Dexels(lattice), 0};
    if (const auto* box = std::get_if<Box3>(&stock))
        fill_box(filled.dexels, *box);
    else if (const auto* bar = std::get_if<CylinderStock>(&stock))
        fill_cylinder(filled.dexels, *bar);
    else
        filled.open_rays = fill_mesh(filled.dexels, std::get<MeshStock>(stock));
    return filled;
}

struct StockFaces::Mesh {
    MeshStock mesh;
    MeshPlaces places;
};

StockFaces::StockFaces(const Stock& stock) {
    if (const auto* box = std::get_if<Box3>(&stock))
        faces_ = *box;
    else if (const auto* bar = std::get_if<CylinderStock>(&stock))
        faces_ = *bar;
    else
        faces_ = std::make_shared<const Mesh>(
            Mesh{std::get<MeshStock>(stock), MeshPlaces(std::get<MeshStock>(stock), box_of(stock))});
}

Vec3 StockFaces::normal_at(Vec3 p) const {
    if (const auto* box = std::get_if<Box3>(&faces_)) return box_normal(*box, p);
    if (const auto* bar = std::get_if<CylinderStock>(&faces_)) return cylinder_normal(*bar, p);
    const Mesh& m = *std::get<std::shared_ptr<const Mesh>>(faces_);
    return m.places.normal_at(m.mesh, p);
}

}  // namespace obrys::sim::milling
