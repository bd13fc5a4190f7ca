#include "report/clamp_bodies.hpp"

#include <set>

#include "mesh/primitives.hpp"

namespace obrys::report {

namespace {

using geom::Vec3;
namespace milling = sim::milling;

struct AsMesh {
    mesh::Mesh operator()(const milling::Box3& b) const { return mesh::box(b.min, b.max); }
    mesh::Mesh operator()(const milling::MeshStock& m) const { return {m.vertices, m.triangles, {}}; }
    mesh::Mesh operator()(const milling::CylinderStock& c) const {
        mesh::Mesh out = mesh::cylinder({0, 0, 0}, c.radius, c.length, mesh::circle_sides(c.radius, 0.05));
        for (Vec3& v : out.vertices) {  // turned in itself, so that outside stays outside
            if (c.axis == 0) v = {v.z, v.x, v.y};
            if (c.axis == 1) v = {v.y, v.z, v.x};
            v = v + c.centre;
        }
        return out;
    }
};

void add_body(mesh::Mesh& all, const mesh::Mesh& body) {
    const auto first = static_cast<std::uint32_t>(all.vertices.size());
    all.vertices.insert(all.vertices.end(), body.vertices.begin(), body.vertices.end());
    for (const mesh::Triangle& t : body.triangles) all.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
}

}  // namespace

ClampBodies clamp_bodies(const check::MillingSetup& setup) {
    ClampBodies out;
    std::set<std::string> names;
    for (const check::Clamp& c : setup.clamps) {
        add_body(out.mesh, std::visit(AsMesh{}, c.body));
        names.insert(c.name);
    }
    const std::string only = names.size() == 1 ? *names.begin() : "";
    out.name = names.size() > 1 ? "clamps" : only.starts_with("clamp") ? only : "clamp " + only;
    return out;
}

}  // namespace obrys::report
