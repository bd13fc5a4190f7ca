#pragma once
/// Which element of a contour a stretch of a cycle's path runs along.

#include <optional>
#include <vector>

#include "geom/edge.hpp"

namespace obrys::cycles {

class Along {
public:
    /// The elements of all contours of the cycle, in the plane, as programmed.
    explicit Along(std::vector<geom::Edge> elements);
    /// Index of the element nearest to the middle of the stretch, where the stretch keeps its distance from it (1e-4
    /// mm); of equally near ones the first, so an arc about a corner belongs to the element that ends there. Nothing
    /// for ways to and from the contour, for a point, and where a coordinate is not known.
    [[nodiscard]] std::optional<std::size_t> find(const geom::Edge& stretch) const;

private:
    /// A box about elements `first` to `last` of `order_`; its halves stand in the places 2 i + 1 and 2 i + 2.
    struct Node {
        geom::Box box;
        std::size_t first = 0, last = 0;
    };
    void build(std::size_t node, std::size_t first, std::size_t last);
    struct Nearest {
        double distance = std::numeric_limits<double>::infinity();
        std::size_t element = 0;
    };
    void search(std::size_t node, geom::Vec2 p, Nearest& best) const;

    std::vector<geom::Edge> elements_;
    std::vector<std::size_t> order_;
    std::vector<Node> nodes_;
};

}  // namespace obrys::cycles
