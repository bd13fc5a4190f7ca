// Any bytes are read without crash as STL, with and without a tolerance; what was read is a sound mesh that can be
// written and read again; memory stays within the size of the input.
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>

#include "mesh/stl.hpp"

namespace {

using namespace obrys;

void require(bool holds) {
    if (!holds) std::abort();
}

void read(const std::string& bytes, double weld) {
    base::Sources sources;
    base::Diagnostics said;
    const std::uint32_t file = sources.add("FUZZ", bytes);
    const auto stl = mesh::read_stl(file, sources[file].text, said, {.weld = weld});
    require(stl || said.has_errors());
    for (const base::Diagnostic& d : said.all()) {
        require(d.where.begin <= d.where.end && d.where.end <= sources[file].text.size());
        (void)base::render(d, sources);
    }
    if (!stl) return;
    const mesh::Mesh& m = stl->mesh;
    require(!m.empty() && m.triangles.size() + stl->degenerate == stl->triangles);
    require(stl->triangles <= bytes.size() / 40 && m.vertices.size() <= 3 * stl->triangles);
    for (const mesh::Triangle& t : m.triangles)
        for (std::size_t c = 0; c < 3; ++c) require(t[c] < m.vertices.size() && t[c] != t[(c + 1) % 3]);
    require(std::isfinite(mesh::volume(m)) && std::isfinite(mesh::area(m)));
    require(!stl->topology.closed() || !(mesh::volume(m) < -1e-6 * (1 + mesh::area(m) * mesh::area(m))));
    base::Diagnostics again;
    const auto second = mesh::read_stl(file, mesh::write_stl(m), again);
    require(!second || second->triangles == m.triangles.size());
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string bytes(data, data + size);
    read(bytes, 0);
    read(bytes, 0.01);
    return 0;
}
