#include "check/left/body.hpp"

#include <algorithm>
#include <cmath>

namespace obrys::check {

namespace milling = sim::milling;

using geom::Vec2;
using geom::Vec3;

std::vector<Disc> discs_of(const LeftBody& b) {
    std::vector<Vec3> tips{b.corner};
    for (const Vec3& edge : b.edges) {
        if (edge == Vec3{}) continue;
        const std::size_t n = tips.size();
        for (std::size_t i = 0; i < n; ++i) tips.push_back(tips[i] + edge);
    }
    std::vector<Disc> discs;
    for (const Vec3& tip : tips) {
        if (b.profile.empty()) discs.push_back({tip, 0});
        for (const Vec2& at : b.profile) discs.push_back({tip + at.y * b.axis, at.x});
    }
    return discs;
}

Vec3 middle_of(const LeftBody& b) {
    Vec3 middle = b.corner + 0.5 * (b.edges[0] + b.edges[1] + b.edges[2]);
    if (!b.profile.empty()) middle = middle + (0.5 * (b.profile.front().y + b.profile.back().y)) * b.axis;
    return middle;
}

double widest(const LeftBody& b) {
    double r = 0;
    for (const Vec2& at : b.profile) r = std::max(r, at.x);
    return r;
}

double radius_of(const LeftBody& b, double height) {
    for (std::size_t i = 1; i < b.profile.size(); ++i) {
        const Vec2 low = b.profile[i - 1], high = b.profile[i];
        if (height > high.y || !(high.y - low.y > thin_piece)) continue;
        return low.x + (high.x - low.x) * std::clamp((height - low.y) / (high.y - low.y), 0.0, 1.0);
    }
    return b.profile.back().x;
}

std::vector<std::array<LeftBody, 2>> halves_of(const LeftBody& b) {
    std::vector<std::array<LeftBody, 2>> all;
    for (std::size_t k = 0; k < 3; ++k) {
        if (!(geom::length(b.edges[k]) > thin_piece)) continue;
        std::array<LeftBody, 2> two{b, b};
        two[0].edges[k] = two[1].edges[k] = 0.5 * b.edges[k];
        two[1].corner = two[1].corner + two[0].edges[k];
        all.push_back(std::move(two));
    }
    if (b.profile.size() < 2 || !(b.profile.back().y - b.profile.front().y > thin_piece)) return all;
    const double middle = 0.5 * (b.profile.front().y + b.profile.back().y);
    std::array<LeftBody, 2> two{b, b};
    two[0].profile.clear(), two[1].profile.clear();
    for (std::size_t i = 0; i < b.profile.size(); ++i) {
        const Vec2 at = b.profile[i];
        if (i > 0 && b.profile[i - 1].y < middle && at.y >= middle) {
            const Vec2 low = b.profile[i - 1];
            const Vec2 cut{low.x + (at.x - low.x) * (middle - low.y) / (at.y - low.y), middle};
            two[0].profile.push_back(cut);
            two[1].profile.push_back(cut);
        }
        if (at.y < middle) two[0].profile.push_back(at);
        if (at.y > middle) two[1].profile.push_back(at);
    }
    for (const LeftBody& half : two)
        if (half.profile.empty()) return all;
    all.push_back(std::move(two));
    return all;
}

LeftBody boxed(const LeftBody& b) {
    const double r = widest(b), low = b.profile.front().y, high = b.profile.back().y;
    LeftBody box;
    box.axis = b.axis;
    const Vec3 way = b.edges[0];
    const double rise = geom::dot(way, b.axis);
    const Vec3 flat = way - rise * b.axis;
    const double size = geom::length(flat);
    const milling::Orientation frame = milling::orientation_of(b.axis);
    const Vec3 along = size > thin_piece ? (1 / size) * flat : frame.x;
    const Vec3 across = geom::cross(b.axis, along);
    const double slope = size > thin_piece ? rise / size : 0;  // the box leans with the way
    const Vec3 leaning = along + slope * b.axis;
    const double more = std::abs(slope) * r, straight_up = size > thin_piece ? 0 : rise;
    box.edges = {(size + 2 * r) * leaning, 2 * r * across, (high - low + 2 * more + std::abs(straight_up)) * b.axis};
    box.corner = b.corner - r * leaning - r * across + (low - more + std::min(0.0, straight_up)) * b.axis;
    return box;
}

}  // namespace obrys::check
