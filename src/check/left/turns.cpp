#include "check/left/turns.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <optional>
#include <vector>

namespace obrys::check {

namespace milling = sim::milling;

using geom::Vec2;
using geom::Vec3;
using milling::Air;

namespace {

constexpr double same_turn = 1e-6;   ///< mm: places of one circle
constexpr double whole_turn = 1e-9;  ///< radians that may be missing
constexpr double thinnest = 1e-6;    ///< mm: lower bodies are none

Vec2 flat(Vec3 p) { return {p.x, p.y}; }

/// About a tool's axis, in its frame.
struct Circle {
    Vec2 centre;
    double radius = 0;
    double turn = 1;  ///< +1 counter-clockwise
};

/// A circle through three places; none through places in a row.
std::optional<Circle> circle_through(Vec2 a, Vec2 b, Vec2 c) {
    const Vec2 u = b - a, v = c - a;
    const double area = 2 * geom::cross(u, v);
    if (!(std::abs(area) > same_turn * same_turn)) return std::nullopt;
    const double uu = geom::dot(u, u), vv = geom::dot(v, v);
    const Vec2 off{(v.y * uu - u.y * vv) / area, (u.x * vv - v.x * uu) / area};
    return Circle{a + off, geom::length(off), area > 0 ? 1.0 : -1.0};
}

bool are_same(const Circle& a, const Circle& b) {
    return a.turn == b.turn && geom::distance(a.centre, b.centre) <= same_turn &&
           std::abs(a.radius - b.radius) <= same_turn;
}

struct Way {
    const Air::Sweep* sweep = nullptr;
    Vec3 from, to;  ///< of the tip, in the tool's frame
};

Way way_of(const Air::Sweep& s) {
    const Vec3 from = s.frame.to_tool(s.from);
    return {&s, from, from + s.track.v};
}

bool follows(const Way& a, const Way& b) {
    return a.sweep->shape == b.sweep->shape && geom::distance(a.sweep->frame.z, b.sweep->frame.z) == 0 &&
           geom::distance(a.sweep->frame.x, b.sweep->frame.x) == 0 && geom::distance(a.to, b.from) <= same_turn;
}

/// What a way, and the one behind it, show of the circle they lie on.
std::optional<Circle> circle_of(const Way& way, const Way* next) {
    const milling::Track& t = way.sweep->track;
    if (t.circular) return Circle{flat(way.from) + t.centre, t.radius, t.turn};
    if (next == nullptr || next->sweep->track.circular || !follows(way, *next)) return std::nullopt;
    return circle_through(flat(way.from), flat(way.to), flat(next->to));
}

/// The angle of a way on a circle; 0: it does not lie on it, or goes back or too far at once to be told.
double angle_on(const Circle& c, const Way& way) {
    const milling::Track& t = way.sweep->track;
    if (t.circular && !are_same(c, {flat(way.from) + t.centre, t.radius, t.turn})) return 0;
    const Vec2 a = flat(way.from) - c.centre, b = flat(way.to) - c.centre;
    if (std::abs(geom::length(a) - c.radius) > same_turn || std::abs(geom::length(b) - c.radius) > same_turn) return 0;
    return std::max(0.0, std::atan2(c.turn * geom::cross(a, b), geom::dot(a, b)));
}

class Turns {
public:
    void take(const Air::Sweep& sweep, const Air::Sweep* behind);
    [[nodiscard]] LeftTurns result() && {
        end_run();
        return std::move(made_);
    }

private:
    /// A way on the circle.
    struct Stretch {
        double angle = 0, inner = 0;  ///< how near to the middle its chord comes
        milling::Heights tips;
    };
    /// A body and what it was made of.
    struct Body {
        Circle circle;
        double inner = 0, radius = 0;  ///< of the circle at least, of the tool
        milling::Heights heights;
        std::size_t first = 0, count = 0;  ///< its sweeps
    };
    void end_run();
    void end_turn();
    void add(const milling::Piece& piece, const Stretch& turn);
    void make(const Body& body);

    LeftTurns made_;
    std::deque<Body> bodies_;
    std::optional<Circle> circle_;
    std::optional<Way> last_;
    std::vector<Stretch> run_;  ///< on the circle, without a break
    double angle_ = 0;          ///< since the last turn
};

void Turns::take(const Air::Sweep& sweep, const Air::Sweep* behind) {
    const Way way = way_of(sweep);
    double angle = last_ && circle_ && follows(*last_, way) ? angle_on(*circle_, way) : 0;
    if (!(angle > 0)) {
        end_run();
        std::optional<Way> next;
        if (behind != nullptr) next = way_of(*behind);
        circle_ = circle_of(way, next ? &*next : nullptr);
        angle = circle_ ? angle_on(*circle_, way) : 0;
    }
    last_ = way;
    if (!(angle > 0)) return circle_.reset();
    const double inner = sweep.track.circular ? circle_->radius : circle_->radius * std::cos(angle / 2);
    run_.push_back({angle, inner, {std::min(way.from.z, way.to.z), std::max(way.from.z, way.to.z)}});
    angle_ += angle;
    if (angle_ >= 2 * geom::pi - whole_turn) end_turn();
}

/// The turn that ends here.
void Turns::end_turn() {
    Stretch turn = run_.back();
    for (auto s = std::next(run_.rbegin()); s != run_.rend() && turn.angle < 2 * geom::pi - whole_turn; ++s)
        turn = {turn.angle + s->angle,
                std::min(turn.inner, s->inner),
                {std::min(turn.tips.low, s->tips.low), std::max(turn.tips.high, s->tips.high)}};
    angle_ = 0;
    if (turn.angle < 2 * geom::pi - whole_turn) return;
    for (const milling::Piece& piece : last_->sweep->shape->pieces)
        if (piece.kind == milling::PieceKind::cone && piece.r0 == piece.r1) add(piece, turn);
}

/// What is left over behind the last turn belongs to one, too.
void Turns::end_run() {
    if (angle_ > 0) end_turn();
    run_.clear();
}

void Turns::add(const milling::Piece& piece, const Stretch& turn) {
    Body body{*circle_, turn.inner, piece.r0, {turn.tips.high + piece.z0, turn.tips.low + piece.z1}, 0, 0};
    if (!(body.heights.high - body.heights.low > thinnest) || !(turn.inner > 0)) return;
    if (!bodies_.empty()) {
        const Body& before = bodies_.back();
        const milling::Heights &a = before.heights, &b = body.heights;
        if (are_same(before.circle, body.circle) && before.radius == body.radius && a.low <= b.high &&
            b.low <= a.high && before.first + before.count == made_.sweeps.size() &&
            geom::distance(made_.sweeps.back().frame.z, last_->sweep->frame.z) == 0) {
            body.heights = {std::min(a.low, b.low), std::max(a.high, b.high)};
            body.inner = std::min(before.inner, body.inner);
            made_.sweeps.resize(before.first);
            bodies_.pop_back();
        }
    }
    body.first = made_.sweeps.size();
    make(body);
    body.count = made_.sweeps.size() - body.first;
    if (body.count > 0) bodies_.push_back(body);
}

/// The tool's cylinder, grown by the circle where it reaches over the middle, else on a circle by quarters.
void Turns::make(const Body& body) {
    const bool full = body.circle.radius <= body.radius;
    const double r = full ? body.radius + body.inner : body.radius - (body.circle.radius - body.inner);
    if (!(r > 0)) return;
    const double high = body.heights.high - body.heights.low;
    made_.shapes.push_back(milling::make_shape({milling::cone(0, high, r, r)}));
    Air::Sweep s = *last_->sweep;
    s.shape = &made_.shapes.back();
    s.track = {};
    const auto place = [&](Vec2 p) { return s.frame.to_stock({p.x, p.y, body.heights.low}); };
    s.from = place(body.circle.centre);
    if (full) return made_.sweeps.push_back(s);
    constexpr std::array<Vec2, 5> ways{{{1, 0}, {0, 1}, {-1, 0}, {0, -1}, {1, 0}}};
    for (std::size_t i = 0; i + 1 < ways.size(); ++i) {
        const Vec2 to = body.circle.radius * (ways[i + 1] - ways[i]);
        s.from = place(body.circle.centre + body.circle.radius * ways[i]);
        s.track = {{to.x, to.y, 0}, true, -body.circle.radius * ways[i], body.circle.radius, 1, ways[i], ways[i + 1]};
        made_.sweeps.push_back(s);
    }
}

}  // namespace

LeftTurns turns_of(const std::deque<Air::Sweep>& sweeps) {
    Turns turns;
    for (std::size_t i = 0; i < sweeps.size(); ++i)
        turns.take(sweeps[i], i + 1 < sweeps.size() ? &sweeps[i + 1] : nullptr);
    return std::move(turns).result();
}

}  // namespace obrys::check
