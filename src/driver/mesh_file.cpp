#include "driver/mesh_file.hpp"

#include "base/codes.hpp"
#include "base/text.hpp"
#include "driver/files.hpp"
#include "driver/step_file.hpp"
#include "mesh/solids.hpp"
#include "mesh/stl.hpp"

namespace obrys::driver {

namespace {

/// What is wrong with the content of a file is said where the job names it, and makes it an input that cannot be used.
void blame_job(Session& s, const shop::SolidFile& file, std::uint32_t source, bool quoted,
               const base::Diagnostics& complaints) {
    for (base::Diagnostic d : complaints.all()) {
        if (d.severity == base::Severity::error && d.code == base::codes::mesh_file && d.where.file == source) {
            if (quoted) d.related.insert(d.related.begin(), {d.where, "here"});
            d.where = file.where;
            d.text = file.path + ": " + d.text;
            s.unusable = true;
        }
        s.diagnostics.add(std::move(d));
    }
}

bool read_bodies_of_step(BodyFile& out, const std::string& bytes, const shop::SolidFile& file, double tolerance,
                         const Guard& guard, base::Diagnostics& complaints) {
    auto step = read_step(out.source, bytes, tolerance, guard, complaints, file.where);
    if (!step) return false;
    out.bodies = std::move(step->solids);
    out.closed = step->closed;
    return true;
}

bool read_bodies_of_stl(BodyFile& out, const std::string& bytes, const shop::SolidFile& file,
                        base::Diagnostics& complaints) {
    auto stl = mesh::read_stl(out.source, bytes, complaints, {0, file.unit_known});
    if (!stl) return false;
    out.closed = stl->topology.closed();
    out.bodies.push_back(std::move(stl->mesh));
    return true;
}

}  // namespace

std::optional<BodyFile> load_bodies(Session& s, const shop::SolidFile& file, double tolerance, const Guard& guard) {
    const fs::path path = beside(s.input, file.path);
    const auto bytes = load_bytes(*s.storage, path, s.diagnostics, file.where);
    if (!bytes) return std::nullopt;
    const bool quoted = bytes->size() <= largest_quoted && !base::looks_binary(*bytes);
    BodyFile out;
    out.source = s.sources.add(path.generic_string(), quoted ? *bytes : std::string{});
    base::Diagnostics complaints;
    const bool read = shop::is_step_name(file.path)
                          ? read_bodies_of_step(out, *bytes, file, tolerance, guard, complaints)
                          : read_bodies_of_stl(out, *bytes, file, complaints);
    blame_job(s, file, out.source, quoted, complaints);
    if (!read) return std::nullopt;
    for (mesh::Mesh& body : out.bodies)
        for (geom::Vec3& v : body.vertices) v = file.unit * v + file.offset;
    return out;
}

mesh::Mesh one_body(Session& s, BodyFile& file) {
    if (file.bodies.size() == 1) return std::move(file.bodies.front());
    return mesh::united(file.source, file.bodies, file.closed, s.diagnostics);
}

}  // namespace obrys::driver
