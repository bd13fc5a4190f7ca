#pragma once
/// Which modal words exclude each other in a block: a control lets a block say one word of a group.
/// Sources: SINUMERIK 840D sl Programming Manual Job Planning, "G functions / preparatory functions" (groups 1, 2, 6 …
/// 15); FANUC Operator's Manual, "Preparatory function", list of groups; LinuxCNC, G-code overview, "Modal groups".

#include <cstdint>

#include "program/word.hpp"

namespace obrys::program {

enum class ModalGroup : std::uint8_t {
    none,  ///< may stand beside any other
    motion,
    once,  ///< acts in its block alone and takes the block's words
    plane,
    compensation,
    datum,
    suppression,
    unit,
    dimension,
    centre,
    feed,
    retract,
    tool_length,
    path,
    diameter,
    approach,
    corner,
    scaling,
    rotation,
    polar,
};

/// Group of a motion word, or `none`.
[[nodiscard]] constexpr ModalGroup motion_group(Modal m) {
    if (m <= Modal::tap_retract) return ModalGroup::motion;
    switch (m) {
        case Modal::canned:
        case Modal::probe:
        case Modal::nurbs: return ModalGroup::motion;
        case Modal::dwell:
        case Modal::reference_point:
        case Modal::fixed_point:
        case Modal::pole_from_position:
        case Modal::pole_from_zero:
        case Modal::pole_from_pole:
        case Modal::set_data:
        case Modal::position_becomes:
        case Modal::local_shift:
        case Modal::home:
        case Modal::home_store:
        case Modal::rigid_tap:
        case Modal::spline_cubic:
        case Modal::spline_quadratic:
        case Modal::turning_cycle:
        case Modal::circle_pocket: return ModalGroup::once;
        default: return ModalGroup::none;
    }
}

[[nodiscard]] constexpr ModalGroup group_of(Modal m) {
    if (const ModalGroup g = motion_group(m); g != ModalGroup::none) return g;
    switch (m) {
        case Modal::plane_xy:
        case Modal::plane_zx:
        case Modal::plane_yz: return ModalGroup::plane;
        case Modal::compensation_off:
        case Modal::compensation_left:
        case Modal::compensation_right:
        case Modal::compensation_left_by:
        case Modal::compensation_right_by: return ModalGroup::compensation;
        case Modal::datum:
        case Modal::datum_extended: return ModalGroup::datum;
        case Modal::suppress_frames:
        case Modal::suppress_all: return ModalGroup::suppression;
        case Modal::inch_geometry:
        case Modal::metric_geometry:
        case Modal::inch_all:
        case Modal::metric_all: return ModalGroup::unit;
        case Modal::absolute:
        case Modal::incremental: return ModalGroup::dimension;
        case Modal::arc_centre_absolute:
        case Modal::arc_centre_incremental: return ModalGroup::centre;
        case Modal::feed_inverse_time:
        case Modal::feed_per_minute:
        case Modal::feed_per_rev: return ModalGroup::feed;
        case Modal::retract_initial:
        case Modal::retract_clearance: return ModalGroup::retract;
        case Modal::tool_length:
        case Modal::tool_length_negative:
        case Modal::tool_length_by_axes:
        case Modal::tool_length_added:
        case Modal::tool_length_off: return ModalGroup::tool_length;
        case Modal::path_exact:
        case Modal::path_stop:
        case Modal::path_blend: return ModalGroup::path;
        case Modal::diameter_on:
        case Modal::diameter_off:
        case Modal::diameter_absolute_only: return ModalGroup::diameter;
        case Modal::approach_normal:
        case Modal::approach_contour: return ModalGroup::approach;
        case Modal::corner_arc:
        case Modal::corner_intersection: return ModalGroup::corner;
        case Modal::scaling_on:
        case Modal::scaling_off: return ModalGroup::scaling;
        case Modal::rotation_on:
        case Modal::rotation_off: return ModalGroup::rotation;
        case Modal::polar_on:
        case Modal::polar_off: return ModalGroup::polar;
        default: return ModalGroup::none;
    }
}

}  // namespace obrys::program
