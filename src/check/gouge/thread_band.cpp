#include "check/gouge/thread_band.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace obrys::check {

using geom::Vec3;

namespace {

constexpr double one_axis_within = 1e-6;  ///< mm
constexpr std::size_t samples = 2048;     ///< of a hole's wall
constexpr std::size_t held_to_part = 4;   ///< one of so many
constexpr double most_upright = 0.3;      ///< of a wall's normal along the axis

/// Half the width along x of a round body about a straight piece.
double left_of(Vec3 foot, Vec3 axis, double height, double radius) {
    return std::min(foot.x, foot.x + height * axis.x) - radius;
}

/// Centres of so many triangles of a wall.
std::vector<WallPoint> some_centres(const mesh::Mesh& m, const std::vector<std::uint32_t>& wall) {
    std::vector<WallPoint> some;
    const std::size_t stride = std::max<std::size_t>(1, wall.size() / samples);
    for (std::size_t i = 0; i < wall.size(); i += stride) {
        // Spread within the stride: a hole's wall repeats itself along its axis, layer by layer.
        const std::size_t within = (i * 2654435761U >> 7U) % std::min(stride, wall.size() - i);
        some.push_back({mesh::centre(m, wall[i + within]), m.tag(wall[i + within])});
    }
    return some;
}

}  // namespace

void ThreadBands::add(Vec3 from, Vec3 to, Vec3 axis, const ThreadRadii& radii) {
    axis = (1 / geom::length(axis)) * axis;
    if (geom::dot(to - from, axis) < 0) std::swap(from, to);
    const Band band{from, axis, geom::dot(to - from, axis), radii};
    constexpr std::size_t looked_at = 4;  // pecks and the way back follow each other
    for (std::size_t i = bands_.size(); i > 0 && i + looked_at > bands_.size(); --i) {
        Band& other = bands_[i - 1];
        const Place place = place_in(other, from);
        const bool one_thread = other.radii.outer == radii.outer && other.radii.core == radii.core;
        const bool meet = place.height <= other.height + one_axis_within &&
                          place.height + band.height >= -one_axis_within;  // a plain bore may lie in a gap
        if (geom::distance(other.axis, axis) > one_axis_within || place.radius > one_axis_within || !one_thread ||
            !meet)
            continue;
        const double low = std::min(0.0, place.height), high = std::max(other.height, place.height + band.height);
        other.foot = other.foot + low * axis;
        other.height = high - low;
        return;
    }
    bands_.push_back(band);
}

ThreadBands::Place ThreadBands::place_in(const Band& band, Vec3 p) {
    const double height = geom::dot(p - band.foot, band.axis);
    return {height, geom::length(p - band.foot - height * band.axis)};
}

bool ThreadBands::holds(const Band& band, Vec3 p, double ball) const {
    const Place place = place_in(band, p);
    const double beyond = allowed_ - ball;
    return place.height >= -beyond && place.height <= band.height + beyond &&
           place.radius >= band.radii.core - beyond && place.radius <= band.radii.outer + beyond;
}

/// The nearest to the axis is that of its shadow on a plane across it.
bool ThreadBands::holds(const Band& band, const std::array<Vec3, 3>& triangle) const {
    std::array<Vec3, 3> shadow;
    for (std::size_t i = 0; i < triangle.size(); ++i) {
        const Place place = place_in(band, triangle[i]);
        if (!holds(band, triangle[i])) return false;
        shadow[i] = triangle[i] - place.height * band.axis;
    }
    return mesh::nearest_on_triangle(band.foot, shadow).distance >= band.radii.core - allowed_;
}

template <class Visit>
void ThreadBands::each_near(Vec3 p, Visit&& visit) const {
    auto at = std::lower_bound(bands_.begin(), bands_.end(), p.x - widest_,
                               [](const Band& b, double x) { return b.left < x; });
    for (; at != bands_.end() && at->left <= p.x; ++at)
        if (holds(*at, p)) visit(static_cast<std::size_t>(at - bands_.begin()));
}

void ThreadBands::fit(const mesh::Mesh& result, const mesh::Distance& part, double allowed,
                      const std::function<bool(std::uint32_t)>& tapped) {
    allowed_ = allowed;
    for (Band& b : bands_) {
        const double radius = b.radii.outer + allowed;
        b.left = left_of(b.foot, b.axis, b.height, radius) - allowed;
        widest_ = std::max(widest_, std::abs(b.height * b.axis.x) + 2 * (radius + allowed));
    }
    std::stable_sort(bands_.begin(), bands_.end(), [](const Band& a, const Band& b) { return a.left < b.left; });
    std::vector<std::vector<std::uint32_t>> walls(bands_.size());
    for (std::uint32_t t = 0; t < result.triangles.size(); ++t) {
        const Vec3 normal = mesh::area_vector(result, t);
        each_near(mesh::centre(result, t), [&](std::size_t b) {
            if (std::abs(geom::dot(normal, bands_[b].axis)) < most_upright * geom::length(normal))
                walls[b].push_back(t);
        });
    }
    for (std::size_t b = 0; b < bands_.size(); ++b) {
        // What the tap has cut is its own core: the hole before is told by the rest.
        std::vector<std::uint32_t> before = walls[b];
        if (tapped) std::erase_if(before, [&](std::uint32_t t) { return tapped(result.tag(t)); });
        fit_one(bands_[b], some_centres(result, before.empty() ? walls[b] : before), part, allowed);
    }
}

/// By the radii of the part's wall about the thread's axis and of the hole about its own.
void ThreadBands::fit_one(Band& band, const std::vector<WallPoint>& wall, const mesh::Distance& part, double allowed) {
    if (wall.empty()) return;
    std::vector<double> off, own, radii;
    for (std::size_t i = 0; i < wall.size(); i += held_to_part) {
        const Vec3 p = wall[i].at;
        const mesh::Nearest nearest = part.nearest(p);
        if (!std::isfinite(nearest.distance)) continue;
        off.push_back(part.is_inside(p, nearest) ? -nearest.distance : nearest.distance);
        own.push_back(place_in(band, p).radius);
        radii.push_back(place_in(band, nearest.at).radius);
    }
    if (off.empty()) return;
    const std::optional<HoleRadii> hole = radii_of(wall, {band.foot, band.axis}, allowed);
    const double shown = hole ? middle(radii) - hole->fitted : middle(off);
    const double radius = hole ? middle(radii) : middle(own) + shown;
    if (!(radius >= band.radii.core - allowed && radius <= band.radii.outer + allowed)) return;
    if ((hole ? hole->least : middle(own)) > band.radii.widest_hole + allowed) return;
    band.left_over = std::max(0.0, shown);
    band.deeper = std::max(0.0, hole ? hole->least - middle(radii) : -shown);
}

bool ThreadBands::holds(Vec3 p) const {
    bool held = false;
    each_near(p, [&](std::size_t) { held = true; });
    return held;
}

double ThreadBands::more(Vec3 p, double radius, bool gouge) const {
    double most = 0;
    each_near(p, [&](std::size_t b) {
        if (holds(bands_[b], p, radius)) most = std::max(most, gouge ? bands_[b].deeper : bands_[b].left_over);
    });
    return most;
}

double ThreadBands::deeper(const std::array<Vec3, 3>& triangle) const {
    double most = 0;
    each_near((1.0 / 3) * (triangle[0] + triangle[1] + triangle[2]), [&](std::size_t b) {
        if (bands_[b].deeper > most && holds(bands_[b], triangle)) most = bands_[b].deeper;
    });
    return most;
}

double ThreadBands::judged(Vec3 p, double deviation) const {
    double left = deviation;
    each_near(p, [&](std::size_t b) {
        const double off = deviation - std::clamp(deviation, -bands_[b].deeper, bands_[b].left_over);
        if (std::abs(off) < std::abs(left)) left = off;
    });
    return left;
}

}  // namespace obrys::check
