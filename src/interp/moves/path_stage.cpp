#include "interp/stream/path_stage.hpp"

#include <cmath>
#include <utility>

#include "base/codes.hpp"
#include "base/whole.hpp"
#include "interp/moves/moves.hpp"

namespace obrys::interp {

namespace codes = base::codes;

namespace {

/// A size written with a sign (Reference::incremental) says by it which way the next element goes along the axis of the
/// plane that its block does not name.
path::CornerRequest sized_corner(const Moving& run, path::CornerKind kind, Code code) {
    const BlockWords& b = run.block;
    path::CornerRequest r;
    r.kind = kind;
    r.size = b.get(code) * length_unit(run.modal);
    r.modal = run.traits->corner_may_be_tangential;
    if (b.ref(code) != 1 + static_cast<std::uint8_t>(program::Reference::incremental)) return r;
    const PlaneAxes a = plane_axes(run.modal.plane);
    const bool u = b.has(axis_code(a.u)), v = b.has(axis_code(a.v));
    if (u != v) r.toward = u ? geom::Vec2{0, r.size} : geom::Vec2{r.size, 0};
    r.size = std::abs(r.size);
    return r;
}

}  // namespace

path::CornerRequest corner_of_block(const Moving& run) {
    const BlockWords& b = run.block;
    if (b.has(Code::chamfer_length)) return sized_corner(run, path::CornerKind::chamfer, Code::chamfer_length);
    if (b.has(Code::chamfer_leg)) return sized_corner(run, path::CornerKind::chamfer_leg, Code::chamfer_leg);
    if (b.has(Code::round)) return sized_corner(run, path::CornerKind::rounding, Code::round);
    path::CornerRequest modal;
    if (run.modal.round_modal > 0 && run.modal.motion != Modal::rapid) {
        modal.kind = path::CornerKind::rounding;
        modal.size = run.modal.round_modal;
        modal.modal = true;
    }
    return modal;
}

namespace {

bool asks_corner(const BlockWords& b) {
    return (b.present & (bit(Code::chamfer_length) | bit(Code::chamfer_leg) | bit(Code::round))) != 0;
}

/// Nothing has to do with a corner where this is not so.
bool may_ask_corner(const Moving& run) {
    return asks_corner(run.block) || run.block.has(Code::corner_feed) || run.modal.round_modal > 0;
}

/// What the program says for the corner alone; 0: nothing.
double corner_feed(const Moving& run) {
    const BlockWords& b = run.block;
    const double feed = b.has(Code::corner_feed) ? b.peek(Code::corner_feed) : run.modal.corner_feed_modal;
    return feed > 0 ? feed * feed_factor(run) : 0;
}

/// At which a corner is run that is not run at the feed of the element behind it; 0: it is.
double feed_of_corner(const Moving& run) {
    const double own = corner_feed(run);
    return own > 0 || !run.traits->corner_keeps_feed ? own : run.feed;
}

}  // namespace

path::CornerRequest PathStage::corner_request(Moving& run) {
    const BlockWords& b = run.block;
    path::CornerRequest r = corner_of_block(run);
    const geom::Vec3& at = run.programmed_position;
    const PlaneAxes a = plane_axes(run.modal.plane);
    if (r.kind != path::CornerKind::none && !std::isfinite(coordinate(at, a.u) + coordinate(at, a.v))) {
        unchecked(run, codes::unknown_value, run.here(),
                  "where the move before this chamfer or rounding comes from is not known: it is left out",
                  "move to a known place before");
        return {};
    }
    if (std::isnan(r.size)) {
        unchecked(run, codes::unknown_value, run.here(),
                  "the size of this chamfer or rounding depends on a value that is not known: it is left out");
        return {};
    }
    if (b.has(Code::corner_feed)) b.use(Code::corner_feed);
    if (const double feed = feed_of_corner(run); r.kind != path::CornerKind::none && feed > 0 && run.feed_valid)
        put_corner_feed(run, feed, r);
    return r;
}

namespace {

/// DISC, 0 … 1; it acts with G450 alone.
double pulled_out(const Reckoning& run) {
    return run.modal.corner == Modal::corner_intersection ? 0 : run.modal.corner_overshoot / 100;
}

}  // namespace

void PathStage::push(Moving& run, path::Element&& e, bool rapid) {
    const path::Setting s = compensation_setting(run);
    tell_begin(run, s);
    tell_programmed(run, e, rapid);
    take(run, std::move(e), s, rapid);
}

void PathStage::push(Moving& run, path::Element&& e, const path::Setting& s) {
    tell_begin(run, s);
    take(run, std::move(e), s, false);
}

/// Compensation that begins or becomes another one.
void PathStage::tell_begin(Moving& run, const path::Setting& s) {
    if (s.side == path::Side::off) return tell_end(run);
    const auto side = s.side == path::Side::left ? cl::CompensationSide::left : cl::CompensationSide::right;
    const double radius = radius_in_stream(run, s.radius);
    const bool sharp = s.corner == path::OuterCorner::intersection;
    const geom::Vec3 normal = plane_normal(run);
    const bool goes_on =
        told_ && told_->side == side && told_->radius == radius && told_->sharp == sharp && told_->normal == normal;
    if (goes_on) return;
    const double number = run.block.has(Code::offset_d) ? run.block.peek(Code::offset_d) : run.modal.offset_d;
    cl::CompensationBegin begin;
    begin.side = side;
    begin.radius = radius;
    begin.sharp = sharp;
    begin.normal = normal;
    begin.given = run.modal.compensation_given;
    if (begin.given) begin.nose = base::whole<std::uint32_t>(run.modal.compensation_orientation, 0).value_or(0);
    if (!begin.given) begin.offset = base::whole<std::uint32_t>(number, 0).value_or(0);
    begin.approach = static_cast<cl::Approach>(s.approach);
    tell_end(run);
    told_ = begin;
    hold({begin, run.here(), run.top().stack});
}

void PathStage::tell_programmed(Moving& run, const path::Element& e, bool rapid) {
    cl::Record& record = next_event();
    auto& p = step_as<cl::Programmed>(record.step);
    if (!programmed_element(run, e, rapid, fixed_plane_, p)) return;
    if (may_ask_corner(run))
        if (const path::CornerRequest corner = corner_of_block(run);
            corner.kind != path::CornerKind::none && std::isfinite(corner.size))
            p.corner = static_cast<cl::Corner>(corner.kind), p.size = corner.size, p.corner_feed = corner_feed(run);
    p.ends = run.ends;
    record.from = run.here();
    record.stack = run.top().stack;
    waiting_.push_back(static_cast<int>(event_count_++));
}

void PathStage::judge_idle_blocks(Saying& run, const path::Element& e, const path::Setting& s) {
    if (!path::moves_in_plane(e)) return;
    constexpr double straight_on = 1e-3;  // rad
    const program::IdleBlocks& limit = run.traits->compensation_idle_blocks;
    block_moved_ = true;
    if (limit.seen_past == 0) return;
    const bool joined = active_ && direction_ && s.side != path::Side::off && s.side == side_;
    if (joined && idle_blocks_ > limit.seen_past &&
        std::abs(path::turn_between(direction_->get(), path::start_direction(e))) > straight_on)
        unchecked(
            run, codes::unsupported, run.here(),
            std::to_string(idle_blocks_) +
                " blocks without motion in the plane stand before this corner under radius compensation, which is " +
                "run as if the control saw past them; by " + std::string(limit.setting) + " it sees past " +
                std::to_string(limit.seen_past) + ", and behind more " + std::string(limit.beyond),
            "write them beside a move, before the compensation or behind it");
    idle_blocks_ = 0;
    side_ = s.side;
    direction_ = path::EndDirection(e);
}

void PathStage::take(Moving& run, path::Element&& e, const path::Setting& s, bool rapid) {
    judge_idle_blocks(run, e, s);
    e.tag = origins_.size();
    e.before = std::move(waiting_);
    const double offset = s.side == path::Side::off ? 0 : s.side == path::Side::left ? s.radius : -s.radius;
    origins_.push_back({run.here(), run.top().stack, rapid || run.block.rapid, s.radius, offset, run.modal.plunge_part,
                        run.modal.feed_reference, s.clearance == path::Clearance::avoided, fixed_plane_,
                        pulled_out(run), asks_corner(run.block)});
    if (!active_) last_.reset();
    active_ = true;
    if (path::moves(e) && !path::moves_in_plane(e)) say_open_corner(run);
    static const path::CornerRequest none{};
    std::optional<path::CornerRequest> asked;
    if (may_ask_corner(run)) asked = corner_request(run);
    const path::CornerRequest& corner = asked ? *asked : none;
    if (asks_corner(run.block) && corner.kind != path::CornerKind::none && !path::moves_in_plane(e))
        say_no_corner(run, run.here(),
                      "there is no corner for this chamfer or rounding, which is left out: the block that it belongs "
                      "to does not move in the plane",
                      "write it behind an element of the contour");
    report(run, path_.push(std::move(e), s, corner, [&](const path::Output& out) { output(run, out); }));
    holds_ = !path_.idle();
    if (path_.idle())
        forget();
    else if (s.side == path::Side::off && corner.kind == path::CornerKind::none)
        flush(run);
}

}  // namespace obrys::interp
