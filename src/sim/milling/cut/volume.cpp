// The volume of a body held as rays: node by node, each with the cell of one step around it.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <vector>

#include "base/parallel.hpp"
#include "base/whole.hpp"
#include "sim/milling/crossings.hpp"
#include "sim/milling/cut/simulation.hpp"

namespace obrys::sim::milling {
namespace {

using geom::Vec3;

/// What an end of an interval says about the cell around the nearest node.
struct EndPart {
    std::uint64_t node = 0;
    int axis = 0;
    double share = 0;     ///< how much of the cell's axis is material
    double at = 0;        ///< the end, in steps from the node
    double sign = 0;      ///< 1 where the ray leaves the material, -1 where it enters; 0: two ends in this cell
    bool inside = false;  ///< the node itself is material
    std::uint32_t cut = 0;
    [[nodiscard]] bool before(const EndPart& p) const {
        return node != p.node ? node < p.node : axis != p.axis ? axis < p.axis : at < p.at;
    }
};

struct Ray {
    int axis = 0;
    std::uint64_t base = 0, stride = 0;  ///< node i of the ray is base + i * stride
    double origin = 0, step = 1;
    int count = 0;
};

/// The parts of one interval; returns how many nodes it holds.
double parts_of(const Interval& v, const Ray& ray, std::vector<EndPart>& parts) {
    const double begin = (v.begin - ray.origin) / ray.step, end = (v.end - ray.origin) / ray.step;
    const double last = ray.count - 1;
    const double i = std::clamp(std::floor(begin + 0.5), 0.0, last), j = std::clamp(std::floor(end + 0.5), 0.0, last);
    const auto node = [&](double n) {
        return ray.base + base::clipped<std::uint64_t>(n, 0, static_cast<std::uint64_t>(ray.count - 1)) * ray.stride;
    };
    if (i == j) {
        parts.push_back({node(i), ray.axis, end - begin, begin - i, 0, begin <= i && i <= end, 0});
    } else {
        parts.push_back({node(i), ray.axis, i + 0.5 - begin, begin - i, -1, begin <= i, v.begin_cut});
        parts.push_back({node(j), ray.axis, end - (j - 0.5), end - j, 1, j <= end, v.end_cut});
    }
    return std::max(0.0, std::floor(end) - std::ceil(begin) + 1);
}

using Parts = std::span<const EndPart>;

/// The product of the parts' shares, or one less the product of their complements: exact for edges and corners of
/// faces normal to the axes.
double by_shares(Parts parts, bool inside) {
    std::array<double, 3> share{-1, -1, -1};
    for (const EndPart& p : parts) {
        double& s = share[static_cast<std::size_t>(p.axis)];
        s = std::max(s, 0.0) + p.share;
    }
    double product = 1;
    for (const double s : share) product *= s < 0 ? 1 : inside ? s : 1 - s;
    return inside ? product : 1 - product;
}

/// Along a face of any direction, rays of each axis by themselves say how much material lies beyond or short of the
/// nodes; the nearer the axis to the face's normal the better. So the axes share in what is said of a face.
class Cells {
public:
    Cells(const Lattice& lattice, Normal normal) : lattice_(lattice), normal_(normal) {}

    /// How much of the cell around the parts' node is material, in cells; where a face slants it may be below 0 or
    /// above 1, which the cells beside it make good.
    [[nodiscard]] double filled(Parts parts, bool inside) const {
        if (parts.size() > 3) return by_shares(parts, inside);
        const Vec3 node = place_of(parts[0].node);
        std::array<Vec3, 3> normals;
        double sum = inside ? 1 : 0;
        for (std::size_t i = 0; i < parts.size(); ++i) {
            const EndPart& p = parts[i];
            if (p.sign == 0 || (i > 0 && parts[i - 1].axis == p.axis)) return by_shares(parts, inside);
            Vec3 at = node;
            set_component(at, p.axis, component(at, p.axis) + p.at * component(lattice_.step, p.axis));
            const Vec3 n = normals[i] = normal_(p.cut, at, p.axis, p.sign);
            const Vec3 square{n.x * n.x, n.y * n.y, n.z * n.z};
            const double own = component(square, p.axis), weight = own * own / dot(square, square);
            bool one_face = weight >= 0;
            for (std::size_t j = 0; j < i; ++j) one_face = one_face && dot(n, normals[j]) > same_face;
            if (!one_face) return by_shares(parts, inside);
            sum += weight * (p.share - (inside ? 1 : 0));
        }
        return sum;
    }

private:
    static constexpr double same_face = 0.9;  ///< cosine between normals

    [[nodiscard]] Vec3 place_of(std::uint64_t node) const {
        const auto nx = static_cast<std::uint64_t>(lattice_.count[0]);
        const auto ny = static_cast<std::uint64_t>(lattice_.count[1]);
        return lattice_.node(static_cast<int>(node % nx), static_cast<int>(node / nx % ny),
                             static_cast<int>(node / (nx * ny)));
    }

    const Lattice& lattice_;
    Normal normal_;
};

/// What the cells of these parts hold, less what counting their nodes gave. In fixed pieces, so that the number of
/// threads does not matter.
double corrections(Parts parts, const Cells& cells) {
    constexpr std::size_t piece = 8192;
    const auto first_of = [&](std::size_t k) {
        std::size_t i = std::min(k * piece, parts.size());
        while (i > 0 && i < parts.size() && parts[i].node == parts[i - 1].node) ++i;
        return i;
    };
    std::vector<double> sums(parts.size() / piece + 1, 0);
    base::for_all(sums.size(), [&](std::size_t k) {
        const std::size_t end = first_of(k + 1);
        for (std::size_t i = first_of(k), j = i; i < end; i = j) {
            bool inside = false;
            for (; j < parts.size() && parts[j].node == parts[i].node; ++j) inside = inside || parts[j].inside;
            sums[k] += cells.filled(parts.subspan(i, j - i), inside) - (inside ? 1 : 0);
        }
    });
    return std::accumulate(sums.begin(), sums.end(), 0.0);
}

double volume_by(const Dexels& dexels, const Cells& cells) {
    const Lattice& lattice = dexels.lattice();
    const std::array<std::uint64_t, 3> stride{
        1, static_cast<std::uint64_t>(lattice.count[0]),
        static_cast<std::uint64_t>(lattice.count[0]) * static_cast<std::uint64_t>(lattice.count[1])};
    std::vector<EndPart> parts;
    double nodes = 0;
    for (int axis = 0; axis < 3; ++axis) {
        const auto own = static_cast<std::size_t>(axis);
        Ray ray{
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
    base::sort_all(parts, [](const EndPart& a, const EndPart& b) { return a.before(b); });
    return (nodes + corrections(parts, cells)) * lattice.step.x * lattice.step.y * lattice.step.z;
}

}  // namespace

double volume(const Simulation& simulation) {
    const auto normal = [&](std::uint32_t cut, Vec3 at, int, double) { return simulation.normal_at(cut, at); };
    const Cells cells(simulation.dexels().lattice(), normal);
    return volume_by(simulation.dexels(), cells);
}

}  // namespace obrys::sim::milling
