/// Blocks with data of their own: smooth approach and departure, splines. Free contours: free_contour.cpp, tilted
/// planes: plane.cpp.

#include <algorithm>
#include <cmath>

#include "base/codes.hpp"
#include "base/number.hpp"
#include "cl/spline.hpp"
#include "interp/capture.hpp"
#include "interp/complaints.hpp"
#include "interp/flow/flow.hpp"

namespace obrys::interp {

namespace codes = base::codes;
using geom::Vec3;
using program::Datum;
using program::Special;
using program::SpecialKind;

namespace {

/// The control refuses a spline that starts more than 1 um beside the end of the last contour element (iTNC 530 User's
/// Manual, "Contour movements - spline interpolation": "larger deviations will provoke an error message"); it is held
/// to it axis by axis.
void check_start(Reckoning& run, const cl::Spline& spline) {
    const Vec3 gap = cl::start_gap(run.position, spline);
    const double worst = std::max({std::abs(gap.x), std::abs(gap.y), std::abs(gap.z)});
    constexpr double allowed = 0.001 + 1e-9;
    if (worst <= allowed) return;
    if (std::isnan(geom::length(gap))) {
        unchecked(run, codes::unknown_value, run.here(), "where the tool stands before this spline is not known");
        return;
    }
    alarm(run, codes::spline_start, run.here(),
          "the spline starts " + base::fixed(geom::length(gap), 4) +
              " mm beside the end of the last contour element, more than 0.001 mm along an axis",
          "let the coefficients K1, K2, K3 and the end point add up to where the last block ended");
}

/// The stream's splines have two additional axes at most, the control's five axes in all.
bool has_too_many_axes(Telling& run, const cl::Spline& spline) {
    if (spline.axes.size() <= 2) return false;
    unchecked(run, codes::unsupported, run.here(),
              "a spline with more than two axes besides X, Y and Z is not followed: it is run straight");
    for (const cl::SplineAxis& a : spline.axes)
        take_along(run, axis_end(std::string_view(a.name.data()), a.to, a.rotary, false));
    emit(run, cl::Linear{spline.to, run.tool_axis, false});
    return true;
}

void spline(Moving& run, const Special& s) {
    flush_path(run);
    const double unit = length_unit(run.modal);
    cl::Spline record;
    const Vec3 to = programmed_target(run);
    Vec3 k[3];
    for (const program::DatumValue& d : s.data) {
        const auto n = static_cast<std::size_t>(d.datum) - static_cast<std::size_t>(Datum::k1);
        const double v = number(run, d.value);
        const auto axis = std::string_view("XYZ").find(d.axis);
        if (axis != std::string_view::npos) {
            coordinate(k[n], static_cast<int>(axis)) = v * unit;
            continue;
        }
        auto at =
            std::find_if(record.axes.begin(), record.axes.end(), [&](const auto& x) { return x.name[0] == d.axis; });
        if (at == record.axes.end()) {
            at = record.axes.insert(record.axes.end(), cl::SplineAxis{});
            at->name[0] = d.axis;
            const Code code = axis_code(static_cast<int>(std::string_view("XYZABC").find(d.axis)));
            at->to = run.block.has(code) ? run.block.get(code) : programmed_coordinate(run, std::string(1, d.axis));
            run.extra_axes[std::string(1, d.axis)] = at->to;
        }
        (n == 0 ? at->k1 : n == 1 ? at->k2 : at->k3) = v;
    }
    record.k1 = geom::apply_direction(run.frame, k[0]);
    record.k2 = geom::apply_direction(run.frame, k[1]);
    record.k3 = geom::apply_direction(run.frame, k[2]);
    record.to = geom::apply(run.frame, to);
    record.axis = run.tool_axis;
    if (run.modal.compensation != Modal::compensation_off)
        alarm(run, codes::compensation, run.here(), "a spline cannot be run with radius compensation",
              "write R0 before it");
    if (run.stopped || run.capture != nullptr) return arrive(run, to);
    require_feed(run);
    begin_motion(run);
    check_start(run, record);
    if (run.stopped) return;
    const PlaneAxes a = plane_axes(run.modal.plane);
    run.last_direction = path::EndDirection(-1.0 * in_plane(k[0], a));  // at t = 0 the curve runs against its parameter
    arrive(run, to);
    if (!has_too_many_axes(run, record)) emit(run, std::move(record));
}

void act(Moving& run, const Special& s, std::uint32_t index, Modal compensation_before) {
    if (s.kind <= SpecialKind::approach_arc_line) return approach(run, s);
    if (s.kind <= SpecialKind::departure_arc_line) return departure(run, s, compensation_before);
    if (s.kind == SpecialKind::spline) return spline(run, s);
    if (s.kind <= SpecialKind::free_select) return free_contour(run, s, index);
    plane(run, s);
}

}  // namespace

void run_special(Cycling& run, const program::Statement& statement, std::uint32_t index) {
    const Unit& unit = run.unit();
    const Special& s = unit.specials[static_cast<std::size_t>(unit.words[statement.first].payload)];
    run.block.clear();
    run.complained = false;
    const Modal compensation_before = run.modal.compensation;
    const std::uint32_t end = unit.words_end(index);
    for (std::uint32_t i = statement.first + 1; i < end; ++i) {
        gather(run, statement, unit.words[i]);
        if (run.stopped) return;
    }
    if (run.block.twice != 0) repeated_words(run);
    if (run.stopped) return;
    technology(run);
    if (!run.stopped && run.block.retract != 0) retract_tool(run);
    if (!run.stopped) act(run, s, index, compensation_before);
    const bool called = run.block.has(Code::cycle_call), modal = run.block.has(Code::cycle_call_modal);
    const bool moves =
        s.kind <= SpecialKind::spline && s.kind != SpecialKind::free_pole && s.kind != SpecialKind::free_select;
    if (!run.stopped && (called || modal || (moves && run.cycle.modal))) {
        run.cycle.modal = modal || (run.cycle.modal && !called);
        call_cycle(run);
    }
    report_unused(run);
    if (!run.stopped) after_motion(run);
}

}  // namespace obrys::interp
