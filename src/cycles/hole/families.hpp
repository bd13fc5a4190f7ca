#pragma once
/// What makes the steps of each cycle at one hole. Private to this room.

#include "cycles/hole/below_surface.hpp"
#include "cycles/hole/between_planes.hpp"
#include "cycles/hole/tapping_below_surface.hpp"
#include "cycles/hole/thread_milling.hpp"

namespace obrys::cycles {

void write_steps(Course&, const OldPecking&, const Situation&);
void write_steps(Course&, const DepthDrilling&, const Situation&);
void write_steps(Course&, const UniversalDrilling&, const Situation&);
void write_steps(Course&, const UniversalPecking&, const Situation&);
void write_steps(Course&, const Centring&, const Situation&);
void write_steps(Course&, const SingleLipDrilling&, const Situation&);

void write_steps(Course&, const Reaming&, const Situation&);
void write_steps(Course&, const DepthBoring&, const Situation&);
void write_steps(Course&, const Counterboring&, const Situation&);
void write_steps(Course&, const BoreMilling&, const Situation&);

void write_steps(Course&, const OldFloatingTapping&, const Situation&);
void write_steps(Course&, const DepthFloatingTapping&, const Situation&);
void write_steps(Course&, const OldRigidTapping&, const Situation&);
void write_steps(Course&, const DepthRigidTapping&, const Situation&);
void write_steps(Course&, const ChipBreakTapping&, const Situation&);
void write_steps(Course&, const ThreadCutting&, const Situation&);

void write_steps(Course&, const ThreadMilling&, const Situation&);
void write_steps(Course&, const CountersunkThreadMilling&, const Situation&);
void write_steps(Course&, const DrilledThreadMilling&, const Situation&);
void write_steps(Course&, const HelicalThreadMilling&, const Situation&);
void write_steps(Course&, const OutsideThreadMilling&, const Situation&);

void write_steps(Course&, const Drilling&, const Situation&);
void write_steps(Course&, const ChipBreakDrilling&, const Situation&);
void write_steps(Course&, const PeckDrilling&, const Situation&);
void write_steps(Course&, const DeepDrilling&, const Situation&);
void write_steps(Course&, const FloatingTapping&, const Situation&);
void write_steps(Course&, const RigidTapping&, const Situation&);
void write_steps(Course&, const FeedBoring&, const Situation&);
void write_steps(Course&, const StopBoring&, const Situation&);
void write_steps(Course&, const OrientedBoring&, const Situation&);
void write_steps(Course&, const BackBoring&, const Situation&);
void write_steps(Course&, const ManualBoring&, const Situation&);

}  // namespace obrys::cycles
