#pragma once
/// What is left of a stock from which tools on lines and arcs took what they sweep, as a signed function of place.
///
/// A tool is a union of convex bodies of revolution. The signed distance from a convex body is a convex function, so along
/// a straight way its least value is found without sampling; arcs are pieces whose sagitta bounds what chords leave out.
/// Outside of what is swept the distance is exact; inside it never says more than there is.

#include <istream>
#include <vector>

#include "vec.hpp"

namespace exact {

/// The hull of two rings about the tool's axis, grown by a ball. Heights from the programmed point, z0 <= z1.
struct Body {
    double r0 = 0, z0 = 0, r1 = 0, z1 = 0, rounding = 0;
};
using Tool = std::vector<Body>;

struct Move {
    std::size_t tool = 0;
    V axis;  ///< to the holder, unit length
    V from, to;
    bool arc = false;
    V centre, normal;  ///< of an arc about `normal`, counter-clockwise by `sweep`; it rises evenly from `from` to `to`
    double sweep = 0;
    Box box;  ///< around what is swept
};
[[nodiscard]] V at(const Move& move, double t);

class Solid {
public:
    /// Text, a record a line; see README.md. Throws std::runtime_error.
    explicit Solid(std::istream& scene);

    /// Negative in what is left. Nobody of its surface is nearer than the value says; in the solid it is the distance.
    [[nodiscard]] double value(V p) const;
    /// Constraints: 0 the stock, then the moves. Negative where the constraint leaves material.
    [[nodiscard]] std::size_t constraints() const { return moves_.size() + 1; }
    [[nodiscard]] Signed constraint(std::size_t i, V p) const;
    /// Which constraints come within `reach` of being in force at a place, the nearest first.
    [[nodiscard]] std::vector<std::size_t> near(V p, double reach) const;
    /// The constraint that has the greatest value there.
    [[nodiscard]] std::size_t foremost(V p) const;
    [[nodiscard]] const Box& stock_box() const { return stock_box_; }
    [[nodiscard]] const std::vector<Move>& moves() const { return moves_; }
    [[nodiscard]] const Tool& tool(const Move& move) const { return tools_[move.tool]; }

private:
    [[nodiscard]] Signed stock(V p) const;
    /// Exactly, where it is below `most`.
    [[nodiscard]] Signed swept(const Move& move, V p, double most = 1e300) const;

    bool round_ = false;
    Box stock_box_;
    V foot_, along_;  ///< of a round stock
    double radius_ = 0, length_ = 0;
    std::vector<Tool> tools_;
    std::vector<Move> moves_;
};

}  // namespace exact
