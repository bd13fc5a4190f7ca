#include "sim/milling/cutter.hpp"

#include <algorithm>
#include <cmath>

#include "sim/milling/profile.hpp"

namespace obrys::sim::milling {
namespace {

using Pieces = std::vector<Piece>;

constexpr double thinnest_piece = 1e-9;  ///< mm

void add(Pieces& pieces, const Piece& piece) {
    if (piece.z1 - piece.z0 > thinnest_piece) pieces.push_back(piece);
}

bool positive(double v) { return v > 0 && std::isfinite(v); }

std::string problem_of(const Cutter& c) {
    if (c.kind == CutterKind::form) return {};
    if (!positive(c.diameter)) return "the diameter is not positive";
    if (c.kind == CutterKind::t_slot) {
        if (!positive(c.width)) return "the width of the disc is not positive";
        if (!(c.neck_diameter >= 0 && c.neck_diameter < c.diameter)) return "the neck is not thinner than the disc";
        if (!(c.corner_radius >= 0 && 2 * c.corner_radius <= c.width && 2 * c.corner_radius <= c.diameter))
            return "the corner radius does not fit the disc";
        return {};
    }
    if (!positive(c.cutting_length)) return "the cutting length is not positive";
    if (c.kind == CutterKind::bull_nose && !(c.corner_radius >= 0 && 2 * c.corner_radius <= c.diameter))
        return "the corner radius is negative or larger than the radius";
    const bool pointed = c.kind == CutterKind::countersink || c.kind == CutterKind::chamfer;
    if (pointed && !(c.tip_diameter >= 0 && c.tip_diameter < c.diameter)) return "the tip is not thinner than the tool";
    if (pointed && !(c.point_angle > 0 && c.point_angle < geom::pi - 1e-6))
        return "the point angle is not between 0 and 180 degrees";
    if (c.kind == CutterKind::drill && !(c.point_angle > 0 && c.point_angle <= geom::pi + 1e-12))
        return "the point angle is not between 0 and 180 degrees";
    return {};
}

/// Round corner, then straight up.
Pieces nose(double radius, double corner, double length) {
    Pieces pieces;
    const double end = std::min(corner, length);
    if (corner > thinnest_piece) add(pieces, round(0, end, std::max(0.0, radius - corner), corner, corner));
    add(pieces, cylinder(end, length, radius));
    return pieces;
}

Pieces point(double tip, double radius, double angle, double length) {
    Pieces pieces;
    const double height = (radius - tip) / std::tan(angle / 2), end = std::min(height, length);
    if (height > thinnest_piece) add(pieces, cone(0, end, tip, tip + (radius - tip) * (end / height)));
    add(pieces, cylinder(std::max(0.0, end), length, radius));
    return pieces;
}

Pieces disc(const Cutter& c) {
    Pieces pieces;
    const double r = c.diameter / 2, corner = c.corner_radius, ring = std::max(0.0, r - corner);
    if (corner > thinnest_piece) add(pieces, round(0, corner, ring, corner, corner));
    add(pieces, cylinder(corner, c.width - corner, r));
    if (corner > thinnest_piece) add(pieces, round(c.width - corner, c.width, ring, c.width - corner, corner));
    return pieces;
}

Pieces cutting_part(const Cutter& c, std::string& problem) {
    const double r = c.diameter / 2;
    switch (c.kind) {
        case CutterKind::end_mill: return {cylinder(0, c.cutting_length, r)};
        case CutterKind::ball: return nose(r, r, c.cutting_length);
        case CutterKind::bull_nose: return nose(r, c.corner_radius, c.cutting_length);
        case CutterKind::drill: return point(0, r, c.point_angle, c.cutting_length);
        case CutterKind::countersink:
        case CutterKind::chamfer: return point(c.tip_diameter / 2, r, c.point_angle, c.cutting_length);
        case CutterKind::t_slot: return disc(c);
        case CutterKind::form: return pieces_of_profile(c.profile, c.deviation, problem);
    }
    return {};
}

/// Stacks bodies from `z` upwards; moves `z` to their end.
Pieces stack(const std::vector<Body>& bodies, double& z, std::string& problem) {
    Pieces pieces;
    for (const Body& b : bodies) {
        if (!positive(b.length) || !(b.lower_diameter >= 0) || !(b.upper_diameter >= 0) ||
            !positive(b.lower_diameter + b.upper_diameter)) {
            problem = "a shank or holder has a dimension that is not positive";
            return {};
        }
        pieces.push_back(cone(z, z + b.length, b.lower_diameter / 2, b.upper_diameter / 2));
        z += b.length;
    }
    return pieces;
}

}  // namespace

MadeShape shape_of(const Cutter& cutter) {
    MadeShape made;
    made.problem = problem_of(cutter);
    if (!made.ok()) return made;
    Pieces cutting = cutting_part(cutter, made.problem);
    if (made.ok() && cutting.empty()) made.problem = "the dimensions make no tool";
    if (!made.ok()) return made;
    double z = cutting.back().z1;
    made.shape.cutting = make_shape(std::move(cutting));
    std::vector<Body> shank = cutter.shank;
    if (cutter.kind == CutterKind::t_slot && cutter.neck_diameter > 0 && cutter.cutting_length > cutter.width)
        shank.insert(shank.begin(),
                     Body{cutter.neck_diameter, cutter.neck_diameter, cutter.cutting_length - cutter.width});
    made.shape.shank = make_shape(stack(shank, z, made.problem));
    made.shape.holder = make_shape(stack(cutter.holder, z, made.problem));
    return made;
}

double smallest_radius(const ToolShape& shape, double tolerance) {
    double smallest = shape.cutting.radius;
    for (const Piece& p : shape.cutting.pieces) {
        const double own = p.kind == PieceKind::round ? p.arc : std::max(p.r0, p.r1);
        const bool counts = p.kind == PieceKind::round ? (own - 1e-12 > 0 && own * 0.41421356 > tolerance)
                                                       : own * 0.41421356 > tolerance;
        if (counts) smallest = std::min(smallest, own);
    }
    return smallest;
}

}  // namespace obrys::sim::milling
