#pragma once
/// The boundary of the workpiece as linked edges in a grid, so that a cut reads and changes only what lies near it.

#include <cstdint>
#include <vector>

#include "geom/arrangement.hpp"

namespace obrys::sim::turning {

using Slot = std::int32_t;

/// One edge of the boundary; material on its left.
struct Bound {
    geom::Edge edge;
    geom::Box box;
    Slot next = -1, previous = -1;
    bool used = false;
    std::uint32_t seen = 0;
};

class Stock {
public:
    explicit Stock(const geom::Region& region) { rebuild(region); }
    void rebuild(const geom::Region& region);

    [[nodiscard]] geom::Region region() const;
    [[nodiscard]] const Bound& operator[](Slot s) const { return bounds_[static_cast<std::size_t>(s)]; }
    [[nodiscard]] const geom::Box& box() const { return box_; }
    [[nodiscard]] std::vector<Slot> near(const geom::Box& b, double margin);
    [[nodiscard]] int winding(geom::Vec2 p);
    template <class F>
    void each(F&& f) const {
        for (const Bound& b : bounds_)
            if (b.used) f(b.edge);
    }

    Slot insert(const geom::Edge& e);
    void erase(Slot s);
    void join(Slot before, Slot after);
    /// Drops closed chains through the given slots that enclose nothing.
    void drop_slivers(const std::vector<Slot>& touched);

private:
    struct Range {
        int x0, x1, y0, y1;
    };
    [[nodiscard]] Range range(const geom::Box& b) const;
    [[nodiscard]] std::vector<Slot>& cell(int x, int y) {
        return cells_[static_cast<std::size_t>(y) * static_cast<std::size_t>(nx_) + static_cast<std::size_t>(x)];
    }
    template <class F>
    void each_cell(const geom::Box& b, F&& f);
    Bound& at(Slot s) { return bounds_[static_cast<std::size_t>(s)]; }

    std::vector<Bound> bounds_;
    std::vector<Slot> free_;
    std::vector<std::vector<Slot>> cells_;
    geom::Box box_;
    double size_ = 1;
    int nx_ = 1, ny_ = 1;
    std::uint32_t query_ = 0;
};

inline constexpr double near_margin = 1e-6;  ///< mm; far more than anything moves by welding

/// The edges near a tool and those of the tool, for an arrangement of the neighbourhood (sets a and b). `near`: sorted.
[[nodiscard]] std::vector<geom::SourceEdge> sources_of(const Stock& stock, const std::vector<Slot>& near,
                                                       const geom::Region& tool);
/// What the stock and the tool have in common. The cost depends on what lies near the tool.
[[nodiscard]] geom::Region overlap(Stock& stock, const geom::Region& tool);

}  // namespace obrys::sim::turning
