#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "sim/milling/dexel.hpp"

namespace obrys::sim::milling {
namespace {

/// What an end of an interval says about the cell around the nearest node: how much of the cell's axis it covers.
struct Part {
    std::uint64_t node = 0;
    int axis = 0;
    double share = 0;
    bool inside = false;  ///< the node itself is material
    auto operator<=>(const Part&) const = default;
};

struct Course {
    int axis = 0;
    std::uint64_t base = 0, stride = 0;  ///< node i of the ray is base + i * stride
    double origin = 0, step = 1;
    int count = 0;
};

/// The parts of one interval; returns how many nodes it holds.
double parts_of(const Interval& v, const Course& ray, std::vector<Part>& parts) {
    const double begin = (v.begin - ray.origin) / ray.step, end = (v.end - ray.origin) / ray.step;
    const double last = ray.count - 1;
    const double i = std::clamp(std::floor(begin + 0.5), 0.0, last), j = std::clamp(std::floor(end + 0.5), 0.0, last);
    const auto node = [&](double n) { return ray.base + static_cast<std::uint64_t>(n) * ray.stride; };
    if (i == j) {
        parts.push_back({node(i), ray.axis, end - begin, begin <= i && i <= end});
    } else {
        parts.push_back({node(i), ray.axis, i + 0.5 - begin, begin <= i});
        parts.push_back({node(j), ray.axis, end - (j - 0.5), j <= end});
    }
    return std::max(0.0, std::floor(end) - std::ceil(begin) + 1);
}

/// Shares of the cells that a surface goes through, less what counting their nodes gave: in cells.
double corrections(const std::vector<Part>& parts) {
    double sum = 0;
    for (std::size_t i = 0; i < parts.size();) {
        std::array<double, 3> share{-1, -1, -1};
        bool inside = false;
        std::size_t j = i;
        for (; j < parts.size() && parts[j].node == parts[i].node; ++j) {
            double& s = share[static_cast<std::size_t>(parts[j].axis)];
            s = std::max(s, 0.0) + parts[j].share;
            inside = inside || parts[j].inside;
        }
        double product = 1;
        for (const double s : share) product *= s < 0 ? 1 : inside ? s : 1 - s;
        sum += inside ? product - 1 : 1 - product;
        i = j;
    }
    return sum;
}

}  // namespace

double volume(const Dexels& dexels) {
    const Lattice& lattice = dexels.lattice();
    const std::array<std::uint64_t, 3> stride{
        1, static_cast<std::uint64_t>(lattice.count[0]),
        static_cast<std::uint64_t>(lattice.count[0]) * static_cast<std::uint64_t>(lattice.count[1])};
    std::vector<Part> parts;
    double nodes = 0;
    for (int axis = 0; axis < 3; ++axis) {
        const auto own = static_cast<std::size_t>(axis);
        Course ray{
            axis, 0, stride[own], component(lattice.origin, axis), component(lattice.step, axis), lattice.count[own]};
        for (int b = 0; b < dexels.rays_b(axis); ++b) {
            for (int a = 0; a < dexels.rays_a(axis); ++a) {
                ray.base = static_cast<std::uint64_t>(a) * stride[static_cast<std::size_t>(first_across(axis))] +
                           static_cast<std::uint64_t>(b) * stride[static_cast<std::size_t>(second_across(axis))];
                for (const Interval& v : dexels.ray(axis, a, b)) {
                    const double held = parts_of(v, ray, parts);
                    if (axis == 2) nodes += held;
                }
            }
        }
    }
    std::sort(parts.begin(), parts.end());
    return (nodes + corrections(parts)) * lattice.step.x * lattice.step.y * lattice.step.z;
}

}  // namespace obrys::sim::milling
