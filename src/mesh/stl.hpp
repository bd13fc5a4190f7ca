#pragma once
/// STL files: reading both forms with what is wrong with them, writing the binary form. Millimetres.
/// Source of the form: 3D Systems, "StereoLithography Interface Specification" (1989): 80 bytes header, number of
/// triangles, 50 bytes each (normal, three corners, attribute), little-endian; or the words solid, facet, vertex.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "base/diagnostic.hpp"
#include "mesh/mesh.hpp"
#include "mesh/topology.hpp"

namespace obrys::mesh {

struct StlOptions {
    /// Corners nearer than this become one vertex, mm; 0: only equal ones. Where a file was written with rounded
    /// corners that do not meet, something like 1e-4 closes it.
    double weld = 0;
    bool unit_known = false;  ///< somebody has said what the numbers are: nothing is remarked about their size
};

struct StlFile {
    Mesh mesh;
    bool binary = false;
    std::size_t triangles = 0;   ///< in the file
    std::size_t degenerate = 0;  ///< left out: two corners in one place
    Topology topology;           ///< of the mesh; a distance has a sign only where it is closed
    bool turned_over = false;    ///< the file's surface was inside out; the mesh is not any more
    bool maybe_inch = false;     ///< so small that it may have been drawn in inch; nothing is scaled
};

/// Nothing where the file cannot be read: truncated, its size and its count disagree, a coordinate is no number or
/// farther than 1000 km off, no triangle. The complaint (`mesh-file`) names byte or line; of a binary file its span is
/// the file's beginning. What is wrong with the surface is complained about as `mesh-not-closed`, once a kind, with the
/// first place; what was assumed or left out as `assumption`. Memory stays within a small multiple of the file's size.
[[nodiscard]] std::optional<StlFile> read_stl(std::uint32_t file, std::string_view bytes, base::Diagnostics& out,
                                              const StlOptions& options = {});

/// Binary form. Coordinates are rounded to single precision (100 mm: 8 nm); tags are not written.
[[nodiscard]] std::string write_stl(const Mesh& m);

}  // namespace obrys::mesh
