#include "obrys/run.hpp"

#include <cmath>

#include "cl/text.hpp"
#include "motion/cursor.hpp"
#include "obrys/shown.hpp"

namespace obrys::api {

namespace {

Point point(const geom::Vec3& p) { return {p.x, p.y, p.z}; }

FeedUnit unit_of(cl::FeedMode mode) {
    switch (mode) {
        case cl::FeedMode::per_rev: return FeedUnit::mm_per_rev;
        case cl::FeedMode::inverse_time: return FeedUnit::per_min;
        case cl::FeedMode::per_minute: break;
    }
    return FeedUnit::mm_per_min;
}

Move move_of(const motion::Step& step, const base::Sources& sources) {
    const motion::State& state = step.state;
    Move move;
    move.rapid = step.rapid;
    move.index = step.index;
    move.from = point(step.from);
    move.to = point(step.to);
    move.axis_from = point(step.axis_from);
    move.axis_to = point(step.axis_to);
    for (const cl::AxisEnd& end : step.axes_to) {
        const cl::AxisEnd* begin = motion::find_axis(step.axes_from, end.name);
        move.axes.push_back({std::string(cl::name_of(end.name)), begin != nullptr ? begin->to : std::nan(""), end.to,
                             end.rotary, end.counted});
    }
    move.zero = {state.datum.number, point(state.datum.origin)};
    if (const auto* arc = std::get_if<cl::Arc>(&step.record.step)) {
        move.kind = MoveKind::arc;
        move.centre = point(arc->centre);
        move.normal = point(arc->normal);
        move.sweep = arc->sweep;
    } else if (std::holds_alternative<cl::Spline>(step.record.step)) {
        move.kind = MoveKind::curve;
    } else if (std::holds_alternative<cl::Thread>(step.record.step)) {
        move.kind = MoveKind::thread;
    }
    move.feed = state.feed.value;
    move.feed_unit = unit_of(state.feed.mode);
    move.speed = state.spindle.speed;
    move.speed_unit = state.spindle.mode == cl::SpindleMode::surface ? SpeedUnit::m_per_min : SpeedUnit::rev_per_min;
    move.spindle = state.spindle.direction;
    move.tool = state.change.number;
    move.in_cycle = state.cycles > 0;
    move.where = shown(sources, step.record.from);
    return move;
}

}  // namespace

Ran run(const Image& image, const std::function<void(const Move&)>& take, const Inputs& inputs) {
    const auto session = session_of(image, inputs);
    motion::Cursor cursor(session->job.tools);
    const interp::Outcome outcome = driver::interpret(*session, [&](const cl::Record& record) {
        if (!take) return;
        if (const auto step = cursor.take(record)) take(move_of(*step, session->sources));
    });
    Ran ran;
    ran.ending = static_cast<Ending>(outcome.ending);
    ran.blocks = outcome.blocks_executed;
    for (const interp::ParameterValue& p : outcome.parameters) ran.parameters[p.name] = p.value;
    ran.messages = shown(*session);
    return ran;
}

std::string stream(const Image& image, const Inputs& inputs) {
    const auto session = session_of(image, inputs);
    std::string text;
    const auto more = [&](std::string_view piece) { text += piece; };
    cl::TextWriter writer(more);
    static_cast<void>(driver::interpret(*session, writer));
    return text;
}

}  // namespace obrys::api
