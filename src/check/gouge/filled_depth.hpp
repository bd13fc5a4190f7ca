#pragma once
/// How deep a place lies in what is left of the stock. Millimetres.

#include <cstddef>

#include "check/gouge/confirm.hpp"

namespace obrys::check {

struct FilledDepth {
    double depth = 0;
    std::size_t body = 0;  ///< that ends it
};

/// How deep a place lies in what is left, at most `enough`; not looked at further where it is no more than `least`.
/// `first`: the body to ask first.
[[nodiscard]] FilledDepth depth_at(const sim::milling::Air& air, geom::Vec3 p, double least, double enough,
                                   std::size_t first);
/// The way on which a body of the air comes nearest.
[[nodiscard]] geom::Vec3 way_out(const sim::milling::Air& air, std::size_t body, geom::Vec3 p);

}  // namespace obrys::check
