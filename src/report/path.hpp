#pragma once
/// Contours and moves as SVG path data.

#include <string>

#include "check/result.hpp"
#include "geom/contour.hpp"

namespace obrys::report {

/// From the (z, x) plane to a picture whose y runs downwards: (left + scale * z, base - scale * x).
struct Projection {
    double scale = 1, left = 0, base = 0;
    int decimals = 2;
    [[nodiscard]] geom::Vec2 operator()(geom::Vec2 p) const { return {left + scale * p.x, base - scale * p.y}; }
};

/// "x y" with trailing zeros cut off.
void append_point(std::string& out, geom::Vec2 p, int decimals);
[[nodiscard]] std::string number(double value, int decimals);

[[nodiscard]] std::string path_of(const geom::Contour& contour, const Projection& to);
[[nodiscard]] std::string path_of(const geom::Region& region, const Projection& to);

/// Chains moves: a new `M` is written only where a move does not begin at the pen.
class MovePath {
public:
    explicit MovePath(const Projection& to) : to_(to) {}
    /// Nothing for a move whose ends are not known.
    void add(const check::MoveTrace& move);
    [[nodiscard]] const std::string& data() const { return data_; }

private:
    Projection to_;
    geom::Vec2 pen_{NAN, NAN};
    std::string data_;
};

/// The text with & < > " replaced for XML and HTML.
[[nodiscard]] std::string escaped(std::string_view text);

}  // namespace obrys::report
