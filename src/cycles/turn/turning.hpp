#pragma once
/// One call of a turning cycle -> the steps the tool makes: contour cycles, threads, grooves, single cuts.
///
/// Coordinates: (u, v, w) of G18: u = Z along the axis of rotation, v = X as a radius, w = Y, which stays as it is. All
/// lengths in mm, those in X as radii; angles in degrees. Arcs turn positive from Z towards X (G3 in G18). Every kind:
/// the moves run at the feed in force; a Feed is written only where an element of the contour brings one.
///
/// Roles (needed ones first, / not needed, with what holds otherwise):
///
///   LinuxCNC 2.9. length_unit (mm per unit of the program; 1) matters to the tolerances inside.
///   lathe_finish_offset   G70: / target_u, target_v (where the tool stands), allowance_first D (0), allowance_last E
///                         (0), passes P (1). The distances lie on the side of the start point.
///   lathe_rough_along     G71, G71.1, G71.2: / target_u, target_v, infeed I (1 unit), escape R (0.5 units),
///                         allowance_side D (0), offset_u W (0), offset_v U (0), pockets: 0 for .0, 1 for .1, 2 for .2.
///   lathe_rough_across    G72, G72.1, G72.2: as above.
///   lathe_thread_degressive  G76: target_u Z, pitch P (negative as written), crest_offset I, first_depth J,
///                         thread_depth K / target_v X (where the tool stands), degression R (1), infeed_angle Q (0),
///                         spring_passes H (0), taper_length E (0), taper_ends L (0).
///
///   Fanuc. The tool stands at the start point A; the contour's first element leads from there to the contour's start.
///   lathe_finish          G70: -
///   lathe_remove_along    G71: infeed U, escape R / allowance_u W, allowance_v U/2 (signed, 0), pockets 1: type II;
///                         relief_u, relief_v (0): what the cuts leave for the last pass (Haas K, I).
///   lathe_remove_across   G72: infeed W, escape R / as above.
///   lathe_repeat_pattern  G73: relief_u W, relief_v U, passes R / allowance_u, allowance_v.
///   lathe_peck_along      G74: target_u Z, infeed Q / target_v X, stepover P, escape R(e) (0), relief R(d) (0).
///   lathe_peck_across     G75: target_v X, infeed P / target_u Z, stepover Q, escape R(e) (0), relief R(d) (0).
///   lathe_thread_passes   G76: target_u Z, target_v X (root), pitch F, thread_depth P, first_depth Q / taper_v R (0),
///                         min_infeed Q (0), finish_allowance R (0), finish_passes m (1), infeed_angle a/2 (0), runout
///                         (0) or runout_leads (0), infeed_method (1),
///                         spindle_angle (0): where its passes begin.
///   lathe_box_along       G90: target_u, target_v / taper_v R (0).
///   lathe_box_thread      G92: target_u, target_v, pitch / taper_v R (0), runout (0).
///   lathe_box_across      G94: target_u, target_v / taper_u R (0).
///
/// Sources: LinuxCNC 2.9, G code chapter and its interpreter (facts; checked call by call against its expected test
/// results and what its stand-alone form prints). Robur Line F1, concise guide to its Fanuc control (G71); ADTECH 4620
/// programming manual (G75: no relief at the first peck); the other sequences of the Fanuc kind are from memory of the
/// 0i-TD operator's manual, functions to simplify programming, not found again in the sources at hand. What is left
/// open is named in Expansion::assumption.

#include <optional>
#include <span>
#include <vector>

#include "cycles/cycle.hpp"

namespace obrys::cycles {

/// One element of the contour; it begins where the one before ended, the first where the tool stands (LinuxCNC: at
/// target_u, target_v).
struct TurningElement {
    geom::Vec2 to;                   ///< (Z, X radius)
    geom::Vec2 centre{};             ///< of an arc, absolute
    int turn = 0;                    ///< 0 line, +1 counter-clockwise (G3), -1 clockwise (G2)
    bool rapid = false;              ///< written with G0
    double fillet = 0;               ///< radius at the corner after it; 0 none (LinuxCNC: A)
    double chamfer = 0;              ///< as above, chamfer (LinuxCNC: C)
    std::optional<cl::Feed> feed{};  ///< from this element on (finishing)
};

struct TurningDemand {
    Demand cycle;
    std::vector<TurningElement> contour;  ///< of the contour cycles
    Situation situation;
};

[[nodiscard]] bool is_turning_cycle(cl::CycleKind kind);
/// What a call of the kind can say (contours.hpp, cuts.hpp); nothing of another kind.
[[nodiscard]] std::span<const cl::CycleRole> roles_of_turning(cl::CycleKind kind);
/// As `expand` for the kinds of this header.
[[nodiscard]] Expansion expand_turning(const TurningDemand& demand);

}  // namespace obrys::cycles
