#include "mesh/surface_remarks.hpp"

#include "base/codes.hpp"
#include "base/number.hpp"

namespace obrys::mesh {

namespace {

std::string place(geom::Vec3 p) {
    return "X " + base::fixed(p.x, 3) + " Y " + base::fixed(p.y, 3) + " Z " + base::fixed(p.z, 3);
}

}  // namespace

std::string counted(std::size_t n, const std::string& one, const std::string& many) {
    return std::to_string(n) + " " + (n == 1 ? one : many);
}

bool is_inside_out(const Mesh& m) {
    const geom::Vec3 size = bounds(m).size();
    return volume(m) < -1e-12 * size.x * size.y * size.z;
}

void Remarks::say(base::Severity severity, std::string_view code, std::string text, std::string remedy) {
    base::Diagnostic d;
    d.severity = severity;
    d.code = code;
    d.where = {file_, 0, 0};
    d.text = std::move(text);
    d.remedy = std::move(remedy);
    out_.add(std::move(d));
}

void Remarks::note(std::string text, std::string remedy) {
    say(base::Severity::note, base::codes::assumption, std::move(text), std::move(remedy));
}

void Remarks::edges(const EdgeFault& fault, const std::string& what, std::string remedy) {
    if (fault.count == 0) return;
    say(base::Severity::warning, base::codes::mesh_not_closed,
        "the surface does not bound a solid: " + counted(fault.count, "edge", "edges") + " " + what +
            ", the first from " + place(fault.from) + " to " + place(fault.to),
        std::move(remedy));
}

void Remarks::surface(const Topology& t, std::string_view open) {
    edges(t.open, "with one triangle only (holes, or corners that do not meet)", std::string(open));
    edges(t.crowded, "with more than two triangles (bodies that touch)", "export one body");
    edges(t.turned, "between triangles of opposite orientation", "make its normals point outwards");
}

}  // namespace obrys::mesh
