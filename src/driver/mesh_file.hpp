#pragma once
/// Bodies that a job has in files of their own: STL and STEP, told apart by the file's name.

#include <optional>
#include <vector>

#include "driver/guarded.hpp"
#include "driver/session.hpp"
#include "mesh/mesh.hpp"
#include "shop/solid.hpp"

namespace obrys::driver {

/// Bodies in the workpiece frame, mm.
struct BodyFile {
    std::vector<mesh::Mesh> bodies;  ///< of an STL file one
    bool closed = false;             ///< every one of them bounds a solid
    std::uint32_t source = 0;
};

/// Nothing after a complaint. STEP files are made into triangles for what is checked to `tolerance` mm; `guard` is what
/// that may take.
[[nodiscard]] std::optional<BodyFile> load_bodies(Session& session, const shop::SolidFile& file, double tolerance,
                                                  const Guard& guard);

/// All of them as one mesh; complains, and `closed` becomes false, where they may touch.
[[nodiscard]] mesh::Mesh one_body(Session& session, BodyFile& file);

}  // namespace obrys::driver
