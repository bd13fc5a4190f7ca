#include "driver/milling_job.hpp"

#ifndef _WIN32
#include <unistd.h>
#endif

#include "base/codes.hpp"
#include "driver/mesh_file.hpp"
#include "driver/program_blank.hpp"
#include "mesh/primitives.hpp"

namespace obrys::driver {

namespace {

constexpr double usual_tolerance = 0.01;  ///< mm
constexpr double share_of_memory = 0.5;   ///< of what the machine has, for the stock
constexpr double unknown_memory = 2e9;    ///< bytes, where the system does not say

double memory_of_machine() {
#ifdef _WIN32
    return unknown_memory;
#else
    const long pages = sysconf(_SC_PHYS_PAGES), size = sysconf(_SC_PAGE_SIZE);
    return pages > 0 && size > 0 ? static_cast<double>(pages) * static_cast<double>(size) : unknown_memory;
#endif
}

/// How finely and at what cost files of bodies are read.
struct Reading {
    double tolerance = usual_tolerance;
    Guard guard;
};

/// What is a box is taken as one: its faces are known exactly.
sim::milling::Stock stock_of_mesh(mesh::Mesh mesh) {
    if (const auto box = mesh::as_box(mesh)) return sim::milling::Box3{box->lo, box->hi};
    return sim::milling::MeshStock{std::move(mesh.vertices), std::move(mesh.triangles)};
}

std::optional<sim::milling::Stock> body_of(Session& s, const shop::Solid& solid, const Reading& reading) {
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
    auto file = load_bodies(s, std::get<shop::SolidFile>(solid), reading.tolerance, reading.guard);
    if (!file) return std::nullopt;
    return stock_of_mesh(one_body(s, *file));
}

std::optional<sim::milling::Stock> stock_of(Session& s, const Reading& reading) {
    if (s.job.solid_stock) return body_of(s, s.job.solid_stock->solid, reading);
    if (s.job.stock || !s.main) return std::nullopt;
    const auto blank = program_blank(*s.main, s.diagnostics);
    return blank ? body_of(s, blank->solid, reading) : std::nullopt;
}

/// The bodies of a clamp's file stay apart: they may touch, and each is met by itself.
void add_clamp(Session& s, const shop::Clamp& clamp, const Reading& reading, check::MillingSetup& to) {
    if (const auto* named = std::get_if<shop::SolidFile>(&clamp.solid)) {
        auto file = load_bodies(s, *named, reading.tolerance, reading.guard);
        if (!file) return;
        for (mesh::Mesh& body : file->bodies) to.clamps.push_back({clamp.name, stock_of_mesh(std::move(body))});
    } else if (auto body = body_of(s, clamp.solid, reading)) {
        to.clamps.push_back({clamp.name, std::move(*body)});
    }
}

/// A part that would fit the stock if its numbers were inches, and is lost in it as it is.
void doubt_unit(Session& s, const shop::SolidFile& file, const mesh::Mesh& part, const sim::milling::Stock& stock) {
    constexpr double inch = 25.4, slack = 1.02, lost = 0.08;
    const geom::Vec3 size = mesh::bounds(part).size();
    const sim::milling::Box3 box = sim::milling::box_of(stock);
    const geom::Vec3 room = box.max - box.min;
    const bool fits =
        inch * size.x <= slack * room.x && inch * size.y <= slack * room.y && inch * size.z <= slack * room.z;
    if (file.unit_known || !fits || size.x > lost * room.x || size.y > lost * room.y) return;
    s.diagnostics.add({base::Severity::warning,
                       base::codes::assumption,
                       file.where,
                       "the part is much smaller than the stock and would fit it in inch: it is taken for millimetres",
                       "say unit = \"inch\", or unit = \"mm\", beside its file",
                       {},
                       {}});
}

}  // namespace

std::optional<check::MillingSetup> milling_setup(Session& s, const MillingRequest& request) {
    if (s.job.machine.kind != shop::MachineKind::mill) return std::nullopt;  // a lathe's stock is a section
    check::MillingSetup m;
    m.tolerance = request.tolerance.value_or(s.job.tolerances.simulation.value_or(usual_tolerance));
    m.memory_bytes = request.memory_bytes.value_or(share_of_memory * memory_of_machine());
    Reading reading;
    reading.tolerance = m.tolerance;
    reading.guard.memory_bytes = m.memory_bytes;
    auto stock = stock_of(s, reading);
    if (!stock) return std::nullopt;
    m.stock = std::move(*stock);
    m.surface = request.surface;
    m.at = request.at;
    m.keep_moves = request.keep_moves;
    for (const shop::Clamp& c : s.job.clamps) add_clamp(s, c, reading, m);
    if (!s.job.solid_part) return m;
    auto file = load_bodies(s, s.job.solid_part->file, reading.tolerance, reading.guard);
    if (!file) return m;
    mesh::Mesh part = one_body(s, *file);
    doubt_unit(s, s.job.solid_part->file, part, m.stock);
    if (file->closed) m.part = std::make_shared<const mesh::Distance>(std::move(part));
    return m;
}

}  // namespace obrys::driver
