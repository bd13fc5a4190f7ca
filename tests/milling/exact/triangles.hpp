#pragma once
/// The triangles of a binary STL file, and how far places lie from them.

#include <cstdint>
#include <string>
#include <vector>

#include "vec.hpp"

namespace exact {

using Triangle = std::array<V, 3>;

/// Throws std::runtime_error.
[[nodiscard]] std::vector<Triangle> read_stl(const std::string& path);
[[nodiscard]] V nearest_on(const Triangle& t, V p);

class Triangles {
public:
    explicit Triangles(std::vector<Triangle> triangles);
    /// Exactly, where it is below `most`.
    [[nodiscard]] double distance(V p, double most = 1e300) const;
    [[nodiscard]] const std::vector<Triangle>& all() const { return triangles_; }

private:
    struct Node {
        Box box;
        std::uint32_t first = 0, count = 0;  ///< of triangles; of inner nodes count is 0 and `first` the second child
    };
    void divide(std::uint32_t first, std::uint32_t count);

    std::vector<Triangle> triangles_;
    std::vector<Node> nodes_;
};

}  // namespace exact
