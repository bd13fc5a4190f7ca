#pragma once
/// What is not there any more, decided at points: the bodies that sweeps have taken, and all that lies outside of the
/// stock. No rays, no lattice. Frame of the stock, millimetres.

#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "mesh/distance.hpp"
#include "sim/milling/shape.hpp"
#include "sim/milling/stock.hpp"
#include "sim/milling/track.hpp"

namespace obrys::sim::milling {

/// The stock as a body.
class StockBody {
public:
    explicit StockBody(const Stock& stock);
    /// Distance from its surface, negative outside of it. The sign of a mesh that is not closed means nothing.
    [[nodiscard]] double within(geom::Vec3 p) const;
    /// No place of the hull of some points lies deeper; of a mesh what the points and their middle tell, not proved.
    [[nodiscard]] double most_within(std::span<const geom::Vec3> corners) const;
    /// One of its faces: how deep a point lies behind its plane, and the direction into the stock.
    struct Face {
        double within = 0;
        geom::Vec3 in;
    };
    /// Those that a point in or near the stock lies no deeper behind than so: at an edge two, at a corner three. Of a
    /// mesh none is told.
    [[nodiscard]] std::vector<Face> faces_at(geom::Vec3 p, double deep) const;
    [[nodiscard]] bool closed() const { return closed_; }

private:
    struct Mesh {
        mesh::Distance distance;
        double outwards = 1;
    };
    std::variant<Box3, CylinderStock, std::shared_ptr<const Mesh>> body_;
    bool closed_ = true;
};

/// How far a point lies outside of what a moving tool sweeps, at least; negative: at least so far inside. Where it is
/// `enough` or more, it is not looked at further.
[[nodiscard]] double outside_sweep(const Shape& shape, const Track& track, geom::Vec3 p,
                                   double enough = std::numeric_limits<double>::infinity());

/// Whether a point lies outside of that by no more than `allowed`, which is not negative.
[[nodiscard]] bool sweeps_within(const Shape& shape, const Track& track, geom::Vec3 p, double allowed);

/// Distance from a tool at rest, 0 inside.
[[nodiscard]] double distance_from(const Shape& shape, geom::Vec3 p);

class Air {
public:
    struct Sweep {
        const Shape* shape = nullptr;
        Orientation frame;
        Track track;
        geom::Vec3 from;
        std::uint32_t cut = 0;  ///< as of Interval
    };
    Air(const StockBody& stock, std::vector<Sweep> sweeps) : stock_(&stock), sweeps_(std::move(sweeps)) {}

    /// Bodies: 0 is what lies outside of the stock, the others are sweeps in the program's order.
    [[nodiscard]] std::size_t bodies() const { return sweeps_.size() + 1; }
    /// How far a point lies outside of a body, at least; negative: at least so far inside.
    [[nodiscard]] double outside(std::size_t body, geom::Vec3 p,
                                 double enough = std::numeric_limits<double>::infinity()) const;
    /// The cut that took a body; 0: none.
    [[nodiscard]] std::uint32_t cut(std::size_t body) const { return body == 0 ? 0 : sweeps_[body - 1].cut; }
    /// Direction out of a body at a point near its surface; not of body 0.
    [[nodiscard]] geom::Vec3 normal(std::size_t body, geom::Vec3 p) const;
    /// One of them; not of body 0.
    [[nodiscard]] const Sweep& sweep(std::size_t body) const { return sweeps_[body - 1]; }
    /// False: nothing can be told, the stock's mesh is not closed.
    [[nodiscard]] bool known() const { return stock_->closed(); }

private:
    const StockBody* stock_;
    std::vector<Sweep> sweeps_;
};

}  // namespace obrys::sim::milling
