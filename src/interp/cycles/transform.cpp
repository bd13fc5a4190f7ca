/// Cycles that act at their definition: datum shift, mirror, rotation, scaling, dwell and the like.

#include <algorithm>
#include <cmath>

#include "base/codes.hpp"
#include "interp/cycles/cycles.hpp"
#include "interp/setup/tilted_axes.hpp"

namespace obrys::interp {

namespace codes = base::codes;
using cl::CycleKind;
using cl::CycleRole;

namespace {

/// Value of a role, scaled to millimetres where it is a length; `set` says whether it was written.
struct Written {
    bool set = false, incremental = false;
    double value = 0;
};

Written written_value(const Reckoning& run, const ActiveCycle& c, CycleRole role) {
    Written w;
    for (std::size_t i = 0; i < c.values.size(); ++i) {
        const program::CycleSetting& s = c.definition->settings[i];
        if (s.role != role) continue;
        w = {true, s.incremental || (s.as_modal && !run.modal.absolute),
             c.values[i] * (s.scales ? length_unit(run.modal) : 1)};
    }
    return w;
}

constexpr CycleRole axis_roles[3] = {CycleRole::axis_x, CycleRole::axis_y, CycleRole::axis_z};

constexpr CycleRole offset_roles[6] = {CycleRole::axis_a, CycleRole::axis_b, CycleRole::axis_c,
                                       CycleRole::axis_u, CycleRole::axis_v, CycleRole::axis_w};

constexpr CycleRole centre_roles[3] = {CycleRole::centre_x, CycleRole::centre_y, CycleRole::centre_z};

bool unknown_value(Saying& run, const ActiveCycle& c) {
    if (std::none_of(c.values.begin(), c.values.end(), [](double v) { return std::isnan(v); })) return false;
    unchecked(run, codes::unknown_value, c.definition->where,
              c.definition->name + " depends on a value that is not known: it is left out");
    return true;
}

bool shift(Telling& run, const ActiveCycle& c) {
    if (const Written n = written_value(run, c, CycleRole::datum_number); n.set) {
        shift_by_table(run, *c.definition, n.value);
        return true;
    }
    geom::Vec3 by = active_shift(run);
    for (int k = 0; k < 3; ++k)
        if (const Written w = written_value(run, c, axis_roles[k]); w.set)
            coordinate(by, k) = w.incremental ? coordinate(by, k) + w.value : w.value;
    for (const CycleRole other : offset_roles)
        if (const Written w = written_value(run, c, other); w.set && w.value != 0)
            unchecked(run, codes::unsupported, c.definition->where,
                      c.definition->name + ": the shift of a rotary or secondary axis is not run");
    set_shift(run, by);
    return true;
}

bool mirror(Telling& run, const ActiveCycle& c) {
    geom::Vec3 factors{1, 1, 1};
    for (int k = 0; k < 3; ++k)
        if (written_value(run, c, axis_roles[k]).set) coordinate(factors, k) = -1;
    for (const CycleRole other : offset_roles)
        if (written_value(run, c, other).set)
            unchecked(run, codes::unsupported, c.definition->where,
                      c.definition->name + ": the mirror image of a rotary or secondary axis is not run");
    place_transform(run, TransformKind::mirror, geom::Frame::scaling(factors));
    return true;
}

bool rotate(Telling& run, const ActiveCycle& c) {
    const Written w = written_value(run, c, CycleRole::angle);
    if (!w.set) {
        alarm(run, codes::value_range, c.definition->where, c.definition->name + ": the angle ROT is not given");
        return true;
    }
    double angle = w.value;
    if (w.incremental) {
        const geom::Frame now = active_transform(run, TransformKind::rotation);
        const PlaneAxes a = plane_axes(run.modal.plane);
        geom::Vec3 u;
        coordinate(u, a.u) = 1;
        const geom::Vec3 turned = geom::apply_direction(now, u);
        angle += geom::degrees(std::atan2(coordinate(turned, a.v), coordinate(turned, a.u)));
    }
    const geom::Frame turned = geom::Frame::rotation(plane_axes(run.modal.plane).w, geom::radians(angle));
    place_transform(run, TransformKind::rotation, angle == 0 ? geom::Frame{} : turned);
    return true;
}

bool scale(Telling& run, const ActiveCycle& c) {
    const double f = written_value(run, c, CycleRole::factor).value;
    if (!(f > 0)) {
        alarm(run, codes::value_range, c.definition->where,
              c.definition->name + ": the scaling factor must be greater than 0");
        return true;
    }
    place_transform(run, TransformKind::scaling, geom::Frame::scaling({f, f, f}));
    return true;
}

bool scale_axes(Telling& run, const ActiveCycle& c) {
    geom::Vec3 factors{1, 1, 1}, centre;
    for (int k = 0; k < 3; ++k) {
        if (const Written w = written_value(run, c, axis_roles[k]); w.set) coordinate(factors, k) = w.value;
        coordinate(centre, k) = written_value(run, c, centre_roles[k]).value;
    }
    geom::Frame f = geom::Frame::scaling(factors);
    f.origin = centre - geom::apply_direction(f, centre);
    place_transform(run, TransformKind::axis_scaling, f);
    return true;
}

/// Cycle 19: the spatial angles about the fixed axes X, then Y, then Z, as PLANE SPATIAL; none or all 0 end it.
bool working_plane(Telling& run, const ActiveCycle& c) {
    geom::Frame plane;
    bool any = false;
    for (int k = 0; k < 3; ++k)
        if (const Written w = written_value(run, c, offset_roles[k]); w.set && w.value != 0) {
            plane = geom::Frame::rotation(k, geom::radians(w.value)) * plane;
            any = true;
        }
    if (any)
        assume(run, c.definition->where,
               c.definition->name + ": A, B and C are taken as spatial angles, not as positions of the rotary axes");
    const geom::Vec3 axis_before = run.tool_axis;
    tilt(run, plane, {}, c.definition->where);
    tell_rotary(run, axis_before);
    return true;
}

/// Cycle 32; without values the machine's own setting holds again.
bool tolerance(Telling& run, const ActiveCycle& c) {
    cl::Tolerance t;
    t.contour = written_value(run, c, CycleRole::tolerance).value;
    t.rotary = written_value(run, c, CycleRole::tolerance_angle).value;
    const Written mode = written_value(run, c, CycleRole::tolerance_mode);
    if (mode.set) t.filter = mode.value == 0 ? cl::Filter::finishing : cl::Filter::roughing;
    if (t.contour < 0 || t.rotary < 0 || (mode.set && mode.value != 0 && mode.value != 1)) {
        alarm(run, codes::value_range, c.definition->where,
              c.definition->name + ": T and TA must not be negative, HSC-MODE is 0 or 1");
        return true;
    }
    emit(run, t);
    run.modal.tolerance_cycle = t.contour;
    run.modal.tolerance_by = "CYCL DEF 32";
    return true;
}

/// Cycle 13 says the angle; the spindle goes there, and stands, with M19.
bool orientation(Telling& run, const ActiveCycle& c) {
    run.spindle.orientation = written_value(run, c, CycleRole::spindle_angle).value;
    return true;
}

bool dwell(Telling& run, const ActiveCycle& c) {
    const Written w = written_value(run, c, CycleRole::dwell);
    if (!w.set || !(w.value >= 0)) {
        alarm(run, codes::value_range, c.definition->where,
              c.definition->name + ": the dwell time is " + (w.set ? "negative" : "not given"));
        return true;
    }
    emit(run, cl::Dwell{w.value, 0});
    return true;
}

}  // namespace

bool act_at_definition(Cycling& run, const ActiveCycle& c) {
    if (unknown_value(run, c)) return true;
    switch (c.definition->kind) {
        case CycleKind::datum_shift: return shift(run, c);
        case CycleKind::mirror: return mirror(run, c);
        case CycleKind::rotation: return rotate(run, c);
        case CycleKind::scaling: return scale(run, c);
        case CycleKind::axis_scaling: return scale_axes(run, c);
        case CycleKind::dwell: return dwell(run, c);
        case CycleKind::working_plane: return working_plane(run, c);
        case CycleKind::tolerance: return tolerance(run, c);
        case CycleKind::orientation: return orientation(run, c);
        case CycleKind::preset: {
            const Written n = written_value(run, c, CycleRole::preset_number);
            select_preset(run, *c.definition, n.set ? n.value : -1);
            return true;
        }
        case CycleKind::contour_definition:
            run.contour_labels = c.texts;
            run.contour_unit = c.unit;
            run.contour_choices.clear();
            return true;
        case CycleKind::pattern_circle:
        case CycleKind::pattern_lines: return run_point_cycle(run, c), true;
        case CycleKind::contour_data: run.contour_data = c; return true;
        case CycleKind::contour_train_data: run.contour_train_data = c; return true;
        default: return false;
    }
}

}  // namespace obrys::interp
