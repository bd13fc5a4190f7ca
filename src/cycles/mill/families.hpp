#pragma once
/// What makes the steps of each milling cycle. Private to this room.

#include "cycles/mill/figures.hpp"
#include "cycles/mill/old_figures.hpp"
#include "cycles/mill/surfaces.hpp"

namespace obrys::cycles {

void write_steps(Course&, const RectangularPocket&, const Situation&);
void write_steps(Course&, const CircularPocket&, const Situation&);
void write_steps(Course&, const OldRectangularPocket&, const Situation&);
void write_steps(Course&, const OldCircularPocket&, const Situation&);

void write_steps(Course&, const Slot&, const Situation&);
void write_steps(Course&, const RoundSlot&, const Situation&);
void write_steps(Course&, const ReciprocatingSlot&, const Situation&);
void write_steps(Course&, const ReciprocatingRoundSlot&, const Situation&);

void write_steps(Course&, const RectangularStud&, const Situation&);
void write_steps(Course&, const CircularStud&, const Situation&);
void write_steps(Course&, const RectangularPocketFinishing&, const Situation&);
void write_steps(Course&, const RectangularStudFinishing&, const Situation&);
void write_steps(Course&, const CircularPocketFinishing&, const Situation&);
void write_steps(Course&, const CircularStudFinishing&, const Situation&);

void write_steps(Course&, const Multipass&, const Situation&);
void write_steps(Course&, const RuledSurface&, const Situation&);
void write_steps(Course&, const FaceMilling&, const Situation&);

}  // namespace obrys::cycles
