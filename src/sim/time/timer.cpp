#include "sim/time/timer.hpp"

#include <algorithm>
#include <utility>

#include "cl/spline.hpp"
#include "cl/totals.hpp"
#include "motion/technology.hpp"

namespace obrys::sim::time {
namespace {

constexpr std::size_t most_waiting = 16'384;  ///< blocks; a machine stops from any speed within far fewer
constexpr double minute = 60;
constexpr double curve_turn = geom::radians(20.0);  ///< more is a corner, however short its neighbours are

double curvature_of(const cl::Arc& a, double length) {
    const geom::Vec3 spoke = a.to - a.centre;
    const geom::Vec3 across = spoke - dot(spoke, a.normal) * a.normal;
    // Of a helix: what lies across its axis is all that bends.
    return length > 0 ? geom::length(across) * a.sweep * a.sweep / (length * length) : 0;
}

/// How much of the way each axis may have at some place of an arc.
geom::Vec3 reach_of(const cl::Arc& a, const geom::Vec3& way) {
    const auto across = [](double n) { return std::sqrt(std::max(0.0, 1 - n * n)); };
    const bool rises = std::abs(dot(way, a.normal)) > 0;
    return rises ? geom::Vec3{1, 1, 1} : geom::Vec3{across(a.normal.x), across(a.normal.y), across(a.normal.z)};
}

bool known(const geom::Vec3& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

double turn_between(const geom::Vec3& a, const geom::Vec3& b) {
    if (!known(a) || !known(b) || a == geom::Vec3{} || b == geom::Vec3{}) return geom::pi;
    return std::atan2(length(cross(a, b)), dot(a, b));
}

}  // namespace

Timer::Timer(std::span<const shop::Tool> tools, Dynamics dynamics) : dynamics_(std::move(dynamics)), cursor_(tools) {}

void Timer::spend(const Piece& piece, Cause cause, double seconds) {
    if (seconds == 0) return;
    const auto i = static_cast<std::size_t>(cause);
    times_.all[i] += seconds;
    if (tool_ == nullptr || piece.tool != tool_number_) {
        tool_number_ = piece.tool;
        tool_ = &times_.tools[tool_number_];
    }
    (*tool_)[i] += seconds;
    std::vector<Spent>& places = times_.places;
    if (places.size() == places.capacity() && places.size() > 2 * merged_) {
        merge(places);
        merged_ = std::max<std::size_t>(places.size(), 4096);
    }
    places.push_back({piece.place, cause, seconds});
}

void Timer::spend(const base::Span& from, Cause cause, double seconds) {
    Piece piece;
    piece.place = {from.file, from.begin};
    piece.tool = cursor_.state().change.number;
    spend(piece, cause, seconds);
}

void Timer::untimed(const motion::Step& step) {
    if (times_.untimed++ == 0) times_.first_untimed = step.record.from;
    stop(Cause::exact_stop);
}

/// On the way to the first place that is known.
void Timer::from_nowhere() {
    ++times_.from_nowhere;
    stop(Cause::exact_stop);
}

void Timer::take_spindle(const cl::Record& record, const cl::Spindle& spindle) {
    stop(Cause::exact_stop);
    const double x = cursor_.position().here().x;
    const bool held = spindle.mode == cl::SpindleMode::surface;
    const double most =
        std::min(motion::spindle_speed(spindle, std::abs(x), dynamics_.highest_speed), dynamics_.highest_speed);
    const double speed = spindle.direction == 0 ? 0 : held && std::isnan(x) ? NAN : most * spindle.direction;
    const double change = std::abs(speed - std::exchange(spindle_, speed));
    if (std::isnan(change)) ++times_.untimed_speeds;
    if (change > 0) spend(record.from, Cause::spindle, change / 1000 * dynamics_.spindle_time);
}

void Timer::take(const cl::Record& record) {
    if (const std::optional<motion::Step> step = cursor_.take(record)) return take_move(*step);
    if (const auto* dwell = std::get_if<cl::Dwell>(&record.step)) {
        stop(Cause::exact_stop);
        const double seconds = motion::dwell_seconds(*dwell, cursor_.state().spindle, cursor_.position().here().x,
                                                     dynamics_.highest_speed);
        if (std::isfinite(seconds)) return spend(record.from, Cause::dwell, seconds);
        ++times_.untimed_dwells;
    } else if (const auto* spindle = std::get_if<cl::Spindle>(&record.step)) {
        take_spindle(record, *spindle);
    } else if (const auto* change = std::get_if<cl::ToolChange>(&record.step)) {
        if (change->standing) return;
        stop(Cause::exact_stop);
        spend(record.from, Cause::tool_change, dynamics_.tool_change);
    } else if (const auto* halt = std::get_if<cl::Stop>(&record.step)) {
        stop(Cause::exact_stop);
        if (halt->kind == cl::StopKind::program) ++times_.stops;
    } else if (std::holds_alternative<cl::Coolant>(record.step) || std::holds_alternative<cl::Auxiliary>(record.step)) {
        stop(Cause::exact_stop);
    }
}

/// How far additional axes go along with a move, and from here on where they stand.
Timer::Turns Timer::take_turns(const cl::Step& step) {
    Turns turns;
    for (const cl::AxisEnd& end : *cl::ends_of(step)) {
        const std::string name(cl::name_of(end.name));
        const auto stood = stand_.find(name);
        const auto limits = dynamics_.others.find(name);
        if (stood == stand_.end()) turns.begins_nowhere = true;
        const double way = stood == stand_.end() ? NAN : std::abs(end.to - stood->second);
        if (way > 0 && limits != dynamics_.others.end()) turns.ways.emplace_back(&limits->second, way);
        if (std::isnan(end.to) || (way > 0 && limits == dynamics_.others.end())) turns.unknown = true;
        if (std::isnan(end.to))
            stand_.erase(name);
        else
            stand_[name] = end.to;
    }
    return turns;
}

void Timer::take_move(const motion::Step& step) {
    ++times_.moves;
    const double length = cl::move_length(step.from, step.record.step);
    const Turns turns = take_turns(step.record.step);
    const bool known = std::isfinite(length);
    if (turns.unknown || (!known && begun_)) return untimed(step);
    if (!known || turns.begins_nowhere) {
        if (known) begun_ = true;
        return step.rapid ? from_nowhere() : untimed(step);
    }
    begun_ = true;
    const cl::PathMode* path = step.state.path ? &*step.state.path : nullptr;
    // Rapid moves are ended before anything else begins: so all controls do unless a parameter says otherwise.
    if (step.rapid || last_rapid_ || (path != nullptr && path->kind == cl::PathKind::exact_stop))
        stop(Cause::exact_stop);
    last_rapid_ = step.rapid;
    if (length == 0) return take_turn(step, turns);
    times_.way += length;
    if (const auto* spline = std::get_if<cl::Spline>(&step.record.step)) {
        const geom::Cubic curve = cl::forward(*spline);
        constexpr int parts = 16;
        geom::Vec3 from = point_at(curve, 0);
        for (int i = 1; i <= parts; ++i) {
            const geom::Vec3 to = point_at(curve, static_cast<double>(i) / parts);
            if (const double part = geom::distance(from, to); part > 0) add(step, part, from, to, 0, turns);
            from = to;
        }
        return;
    }
    const auto* arc = std::get_if<cl::Arc>(&step.record.step);
    add(step, length, step.from, step.to, arc != nullptr ? curvature_of(*arc, length) : 0, turns);
}

/// Additional axes alone. Degrees per minute is what a feed says of a rotary one.
void Timer::take_turn(const motion::Step& step, const Turns& turns) {
    if (turns.ways.empty()) return;
    const cl::Feed& feed = step.state.feed;
    const bool by_time = !step.rapid && feed.mode == cl::FeedMode::inverse_time;
    if (!step.rapid && (!(feed.value > 0) || feed.mode == cl::FeedMode::per_rev)) return untimed(step);
    double seconds = by_time ? minute / feed.value : 0;
    for (const auto& [limits, way] : turns.ways) {
        const double asked = step.rapid || by_time ? limits->speed : std::min(limits->speed, feed.value / minute);
        if (const auto span = plan_span(way, {}, {}, asked, {limits->acceleration, limits->jerk}))
            seconds = std::max(seconds, span->seconds);
    }
    stop(Cause::exact_stop);
    spend(step.record.from, step.rapid ? Cause::rapid : Cause::feed, seconds);
}

void Timer::add(const motion::Step& step, double length, const geom::Vec3& from, const geom::Vec3& to, double curvature,
                const Turns& turns) {
    // Coordinates that nobody knows do not move.
    geom::Vec3 way = to - from;
    for (std::size_t i = 0; i < 3; ++i)
        if (double& part = i == 0 ? way.x : i == 1 ? way.y : way.z; std::isnan(part)) part = 0;
    const bool straight = curvature == 0;
    const geom::Vec3 direction = straight ? (1 / geom::length(way)) * way : geom::Vec3{};
    const WayLimits own = along(dynamics_, straight ? direction : reach_of(std::get<cl::Arc>(step.record.step), way));
    Piece piece;
    piece.place = {step.record.from.file, step.record.from.begin};
    piece.tool = step.state.change.number;
    piece.asked = piece.most = step.rapid ? Cause::rapid : Cause::feed;
    piece.fed = step.rapid ? own.speed : length / motion::feed_seconds(step, length, dynamics_.highest_speed);
    if (!(piece.fed > 0)) return untimed(step);
    Block block{length, piece.fed, own.limits, INFINITY};
    const double axes = step.rapid ? own.speed : std::min(own.speed, dynamics_.most_feed);
    if (axes < block.speed) block.speed = axes, piece.most = Cause::axis_speed;
    // Additional axes go along, and may be slower than the path.
    for (const auto& [limits, turned] : turns.ways)
        if (const double speed = limits->speed * length / turned; speed < block.speed)
            block.speed = speed, piece.most = Cause::axis_speed;
    const CornerSpeed bent = curve_speed(curvature, block.speed, own.limits);
    if (bent.by != CornerLimit::none) block.speed = bent.speed, piece.most = Cause::curvature;
    if (dynamics_.block_time > 0 && length / dynamics_.block_time < block.speed)
        block.speed = length / dynamics_.block_time, piece.most = Cause::block_rate;
    join(straight ? direction : cl::first_direction(step.from, step.record.step), length, step);
    piece.leaves = straight ? direction : cl::last_direction(step.from, step.record.step);
    piece.sharpness = straight ? length : 0;
    blocks_.push_back(block);
    pieces_.push_back(piece);
    if (blocks_.size() >= most_waiting) plan_piece();
}

/// How fast the last block may end where a move of this direction follows.
void Timer::join(const geom::Vec3& direction, double length, const motion::Step& step) {
    if (blocks_.empty()) return;
    Block& last = blocks_.back();
    Piece& piece = pieces_.back();
    const double turn = turn_between(piece.leaves, direction);
    piece.end = Cause::acceleration;
    const cl::PathMode* path = step.state.path ? &*step.state.path : nullptr;
    const double tolerance = step.state.tolerance.contour > 0         ? step.state.tolerance.contour
                             : path != nullptr && path->tolerance > 0 ? path->tolerance
                                                                      : dynamics_.tolerance;
    const double before = piece.sharpness, mean = (before + length) / 2;
    CornerSpeed corner{last.speed, CornerLimit::none};
    if (turn < 1e-6) {
        // straight on
    } else if (before > 0 && turn < curve_turn && turn * mean / 8 <= tolerance) {
        corner = curve_speed(turn / mean, last.speed, last.limits);
        if (corner.by != CornerLimit::none) piece.end = Cause::curvature;
    } else if (dynamics_.corner == CornerMode::exact_stop || (path != nullptr && path->kind == cl::PathKind::exact)) {
        corner = {0, CornerLimit::stop};
        piece.end = Cause::exact_stop;
    } else {
        const double shorter = std::min(before > 0 ? before : length, length);
        corner = dynamics_.corner == CornerMode::filter
                     ? filtered_corner(turn, tolerance, last.speed, last.limits)
                     : blended_corner(turn, tolerance, shorter, last.speed, last.limits);
        if (corner.by != CornerLimit::none) piece.end = Cause::corner;
    }
    last.end_speed = std::min(last.end_speed, corner.speed);
}

void Timer::look_ahead() {
    if (dynamics_.look_ahead > 0)
        limit_to_known(blocks_, dynamics_.look_ahead, [&](std::size_t i) { pieces_[i].end = Cause::look_ahead; });
}

Cause Timer::cause_at(std::uint32_t place, const Block& block) const {
    if (place == 0) return began_;
    const Piece& piece = pieces_[place - 1];
    // Slower than its corner allows, it is the feed of a neighbour that holds it down.
    return piece.end == Cause::feed || block.end_speed >= block.speed ? Cause::acceleration : piece.end;
}

void Timer::spend_blocks(const Profile& profile, std::size_t spans) {
    const std::vector<BlockTime> times = block_times(blocks_, profile);
    for (std::size_t n = 0; n < spans; ++n) {
        const std::uint32_t from = profile.places[n].block, to = profile.places[n + 1].block;
        const Cause left = cause_at(from, from == 0 ? Block{} : blocks_[from - 1]),
                    right = cause_at(to, blocks_[to - 1]);
        for (std::uint32_t i = from; i < to; ++i) {
            const Block& block = blocks_[i];
            const Piece& piece = pieces_[i];
            const double fed = block.length / piece.fed, most = block.length / block.speed;
            spend(piece, piece.asked, fed);
            if (most > fed) spend(piece, piece.most, most - fed);
            const double rest = times[i].seconds - std::max(most, fed);
            const double share = times[i].seconds > 0 ? times[i].rising / times[i].seconds : 0;
            spend(piece, left, rest * share);
            spend(piece, right, rest * (1 - share));
        }
    }
}

void Timer::stop(Cause why) {
    if (!blocks_.empty()) {
        look_ahead();
        blocks_.back().end_speed = 0;
        pieces_.back().end = why;
        const Profile profile = plan(blocks_, begin_, 0);
        spend_blocks(profile, profile.spans.size());
        blocks_.clear();
        pieces_.clear();
    }
    begin_ = 0;
    began_ = why;
}

void Timer::plan_piece() {
    look_ahead();
    const auto half = static_cast<std::uint32_t>(blocks_.size() / 2);
    const Profile whole = plan(blocks_, begin_, 0);
    const double speed = block_times(blocks_, whole)[half - 1].speed;
    const std::vector<Block> later(blocks_.begin() + half, blocks_.end());
    const std::vector<Piece> pieces(pieces_.begin() + half, pieces_.end());
    blocks_.resize(half);
    pieces_.resize(half);
    const Cause end = pieces_.back().end;
    const Profile profile = plan(blocks_, begin_, speed);
    spend_blocks(profile, profile.spans.size());
    begin_ = profile.places.back().speed;
    began_ = end == Cause::feed ? Cause::acceleration : end;
    blocks_ = later;
    pieces_ = pieces;
}

Times Timer::finish() {
    stop(Cause::exact_stop);
    merge(times_.places);
    tool_ = nullptr;
    return std::move(times_);
}

}  // namespace obrys::sim::time
