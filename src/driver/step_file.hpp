#pragma once
/// STEP files (ISO 10303-21): read by the module libobrys-step.so, in a process of its own. The only place that knows
/// the module.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "base/diagnostic.hpp"
#include "driver/guarded.hpp"
#include "mesh/mesh.hpp"

namespace obrys::driver {

/// Bytes of a body's file that messages may quote, where it is text; of a larger one the source stays empty.
inline constexpr std::size_t largest_quoted = 64 << 20;

struct StepFile {
    std::vector<mesh::Mesh> solids;  ///< one a body, mm (whatever the unit of the file); joined and looked at
    bool closed = true;              ///< every one of them bounds a solid
};

/// The fifth of the tolerance by which triangles may leave the surface: what the part's facets add to a deviation stays
/// well below what is looked for.
[[nodiscard]] double step_deflection(double tolerance);

/// Nothing where the file cannot be read: no STEP file, cut off, no solid in it, no module, or the module fails, takes
/// too long or too much memory. The complaint is `mesh-file`, at the damaged line or the file's beginning (or at
/// `where`, the name in the job, where the module is missing). `file` is the source of these bytes.
[[nodiscard]] std::optional<StepFile> read_step(std::uint32_t file, std::string_view bytes, double tolerance,
                                                const Guard& guard, base::Diagnostics& out, const base::Span& where);

}  // namespace obrys::driver
