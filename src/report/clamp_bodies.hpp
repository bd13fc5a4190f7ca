#pragma once
/// The clamps of a milling job as one mesh, for pictures.

#include <string>

#include "check/result.hpp"
#include "check/setup.hpp"
#include "mesh/mesh.hpp"

namespace obrys::report {

struct ClampBodies {
    mesh::Mesh mesh;
    std::string name;  ///< "clamp vice", or "clamps" of several
};

[[nodiscard]] ClampBodies clamp_bodies(const check::MillingSetup& setup);

}  // namespace obrys::report
