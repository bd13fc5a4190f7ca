#pragma once
/// Nose radius compensation in turning: the compensation moves the nose centre S, the program moves the tip P.

#include <optional>

#include "geom/vec.hpp"

namespace obrys::path {

/// Vector from the nose centre S to the imaginary tip P for cutting edge position 1-9 ($TC_DP2), mm; Vec2.x is z,
/// Vec2.y is x as a radius, in the workpiece's own axes. Nothing for other numbers.
///
///        +x        2   6   1        Where P lies as seen from S (here *). Position 3, P towards the axis and the
///         |          \ | /          chuck, is outside turning; 2 is boring towards the chuck.
///         |        7 - * - 5        5-8: P on the nose itself, in one axis; 9: P is S.
///         |          / | \          In machine axes the numbers are the same in front of and behind the turning
///         +---- +z 3   8   4        centre; only the picture on the screen is mirrored.
///
/// Source: Siemens, Function Manual Basic Functions, W1 Tool offset, table to SD42920 WEAR_SIGN_CUTPOS (positions 3, 4,
/// 8 invert the wear of length 1 = x, positions 2, 3, 7 that of length 2 = z); SINUMERIK 810T Operating, 3.1.4
/// (pictures of P, S).
[[nodiscard]] std::optional<geom::Vec2> nose_offset(int orientation, double radius);

}  // namespace obrys::path
