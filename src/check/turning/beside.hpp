#pragma once
/// Moves that cannot meet a turned stock. Millimetres, x a radius.

#include "check/turning/removal.hpp"

namespace obrys::check {

/// Whether everything between the radii a + low and b + high, of either sign, lies beside the stock.
[[nodiscard]] bool beside_in_x(double a, double b, const Box& tool, const Box& stock);
/// The same along Z.
[[nodiscard]] bool beside_in_z(double a, double b, const Box& tool, const Box& stock);
/// A rapid that comes no nearer to the stock, in X and in Z, and ends in front of it, behind it or clear of its side: a
/// way to where tools are changed. A place that is not known is home, away from the stock.
[[nodiscard]] bool leads_away(const Move& move, const Box& stock);

}  // namespace obrys::check
