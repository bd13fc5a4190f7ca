#pragma once
/// What the colours of a picture by deviation mean.

#include <vector>

#include "mesh/compare.hpp"
#include "report/picture/milling_picture.hpp"

namespace obrys::report::picture {

/// Of each way, too deep and too high, the smallest and the largest deviation that there is, as the range in
/// millimetres that its colour stands for; no entry for what is not there. `allowed` and `full` as of
/// mesh::deviation_colours.
[[nodiscard]] std::vector<PictureLegend> deviation_legend(const mesh::DeviationColours& colours, double allowed,
                                                          double full);

}  // namespace obrys::report::picture
