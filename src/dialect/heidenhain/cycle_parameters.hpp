#pragma once
/// Parameter lists of the iTNC 530's cycles, one for each cycle; used by the table in cycles.cpp only.

#include "dialect/heidenhain/cycles.hpp"

namespace obrys::dialect::heidenhain::parameters {

using List = std::span<const CycleParameter>;

// Numbered form.
extern const List c1, c2, c3, c4, c5, c6, c7, c8, c9, c10, c11, c13, c14, c15, c16, c17, c18, c19, c26, c32;
// Contour cycles, named form.
extern const List c20, c21, c22, c23, c24, c25, c27, c28, c29, c39, c270;
// Holes and threads.
extern const List c200, c201, c202, c203, c204, c205, c206, c207, c208, c209, c240, c241, c262, c263, c264, c265, c267;
// Pockets, slots, studs, patterns, surfaces, preset.
extern const List c210, c211, c212, c214, c220, c221, c230, c231, c232, c247, c251, c252, c253, c254, c256, c257;

}  // namespace obrys::dialect::heidenhain::parameters
