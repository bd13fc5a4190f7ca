#pragma once
/// The families of cycles at one hole. Private to this room.

#include "cycles/course.hpp"

namespace obrys::cycles {

void expand_drill(Course& course, const Demand& demand, const Situation& situation);
void expand_bore(Course& course, const Demand& demand, const Situation& situation);
void expand_tap(Course& course, const Demand& demand, const Situation& situation);
void expand_thread_mill(Course& course, const Demand& demand, const Situation& situation);
void expand_canned(Course& course, const Demand& demand, const Situation& situation);

}  // namespace obrys::cycles
