#include "motion/chords.hpp"

#include <cmath>
#include <utility>

#include "cl/spline.hpp"
#include "motion/cursor.hpp"

namespace obrys::motion {

namespace {

bool is_plain(const cl::Arc& arc) { return !arc.rapid && arc.ends.empty(); }
bool is_plain(const cl::Spline& spline) { return spline.axes.empty() && spline.ends.empty(); }

/// The end and the tool's axis there of a curve that lines can say; nothing: they cannot.
std::optional<cl::Linear> end_of(const cl::Step& step) {
    cl::Linear end;
    if (const auto* arc = std::get_if<cl::Arc>(&step); arc != nullptr && is_plain(*arc))
        end.to = arc->to, end.axis = arc->axis;
    else if (const auto* spline = std::get_if<cl::Spline>(&step); spline != nullptr && is_plain(*spline))
        end.to = spline->to, end.axis = spline->axis;
    else
        return std::nullopt;
    return end;
}

bool allows_lines(const State& s) {
    return !s.compensation && s.feed.mode != cl::FeedMode::inverse_time &&
           !(s.path && s.path->kind == cl::PathKind::exact_stop);
}

}  // namespace

std::size_t take_chords(const cl::Recording& stream, double tolerance,
                        base::FunctionRef<bool(const cl::Record&)> wanted, cl::Recording& out) {
    constexpr int most = 1'000'000;  // of one curve
    constexpr double same_axis = 1e-9;
    Cursor cursor;
    geom::Vec3 tool{0, 0, 1};
    std::size_t curves = 0;
    const auto replaced = [&](const cl::Record& record) {
        const std::optional<cl::Linear> end = end_of(record.step);
        const geom::Vec3 from = cursor.position().here();
        if (!end || !allows_lines(cursor.state())) return false;
        if (!(geom::distance(end->axis, tool) <= same_axis) || !geom::is_finite(from) || !geom::is_finite(end->to))
            return false;
        if (!wanted(record)) return false;
        cl::Record line{*end, record.from, record.stack};
        cl::points_between(from, record.step, tolerance, most, [&](geom::Vec3 point) {
            std::get<cl::Linear>(line.step).to = point;
            out.take(line);
        });
        std::get<cl::Linear>(line.step).to = end->to;
        out.take(line);
        return true;
    };
    cl::Recording::Playback playback(stream);
    while (playback.step([&](const cl::Record& record) {
        if (replaced(record))
            ++curves;
        else
            out.take(record);
        static_cast<void>(cursor.take(record));
        if (const geom::Vec3* axis = cl::tool_axis_of(record.step)) tool = *axis;
    })) {
    }
    return curves;
}

}  // namespace obrys::motion
