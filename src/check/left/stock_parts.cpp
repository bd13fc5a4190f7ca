#include "check/left/stock_parts.hpp"

#include <algorithm>
#include <cmath>

#include "base/whole.hpp"
#include "check/certify_shapes.hpp"
#include "check/left/cuts.hpp"

namespace obrys::check {

namespace milling = sim::milling;

using geom::Vec2;
using geom::Vec3;

namespace {

constexpr double most_way_chords = 4096;  ///< of one way

/// Points around a round piece, so that their hull holds it and stands off by no more than `off`.
void add_round_hull(std::vector<Vec2>& profile, const milling::Piece& p, double off) {
    const auto angle_at = [&](double z) { return std::asin(std::clamp((z - p.centre) / p.arc, -1.0, 1.0)); };
    const double from = angle_at(p.z0), to = angle_at(p.z1), step = 2 * std::acos(p.arc / (p.arc + off));
    const auto n = base::clipped<std::size_t>(std::ceil((to - from) / step), 1, 1000);
    const double turn = (to - from) / static_cast<double>(n), far = p.arc / std::cos(turn / 2);
    profile.push_back({p.r0, p.z0});
    for (std::size_t i = 0; i < n; ++i) {
        const double at = from + (static_cast<double>(i) + 0.5) * turn;
        profile.push_back({p.ring + far * std::cos(at), std::clamp(p.centre + far * std::sin(at), p.z0, p.z1)});
    }
    profile.push_back({p.r1, p.z1});
}

}  // namespace

StockPart stock_part_of(const milling::Shape& shape, double off, double certified) {
    StockPart part{certified_shape(shape, certified), {}, shape.radius, shape.bottom, shape.top};
    for (std::size_t first = 0; first < shape.pieces.size();) {
        const std::size_t end = convex_end(shape.pieces, first);
        std::vector<Vec2> profile;
        for (; first < end; ++first) {
            const milling::Piece& p = shape.pieces[first];
            if (p.kind == milling::PieceKind::round) {
                add_round_hull(profile, p, off);
                continue;
            }
            profile.push_back({p.r0, p.z0});
            profile.push_back({p.r1, p.z1});
        }
        profile.erase(std::unique(profile.begin(), profile.end()), profile.end());
        part.profiles.push_back(std::move(profile));
    }
    return part;
}

std::size_t chords_of(const geom::PathElement& path, double off) {
    double bend = 0;
    if (const auto* c = std::get_if<geom::Circular>(&path)) {
        const Vec3 out = c->from - c->centre;
        bend = c->sweep * c->sweep * geom::length(out);
    } else if (const auto* k = std::get_if<geom::Cubic>(&path)) {
        bend = std::max(geom::length(2.0 * k->k2), geom::length(2.0 * k->k2 + 6.0 * k->k3));
    }
    return base::clipped<std::size_t>(std::ceil(std::sqrt(bend / (8 * off))), 1,
                                      static_cast<std::size_t>(most_way_chords));
}

std::vector<Vec2> clipped(const std::vector<Vec2>& profile, double low, double high) {
    std::vector<Vec2> part;
    for (std::size_t i = 0; i < profile.size(); ++i) {
        const Vec2 at = profile[i];
        for (const double z : {low, high}) {
            if (i == 0 || !(profile[i - 1].y < z && at.y > z)) continue;
            const Vec2 before = profile[i - 1];
            part.push_back({before.x + (at.x - before.x) * (z - before.y) / (at.y - before.y), z});
        }
        if (at.y >= low && at.y <= high) part.push_back(at);
    }
    return part;
}

}  // namespace obrys::check
