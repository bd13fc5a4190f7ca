#include "sim/milling/shape.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace obrys::sim::milling {
namespace {

constexpr double same_size = 1e-12;  ///< mm

/// The whole ball, or disc with a round rim, stays inside the piece and cylinders above and below it.
void find_whole(std::vector<Piece>& pieces) {
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        Piece& p = pieces[i];
        if (p.kind != PieceKind::round) continue;
        const auto hides = [&](std::size_t n, double reach) {
            const Piece& other = pieces[n];
            return other.z1 - other.z0 >= reach - same_size && other.kind == PieceKind::cone &&
                   std::min(other.r0, other.r1) >= p.ring + p.arc - same_size;
        };
        const double above = p.centre + p.arc - p.z1, below = p.z0 - (p.centre - p.arc);
        p.whole = (above <= same_size || (i + 1 < pieces.size() && p.z1 <= p.centre + same_size &&
                                          p.z1 >= p.centre - same_size && hides(i + 1, above))) &&
                  (below <= same_size ||
                   (i > 0 && p.z0 >= p.centre - same_size && p.z0 <= p.centre + same_size && hides(i - 1, below)));
    }
}

/// From a piece's side alone, gone on with beyond its ends.
double beside(const Piece& piece, geom::Vec3 p, geom::Vec3& normal) {
    const double distance = std::sqrt(p.x * p.x + p.y * p.y);  // in the innermost loops; hypot takes five times as long
    const geom::Vec3 out = distance > 0 ? geom::Vec3{p.x / distance, p.y / distance, 0} : geom::Vec3{1, 0, 0};
    if (piece.kind == PieceKind::cone) {
        const double rise = piece.z1 - piece.z0, growth = piece.r1 - piece.r0, slant = std::hypot(rise, growth);
        normal = (rise / slant) * out + geom::Vec3{0, 0, -growth / slant};
        return ((distance - piece.r0) * rise - (p.z - piece.z0) * growth) / slant;
    }
    const double beyond = std::max(0.0, distance - piece.ring), h = p.z - piece.centre,
                 far = std::sqrt(beyond * beyond + h * h);
    normal = far > 0 ? (beyond / far) * out + geom::Vec3{0, 0, h / far} : geom::Vec3{0, 0, -1};
    return far - piece.arc;
}

void beyond_ends(double low, double high, double z, double& outside, geom::Vec3& normal) {
    if (low - z > outside) outside = low - z, normal = {0, 0, -1};
    if (z - high > outside) outside = z - high, normal = {0, 0, 1};
}

}  // namespace

Piece cylinder(double z0, double z1, double r) { return cone(z0, z1, r, r); }

Piece cone(double z0, double z1, double r0, double r1) {
    Piece p;
    p.z0 = z0;
    p.z1 = z1;
    p.r0 = r0;
    p.r1 = r1;
    return p;
}

Piece round(double z0, double z1, double ring, double centre, double arc) {
    Piece p;
    p.kind = PieceKind::round;
    p.z0 = z0;
    p.z1 = z1;
    p.ring = ring;
    p.centre = centre;
    p.arc = arc;
    p.r0 = radius_at(p, z0);
    p.r1 = radius_at(p, z1);
    return p;
}

double radius_at(const Piece& piece, double z) {
    if (piece.kind == PieceKind::cone)
        return piece.r0 == piece.r1 ? piece.r0
                                    : piece.r0 + (piece.r1 - piece.r0) * ((z - piece.z0) / (piece.z1 - piece.z0));
    const double h = z - piece.centre;
    return piece.ring + std::sqrt(std::max(0.0, piece.arc * piece.arc - h * h));
}

std::size_t convex_end(const std::vector<Piece>& pieces, std::size_t first) {
    constexpr double same_place = 1e-9;  // mm
    const auto steepness = [](const Piece& p, double z) {
        if (p.kind == PieceKind::cone) return (p.r1 - p.r0) / (p.z1 - p.z0);
        const double h = z - p.centre, across = std::sqrt(std::max(0.0, p.arc * p.arc - h * h));
        return across > 0 ? -h / across : -std::copysign(std::numeric_limits<double>::infinity(), h);
    };
    std::size_t end = first + 1;
    for (; end < pieces.size(); ++end) {
        const Piece &low = pieces[end - 1], &high = pieces[end];
        if (std::abs(low.r1 - high.r0) > same_place || std::abs(low.z1 - high.z0) > same_place) break;
        if (!(steepness(high, high.z0) <= steepness(low, low.z1) + same_place)) break;
    }
    return end;
}

double widest_between(const Piece& piece, double low, double high) {
    low = std::max(low, piece.z0);
    high = std::min(high, piece.z1);
    if (!(low <= high)) return -1;
    if (piece.kind == PieceKind::cone) return std::max(radius_at(piece, low), radius_at(piece, high));
    return radius_at(piece, std::clamp(piece.centre, low, high));
}

std::optional<Heights> heights_at(const Piece& piece, double distance) {
    Heights h{piece.z0, piece.z1};
    if (piece.kind == PieceKind::cone) {
        if (distance > std::max(piece.r0, piece.r1)) return std::nullopt;
        if (distance <= std::min(piece.r0, piece.r1)) return h;
        const double z = piece.z0 + (piece.z1 - piece.z0) * ((distance - piece.r0) / (piece.r1 - piece.r0));
        (piece.r1 > piece.r0 ? h.low : h.high) = z;
        return h;
    }
    const double beyond = std::max(0.0, distance - piece.ring);
    if (beyond > piece.arc) return std::nullopt;
    const double half = std::sqrt(piece.arc * piece.arc - beyond * beyond);
    h.low = std::max(h.low, piece.centre - half);
    h.high = std::min(h.high, piece.centre + half);
    if (h.low > h.high) return std::nullopt;
    return h;
}

double outside(const Piece& piece, geom::Vec3 p, geom::Vec3& normal) {
    double side = beside(piece, p, normal);
    if (!piece.whole) beyond_ends(piece.z0, piece.z1, p.z, side, normal);
    return side;
}

double outside(const Bridge& bridge, geom::Vec3 p, geom::Vec3& normal) {
    geom::Vec3 other;
    double side = beside(bridge.lower, p, normal);
    if (const double above = beside(bridge.upper, p, other); above > side) side = above, normal = other;
    beyond_ends(bridge.lower.z0, bridge.upper.z1, p.z, side, normal);
    return side;
}

Shape make_shape(std::vector<Piece> pieces) {
    Shape shape;
    find_whole(pieces);
    shape.rising = !pieces.empty();
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        Piece& p = pieces[i];
        p.covered = i > 0 && pieces[i - 1].r1 >= p.r0 - same_size && std::abs(pieces[i - 1].z1 - p.z0) <= same_size;
        shape.radius = std::max(shape.radius, widest_between(p, p.z0, p.z1));
        const bool grows = p.r1 >= widest_between(p, p.z0, p.z1) - same_size;
        const bool continues =
            i == 0 || (p.r0 >= pieces[i - 1].r1 - same_size && std::abs(pieces[i - 1].z1 - p.z0) <= same_size);
        shape.rising = shape.rising && grows && continues;
    }
    if (!pieces.empty()) {
        shape.bottom = pieces.front().z0;
        shape.top = pieces.back().z1;
    }
    for (std::size_t i = 0; i + 1 < pieces.size(); ++i) shape.bridges.push_back({pieces[i], pieces[i + 1]});
    shape.pieces = std::move(pieces);
    return shape;
}

double widest_between(const Shape& shape, double low, double high) {
    double widest = -1;
    for (const Piece& p : shape.pieces) widest = std::max(widest, widest_between(p, low, high));
    return widest;
}

double lower_side(const Shape& shape, double distance) {
    double low = std::numeric_limits<double>::infinity();
    for (const Piece& p : shape.pieces)
        if (const auto h = heights_at(p, distance)) low = std::min(low, h->low);
    return low;
}

}  // namespace obrys::sim::milling
