/// Polar coordinates: AP=, RP= and the pole they refer to (G110, G111, G112).

#include <cmath>

#include "base/codes.hpp"
#include "interp/moves/moves.hpp"

namespace obrys::interp {

namespace codes = base::codes;

namespace {

/// G91 counts where the words are taken from the position; else only AP=IC(…), RP=IC(…) and IPA, IPR do.
bool is_added(const Reckoning& run, std::uint8_t reference) {
    if (run.unit().traits->polar_from_position) return is_incremental(run, reference);
    return reference == 1 + static_cast<std::uint8_t>(program::Reference::incremental);
}

/// Source: LinuxCNC 2.9, its stand-alone interpreter asked (tests/linuxcnc/bad_programs.py).
bool may_be_polar(Reckoning& run, bool grows_from_pole) {
    if (run.modal.plane != 17) {
        alarm(run, codes::value_range, run.here(), "polar coordinates are for the plane of G17 only",
              "write X, Y and Z, or G17 before it");
        return false;
    }
    if (!grows_from_pole) return true;
    alarm(run, codes::value_range, run.here(),
          "polar coordinates that add (G91) have no direction where the tool stands: at the origin",
          "move away from the origin first, or write the place in G90");
    return false;
}

}  // namespace

bool has_pole(Reckoning& run) {
    if (run.modal.pole_set || !run.unit().traits->needs_pole) return true;
    alarm(run, codes::arc_radius, run.here(), "circle center undefined: no pole was set before this block",
          "write CC with its coordinates before it");
    return false;
}

namespace {

/// LP X+70: LP, CP and CTP have PR, PA and the tool axis, no coordinates of the plane. DIN/ISO: its reader says so.
void say_missing_polar_words(Moving& run, std::uint64_t polar) {
    const BlockWords& b = run.block;
    const PlaneAxes plane = plane_axes(run.modal.plane);
    if (!b.polar_path || (b.present & polar) != 0 || (!b.has(axis_code(plane.u)) && !b.has(axis_code(plane.v)))) return;
    unchecked(run, codes::unknown_word, run.here(),
              "the path function of this block takes polar coordinates, and coordinates of the plane stand here: it is "
              "run by them",
              "write PR and PA, or L, C or CT for coordinates of the plane");
}

}  // namespace

void complete_arc(Moving& run) {
    BlockWords& b = run.block;
    constexpr auto bit = [](Code c) { return std::uint64_t{1} << static_cast<unsigned>(c); };
    constexpr std::uint64_t polar = bit(Code::polar_angle) | bit(Code::polar_radius);
    constexpr std::uint64_t sized = bit(Code::radius) | bit(Code::opening_angle) | bit(Code::i) | bit(Code::j) |
                                    bit(Code::k) | bit(Code::pole_angle);
    constexpr std::uint64_t axes = bit(Code::w) * 2 - bit(Code::x);
    if (!run.traits->arcs_about_pole || b.special != Modal::linear || (b.present & (axes | polar)) == 0) return;
    if ((b.present & polar) != 0 && run.modal.cartesian_path) {
        unchecked(
            run, codes::unknown_word, run.here(),
            "polar coordinates need a polar path function, and the one in force here takes none: they are not run",
            "G10 to G16 move in polar coordinates, G00 to G06 do not");
        b.present &= ~polar;
    }
    say_missing_polar_words(run, polar);
    const Modal m = run.modal.motion;
    if ((m != Modal::arc_cw && m != Modal::arc_ccw) || (b.present & sized) != 0) return;
    if (!b.has(Code::centre_at_pole)) b.put(Code::centre_at_pole, 0);
    if (!b.has(Code::polar_angle) || !is_incremental(run, b.ref(Code::polar_angle))) return;
    const double angle = b.get(Code::polar_angle);
    b.present &= ~bit(Code::polar_angle);
    b.put(Code::pole_angle, angle);
}

geom::Vec3 polar_target(Moving& run, geom::Vec3 to) {
    if (!has_pole(run)) return to;
    const BlockWords& b = run.block;
    const PlaneAxes axes = plane_axes(run.modal.plane);
    if (b.has(axis_code(axes.u)) || b.has(axis_code(axes.v))) {
        alarm(run, codes::repeated_word, run.here(),
              "the block gives its end twice: by coordinates of the plane and by polar coordinates",
              "write one of them");
        return to;
    }
    const geom::Vec3& pole = run.modal.pole;
    const double du = coordinate(run.programmed_position, axes.u) - coordinate(pole, axes.u);
    const double dv = coordinate(run.programmed_position, axes.v) - coordinate(pole, axes.v);
    // A word left out keeps its last value; before there is one, the position says it.
    const bool here = run.unit().traits->polar_from_position;
    const bool grows = (b.has(Code::polar_radius) && is_added(run, b.ref(Code::polar_radius))) ||
                       (b.has(Code::polar_angle) && is_added(run, b.ref(Code::polar_angle)));
    if (run.traits->refuses_unready && !may_be_polar(run, grows && du == 0 && dv == 0)) return to;
    double radius = here || std::isnan(run.modal.polar_radius) ? std::hypot(du, dv) : run.modal.polar_radius;
    double angle =
        here || std::isnan(run.modal.polar_angle) ? geom::degrees(std::atan2(dv, du)) : run.modal.polar_angle;
    if (b.has(Code::polar_radius)) {
        const double v = b.get(Code::polar_radius) * length_unit(run.modal);
        radius = is_added(run, b.ref(Code::polar_radius)) ? radius + v : v;
    }
    if (b.has(Code::polar_angle)) {
        const double v = b.get(Code::polar_angle);
        angle = is_added(run, b.ref(Code::polar_angle)) ? angle + v : v;
    }
    run.modal.polar_radius = radius;
    run.modal.polar_angle = angle;
    coordinate(to, axes.u) = coordinate(pole, axes.u) + radius * std::cos(geom::radians(angle));
    coordinate(to, axes.v) = coordinate(pole, axes.v) + radius * std::sin(geom::radians(angle));
    return to;
}

namespace {

/// Of two coordinates, one of them along the tool axis: the circle about it lies in their plane (iTNC 530, User's
/// Manual, "Circular path C": C Z… X… with tool axis Z). 0: the working plane.
int plane_of_pole(const Moving& run) {
    const auto has = [&](int k) { return run.block.has(axis_code(k)); };
    const PlaneAxes axes = plane_axes(run.modal.plane);
    if (!has(axes.w) || has(axes.u) == has(axes.v)) return 0;
    const int missing = has(axes.u) ? axes.v : axes.u;
    return missing == 1 ? 18 : missing == 0 ? 19 : 17;
}

/// CC: absolute, or incremental from where the tool stands; without any coordinate there. A coordinate that is left out
/// stays as it was.
void give_pole(Moving& run) {
    const BlockWords& b = run.block;
    run.modal.pole_set = true;
    bool any = false;
    run.modal.pole_plane = plane_of_pole(run);
    const PlaneAxes axes = plane_axes(run.modal.pole_plane != 0 ? run.modal.pole_plane : run.modal.plane);
    for (const int k : {axes.u, axes.v}) any = any || b.has(axis_code(k));
    if (!any) run.modal.pole = run.programmed_position;
    for (const int k : {axes.u, axes.v}) {
        if (!b.has(axis_code(k))) continue;
        const bool incremental = is_incremental(run, b.ref(axis_code(k)));
        const double v = b.get(axis_code(k)) * length_factor(run, k, incremental);
        coordinate(run.modal.pole, k) = incremental ? coordinate(run.programmed_position, k) + v : v;
    }
    forget_polar_angle(run.modal);
}

}  // namespace

/// G110 last position, G111 workpiece zero, G112 last pole: the words of the block are the pole as seen from there.
void set_pole(Moving& run) {
    const BlockWords& b = run.block;
    if (b.special == Modal::pole_given) {
        give_pole(run);
        return;
    }
    geom::Vec3 base = run.modal.pole;
    if (b.special == Modal::pole_from_position) base = run.programmed_position;
    if (b.special == Modal::pole_from_zero) base = {};
    geom::Vec3 offset;
    const PlaneAxes axes = plane_axes(run.modal.plane);
    if (b.has(Code::polar_angle) || b.has(Code::polar_radius)) {
        const double r = b.has(Code::polar_radius) ? b.get(Code::polar_radius) * length_unit(run.modal) : 0;
        const double a = geom::radians(b.has(Code::polar_angle) ? b.get(Code::polar_angle) : 0);
        coordinate(offset, axes.u) = r * std::cos(a);
        coordinate(offset, axes.v) = r * std::sin(a);
    } else {
        for (const int k : {axes.u, axes.v})
            if (b.has(axis_code(k)))
                coordinate(offset, k) = b.get(axis_code(k)) * length_factor(run, k, b.special != Modal::pole_from_zero);
    }
    run.modal.pole = base + offset;
    forget_polar_angle(run.modal);
}

}  // namespace obrys::interp
