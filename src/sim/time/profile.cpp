#include "sim/time/profile.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "sim/time/walk.hpp"

namespace obrys::sim::time {
namespace {

constexpr double speed_noise = 1e-9;  ///< of speeds: what rounding makes of a limit that is just kept
constexpr std::uint32_t nobody = UINT32_MAX;

/// Until it no longer gets faster: the middle of what is gone along at the highest speed.
double seconds_to_top(const Span& s) {
    Motion m{0, s.from.speed, s.from.acceleration};
    double seconds = 0, first = 0, last = 0, highest = -1;
    for (std::size_t i = 0; i <= s.count; ++i) {
        if (m.speed > highest * (1 + speed_noise)) highest = m.speed, first = seconds;
        if (m.speed >= highest * (1 - speed_noise)) last = seconds;
        if (i == s.count) break;
        m = after(m, s.phases[i].seconds, s.phases[i].jerk);
        seconds += s.phases[i].seconds;
    }
    return (first + last) / 2;
}

class Planner {
public:
    Planner(std::span<const Block> blocks, double begin, double end) : blocks_(blocks) {
        const std::size_t n = blocks.size();
        at_.resize(n + 1);
        most_.resize(n + 1);
        for (std::size_t i = 0; i < n; ++i) {
            at_[i + 1] = at_[i] + blocks[i].length;
            most_[i] = i == 0 ? begin : std::min({blocks[i - 1].speed, blocks[i - 1].end_speed, blocks[i].speed});
        }
        most_[n] = end;
        if (n > 0)
            most_[n] = std::min({end, blocks[n - 1].speed, blocks[n - 1].end_speed}),
            most_[0] = std::min(begin, blocks[0].speed);
        nodes_.resize(n + 1);
    }

    Profile run() {
        const auto n = static_cast<std::uint32_t>(blocks_.size());
        Profile profile;
        if (n == 0) return profile;
        nodes_[0] = {most_[0], 0, nobody, n, {}, false};
        nodes_[n] = {most_[n], 0, 0, nobody, {}, false};
        ask(0);
        settle();
        for (int round = 0; round < 6; ++round)
            if (!lean()) break;
        for (std::uint32_t i = 0; i != nobody; i = nodes_[i].next) {
            profile.places.push_back({i, nodes_[i].speed, nodes_[i].acceleration});
            if (nodes_[i].next != nobody) profile.spans.push_back(nodes_[i].span);
        }
        return profile;
    }

private:
    /// A slow place, and the span that follows it.
    struct Node {
        double speed = 0, acceleration = 0;
        std::uint32_t before = nobody, next = nobody;
        Span span;
        bool asked = false;
    };

    void ask(std::uint32_t i) {
        if (i == nobody || nodes_[i].next == nobody || nodes_[i].asked) return;
        nodes_[i].asked = true;
        open_.push_back(i);
    }

    void settle() {
        while (!open_.empty()) {
            const std::uint32_t i = open_.back();
            open_.pop_back();
            nodes_[i].asked = false;
            work(i);
        }
    }

    [[nodiscard]] Limits limits(std::uint32_t from, std::uint32_t to) const {
        Limits l = blocks_[from].limits;
        for (std::uint32_t i = from + 1; i < to; ++i) {
            l.acceleration = std::min(l.acceleration, blocks_[i].limits.acceleration);
            l.jerk = std::min(l.jerk, blocks_[i].limits.jerk);
        }
        return l;
    }
    [[nodiscard]] double highest(std::uint32_t from, std::uint32_t to) const {
        double v = 0;
        for (std::uint32_t i = from; i < to; ++i) v = std::max(v, blocks_[i].speed);
        return v;
    }

    /// Plans the span behind a place; lowers an end, or adds a place, where it does not hold.
    void work(std::uint32_t i) {
        const std::uint32_t k = nodes_[i].next;
        Node &a = nodes_[i], &b = nodes_[k];
        const Limits l = limits(i, k);
        const double length = at_[k] - at_[i];
        const double slow = std::min(a.speed, b.speed), fast = std::max(a.speed, b.speed);
        if (fast > slow && ramp_length(slow, fast, l) > length * (1 + speed_noise)) {
            const bool at_end = b.speed > a.speed;
            (at_end ? b : a).speed = reachable(slow, length, l);
            ask(at_end ? k : a.before);
        }
        double most = highest(i, k);
        for (int tries = 0; tries < 8; ++tries) {
            const std::optional<Span> s = plan_span(length, {a.speed, 0}, {b.speed, 0}, most, l);
            a.span = s ? *s : crawl(length, a.speed, b.speed);
            const Fault f = fault(a.span, i, k);
            if (f.place != nobody) return split(i, f.place, k);
            if (f.lower >= most) return;
            if (f.lower < fast && (f.slow > i || f.slow + 1 < k)) return split(i, f.slow > i ? f.slow : f.slow + 1, k);
            most = f.lower;
        }
    }

    /// Where rounding leaves no curve: the mean speed.
    static Span crawl(double length, double from, double to) {
        Span s;
        s.from = {from, 0};
        s.count = 1;
        s.peak = std::max(from, to);
        s.phases[0] = {from + to > 0 ? 2 * length / (from + to) : 0, 0};
        s.seconds = s.phases[0].seconds;
        return s;
    }

    struct Fault {
        std::uint32_t place = nobody;  ///< where it is fastest beyond what is allowed
        double lower = INFINITY;       ///< the most that a block allows which is too fast in its middle
        std::uint32_t slow = nobody;   ///< that block
    };
    [[nodiscard]] Fault fault(const Span& s, std::uint32_t from, std::uint32_t to, bool any = false) const {
        Fault f;
        Walk walk(s);
        double worst = speed_noise, before = s.from.speed;
        for (std::uint32_t i = from; i < to; ++i) {
            const double v = i + 1 < to ? walk.to(at_[i + 1] - at_[from]).speed : 0;
            if (i + 1 < to && v - most_[i + 1] > worst * most_[i + 1] + 1e-9) {
                const double over = (v - most_[i + 1]) / (most_[i + 1] + 1e-9);
                if (over > worst) worst = over, f.place = i + 1;
            }
            if (s.peak > blocks_[i].speed * (1 + speed_noise) &&
                std::max(before, v) <= blocks_[i].speed * (1 + speed_noise) &&
                peak_in(s, at_[i] - at_[from], at_[i + 1] - at_[from]) > blocks_[i].speed * (1 + speed_noise))
                if (blocks_[i].speed < f.lower) f.lower = blocks_[i].speed, f.slow = i;
            before = v;
            if (any && (f.place != nobody || f.lower < INFINITY)) break;
        }
        return f;
    }
    /// The highest speed between two places of a span.
    static double peak_in(const Span& s, double from, double to) {
        Motion m{0, s.from.speed, s.from.acceleration};
        double v = 0;
        for (std::size_t i = 0; i < s.count; ++i) {
            if (m.at > from && m.at < to) v = std::max(v, m.speed);
            m = after(m, s.phases[i].seconds, s.phases[i].jerk);
        }
        return v;
    }

    void split(std::uint32_t i, std::uint32_t at, std::uint32_t k) {
        nodes_[at] = {most_[at], 0, i, k, {}, false};
        nodes_[i].next = at;
        nodes_[k].before = at;
        ask(at);
        ask(i);
    }

    /// Places in the middle of a ramp: going on to change speed there, where both spans then take less time.
    bool lean() {
        bool any = false;
        for (std::uint32_t i = nodes_[0].next; i != nobody && nodes_[i].next != nobody; i = nodes_[i].next)
            any = pass(i) || lean_at(i) || any;
        return any;
    }

    /// A place that no longer holds anything down: the curve from the one before to the next keeps what is allowed.
    bool pass(std::uint32_t i) {
        Node &b = nodes_[i], &a = nodes_[b.before], &c = nodes_[b.next];
        const std::optional<Span> s =
            plan_span(at_[b.next] - at_[b.before], {a.speed, a.acceleration}, {c.speed, c.acceleration},
                      highest(b.before, b.next), limits(b.before, b.next));
        if (!s || s->seconds >= (a.span.seconds + b.span.seconds) * (1 - 1e-9) || !holds(*s, b.before, b.next))
            return false;
        a.span = *s;
        a.next = b.next;
        c.before = b.before;
        return true;
    }

    bool lean_at(std::uint32_t i) {
        Node &b = nodes_[i], &a = nodes_[b.before], &c = nodes_[b.next];
        // The speed goes on to rise behind a place that is come to by a rise, also where the next one is slower again.
        const double through = b.speed * (1 + speed_noise);
        const bool rises = a.span.peak <= through && b.span.peak > through,
                   falls = a.span.peak > through && b.span.peak <= through;
        const bool up = a.speed < b.speed && rises, down = b.speed > c.speed && falls;
        if (!up && !down) return false;
        const Limits left = limits(b.before, i), right = limits(i, b.next);
        const double most = std::min(left.acceleration, right.acceleration);
        double best = a.span.seconds + b.span.seconds, now = std::abs(b.acceleration);
        bool better = false;
        for (double step = most / 2; step > most / 16; step /= 2) {
            for (const double tried : {now + step, now - step}) {
                if (tried < 0 || tried > most) continue;
                const End at{raised(i, up, tried, up ? left : right), up ? tried : -tried};
                const auto pair = with(b.before, i, b.next, at, left, right);
                if (!pair || pair->first.seconds + pair->second.seconds >= best * (1 - 1e-9)) continue;
                best = pair->first.seconds + pair->second.seconds;
                now = tried;
                a.span = pair->first;
                b.span = pair->second;
                b.speed = at.speed;
                b.acceleration = at.acceleration;
                better = true;
                break;
            }
        }
        return better;
    }

    /// How fast a place may be that a ramp goes through with this acceleration: one that was lowered, faster again.
    [[nodiscard]] double raised(std::uint32_t i, bool up, double acceleration, const Limits& l) const {
        const Node& b = nodes_[i];
        if (b.speed >= most_[i] * (1 - speed_noise)) return b.speed;
        const std::uint32_t k = up ? b.before : b.next;
        const End slow{nodes_[k].speed, std::abs(nodes_[k].acceleration)};
        return reachable(slow, acceleration, std::abs(at_[i] - at_[k]), most_[i], l).value_or(b.speed);
    }

    /// Both spans beside a place, with this acceleration there; nothing where they do not hold.
    [[nodiscard]] std::optional<std::pair<Span, Span>> with(std::uint32_t a, std::uint32_t i, std::uint32_t c,
                                                            const End& at, const Limits& left,
                                                            const Limits& right) const {
        std::optional<Span> one;
        for (const double most : {highest(a, i), nodes_[a].span.peak}) {
            one = plan_span(at_[i] - at_[a], {nodes_[a].speed, nodes_[a].acceleration}, at, most, left);
            if (one && !holds(*one, a, i)) one.reset();
            if (one) break;
        }
        if (!one) return {};
        std::optional<Span> two;
        for (const double most : {highest(i, c), nodes_[i].span.peak}) {
            two = plan_span(at_[c] - at_[i], at, {nodes_[c].speed, nodes_[c].acceleration}, most, right);
            if (two && !holds(*two, i, c)) two.reset();
            if (two) break;
        }
        if (!two) return {};
        return std::pair(*one, *two);
    }
    [[nodiscard]] bool holds(const Span& s, std::uint32_t from, std::uint32_t to) const {
        const Fault f = fault(s, from, to, true);
        return f.place == nobody && f.lower == INFINITY;
    }

    std::span<const Block> blocks_;
    std::vector<double> at_, most_;
    std::vector<Node> nodes_;
    std::vector<std::uint32_t> open_;
};

}  // namespace

double Profile::seconds() const {
    double sum = 0;
    for (const Span& s : spans) sum += s.seconds;
    return sum;
}

Profile plan(std::span<const Block> blocks, double begin, double end) { return Planner(blocks, begin, end).run(); }

void limit_to_known(std::span<Block> blocks, std::size_t depth, base::FunctionRef<void(std::size_t)> lowered) {
    // As a block begins, it and `depth` - 1 more are known.
    const std::size_t n = blocks.size();
    --depth;
    double way = 0;
    for (std::size_t i = 1; i < std::min(depth + 1, n); ++i) way += blocks[i].length;
    for (std::size_t i = 0; i + depth < n; ++i) {
        const double most = reachable(0, std::max(0.0, way), blocks[i].limits);
        if (most < blocks[i].end_speed) {
            blocks[i].end_speed = most;
            lowered(i);
        }
        if (depth > 0 && i + 1 < n) way -= blocks[i + 1].length;
        if (depth > 0 && i + depth + 1 < n) way += blocks[i + depth + 1].length;
    }
}

std::vector<BlockTime> block_times(std::span<const Block> blocks, const Profile& profile) {
    std::vector<BlockTime> times;
    block_times(blocks, profile, profile.spans.size(), times);
    return times;
}

void block_times(std::span<const Block> blocks, const Profile& profile, std::size_t spans,
                 std::vector<BlockTime>& times) {
    times.resize(blocks.size());
    for (std::size_t n = 0; n < spans; ++n) {
        const Span& span = profile.spans[n];
        const std::uint32_t from = profile.places[n].block, to = profile.places[n + 1].block;
        Walk walk(span);
        const double top = seconds_to_top(span);
        double at = 0, before = 0;
        for (std::uint32_t i = from; i < to; ++i) {
            at += blocks[i].length;
            double now = span.seconds, speed = profile.places[n + 1].speed;
            if (i + 1 < to) speed = walk.to(at).speed, now = walk.seconds();
            times[i] = {now - before, std::clamp(top - before, 0.0, now - before), speed};
            before = now;
        }
    }
}

}  // namespace obrys::sim::time
