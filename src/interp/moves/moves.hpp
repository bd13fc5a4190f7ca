#pragma once
/// Moves: straight, arcs, splines, threads, those of the machine, and ways onto a contour. Private to interp.

#include "interp/setup/setup.hpp"
#include "path/arc_input.hpp"
#include "path/element.hpp"
#include "shop/home.hpp"

namespace obrys::interp {

// --- positioning.cpp
/// Linear axes that move on their own, behind the block's path (positioning.cpp).
void position_axes(Moving&, bool path_moved);
/// Behind a block that may have moved while axes of POSA are under way.
void judge_underway(Moving&, bool path_moved);
/// WAITP.
void wait_for_axes(Moving&, const program::ProcedureCall&);

// --- polar.cpp
/// Traits::arcs_about_pole (polar.cpp).
void complete_arc(Moving&);
/// `to` with the coordinates that AP= and RP= give (polar.cpp).
[[nodiscard]] geom::Vec3 polar_target(Moving&, geom::Vec3 to);
/// False (and an alarm) where the control needs a pole and the program has set none.
[[nodiscard]] bool has_pole(Reckoning&);
/// G110, G111, G112: the words of the block place the pole.
void set_pole(Moving&);

// --- home.cpp
/// G28, G30, G28.1, G30.1.
void go_home(Moving&);
void store_home(Moving&);
/// The first reference point of an axis, 0 for X; NaN where nobody gives it or takes it for granted.
[[nodiscard]] shop::Home reference_point_of(const Reckoning&, std::size_t axis);
/// By axis: its home is taken for granted, and where the tool then stands in the workpiece follows from that.
void tell_assumed_homes(Saying&, const std::array<bool, 3>& axes);

// --- spline.cpp
/// G5, G5.1, G5.2 … G5.3, G6.2.
[[nodiscard]] bool spline_motion(Moving&);

// --- straight.cpp
/// An axis the machine file does not list: moved all the same, but said.
void require_axis(Saying& run, const std::string& name);
/// Keeps an element for whoever rehearses the run (capture.hpp).
void capture(Moving&, const path::Element& element, bool rapid);
[[nodiscard]] bool needs_path_stage(const Moving&);
/// Where the coordinates of the block lead, programmed frame.
[[nodiscard]] geom::Vec3 programmed_target(Moving&);
/// The axes besides X, Y, Z that the block names go where it says.
void extra_axes(Moving&);
/// Before a move: datum, feed that was dropped.
void begin_motion(Moving&);
/// Before the first move in a tilted plane whose rotary axes a word of its own turns: that it has done so (plane.cpp).
void judge_plane_taken_up(Moving&);
void require_feed(Telling&);
/// Straight move to `to` (programmed frame).
void straight_motion(Moving&, const geom::Vec3& to, bool rapid);

// --- approach.cpp
void approach(Moving& run, const program::Special& s);
void departure(Moving& run, const program::Special& s, Modal compensation_before);

// --- arc_words.cpp
/// A centre along the axis across the plane in force: it was meant for another plane.
[[nodiscard]] bool says_centre_across(Moving& run);
[[nodiscard]] path::ArcResult planar_arc(Moving& run, geom::Vec2 from, geom::Vec2 to, bool end_given,
                                         const PlaneAxes& a, double rise);
/// What nearly all arcs are: G2 or G3 from a known place to another, with a centre in the plane and no other word of a
/// circle. Nothing of it is other than by planar_arc; a failure where it is none of these, or what it asks for fails.
[[nodiscard]] path::ArcResult usual_arc(const Moving& run, geom::Vec2 from, geom::Vec2 to, const PlaneAxes& a);

// --- line_angle.cpp
/// ANG= (line_angle.cpp): `to` with what the angle says; false after a complaint.
[[nodiscard]] bool line_by_angle(Moving&, geom::Vec3& to);
/// ANG= of a block that gives both coordinates of its end, absolute: the second of two lines.
[[nodiscard]] std::optional<double> angle_of_whole_line(const Moving&);

// --- machine_motion.cpp
/// G74 and G75: the axes of the block go to their reference point (machine_motion.cpp).
[[nodiscard]] bool reference_point(Moving&);
/// SUPA, G53, G153.
[[nodiscard]] bool machine_move(Moving&);
/// M140: away along the tool axis.
void retract_tool(Moving&);

// --- thread.cpp
/// G33.1: down with the spindle, and back with it reversed (thread.cpp).
[[nodiscard]] bool rigid_tap(Moving&);
/// The block's thread to `to` (programmed frame).
[[nodiscard]] bool thread_motion(Moving&, const geom::Vec3& to);

// --- arc.cpp
/// Runs the block's arc to `to` (programmed frame); false where it could not be resolved.
[[nodiscard]] bool arc_motion(Moving&, const geom::Vec3& to);
/// Says why an arc cannot be run.
void arc_alarm(Moving&, const path::ArcResult&);

// --- arc_in_space.cpp
/// An arc in the programmed frame: through the path stage where it lies in the working plane (arc_in_space.cpp).
void run_arc_in_space(Moving&, const cl::Arc&);
/// Modal::arc_about; false where it could not be resolved.
[[nodiscard]] bool arc_about_axis(Moving&, const geom::Vec3& to);
/// Modal::tool_along: the words of the block aim the tool.
void aim_tool(Moving&);

// --- plane_element.cpp
/// Runs an element of the working plane that ends at `to` (programmed frame), through the path stage where it is at
/// work.
void plane_element(Moving&, path::Element&& element, const geom::Vec3& to, bool rapid);

// --- free_contour.cpp
/// FL, FLT, FC, FCT, FPOL, FSELECT (free_contour.cpp).
void free_contour(Moving&, const program::Special&, std::uint32_t index);

// --- plane.cpp
/// PLANE (plane.cpp).
void plane(Moving&, const program::Special&);

// --- swivel.cpp
/// Tells the stream where the rotary axes stand that the program has moved, whether that counts, and the tool's axis
/// where it is another than before: by a rapid on the spot, since arcs do not say it.
void tell_rotary(Telling&, const geom::Vec3& axis_before);
/// The rotary axes as they stand go with the next move, but those of these letters.
void take_rotary_along(Telling&, std::string_view without);
/// How the tool stood before the plane changed, seen from the workpiece, and what MOVE says besides.
struct BeforeSwivel {
    geom::Vec3 tip, axis;
    double distance = 0;  ///< mm before the tip at which the place stays that is turned about (DIST)
};
/// MOVE, TURN: the rotary axes go where `aim` said.
void swivel(Moving&, bool keeps_tip, bool rapid, const BeforeSwivel&, const base::Span& where);
/// Where the tool's axis points, seen from the workpiece, the rotary axes as they stand.
[[nodiscard]] geom::Vec3 axis_of_tool(const Reckoning&);
/// The position as seen from the workpiece, whatever counts.
[[nodiscard]] geom::Vec3 on_workpiece(const Reckoning&);
/// The position in the machine's directions, as though no rotary axis counted, and back.
[[nodiscard]] geom::Vec3 along_machine(const Reckoning&);
[[nodiscard]] geom::Vec3 from_along_machine(const Reckoning&, const geom::Vec3& position);

}  // namespace obrys::interp
