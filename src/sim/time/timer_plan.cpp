/// Profiles under what waits, and what their seconds were spent on.

#include <algorithm>
#include <cmath>

#include "sim/time/timer.hpp"

namespace obrys::sim::time {
namespace {

constexpr std::size_t usually_waiting = 4096, most_waiting = 65'536;  ///< blocks
/// Of an axis that lags as usual, where the machine is assumed not to: 1 m/min/mm, to 10 um (shared spec physics.md).
constexpr double lagging_gain = 1000.0 / 60, lagging_window = 0.01;

double speed_at(const Span& span, double seconds) {
    Motion m{0, span.from.speed, span.from.acceleration};
    for (std::size_t i = 0; i < span.count; ++i) {
        const Phase& p = span.phases[i];
        if (seconds <= p.seconds) return after(m, seconds, p.jerk).speed;
        m = after(m, p.seconds, p.jerk);
        seconds -= p.seconds;
    }
    return m.speed;
}

}  // namespace

/// A piece is planned once the machine could stand several times within what waits.
void Timer::wait(const Block& block) {
    waiting_.way += block.length;
    waiting_.speed = std::max(waiting_.speed, block.speed);
    waiting_.least.acceleration = std::min(waiting_.least.acceleration, block.limits.acceleration);
    waiting_.least.jerk = std::min(waiting_.least.jerk, block.limits.jerk);
    if (blocks_.size() < usually_waiting || blocks_.size() < waiting_.next) return;
    if (blocks_.size() < most_waiting && waiting_.way < 16 * ramp_length(0, waiting_.speed, waiting_.least)) return;
    plan_piece();
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

void Timer::settle(const Piece& piece, double speed) {
    if (!(dynamics_.servo_gain > 0)) {
        times_.may_settle += settling_time(speed, lagging_gain, lagging_window);
        return;
    }
    const double seconds = settling_time(speed, dynamics_.servo_gain, dynamics_.window);
    spend(piece, Cause::exact_stop, seconds);
    if (options_.samples > 0) curve_.take(seconds, 0, 0, piece.place);
}

void Timer::draw(const Span& span, double from, double seconds, const Place& place) {
    // Short blocks are drawn straight; of a long one its ramps are seen.
    const int parts = seconds > curve_.step() / 4 ? 24 : 1;
    double before = speed_at(span, from);
    for (int i = 1; i <= parts; ++i) {
        const double then = speed_at(span, from + seconds * i / parts);
        curve_.take(seconds / parts, before, then, place);
        before = then;
    }
}

void Timer::spend_blocks(const Profile& profile, std::size_t spans) {
    block_times(blocks_, profile, spans, block_times_);
    for (std::size_t n = 0; n < spans; ++n) {
        const std::uint32_t from = profile.places[n].block, to = profile.places[n + 1].block;
        const Cause left = cause_at(from, from == 0 ? Block{} : blocks_[from - 1]),
                    right = cause_at(to, blocks_[to - 1]);
        double passed = 0;
        for (std::uint32_t i = from; i < to; ++i) {
            const Block& block = blocks_[i];
            const Piece& piece = pieces_[i];
            const BlockTime& time = block_times_[i];
            const double fed = block.length / piece.fed, most = block.length / block.speed;
            spend(piece, piece.asked, fed);
            if (most > fed) spend(piece, piece.most, most - fed);
            const double rest = time.seconds - std::max(most, fed);
            const double share = time.seconds > 0 ? time.rising / time.seconds : 0;
            spend(piece, left, rest * share);
            spend(piece, right, rest * (1 - share));
            if (options_.samples > 0) draw(profile.spans[n], passed, time.seconds, piece.place);
            passed += time.seconds;
        }
        if (profile.places[n + 1].speed == 0) settle(pieces_[to - 1], profile.spans[n].peak);
    }
}

void Timer::drop(std::size_t count) {
    const auto n = static_cast<std::ptrdiff_t>(count);
    blocks_.erase(blocks_.begin(), blocks_.begin() + n);
    pieces_.erase(pieces_.begin(), pieces_.begin() + n);
    waiting_ = {};
    for (const Block& b : blocks_) {
        waiting_.way += b.length;
        waiting_.speed = std::max(waiting_.speed, b.speed);
    }
    if (!blocks_.empty()) waiting_.least = blocks_.front().limits;
    waiting_.next = count > 0 ? 0 : 2 * blocks_.size();
}

void Timer::stop(Cause why) {
    if (!blocks_.empty()) {
        look_ahead();
        blocks_.back().end_speed = 0;
        pieces_.back().end = why;
        const Profile profile = plan(blocks_, begin_, 0);
        spend_blocks(profile, profile.spans.size());
        if (last_rapid_) rapid_seconds_ += profile.seconds();
        drop(blocks_.size());
    }
    begin_ = 0;
    began_ = why;
}

/// Up to the last slow place from which on there is way enough to stand: what follows does not change it any more.
void Timer::plan_piece() {
    look_ahead();
    const std::size_t n = blocks_.size();
    const Profile whole = plan(blocks_, begin_, 0);
    const double enough = 4 * ramp_length(0, waiting_.speed, waiting_.least);
    std::size_t place = whole.spans.size();
    for (double way = 0; place > 0; --place) {
        const Profile::Place& p = whole.places[place];
        for (std::uint32_t i = p.block; place < whole.spans.size() && i < whole.places[place + 1].block; ++i)
            way += blocks_[i].length;
        if (way >= enough && p.acceleration == 0 && p.speed > 0 && n - p.block > dynamics_.look_ahead &&
            p.block <= n - n / 16)
            break;
    }
    if (place == 0 || whole.places[place].block < n / 4) return plan_half(whole);
    const Profile::Place cut = whole.places[place];
    spend_blocks(whole, place);
    const Cause end = cause_at(cut.block, blocks_[cut.block - 1]);
    drop(cut.block);
    begin_ = cut.speed;
    began_ = end;
}

/// Where nothing is slow for long: in the middle, at the speed that it has there.
void Timer::plan_half(const Profile& whole) {
    const auto half = static_cast<std::uint32_t>(blocks_.size() / 2);
    block_times(blocks_, whole, whole.spans.size(), block_times_);
    const double speed = block_times_[half - 1].speed;
    const Profile profile = plan(std::span(blocks_).first(half), begin_, speed);
    const Cause end = pieces_[half - 1].end;
    spend_blocks(profile, profile.spans.size());
    drop(half);
    begin_ = profile.places.back().speed;
    began_ = end == Cause::feed ? Cause::acceleration : end;
}

}  // namespace obrys::sim::time
