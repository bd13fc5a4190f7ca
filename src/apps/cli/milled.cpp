#include "milled.hpp"

#include <cmath>
#include <cstdio>

#include "driver/files.hpp"
#include "mesh/export.hpp"
#include "mesh/stl.hpp"

namespace obrys::cli {

/// Writes the text where it was asked for. False where that fails (the complaint is printed).
bool deliver(driver::Session& s, const std::string& path, const std::string& text) {
    if (path.empty() || path == "-") {
        std::fwrite(text.data(), 1, text.size(), stdout);
        return std::fflush(stdout) == 0;
    }
    base::Diagnostics written;
    if (driver::store(path, text, written)) return true;
    for (const base::Diagnostic& d : written.all()) std::fputs(base::render(d, s.sources).c_str(), stderr);
    return false;
}

bool wants_surface(const Arguments& a) { return !a.stl.empty() || !a.three_mf.empty() || !a.gltf.empty(); }

namespace {

constexpr double full_deviation = 20;  ///< tolerances at which a deviation has its deepest colour

/// The first colour is that of faces that no tool has cut.
constexpr mesh::Colour tool_colours[] = {{168, 172, 178}, {86, 156, 214}, {220, 160, 70}, {120, 180, 110},
                                         {190, 110, 160}, {90, 180, 180}, {200, 110, 90}, {150, 150, 90}};
constexpr std::uint32_t tool_colour_count = sizeof(tool_colours) / sizeof(tool_colours[0]);

/// By deviation where there is a part, else by the tool that cut last.
mesh::DeviationColours colour(const check::Milled& milled, mesh::Mesh& surface, double tolerance) {
    mesh::DeviationColours c;
    if (milled.comparison) {
        mesh::CompareOptions allowed;
        allowed.gouge = allowed.excess = tolerance;
        c = mesh::deviation_colours(milled.comparison->deviation, allowed, full_deviation * tolerance);
    } else {
        c.palette.assign(std::begin(tool_colours), std::end(tool_colours));
        for (const std::uint32_t tag : surface.tags) {
            const std::uint32_t tool = tag == 0 ? 0 : milled.moves[tag - 1].tool;
            c.tags.push_back(tool == 0 ? 0 : 1 + (tool - 1) % (tool_colour_count - 1));
        }
    }
    surface.tags = c.tags;
    return c;
}

}  // namespace

bool write_surface(const Arguments& a, driver::Session& s, const driver::Checked& checked) {
    if (!wants_surface(a)) return true;
    const auto& milled = checked.result.milled;
    if (milled == nullptr || milled->surface.empty()) {
        std::fputs("obrys: there is no machined surface to write: the job has no milling stock that was simulated\n",
                   stderr);
        return false;
    }
    bool written = a.stl.empty() || deliver(s, a.stl, mesh::write_stl(milled->surface));
    if (a.three_mf.empty() && a.gltf.empty()) return written;
    mesh::Mesh surface = milled->surface;
    const mesh::DeviationColours colours = colour(*milled, surface, milled->figures.tolerance_mm);
    if (!a.three_mf.empty()) written = deliver(s, a.three_mf, mesh::write_3mf(surface, colours.palette)) && written;
    if (a.gltf.empty()) return written;
    const auto glb = mesh::write_glb(surface, colours.palette);
    if (glb) return deliver(s, a.gltf, *glb) && written;
    std::fputs("obrys: the surface is too large for a glTF file; take a coarser --tolerance\n", stderr);
    return false;
}

}  // namespace obrys::cli
