#pragma once
/// Contour train (25) with its data (270).

#include "cycles/contour/contour.hpp"
#include "cycles/course.hpp"

namespace obrys::cycles {

void expand_contour_train(Course& course, const Situation& situation, const ContourTrain& train);

}  // namespace obrys::cycles
