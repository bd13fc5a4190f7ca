#pragma once
/// A contour that stands in a part of a program, as the elements that it is made of. Private to rewrite.

#include <optional>
#include <string>
#include <vector>

#include "rewrite/writing.hpp"

namespace obrys::rewrite {

/// A place in the plane.
struct Place {
    Text u, v;
};

struct ContourPart {
    Place to;
    bool is_arc = false, clockwise = false;
    Place centre;               ///< of an arc
    std::optional<Text> round;  ///< between this one and the next
    std::optional<Text> chamfer;
};

struct ContourText {
    Place from;
    int side = 0;  ///< of the tool: 1 left, -1 right
    std::vector<ContourPart> parts;

    [[nodiscard]] const Place& start_of(std::size_t part) const { return part == 0 ? from : parts[part - 1].to; }
    /// The same from its end to its beginning.
    [[nodiscard]] ContourText reversed() const;
};

/// Sums, differences and quotients in the other language; numbers are computed at once.
class Sums {
public:
    explicit Sums(Writing& w) : w_(w) {}
    Text plus(const Text& a, const Text& b);
    Text minus(const Text& a, const Text& b);
    Text times(const Text& a, const Text& b);
    Text through(const Text& a, const Text& b);
    Text root(const Text& a, const Text& b);  ///< of the sum of their squares
private:
    Writing& w_;
};

/// The point beside the contour's begin or end, square to it on the side of the tool, so far away.
[[nodiscard]] Place beside(Writing& w, const ContourText& contour, bool at_end, const Text& away);

}  // namespace obrys::rewrite
