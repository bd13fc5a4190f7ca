#pragma once
/// What makes the steps of each milling cycle. Private to this room.

#include "cycles/mill/figures.hpp"
#include "cycles/mill/old_figures.hpp"
#include "cycles/mill/surfaces.hpp"

namespace obrys::cycles {

void make(Course&, const RectangularPocket&, const Situation&);
void make(Course&, const CircularPocket&, const Situation&);
void make(Course&, const OldRectangularPocket&, const Situation&);
void make(Course&, const OldCircularPocket&, const Situation&);

void make(Course&, const Slot&, const Situation&);
void make(Course&, const RoundSlot&, const Situation&);
void make(Course&, const ReciprocatingSlot&, const Situation&);
void make(Course&, const ReciprocatingRoundSlot&, const Situation&);

void make(Course&, const RectangularStud&, const Situation&);
void make(Course&, const CircularStud&, const Situation&);
void make(Course&, const RectangularPocketFinishing&, const Situation&);
void make(Course&, const RectangularStudFinishing&, const Situation&);
void make(Course&, const CircularPocketFinishing&, const Situation&);
void make(Course&, const CircularStudFinishing&, const Situation&);

void make(Course&, const Multipass&, const Situation&);
void make(Course&, const RuledSurface&, const Situation&);
void make(Course&, const FaceMilling&, const Situation&);

}  // namespace obrys::cycles
