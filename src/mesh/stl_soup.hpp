#pragma once
/// What the two readers of STL share: triangles on their way into a mesh.

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "base/diagnostic.hpp"
#include "mesh/mesh.hpp"
#include "mesh/weld.hpp"

namespace obrys::mesh {

/// Coordinates beyond are taken for damage, mm: 1000 km.
inline constexpr double largest_coordinate = 1e9;

struct Soup {
    explicit Soup(double weld) : welder(weld) {}

    Welder welder;
    std::vector<Triangle> triangles;
    std::size_t read = 0, degenerate = 0;

    void add(const std::array<geom::Vec3, 3>& corners) {
        Triangle t{};
        for (std::size_t i = 0; i < 3; ++i) t[i] = welder.add(corners[i]);
        ++read;
        if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0]) {
            ++degenerate;
        } else {
            triangles.push_back(t);
        }
    }
};

/// False where the file cannot be read; `out` then says why.
[[nodiscard]] bool read_ascii_stl(std::uint32_t file, std::string_view text, Soup& soup, base::Diagnostics& out);
[[nodiscard]] bool read_binary_stl(std::uint32_t file, std::string_view bytes, Soup& soup, base::Diagnostics& out);

}  // namespace obrys::mesh
