/// POS and POSA: a linear axis goes to its place on its own, at its own feed.

#include <cmath>

#include "base/codes.hpp"
#include "interp/motion.hpp"
#include "interp/run.hpp"

namespace obrys::interp {

namespace codes = base::codes;

namespace {

/// Why the way of these axes is not known; empty: it is one straight move.
std::string unknown_way(const Run& run, bool path_moved) {
    const BlockWords& b = run.block;
    const std::string axis = b.positioned.front().name;
    if (path_moved) return axis + " moves on its own while the path goes on: it is run behind it";
    if (b.positioned.size() > 1) return "several axes move on their own: they are run one after the other";
    if (b.goes_on) return "POSA[" + axis + "]= moves while the next blocks are run: it is run before them";
    if (run.modal.compensation != Modal::compensation_off)
        return "POS[" + axis + "]= under radius compensation is run as an uncompensated move";
    return {};
}

void position_axis(Run& run, const BlockWords::NamedAxis& axis) {
    const int k = axis.name == "X" ? 0 : axis.name == "Y" ? 1 : 2;
    const bool incremental = is_incremental(run, axis.reference);
    const double v = axis.value * word_factor(run, k, axis.reference);
    geom::Vec3 to = run.programmed_position;
    coordinate(to, k) = incremental ? coordinate(to, k) + v : v;
    const auto feed = run.axis_feeds.find(axis.name);
    const bool rapid = feed == run.axis_feeds.end() || !(feed->second > 0);
    if (!rapid) emit(run, cl::Feed{feed->second, cl::FeedMode::per_minute});
    arrive(run, to);
    emit(run, cl::Linear{run.position, run.tool_axis, rapid});
    if (!rapid && run.feed_valid) emit(run, cl::Feed{run.feed, run.modal.feed_mode});
    if (rapid)
        assume(run, axis.where,
               "POS[" + axis.name + "]= without FA[" + axis.name + "]= goes at the axis' own speed: taken as a rapid");
}

}  // namespace

void position_axes(Run& run, bool path_moved) {
    const std::string why = unknown_way(run, path_moved);
    if (!why.empty()) unchecked(run, codes::unsupported, run.here(), why);
    flush_path(run);
    begin_motion(run);
    const std::vector<BlockWords::NamedAxis> axes = run.block.positioned;
    for (const BlockWords::NamedAxis& axis : axes)
        if (!run.stopped) position_axis(run, axis);
}

}  // namespace obrys::interp
