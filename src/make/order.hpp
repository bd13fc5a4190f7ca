#pragma once
/// A groove as a file orders it: its measures, where it lies on the lathe, and with what feed and speed it is cut.

#include <optional>
#include <string>
#include <vector>

#include "base/diagnostic.hpp"
#include "base/source.hpp"
#include "cycles/groove/strategy.hpp"

namespace obrys::make {

using geom::Vec2;
namespace groove = cycles::groove;

/// Which surface carries the groove.
enum class Surface : std::uint8_t {
    outside,
    inside,
    face,          ///< the tool comes from +Z
    counter_face,  ///< from -Z, at a counter spindle
};

/// The plane (u, v) of the groove on the lathe: v leads out of the material. Lengths and angles stay.
struct Placing {
    Surface surface = Surface::outside;
    bool turned = false;                           ///< the start edge is the left one: u runs the other way round
    [[nodiscard]] Vec2 on_machine(Vec2 uv) const;  ///< x of the result is z, y is x as a radius
    [[nodiscard]] Vec2 in_groove(Vec2 zx) const;
    [[nodiscard]] bool mirrors() const;  ///< turns become those of the other way
    /// Of a surface in the plane (u, v), by that of the drawing: dX/dZ of longitudinal ones, dZ/dX of faces.
    [[nodiscard]] double slope(double drawn) const;
};

/// Values of the source of the strategies' comparison, where the file says none.
struct Cutting {
    double feed = 0.2;                 ///< mm/rev
    double speed = 300;                ///< m/min (G96)
    double speed_limit = 3000;         ///< 1/min
    double rapid = 10'000;             ///< mm/min, for the time of rapids
    std::vector<std::string> assumed;  ///< keys that the file does not say
};

struct Order {
    groove::Request request;
    Placing placing;
    Cutting cutting;
    std::uint32_t tool = 1;
    bool stepover_given = false;
};

/// Nothing where something is wrong: it stands in the diagnostics.
[[nodiscard]] std::optional<Order> read_order(std::uint32_t file, const base::Sources& sources,
                                              base::Diagnostics& diagnostics);

/// A strategy works with its own step where the file says none: of CYCLE93 0.95 of the insert without its corners, of
/// the others 0.8 of its width.
[[nodiscard]] groove::Request request_for(const Order& order, groove::Strategy strategy);

}  // namespace obrys::make
