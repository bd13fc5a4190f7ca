/// POS and POSA: a linear axis goes to its place on its own, at its own feed.

#include "base/codes.hpp"
#include "interp/moves/moves.hpp"

namespace obrys::interp {

namespace codes = base::codes;

namespace {

/// Why the way of these axes is not known; empty: it is one straight move.
std::string unknown_way(const Moving& run, bool path_moved) {
    const BlockWords& b = run.block;
    const std::string axis = b.positioned.front().name;
    if (path_moved) return axis + " moves on its own while the path goes on: it is run behind it";
    if (b.positioned.size() > 1) return "several axes move on their own: they are run one after the other";
    if (run.modal.compensation != Modal::compensation_off)
        return "POS[" + axis + "]= under radius compensation is run as an uncompensated move";
    return {};
}

void position_axis(Telling& run, const BlockWords::NamedAxis& axis) {
    const int k = axis.name == "X" ? 0 : axis.name == "Y" ? 1 : 2;
    const bool incremental = is_incremental(run, axis.reference);
    const double v = axis.value * word_factor(run, k, axis.reference);
    geom::Vec3 to = run.programmed_position;
    coordinate(to, k) = incremental ? coordinate(to, k) + v : v;
    const auto feed = run.axis_feeds.find(axis.name);
    const bool rapid = feed == run.axis_feeds.end() || feed->second <= 0;  // one that is not known is no rapid
    if (!rapid) emit(run, cl::Feed{feed->second, cl::FeedMode::per_minute});
    arrive(run, to);
    emit(run, cl::Linear{run.position, run.tool_axis, rapid});
    if (!rapid && run.feed_valid) emit(run, cl::Feed{run.feed, run.modal.feed_mode});
    if (rapid)
        assume(run, axis.where,
               "POS[" + axis.name + "]= without FA[" + axis.name + "]= goes at the axis' own speed: taken as a rapid");
}

}  // namespace

void position_axes(Moving& run, bool path_moved) {
    const std::string why = unknown_way(run, path_moved);
    if (!why.empty()) unchecked(run, codes::unsupported, run.here(), why);
    flush_path(run);
    begin_motion(run);
    const std::vector<BlockWords::NamedAxis> axes = run.block.positioned;
    const bool goes_on = run.block.goes_on && run.capture == nullptr;
    for (const BlockWords::NamedAxis& axis : axes) {
        if (!run.stopped) position_axis(run, axis);
        if (goes_on) run.underway[axis.name] = run.here();
    }
}

/// POSA is run like POS. That is right where nothing else moves until WAITP, or until its axis is programmed again, for
/// which the control waits, too (NC programming 12/2019, positioning axes).
void judge_underway(Moving& run, bool path_moved) {
    BlockWords& b = run.block;
    if (run.capture != nullptr || !(path_moved || !b.positioned.empty())) return;
    bool others = false;
    for (int k = 0; k < 9; ++k) {
        if (!b.has(axis_code(k))) continue;
        const std::string name = axis_name(static_cast<std::size_t>(k));
        others = others || !run.underway.contains(name);
    }
    for (const BlockWords::NamedAxis& axis : b.positioned) others = others || !run.underway.contains(axis.name);
    if (others)
        unchecked(run, codes::unsupported, run.underway.begin()->second,
                  "POSA[" + run.underway.begin()->first +
                      "]= moves while the next blocks move other axes: it is run before them",
                  "write WAITP(" + run.underway.begin()->first + ") before them, or POS");
    run.underway.clear();
}

void wait_for_axes(Moving& run, const program::ProcedureCall& p) {
    for (const ExprId id : p.arguments) {
        const std::string written = axis_of(run, id);
        run.underway.erase(machine_axis_name(run, written).value_or(written));
    }
}

}  // namespace obrys::interp
