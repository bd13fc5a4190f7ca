#pragma once
/// What is said of a surface that was read from a file, whatever the file's form. Private to the readers of meshes.

#include <cstdint>
#include <string>
#include <string_view>

#include "base/diagnostic.hpp"
#include "mesh/mesh.hpp"
#include "mesh/topology.hpp"

namespace obrys::mesh {

/// Complaints about a file as a whole; they stand at its beginning.
class Remarks {
public:
    Remarks(std::uint32_t file, base::Diagnostics& out) : file_(file), out_(out) {}

    void say(base::Severity severity, std::string_view code, std::string text, std::string remedy = "");
    void note(std::string text, std::string remedy = "");  ///< `assumption`

    /// `mesh-not-closed` for each way in which the surface does not bound a solid; `open` is what to do about holes.
    void surface(const Topology& t, std::string_view open);

private:
    void edges(const EdgeFault& fault, const std::string& what, std::string remedy);

    std::uint32_t file_;
    base::Diagnostics& out_;
};

/// "1 edge", "2 edges".
[[nodiscard]] std::string counted(std::size_t n, const std::string& one, const std::string& many);

/// A volume that can be told from rounding, and is negative.
[[nodiscard]] bool is_inside_out(const Mesh& m);

}  // namespace obrys::mesh
