// Writes a few meshes as 3MF, glTF and STL into a folder, and prints a line of facts for each:
// name, vertices, triangles, colours, volume in mm3.
#include <array>
#include <cstdio>
#include <fstream>
#include <string>

#include "base/number.hpp"
#include "mesh/export.hpp"
#include "mesh/package/three_mf.hpp"
#include "mesh/primitives.hpp"
#include "mesh/stl.hpp"

namespace {

using namespace obrys;

void store(const std::string& path, const std::string& bytes) {
    std::ofstream(path, std::ios::binary).write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
}

void sample(const std::string& folder, const std::string& name, const mesh::Mesh& m, mesh::Palette palette) {
    store(folder + "/" + name + ".3mf", mesh::package::write_3mf(m, palette));
    store(folder + "/" + name + ".glb", mesh::write_glb(m, palette).value());
    store(folder + "/" + name + ".stl", mesh::write_stl(m));
    const std::string line = name + " " + std::to_string(m.vertices.size()) + " " + std::to_string(m.triangles.size()) +
                             " " + std::to_string(palette.size()) + " " + base::fixed(mesh::volume(m), 6);
    std::puts(line.c_str());
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 2) return 2;
    const std::string folder = argv[1];
    const std::array<mesh::Colour, 3> colours{mesh::Colour{200, 30, 40}, mesh::Colour{40, 160, 60},
                                              mesh::Colour{9, 80, 255}};
    sample(folder, "box", mesh::box({-1.5, 2, 3}, {40.25, 60, 8}), {});
    mesh::Mesh bodies = mesh::cylinder({0.1, 0.2, -5}, 12.5, 30, 90);
    bodies.tags.assign(bodies.triangles.size(), 1);
    mesh::append(bodies, mesh::ball({40, 0, 0}, 8, 40));
    mesh::append(bodies, mesh::box({-40, -5, -5}, {-20, 5, 5}));
    for (std::size_t i = bodies.triangles.size() - 12; i < bodies.triangles.size(); ++i) bodies.tags[i] = 7;
    sample(folder, "bodies", bodies, colours);
    sample(folder, "nothing", {}, colours);
    return 0;
}
