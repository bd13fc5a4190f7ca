#pragma once
/// The families of milling cycles. Private to this room.

#include "cycles/course.hpp"

namespace obrys::cycles {

void expand_pocket(Course& course, const Demand& demand, const Situation& situation);
void expand_slot(Course& course, const Demand& demand, const Situation& situation);
void expand_stud(Course& course, const Demand& demand, const Situation& situation);
void expand_finish(Course& course, const Demand& demand, const Situation& situation);
void expand_surface(Course& course, const Demand& demand, const Situation& situation);

}  // namespace obrys::cycles
