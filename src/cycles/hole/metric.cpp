#include "cycles/hole/metric.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace obrys::cycles {

namespace {

struct Thread {
    double diameter, pitch;
};
constexpr std::array threads{
    Thread{1, 0.25},   Thread{1.2, 0.25}, Thread{1.4, 0.3}, Thread{1.6, 0.35}, Thread{1.8, 0.35}, Thread{2, 0.4},
    Thread{2.5, 0.45}, Thread{3, 0.5},    Thread{3.5, 0.6}, Thread{4, 0.7},    Thread{4.5, 0.75}, Thread{5, 0.8},
    Thread{6, 1},      Thread{7, 1},      Thread{8, 1.25},  Thread{9, 1.25},   Thread{10, 1.5},   Thread{11, 1.5},
    Thread{12, 1.75},  Thread{14, 2},     Thread{16, 2},    Thread{18, 2.5},   Thread{20, 2.5},   Thread{22, 2.5},
    Thread{24, 3},     Thread{27, 3},     Thread{30, 3.5},  Thread{33, 3.5},   Thread{36, 4},     Thread{39, 4},
    Thread{42, 4.5},   Thread{45, 4.5},   Thread{48, 5},    Thread{52, 5},     Thread{56, 5.5},   Thread{60, 5.5},
    Thread{64, 6},     Thread{68, 6}};

}  // namespace

std::optional<double> coarse_pitch(double diameter) {
    constexpr double same = 1e-6;
    const auto* const found = std::find_if(threads.begin(), threads.end(),
                                           [&](const Thread& t) { return std::abs(t.diameter - diameter) < same; });
    return found == threads.end() ? std::nullopt : std::optional(found->pitch);
}

}  // namespace obrys::cycles
