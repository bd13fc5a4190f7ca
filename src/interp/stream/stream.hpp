#pragma once
/// The stream: records, the frame and zero they stand in, brackets, and how contours come into it. Private to interp.

#include <optional>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "cl/totals.hpp"
#include "cycles/cycle.hpp"
#include "interp/heard.hpp"
#include "interp/values/values.hpp"
#include "path/arc_input.hpp"
#include "path/element.hpp"

namespace obrys::interp {

// --- frame_words.cpp
void update_frame(Telling&);
/// That frame, from the selected zero inwards (frame_words.cpp).
[[nodiscard]] std::vector<cl::FramePart> frame_parts(const Telling&);

// --- surface_moves.cpp
/// Hands a move of the plane to the stream as the axes make it.
void send_on_surface(Telling&, const cl::Record&);
[[nodiscard]] geom::Vec3 turned_by(const geom::Vec3& p, double by);
/// A move with the angle to which C turns in it.
void send_turned(Telling& run, cl::Record record, double angle, bool counted);

// --- active_zero.cpp
/// Takes what the parameters hold at the start of the run.
void begin_offsets(Telling&);
/// Programmed frame -> stream; also sets Offsets::total.
[[nodiscard]] geom::Frame offset_frame(Telling&);
/// What a zero offset is, as it stands in the control's parameters or in the job.
struct KeptZero {
    enum class From : std::uint8_t { nowhere, parameters, job };
    Axes at{};
    double turn = 0;  ///< degrees about Z
    From from = From::nowhere;
};
[[nodiscard]] KeptZero kept_zero(const Reckoning&, std::uint32_t number);
/// The active zero offset anew from its parameters.
void load_datum(Telling&);
/// The zero offset in force was written: it counts from here on.
void datum_changed(Telling&);
void take_shift(Reckoning& run);

// --- tool_tip.cpp
/// The tool in the spindle, its compensation or the zero was changed: where its tip is (tool_length.cpp).
void take_tip(Telling&);
/// Changes tool offset or tip while the machine stands still: the tip's place follows.
void while_standing(Telling&, base::FunctionRef<void()> change);
/// mm of the axes X … W that compensating a tool's length means.
[[nodiscard]] Axes axes_of(const shop::Tool&);
[[nodiscard]] const Offsets::TouchedOff* touched_off(const Reckoning& run);

// --- written_zero.cpp
/// Behind an assignment: the zero offset in force may stand there, else it is said where writing does more than keep a
/// value.
void note_written(Telling&, std::uint32_t parameter, const base::Span& where);

// --- tell.cpp
/// To who listens, in its place between the records.
void pass_on(Telling&, Heard what);
/// Says what the control is told; nothing where nobody listens.
template <class What>
void hear(Telling& run, const What& what) {
    if (run.listener) pass_on(run, what);
}
/// With shift and turn.
[[nodiscard]] heard::Zero zero_in_force(const Reckoning&);
[[nodiscard]] heard::Joining joining_in_force(const Reckoning&);
/// What the end of the program sets back.
void hear_end(Telling&, int m);
/// What is in force when the run begins.
void hear_beginning(Telling&);
/// How moves are joined from here on; `smoothing_words`: by G60, G64 … G645 of SINUMERIK, else by G61, G61.1, G64.
void tell_joining(Telling&, bool smoothing_words);
/// M48 … M53: what the operator may change.
void switch_override(Telling&, cl::OverrideKind, bool on);

// --- feed_shape.cpp
/// From here on records are looked at.
void shape_feed_from_here(Telling&);
/// Before `record` goes out: the feed that it is run with.
void shape_feed(Telling&, const cl::Record& record);

/// A move goes out with the axes that it takes along.
void send_with_ends(Telling& run, cl::Record record);
/// Hands a record to whoever takes the stream.
inline void send(Telling& run, const cl::Record& record) {
    if (cl::is_move(record.step)) {
        if (!run.ends.empty()) return send_with_ends(run, record);
        run.unsaid_since_change = {};  // it leads on from where it ends
    } else if (const auto* feed = std::get_if<cl::Feed>(&record.step))
        run.told.feed = *feed;
    run.sent = cl::position_after(run.sent, record.step);
    if (run.surface.kind != SurfaceMode::Kind::none) return send_on_surface(run, record);
    if (run.feed_shape.on) shape_feed(run, record);
    run.sink(record);
}
/// As above, a record that radius compensation has not made.
inline void send_plain(Telling& run, const cl::Record& record) {
    run.feed_shape.plunge = run.modal.plunge_part;
    run.feed_shape.arc = 1;
    send(run, record);
}
constexpr const char* turned_axis = "C";
inline constexpr double stream_joined = 1e-6;  ///< mm; no farther off a curve begins where the stream stands
using CycleValues = std::vector<cl::CycleValue>;
/// How a cycle is called, as the stream tells it.
struct WayOfCall {
    cl::CycleCall call = cl::CycleCall::single;
    std::uint64_t pass = 1, passes = 1;  ///< of a pattern's points, of the holes of one block
};

// --- path_output.cpp
/// A chamfer or rounding that no corner was found for. SINUMERIK leaves it out without an alarm.
void say_no_corner(Reckoning& run, const base::Span& where, const char* text, const char* remedy);

// --- plane_move.cpp
[[nodiscard]] inline geom::Vec3 in_space(const PlaneAxes& a, geom::Vec2 p, double w) {
    return a.w == 2 ? geom::Vec3{p.x, p.y, w} : a.w == 1 ? geom::Vec3{p.y, w, p.x} : geom::Vec3{w, p.x, p.y};
}
/// A point of the working plane in the stream's frame.
[[nodiscard]] inline geom::Vec3 point_in_stream(const Reckoning& run, geom::Vec2 p, double w) {
    const geom::Vec3 v = in_space(plane_axes(run.modal.plane), p, w);
    return run.frame_is_identity ? v : geom::apply(run.frame, v);
}
/// By how much the radii of a programmed arc may differ.
[[nodiscard]] inline path::ArcTolerance arc_tolerance(const Reckoning& run) {
    const program::Traits& t = *run.traits;
    const double own = run.modal.inch_geometry ? t.arc_tolerance_inch : t.arc_tolerance;
    return {own > 0 ? own : run.env.machine.defaults.circle_tolerance, 0.001, own > 0};
}
/// Of the working plane, in the stream's frame, as frames turn it.
[[nodiscard]] geom::Vec3 plane_normal(const Reckoning&);
/// Elements of the working plane as moves of the stream.
class PlaneView {
public:
    /// `in_stream`: the elements are in the stream's frame, not in the programmed one.
    explicit PlaneView(const Reckoning& run, bool in_stream = false)
        : run_(run), axes_(plane_axes(run.modal.plane)), as_it_is_(in_stream || run.frame_is_identity) {}
    /// A point of the plane in the stream's frame.
    [[nodiscard]] geom::Vec3 at(geom::Vec2 p, double w) const {
        const geom::Vec3 v = in_space(axes_, p, w);
        return as_it_is_ ? v : geom::apply(run_.frame, v);
    }
    void line(const path::Element&, bool rapid, cl::Linear& out) const;
    /// False where scaling leaves no circle of it; `out` is as it was then.
    [[nodiscard]] bool arc(const path::Element&, bool rapid, cl::Arc& out) const;
    /// What a circle of the plane stands square to; nothing where scaling leaves no circle of one.
    [[nodiscard]] std::optional<geom::Vec3> normal_of_circle() const;

private:
    const Reckoning& run_;
    PlaneAxes axes_;
    bool as_it_is_;
};
void circle_alarm(Saying&, const base::Span& where);
/// Before an arc that no path stage makes: to where the program stands, if compensation has left the tool beside it.
void lead_to_place(Telling&);
/// The frame in force turns the working plane, and radius compensation is made in the plane that it does not turn.
[[nodiscard]] bool compensates_in_fixed_plane(const Telling&);

// --- emit.cpp
/// The step as one of this kind, to be filled. Most records are followed by one of their kind: then there is nothing to
/// take apart, and it holds what it held.
template <class T>
T& step_as(cl::Step& step) {
    if (T* last = std::get_if<T>(&step)) return *last;
    return step.emplace<T>();
}
/// The same, of one that is there already.
template <class T>
void put_step(cl::Step& step, T&& next) {
    static_assert(!std::is_reference_v<T>, "what is put in goes over");
    step_as<T>(step) = std::move(next);
}
void emit(Telling&, cl::Step step);
/// A straight move to where the tool stands now, as radius compensation has not made it.
void emit_line(Telling&, bool rapid);
/// Brackets of the stream about what is called or repeated.
void begin_part(Telling&, cl::PartKind kind, std::string name, std::uint64_t pass, std::uint64_t passes,
                std::vector<cl::PartArgument> arguments = {});
void end_part(Telling&);
/// Before a move: the zero that is selected and the frame in which coordinates are programmed, as far as the stream
/// does not have them yet.
void emit_frame(Telling&);
/// Zero of the run's coordinates in the machine's, and that of the selected datum; NaN where it is not known.
[[nodiscard]] geom::Vec3 stream_origin(const Reckoning&);
[[nodiscard]] geom::Vec3 selected_origin(const Reckoning&);
/// The next move takes the axis along.
void take_along(Telling&, const cl::AxisEnd& axis);
[[nodiscard]] cl::AxisEnd axis_end(std::string_view name, double to, bool is_rotary, bool counted);
/// Emits what a path stage (compensation, rounding) still holds back.
void flush_path(Telling&);

// --- repetition.cpp
/// Runs a section that has been run before once more, `section.left` times in all.
void begin_repetition(Telling&, ActiveSection section);

// --- cycle_bracket.cpp
/// As above, of a cycle that is no definition; `name` as the control writes it.
void begin_bracket(Telling&, const cycles::Demand&, std::string_view name, const WayOfCall& calling = {},
                   std::vector<cl::CycleParameter> written = {});
/// Closes the bracket that was opened last.
void end_bracket(Telling&);

}  // namespace obrys::interp
