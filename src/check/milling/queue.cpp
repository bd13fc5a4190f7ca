/// What of a tool goes where: the passes of a move, for the stock, the part and the clamps.

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/whole.hpp"
#include "check/milling/milling.hpp"
#include "check/milling_tool.hpp"
#include "check/touching/rapid_way.hpp"
#include "sim/milling/cut/pieces.hpp"

namespace obrys::check {

namespace milling = sim::milling;

namespace {

constexpr double piece_length = 0.1;                    ///< mm in which the way in the material is measured
constexpr double short_way = 1;                         ///< mm; moves up to that count as a whole
constexpr double off_the_wall = 0.5;                    ///< of a boring bar's radius
constexpr std::uint32_t most_pieces_of_move = 200'000;  ///< of one move whose core goes down

bool goes_down(const geom::PathElement& e, geom::Vec3 axis) {
    return geom::dot(geom::point_at(e, 1) - geom::point_at(e, 0), axis) < -1e-9;
}

geom::PathElement part_of(const geom::PathElement& e, double u0, double u1) {
    if (const auto* s = std::get_if<geom::Straight>(&e))
        return geom::Straight{s->from + u0 * (s->to - s->from), s->from + u1 * (s->to - s->from)};
    if (const auto* c = std::get_if<geom::Circular>(&e)) {
        geom::Circular part = *c;
        part.from = u0 == 0 ? c->from : geom::point_at(e, u0);
        part.to = u1 == 1 ? c->to : geom::point_at(e, u1);
        part.centre = c->centre + u0 * geom::dot(c->to - c->from, c->normal) * c->normal;
        part.sweep = (u1 - u0) * c->sweep;
        return part;
    }
    return e;
}

}  // namespace

bool leads_down(const geom::PathElement& e, geom::Vec3 axis) {
    const auto* s = std::get_if<geom::Straight>(&e);
    if (s == nullptr) return false;
    const geom::Vec3 way = s->to - s->from;
    const double down = -geom::dot(way, axis);
    return down > 1e-9 && geom::length(way + down * axis) < 1e-9 * down;
}

/// Only straight ways may bend or turn: a rapid arc (HEIDENHAIN's C with FMAX, a rounded corner of G0) is run as it is.
void Milling::queue_rapid(const Move& move, const MilledMove& m, const geom::PathElement& way,
                          const motion::Stand::View& view, const std::vector<shop::ToolPose>& swing) {
    if (!std::holds_alternative<geom::Straight>(way)) return queue(way, m, false);
    const geom::Vec3 axis = axis_;
    for (std::size_t i = 1; i < swing.size(); ++i) {
        axis_ = swing[i].axis;
        queue(geom::Straight{swing[i - 1].tip, swing[i].tip}, m, false);
    }
    axis_ = axis;
    if (!swing.empty()) return;
    const geom::Straight straight{move.from, move.to};
    const shop::RapidPath path = rapid_path(setup_);
    if (path == shop::RapidPath::straight) return queue(straight, m, false);
    if (!motion::are_square(view.linear)) {
        out_.unchecked(move.record, "rapids that may bend are simulated straight while the rotary axes are swivelled");
        return queue(straight, m, false);
    }
    const std::vector<geom::Vec3> corners = motion::corners_of_rapid(setup_.machine, view.linear, move.from, move.to);
    if (corners.size() == 1) return queue(straight, m, false);
    if (path == shop::RapidPath::either) {
        if (!leaves_the_wall(straight)) queue_if_bent(move.from, corners);
        return queue(straight, m, false);
    }
    if (!setup_.machine.rapid_path) out_.assumption(bent_as_delivered(setup_), move.record.from);
    geom::Vec3 from = move.from;
    for (const geom::Vec3& to : corners) {
        queue(geom::Straight{from, to}, m, false);
        from = to;
    }
}

/// What the move would meet on its bent way; it takes nothing away.
void Milling::queue_if_bent(geom::Vec3 from, const std::vector<geom::Vec3>& corners) {
    if_bent_ = true;
    for (const geom::Vec3& to : corners) {
        const geom::Straight way{from, to};
        from = to;
        if (clamps_.empty() && is_above(way, 0)) continue;
        queue_pass(QueuedPass::Kind::rapid_probe, milling::Part::cutting, false, way);
        queue_body(way);
    }
    if_bent_ = false;
}

namespace {

/// How far beside a point, seen along an axis.
geom::Vec3 beside(geom::Vec3 p, geom::Vec3 point, geom::Vec3 axis) {
    const geom::Vec3 way = p - point;
    return way - (geom::dot(way, axis) / geom::dot(axis, axis)) * axis;
}

}  // namespace

/// A boring bar whose spindle stands at an angle, or was stopped by a cycle, as far beside its hole as its body may be
/// thinner than the hole.
bool Milling::leaves_the_wall(const geom::Straight& way) const {
    if (!edge_away_ || !may_bore(*tool_)) return false;
    const double most = off_the_wall * (tool_->radius + tool_->delta_radius);
    const geom::Vec3 from = beside(way.from, stopped_at_, axis_), to = beside(way.to, stopped_at_, axis_);
    if (!(std::max(geom::length(from), geom::length(to)) > 1e-9)) return false;
    if (geom::length(from) > most || geom::length(to) > most) return false;
    return is_placed(cycle_) || is_on_its_way_out(way, from, to);
}

/// By words of its own a program may do anything beside the hole: what cycles do is taken for what it is, a small step
/// to one side, along the axis outwards, and back over the hole.
bool Milling::is_on_its_way_out(const geom::Straight& way, const geom::Vec3& from, const geom::Vec3& to) const {
    constexpr double most_step = 1.0;  // mm; cycles step 0.2 mm, or by Q of G76
    if (std::max(geom::length(from), geom::length(to)) > most_step) return false;
    if (geom::dot(way.to - way.from, axis_) < -1e-9) return false;
    const auto is_there = [&](const geom::Vec3& v) {
        return geom::length(v) <= 1e-9 || !edge_leaves_ ||
               geom::length(v - (geom::dot(v, *edge_leaves_)) * *edge_leaves_) <= 1e-6;
    };
    const auto is_that_side = [&](const geom::Vec3& v) {
        return !edge_leaves_ || geom::dot(v, *edge_leaves_) >= -1e-9;
    };
    return is_there(from) && is_there(to) && is_that_side(from) && is_that_side(to);
}

std::uint32_t Milling::bar_of(double radius) {
    constexpr double steps = 1e6;  // 1e-6 mm: turned back and forth, a shift differs in its last digits
    const double rounded = std::floor(radius * steps) / steps;
    const auto [at, is_new] = bars_.try_emplace({sim_tool_, rounded}, 0);
    if (is_new) {
        milling::ToolShape bar;
        const double height = shop::cutting_height(*tool_).value_or(unknown_height);
        bar.cutting = milling::make_shape({milling::cylinder(0, height, rounded)});
        at->second = add_tool(bar);
    }
    return at->second;
}

/// Its edge stands off the wall, in a hole that lets it pass; the body behind it is no thinner than half as wide as
/// what the edge cuts.
void Milling::queue_bar(const geom::Straight& way, const MilledMove& move) {
    const double radius = tool_->radius + tool_->delta_radius;
    const auto probe = [&](const geom::Straight& e, double r) {
        const std::uint32_t own = std::exchange(sim_tool_, bar_of(r));
        queue_pass(QueuedPass::Kind::rapid_probe, milling::Part::cutting, false, e);
        if (certificate_) certificate_->add(static_cast<std::uint32_t>(moves_.size() - 1), e, axis_, sim_tool_);
        sim_tool_ = own;
    };
    const geom::Vec3 from = beside(way.from, stopped_at_, axis_), to = beside(way.to, stopped_at_, axis_);
    if (!edge_leaves_ && geom::length(to) > 1e-9) edge_leaves_ = (1 / geom::length(to)) * to;
    probe(way, off_the_wall * radius);
    if (geom::distance(from, to) < 1e-9) probe({way.from - from, way.to - from}, radius - geom::length(from));
    out_.assumption(
        "the spindle is stopped and the tool moves: its edge is taken to leave the wall, and the side opposite to it "
        "to "
        "have room in the hole",
        move.where);
}

void Milling::queue(const geom::PathElement& element, const MilledMove& move, bool feed) {
    const auto* way = std::get_if<geom::Straight>(&element);
    if (way != nullptr && leaves_the_wall(*way))
        queue_bar(*way, move);
    else
        queue_cutting(element, move, feed);
    queue_body(element);
}

/// What does not cut, and all of the tool against the clamps.
void Milling::queue_body(const geom::PathElement& element) {
    if (tool_parts_.shank) queue_pass(QueuedPass::Kind::shank, milling::Part::shank, false, element);
    if (tool_parts_.holder && !is_above(element, tool_parts_.holder_from))
        queue_pass(QueuedPass::Kind::holder, milling::Part::holder, false, element);
    queue_clamps(element);
}

/// What the cutting part meets and takes.
void Milling::queue_cutting(const geom::PathElement& element, const MilledMove& move, bool feed) {
    using Kind = QueuedPass::Kind;
    if (!feed) queue_pass(Kind::rapid_probe, milling::Part::cutting, false, element);
    if (certificate_) certificate_->add(static_cast<std::uint32_t>(moves_.size() - 1), element, axis_, sim_tool_);
    double way = geom::distance(move.from, move.to);
    if (const auto* c = std::get_if<geom::Circular>(&element)) {
        const geom::Vec3 spoke = c->from - c->centre;
        const double radius = geom::length(spoke - geom::dot(spoke, c->normal) * c->normal);
        way = geom::length(geom::Vec2{radius * c->sweep, geom::dot(c->to - c->from, c->normal)});
    }
    std::uint32_t pieces = 1;
    if (feed && !std::holds_alternative<geom::Cubic>(element) && way > short_way && way / piece_length < pieces_left_) {
        pieces = base::clipped<std::uint32_t>(std::ceil(way / piece_length), 1, pieces_left_);
        pieces_left_ -= pieces;
    }
    const double core = tool_parts_.core_radius;
    if (feed && core > 0 && !move.plunging && !std::holds_alternative<geom::Cubic>(element) &&
        goes_down(element, axis_))
        pieces = std::max(pieces, base::clipped<std::uint32_t>(std::ceil(2 * way / core), 1, most_pieces_of_move));
    const milling::Pieces all = milling::in_pieces_of_turns(element, pieces);
    pieces = base::clipped<std::uint32_t>(all.count, 1, 2 * most_pieces_of_move);
    for (std::uint32_t i = 0; i < pieces; ++i) {
        const geom::PathElement part = pieces == 1 ? element : part_of(element, all.end(i), all.end(i + 1));
        if (core > 0) queue_core(part, feed, move.plunging);
        queue_pass(Kind::cut, milling::Part::cutting, true, part, i > 0);
        const double length = way * (all.end(i + 1) - all.end(i));
        queued_.back().length = static_cast<float>(length);
        if (feed) figures_.contact_accuracy_mm = std::max(figures_.contact_accuracy_mm, length);
    }
}

/// What of the tool begins so high above its tip is above all that there is, wherever the straight or level way leads:
/// nothing to look for.
bool Milling::is_above(const geom::PathElement& element, double height) const {
    const geom::Vec3 from = geom::point_at(element, 0), to = geom::point_at(element, 1);
    const auto* circle = std::get_if<geom::Circular>(&element);
    const double size = geom::length(axis_);
    const bool level = circle != nullptr && geom::length(geom::cross(circle->normal, axis_)) <= 1e-12 * size;
    if (!level && !std::holds_alternative<geom::Straight>(element)) return false;
    const double low = std::min(geom::dot(from, axis_), geom::dot(to, axis_)) / size + height;
    return milling::heights_along(axis_, {all_.lo, all_.hi}).high / size < low;
}

/// What the simulation does not take is not simulated: said, once each reason.
void Milling::require(milling::Taken taken) {
    if (taken == milling::Taken::taken || taken == milling::Taken::no_motion) return;
    complete_ = false;
    const MilledMove& m = moves_.back();
    const cl::Record record{cl::Linear{m.to, axis_, m.rapid}, m.where, m.stack};
    out_.unchecked(record, taken == milling::Taken::too_long
                               ? "this move is too long for the tolerance asked for: it is not simulated"
                               : "the way or the tool of this move is not known: it is not simulated");
}

void Milling::queue_pass(QueuedPass::Kind kind, milling::Part part, bool cut, const geom::PathElement& element,
                         bool goes_on) {
    const milling::Pass pass{element, axis_, sim_tool_, part, cut, goes_on};
    require(simulation_->add(pass));
    if (part_guard_ && part != milling::Part::cutting) part_guard_->add(passes_, pass);
    if (stock_guard_ && kind != QueuedPass::Kind::cut) stock_guard_->add(passes_, pass);
    QueuedPass q;
    q.kind = kind;
    q.move = static_cast<std::uint32_t>(moves_.size() - 1);
    q.pass = passes_++;
    q.if_bent = if_bent_;
    q.low = std::min(geom::dot(geom::point_at(element, 0), axis_), geom::dot(geom::point_at(element, 1), axis_));
    q.axis = axis_;
    q.down = leads_down(element, axis_);
    move_of_pass_.push_back(q.move);
    queued_.push_back(q);
}

void Milling::queue_clamps(const geom::PathElement& element) {
    const double low =
        std::min(geom::dot(geom::point_at(element, 0), axis_), geom::dot(geom::point_at(element, 1), axis_));
    for (std::size_t i = 0; i < clamps_.size(); ++i) {
        Clamp& c = clamps_[i];
        for (const auto& [kind, part] : {std::pair{QueuedPass::Kind::cut, milling::Part::cutting},
                                         std::pair{QueuedPass::Kind::shank, milling::Part::shank},
                                         std::pair{QueuedPass::Kind::holder, milling::Part::holder}}) {
            const milling::Pass pass{element, axis_, sim_tool_, part, false};
            require(c.simulation.add(pass));
            c.guard->add(static_cast<std::uint32_t>(c.simulation.engagements().size() - 1), pass);
            QueuedPass q;
            q.kind = kind;
            q.move = static_cast<std::uint32_t>(moves_.size() - 1);
            q.clamp = static_cast<std::uint32_t>(i + 1);
            q.if_bent = if_bent_;
            q.pass = static_cast<std::uint32_t>(c.simulation.engagements().size() - 1);
            q.low = low;
            q.axis = axis_;
            q.down = leads_down(element, axis_);
            queued_.push_back(q);
        }
    }
}

}  // namespace obrys::check
