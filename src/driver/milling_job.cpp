#include "driver/milling_job.hpp"

#ifndef _WIN32
#include <unistd.h>
#endif

#include "base/codes.hpp"
#include "base/text.hpp"
#include "driver/files.hpp"
#include "driver/program_blank.hpp"
#include "mesh/stl.hpp"

namespace obrys::driver {

namespace {

constexpr double usual_tolerance = 0.01;      ///< mm
constexpr double share_of_memory = 0.5;       ///< of what the machine has, for the stock
constexpr double unknown_memory = 2e9;        ///< bytes, where the system does not say
constexpr std::size_t shown_text = 64 << 20;  ///< bytes of an ASCII file that messages may quote

double memory_of_machine() {
#ifdef _WIN32
    return unknown_memory;
#else
    const long pages = sysconf(_SC_PHYS_PAGES), size = sysconf(_SC_PAGE_SIZE);
    return pages > 0 && size > 0 ? static_cast<double>(pages) * static_cast<double>(size) : unknown_memory;
#endif
}

/// The mesh of an STL file in the workpiece frame; nothing after a complaint. `closed`: its surface is.
std::optional<mesh::Mesh> load_mesh(Session& s, const shop::SolidFile& file, bool& closed) {
    const fs::path path = beside(s.input, file.path);
    const auto bytes = load_bytes(path, s.diagnostics, file.where);
    if (!bytes) return std::nullopt;
    const bool quoted = bytes->size() <= shown_text && !base::looks_binary(*bytes);
    const std::uint32_t id = s.sources.add(path.generic_string(), quoted ? *bytes : std::string{});
    auto read = mesh::read_stl(id, *bytes, s.diagnostics);
    if (!read) return std::nullopt;
    closed = read->topology.closed();
    for (geom::Vec3& v : read->mesh.vertices) v = file.unit * v + file.offset;
    return std::move(read->mesh);
}

std::optional<sim::milling::Stock> body_of(Session& s, const shop::Solid& solid) {
    if (const auto* box = std::get_if<shop::SolidBox>(&solid)) return sim::milling::Box3{box->min, box->max};
    if (const auto* bar = std::get_if<shop::SolidCylinder>(&solid)) {
        sim::milling::CylinderStock c;
        c.axis = bar->axis;
        c.centre = bar->centre;
        (bar->axis == 0 ? c.centre.x : bar->axis == 1 ? c.centre.y : c.centre.z) = bar->min;
        c.radius = bar->radius;
        c.length = bar->max - bar->min;
        return c;
    }
    bool closed = false;
    auto mesh = load_mesh(s, std::get<shop::SolidFile>(solid), closed);
    if (!mesh) return std::nullopt;
    return sim::milling::MeshStock{std::move(mesh->vertices), std::move(mesh->triangles)};
}

std::optional<sim::milling::Stock> stock_of(Session& s) {
    if (s.job.solid_stock) return body_of(s, s.job.solid_stock->solid);
    if (s.job.stock || !s.main) return std::nullopt;
    const auto blank = program_blank(*s.main, s.diagnostics);
    return blank ? body_of(s, blank->solid) : std::nullopt;
}

}  // namespace

std::optional<check::MillingSetup> milling_setup(Session& s, const MillingRequest& request) {
    if (s.job.machine.kind != shop::MachineKind::mill) return std::nullopt;  // a lathe's stock is a section
    auto stock = stock_of(s);
    if (!stock) return std::nullopt;
    check::MillingSetup m;
    m.stock = std::move(*stock);
    m.tolerance = request.tolerance.value_or(s.job.tolerances.simulation.value_or(usual_tolerance));
    m.memory_bytes = share_of_memory * memory_of_machine();
    m.surface = request.surface;
    m.keep_moves = request.keep_moves;
    for (const shop::Clamp& c : s.job.clamps)
        if (auto body = body_of(s, c.solid)) m.clamps.push_back({c.name, std::move(*body)});
    if (!s.job.solid_part) return m;
    bool closed = false;
    if (auto part = load_mesh(s, s.job.solid_part->file, closed); part && closed)
        m.part = std::make_shared<const mesh::Distance>(std::move(*part));
    return m;
}

}  // namespace obrys::driver
