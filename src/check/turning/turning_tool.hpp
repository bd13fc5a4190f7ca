#pragma once
/// Tools on a lathe as the removal needs them, in the (z, x) plane relative to the programmed point.

#include <string>
#include <vector>

#include "cl/record.hpp"
#include "shop/tool.hpp"

namespace obrys::check {

/// What the insert covers; of a drill, reamer, tap (its core) or mill that stands on the turning axis the section of
/// its edges, on both sides of the axis, with the tip at the left. Empty where there is none.
[[nodiscard]] geom::Contour turning_outline(const shop::Tool& tool);
/// The section of a tap with its thread.
[[nodiscard]] geom::Contour whole_tap(const shop::Tool& tap);
/// What stands behind a blade of known length whose holder is not given: wider than the blade on both sides. Empty for
/// other tools, and for blades that go on into a bore.
[[nodiscard]] geom::Contour behind_blade(const shop::Tool& tool);

/// A body that goes with the edges and does not cut.
struct Carried {
    enum class Kind : std::uint8_t {
        shank,
        holder,
        edges,    ///< as thick as the edges are, above them, where no shank is given
        machine,  ///< above the length that the job gives
    };
    Kind kind = Kind::holder;
    geom::Contour body;
};
/// All that the shop's list says of them, in the same frame as the outline.
[[nodiscard]] std::vector<Carried> carried_by(const shop::Tool& tool);
/// It has bodies, but nothing says where its edges end.
[[nodiscard]] bool is_carried_anywhere(const shop::Tool& tool);
/// Neither what holds it is known, nor how long it is.
[[nodiscard]] bool is_held_by_nothing(const shop::Tool& tool);

}  // namespace obrys::check
