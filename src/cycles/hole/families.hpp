#pragma once
/// What makes the steps of each cycle at one hole. Private to this room.

#include "cycles/hole/below_surface.hpp"
#include "cycles/hole/between_planes.hpp"
#include "cycles/hole/tapping_below_surface.hpp"
#include "cycles/hole/thread_milling.hpp"

namespace obrys::cycles {

void make(Course&, const OldPecking&, const Situation&);
void make(Course&, const DepthDrilling&, const Situation&);
void make(Course&, const UniversalDrilling&, const Situation&);
void make(Course&, const UniversalPecking&, const Situation&);
void make(Course&, const Centring&, const Situation&);
void make(Course&, const SingleLipDrilling&, const Situation&);

void make(Course&, const Reaming&, const Situation&);
void make(Course&, const DepthBoring&, const Situation&);
void make(Course&, const Counterboring&, const Situation&);
void make(Course&, const BoreMilling&, const Situation&);

void make(Course&, const OldFloatingTapping&, const Situation&);
void make(Course&, const DepthFloatingTapping&, const Situation&);
void make(Course&, const OldRigidTapping&, const Situation&);
void make(Course&, const DepthRigidTapping&, const Situation&);
void make(Course&, const ChipBreakTapping&, const Situation&);
void make(Course&, const ThreadCutting&, const Situation&);

void make(Course&, const ThreadMilling&, const Situation&);
void make(Course&, const CountersunkThreadMilling&, const Situation&);
void make(Course&, const DrilledThreadMilling&, const Situation&);
void make(Course&, const HelicalThreadMilling&, const Situation&);
void make(Course&, const OutsideThreadMilling&, const Situation&);

void make(Course&, const Drilling&, const Situation&);
void make(Course&, const ChipBreakDrilling&, const Situation&);
void make(Course&, const PeckDrilling&, const Situation&);
void make(Course&, const DeepDrilling&, const Situation&);
void make(Course&, const FloatingTapping&, const Situation&);
void make(Course&, const RigidTapping&, const Situation&);
void make(Course&, const FeedBoring&, const Situation&);
void make(Course&, const StopBoring&, const Situation&);
void make(Course&, const OrientedBoring&, const Situation&);
void make(Course&, const BackBoring&, const Situation&);
void make(Course&, const ManualBoring&, const Situation&);

}  // namespace obrys::cycles
