#pragma once
/// Motion inside interp: what straight moves and arcs share. Private.

#include <optional>

#include "interp/run.hpp"
#include "path/arc_input.hpp"
#include "path/element.hpp"

namespace obrys::interp {

/// The working plane: indices (0 = x …) of its first and second axis and of its normal.
struct PlaneAxes {
    int u = 0, v = 1, w = 2;
};
[[nodiscard]] inline PlaneAxes plane_axes(int plane) {
    if (plane == 18) return {2, 0, 1};
    if (plane == 19) return {1, 2, 0};
    return {0, 1, 2};
}
[[nodiscard]] inline geom::Vec2 in_plane(const geom::Vec3& v, const PlaneAxes& a) {
    return {coordinate(v, a.u), coordinate(v, a.v)};
}

/// Millimetres per programmed unit of a linear axis: inches, and diameters of a lathe's X.
[[nodiscard]] double length_factor(const Reckoning&, int axis, bool incremental);

/// The same of a word with its own reference (DIC, RAC …; 0: as the modal state says).
[[nodiscard]] double word_factor(const Reckoning&, int axis, std::uint8_t reference);
/// ANG= (line_angle.cpp): `to` with what the angle says; false after a complaint.
[[nodiscard]] bool line_by_angle(Moving&, geom::Vec3& to);
/// ANG= of a block that gives both coordinates of its end, absolute: the second of two lines.
[[nodiscard]] std::optional<double> angle_of_whole_line(const Moving&);
/// Whether a word with this reference (0 = as the modal state says) is incremental.
[[nodiscard]] bool is_incremental(const Reckoning&, std::uint8_t reference);
/// The machine's axis of that name, or null.
[[nodiscard]] const shop::MachineAxis* machine_axis(const Saying&, const std::string& name);

/// `to` with the coordinates that AP= and RP= give (polar.cpp).
[[nodiscard]] geom::Vec3 polar_target(Moving&, geom::Vec3 to);
/// False (and an alarm) where the control needs a pole and the program has set none.
[[nodiscard]] bool has_pole(Reckoning&);
/// G110, G111, G112: the words of the block place the pole.
void set_pole(Moving&);

/// G74 and G75: the axes of the block go to their reference point (machine_motion.cpp).
[[nodiscard]] bool reference_point(Moving&);
/// SUPA, G53, G153.
[[nodiscard]] bool machine_move(Moving&);
/// M140: away along the tool axis.
void retract_tool(Moving&);

/// G33.1: down with the spindle, and back with it reversed (thread.cpp).
[[nodiscard]] bool rigid_tap(Moving&);
/// The block's thread to `to` (programmed frame).
[[nodiscard]] bool thread_motion(Moving&, const geom::Vec3& to);
/// By how much the radii of a programmed arc may differ.
[[nodiscard]] path::ArcTolerance arc_tolerance(const Reckoning&);
/// Runs the block's arc to `to` (programmed frame); false where it could not be resolved.
[[nodiscard]] bool arc_motion(Moving&, const geom::Vec3& to);
/// Says why an arc cannot be run.
void arc_alarm(Moving&, const path::ArcResult&);
/// An arc in the programmed frame: through the path stage where it lies in the working plane (arc_in_space.cpp).
void run_arc_in_space(Moving&, const cl::Arc&);
/// Modal::arc_about; false where it could not be resolved.
[[nodiscard]] bool arc_about_axis(Moving&, const geom::Vec3& to);
/// Modal::tool_along: the words of the block aim the tool.
void aim_tool(Moving&);
/// Of the working plane, in the stream's frame, as frames turn it.
[[nodiscard]] geom::Vec3 plane_normal(const Reckoning&);
/// An element of the working plane as a move of the stream; nothing where scaling leaves no circle of an arc.
/// `in_stream`: the element is in the stream's frame, not in the programmed one.
[[nodiscard]] std::optional<cl::Step> plane_move(const Reckoning&, const path::Element& element, bool rapid,
                                                 bool in_stream = false);
void circle_alarm(Saying&, const base::Span& where);
/// Before an arc that no path stage makes: to where the program stands, if compensation has left the tool beside it.
void lead_to_place(Telling&);
/// Keeps an element for whoever rehearses the run (capture.hpp).
void capture(Moving&, const path::Element& element, bool rapid);
/// Runs an element of the working plane that ends at `to` (programmed frame), through the path stage where it is at
/// work.
void plane_element(Moving&, path::Element element, const geom::Vec3& to, bool rapid);
[[nodiscard]] bool needs_path_stage(const Moving&);
/// The frame in force turns the working plane, and radius compensation is made in the plane that it does not turn.
[[nodiscard]] bool compensates_in_fixed_plane(const Telling&);
/// Where the coordinates of the block lead, programmed frame.
[[nodiscard]] geom::Vec3 programmed_target(Moving&);
/// The tool stands at `to` (programmed frame) from here on.
void arrive(Reckoning&, const geom::Vec3& to);
/// The axes besides X, Y, Z that the block names go where it says.
void extra_axes(Moving&);
/// Before a move: datum, feed that was dropped.
void begin_motion(Moving&);
void require_feed(Telling&);
/// Straight move to `to` (programmed frame).
void straight_motion(Moving&, const geom::Vec3& to, bool rapid);

}  // namespace obrys::interp
