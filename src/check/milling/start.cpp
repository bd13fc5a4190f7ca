/// Moves of which one end is not known: from the start, to and from home.

#include <algorithm>

#include "check/milling/milling.hpp"

namespace obrys::check {

namespace milling = sim::milling;

namespace {

/// Highest point of all that may be met.
double top_of(const MillingSetup& m) {
    double top = milling::box_of(m.stock).max.z;
    for (const Clamp& c : m.clamps) top = std::max(top, milling::box_of(c.body).max.z);
    return top;
}

}  // namespace

/// What is known of the way is simulated; reports show its ends as far as they are known.
void Milling::take_open(const Move& move, std::uint32_t use, const motion::Stand::View& view) {
    const bool upright = !move.turning && view.problem.empty() && geom::distance(view.axis, {0, 0, 1}) < 1e-9;
    const bool straight = std::holds_alternative<cl::Linear>(move.record.step);
    const geom::Vec3 away{NAN, NAN, upright ? top_of(*setup_.milling) : NAN};
    OpenMove open = whereabouts_.open(move.from, move.to, move.rapid, away);
    const bool spindle_empty = tool_ == nullptr && tool_name_.empty();
    if (!upright || !straight || (open.start && spindle_empty)) open.way.kind = OpenWay::Kind::lost;
    if (open.start) ++start_moves_;
    if (open.assumed)
        out_.assumption("a position that is not known, such as home, is taken to lie above the stock",
                        move.record.from);
    if (open.way.kind == OpenWay::Kind::swept || open.way.kind == OpenWay::Kind::end) {
        const Whereabouts now = whereabouts_;
        const cl::Record record{cl::Linear{open.way.to, view.axis, move.rapid}, move.record.from, move.record.stack};
        const std::size_t before = moves_.size();
        take(Move{record, move.index, open.way.from, open.way.to, move.rapid, false}, use, view, {});
        whereabouts_ = now;
        if (moves_.size() > before) {
            moves_.back().from = move.from;
            moves_.back().to = move.to;
        }
    }
    if (!open.left_out && (open.start || (upright && straight))) return;
    complete_ = false;
    if (view.problem.empty())
        out_.unchecked(move.record, "position not known: removal not simulated");
    else
        out_.unchecked(move.record, view.problem, view.remedy);
}

}  // namespace obrys::check
