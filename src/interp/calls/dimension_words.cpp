/// Words of plane, unit, absolute and incremental dimensions, zeros and lengths.

#include "base/codes.hpp"
#include "interp/calls/calls.hpp"

namespace obrys::interp {

namespace {

bool names_axes(const BlockWords& b) { return (b.present & (linear_axes | other_axes)) != 0; }

}  // namespace

void set_plane(Moving& run, int plane) {
    hear(run, heard::Plane{plane});
    if (run.modal.plane == plane) return;
    run.block.changes_plane = true;
    flush_path(run);
    run.modal.plane = plane;
    forget_polar_angle(run.modal);
}

void change_plane(Moving& run, int plane) {
    if (plane != run.modal.plane) leave_compensation(run, "the working plane changes");
    run.modal.plane_said = true;
    if (run.stopped) return;
    set_plane(run, plane);
    say_length_axis(run);
}

namespace {

bool names_axis(const Moving& run) {
    for (std::size_t k = 0; k < 9; ++k)
        if (run.block.has(axis_code(static_cast<int>(k)))) return true;
    return false;
}

}  // namespace

bool offset_word(Moving& run, Modal m, int number) {
    BlockWords& b = run.block;
    switch (m) {
        case Modal::tool_length_added:
            if (!b.has(Code::offset_h) && names_axis(run)) b.special = Modal::tool_length_by_axes;
            tool_length_words(run, m);
            return true;
        case Modal::tool_length_by_axes: b.special = m; [[fallthrough]];
        case Modal::tool_length:
        case Modal::tool_length_negative:
        case Modal::tool_length_off: tool_length_words(run, m); return true;
        case Modal::set_data:
            b.special = m;
            set_data(run, static_cast<program::DataTable>(number));
            return true;
        case Modal::position_becomes:
        case Modal::local_shift: b.special = m; [[fallthrough]];
        case Modal::position_reset:
            if (run.traits->position_reset_names_axes && names_axes(b)) b.special = m;
            [[fallthrough]];
        case Modal::position_suspend:
        case Modal::position_restore: shift_words(run, m); return true;
        case Modal::scaling_on:
        case Modal::scaling_off:
        case Modal::mirror_on:
        case Modal::mirror_off:
        case Modal::rotation_on:
        case Modal::rotation_off:
            b.special = m;
            transform_about_centre(run, m);
            return true;
        case Modal::home:
            b.special = m;
            b.special_number = number;
            return true;
        case Modal::home_store:
            b.special_number = number;
            store_home(run);
            return true;
        default: return false;
    }
}

namespace {

/// Sources: FANUC B-63944EN/02 page 192: at the beginning of the program, not to be switched during it; Haas: must be
/// what Setting 9 says (96-8000, G20/G21).
/// HEIDENHAIN: the head says the unit of the whole program. `inside`: a G70 or G71 elsewhere.
void say_changed_unit(Telling& run, bool changes, bool inside) {
    const bool in_use = run.moved && (run.modal.unit_said || run.feed_valid);  // G28 before the first G21 is usual
    run.modal.unit_said = true;
    if (!changes || !in_use || (!inside && !run.traits->unit_before_motion)) return;
    unchecked(run, base::codes::unsupported, run.here(),
              "the unit of length changes behind moves, which this control does not allow: what its offsets then mean "
              "is not known",
              "say the unit at the beginning of the program, before it moves");
}

}  // namespace

bool dimension_word(Telling& run, Modal m, int number) {
    ModalState& state = run.modal;
    switch (m) {
        case Modal::arc_centre_absolute:
        case Modal::arc_centre_incremental:
            if (state.centre_absolute != (m == Modal::arc_centre_absolute))
                hear(run, heard::Increments{m == Modal::arc_centre_incremental, true});
            state.centre_absolute = m == Modal::arc_centre_absolute;
            return true;
        case Modal::inch_geometry: state.inch_geometry = true; return true;
        case Modal::metric_geometry: state.inch_geometry = state.metric_feed = false; return true;
        case Modal::inch_all:
            say_changed_unit(run, !state.inch_geometry, number == program::unit_inside);
            state.inch_geometry = state.inch_feed = true;
            hear(run, heard::Unit{true});
            return true;
        case Modal::metric_all:
            say_changed_unit(run, state.inch_geometry, number == program::unit_inside);
            state.inch_geometry = state.inch_feed = false;
            state.metric_feed = true;
            hear(run, heard::Unit{false});
            return true;
        case Modal::absolute:
        case Modal::incremental:
            if (state.absolute != (m == Modal::absolute)) hear(run, heard::Increments{m == Modal::incremental, false});
            state.absolute = m == Modal::absolute;
            return true;
        case Modal::diameter_on:
        case Modal::diameter_off:
            if ((state.diameter == DiameterMode::on) != (m == Modal::diameter_on))
                hear(run, heard::Diameters{m == Modal::diameter_on});
            state.diameter = m == Modal::diameter_on ? DiameterMode::on : DiameterMode::off;
            return true;
        case Modal::diameter_absolute_only: state.diameter = DiameterMode::absolute_only; return true;
        default: return false;
    }
}

void hold_plane(Reckoning& run) {
    if (run.traits->compensation_holds_plane.empty() || run.modal.compensation == Modal::compensation_off) return;
    alarm(run, base::codes::compensation, run.here(),
          "the plane changes while radius compensation is on" + of_alarm(run.traits->compensation_holds_plane),
          "write G40 before it");
}

}  // namespace obrys::interp
