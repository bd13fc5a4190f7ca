#include "driver/mesh_file.hpp"

#include "base/text.hpp"
#include "driver/files.hpp"
#include "driver/step_file.hpp"
#include "mesh/solids.hpp"
#include "mesh/stl.hpp"

namespace obrys::driver {

std::optional<BodyFile> load_bodies(Session& s, const shop::SolidFile& file, double tolerance, const Guard& guard) {
    const fs::path path = beside(s.input, file.path);
    const auto bytes = load_bytes(path, s.diagnostics, file.where);
    if (!bytes) return std::nullopt;
    const bool quoted = bytes->size() <= largest_quoted && !base::looks_binary(*bytes);
    BodyFile out;
    out.source = s.sources.add(path.generic_string(), quoted ? *bytes : std::string{});
    if (shop::is_step_name(file.path)) {
        auto step = read_step(out.source, *bytes, tolerance, guard, s.diagnostics, file.where);
        if (!step) return std::nullopt;
        out.bodies = std::move(step->solids);
        out.closed = step->closed;
    } else {
        auto stl = mesh::read_stl(out.source, *bytes, s.diagnostics, {0, file.unit_known});
        if (!stl) return std::nullopt;
        out.closed = stl->topology.closed();
        out.bodies.push_back(std::move(stl->mesh));
    }
    for (mesh::Mesh& body : out.bodies)
        for (geom::Vec3& v : body.vertices) v = file.unit * v + file.offset;
    return out;
}

mesh::Mesh one_body(Session& s, BodyFile& file) {
    if (file.bodies.size() == 1) return std::move(file.bodies.front());
    return mesh::united(file.source, file.bodies, file.closed, s.diagnostics);
}

}  // namespace obrys::driver
