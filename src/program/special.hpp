#pragma once
/// Blocks of a kind of their own, whose data only they have: approach and departure, free contours, splines, planes.

#include <cstdint>
#include <vector>

#include "base/source.hpp"
#include "program/expr.hpp"

namespace obrys::program {

enum class SpecialKind : std::uint8_t {
    // Smooth approach and departure: by a line on the tangent, a line on the normal, an arc, an arc with a line.
    approach_tangent,
    approach_normal,
    approach_arc,
    approach_arc_line,
    departure_tangent,
    departure_normal,
    departure_arc,
    departure_arc_line,
    // Free contour.
    free_pole,
    free_line,
    free_line_tangential,
    free_arc,
    free_arc_tangential,
    free_select,
    spline,
    // Tilted working plane.
    plane_spatial,
    plane_projected,
    plane_euler,
    plane_vector,
    plane_points,
    plane_relative,
    plane_axial,
    plane_reset,
    plane_roll_pitch_yaw,  ///< about X, Y, Z: whether as they stand or as the turns before have left them is not known
    plane_of_axes,         ///< as the rotary axes stand (Haas G254)
    plane_not_said,        ///< a form that is not run: which plane holds from here on is not known
    plane_taken_up,        ///< no plane: the rotary axes turn to the one in force (G53.1)
};

enum class Datum : std::uint8_t {
    length,
    radius,
    centre_angle,  ///< LEN, R, CCA
    x,
    y,
    polar_radius,
    polar_angle,
    gradient,  ///< AN
    sense,     ///< DR: +1 or -1
    centre_x,
    centre_y,
    centre_radius,
    centre_polar_angle,  ///< CCX CCY CCPR CCPA
    point1_x,
    point1_y,
    point2_x,
    point2_y,
    point3_x,
    point3_y,
    beside_x,
    beside_y,
    beside_distance,    ///< PDX PDY D
    parallel,           ///< PAR: number of a block
    parallel_distance,  ///< DP
    closed,             ///< CLSD: +1 begins, -1 ends
    // RX RY RPR RPA RAN RCCX RCCY RCCPR RCCPA: the block to which the value of the same name refers.
    block_of_x,
    block_of_y,
    block_of_polar_radius,
    block_of_polar_angle,
    block_of_gradient,
    block_of_centre_x,
    block_of_centre_y,
    block_of_centre_radius,
    block_of_centre_angle,
    number,  ///< FSELECT
    // Spline: coefficients of an axis; the axis follows from `axis`.
    k1,
    k2,
    k3,
    // Plane: SPA SPB SPC, PROPR PROMIN ROT, EULPR EULNU EULROT, BX BY BZ NX NY NZ, P1X …, A B C.
    angle_a,
    angle_b,
    angle_c,
    vector_x,
    vector_y,
    vector_z,
    normal_x,
    normal_y,
    normal_z,
    point1_z,
    point2_z,
    point3_z,
    origin_x,
    origin_y,
    origin_z,
    order,        ///< of angles about the fixed axes: 123 X, Y, Z
    positioning,  ///< 0 STAY, 1 MOVE, 2 TURN, 3 by a word of its own that is still to come, 4 the tool stands on it
                  ///< whoever turns the axes (CL data)
    side,         ///< SEQ +1, -1
    distance,     ///< DIST of MOVE
    table_turns,  ///< 1: TABLE ROT, 0: COORD ROT
};

struct DatumValue {
    Datum datum = Datum::length;
    ExprId value = no_expr;
    bool incremental = false;
    char axis = 0;  ///< letter, of k1 … k3
    base::Span where;
};

struct Special {
    SpecialKind kind = SpecialKind::spline;
    std::vector<DatumValue> data;
    std::uint32_t block_number = 0;  ///< as other blocks refer to it; 0 where it has none
    base::Span where;
};

}  // namespace obrys::program
