/// Roughing down to a contour in parallel cuts, with or without pockets (LinuxCNC G71 … G72.2). Facts about the
/// algorithm: LinuxCNC 2.9, interpreter, lathe contour cycles. Everything happens in the laid profile
/// (turning_profile): the cuts run towards smaller u, the tool goes down in v from the start point by one infeed after
/// the other; a piece that falls in v is one to go down along ("dive"), one that rises is one to follow ("climb").

#include "cycles/turn/rough.hpp"

#include <algorithm>
#include <cmath>

namespace obrys::cycles {

using geom::Vec2;
using profile::touch;

ContourStart start_of(TurningPath& path, const TurnedContour& d, const TurningDemand& demand) {
    Course& c = path.course();
    ContourStart s;
    s.at = {d.target_u.value_or(demand.situation.at.x), d.target_v.value_or(demand.situation.at.y)};
    c.known(s.at.x + s.at.y, "the start point");
    s.unit = d.length_unit.value_or(1);
    if (demand.contour.empty()) c.fault("the contour is empty");
    return s;
}

void ProfilePath::arc(Vec2 to, Vec2 centre, int turn) {
    constexpr double same = 1e-4;  // of the program's unit: the control takes such places for one
    const Vec2 end = outside(to), at = path_.at();
    if (std::abs(end.x - at.x) < same * unit_ && std::abs(end.y - at.y) < same * unit_) return;
    path_.arc(end, outside(centre), laid_.same_sense() ? turn : -turn);
}

void ProfilePath::along(const Piece& piece) {
    piece.turn == 0 ? feed(piece.to) : arc(piece.to, piece.centre, piece.turn);
}

std::vector<double> meetings(const Piece& p, double v) {
    if (p.turn == 0) {
        if (std::min(p.from.y, p.to.y) > v + touch || std::max(p.from.y, p.to.y) < v - touch) return {};
        if (std::abs(p.from.y - p.to.y) < touch) return {p.from.x, p.to.x};
        return {(v - p.from.y) / (p.to.y - p.from.y) * (p.to.x - p.from.x) + p.from.x};
    }
    const double radius = geom::distance(p.from, p.centre);
    const double square = -(v - radius - p.centre.y) * (v + radius - p.centre.y);
    if (square < -touch) return {};
    const double half = std::sqrt(std::max(0.0, square));
    std::vector<double> found;
    for (const double u : {p.centre.x + half, p.centre.x - half}) {
        const Vec2 arm = Vec2{u, v} - p.centre;
        const double side = p.turn > 0 ? 1 : -1;
        if (side * geom::cross(p.from - p.centre, arm) >= -touch && side * geom::cross(p.to - p.centre, arm) <= touch)
            found.push_back(u);
    }
    return found;
}

namespace {

class Rougher {
public:
    Rougher(ProfilePath& out, const std::vector<Piece>& pieces, double infeed, double escape)
        : out_(out), pieces_(pieces), infeed_(infeed), escape_(escape), at_(pieces.front().from) {}

    /// pockets: 0 all, 1 leaves them, 2 only them.
    Fault run(int pockets);

private:
    enum class Next { pocket, end };
    Next next_pocket(bool& deeper);
    Next after_dive(bool& deeper);
    void scan();
    void cut(double u);
    bool dive(const Piece& p, double level, bool fast);
    bool dive_line(const Piece& p, double level, bool fast);
    bool dive_arc(const Piece& p, double level);
    bool climb(const Piece& p);
    void climb_only(const Piece& p);
    bool climb_arc(const Piece& p);
    void lower_level();
    bool fail(const char* text) {
        if (!fault_) fault_ = text;
        return true;
    }
    [[nodiscard]] Course& course() { return out_.path().course(); }

    ProfilePath& out_;
    const std::vector<Piece>& pieces_;
    double infeed_, escape_;
    int pockets_ = 0;  ///< 3: only them, and the first pass is over
    std::vector<Vec2> starts_;
    Vec2 at_;
    double level_ = 0;
    std::size_t piece_ = 0;
    std::size_t rounds_ = 0;
    Fault fault_;
};

bool Rougher::dive_line(const Piece& p, double level, bool fast) {
    if (p.from.y <= p.to.y + touch) return true;  // does not fall
    Vec2 end = p.to;
    if (level >= p.to.y) {
        const auto u = meetings(p, level);
        if (u.empty()) return fail("the start point does not suit the contour");
        end = {u.front(), level};
    }
    fast ? out_.rapid(end) : out_.feed(end);
    at_ = end;
    return false;
}

bool Rougher::dive_arc(const Piece& p, double level) {
    if (geom::distance(at_, p.to) < touch || at_.x - p.to.x <= touch) {
        at_ = p.to;
        return false;
    }
    auto u = meetings(p, level);
    if (u.empty()) u = meetings(p, level - touch);
    Vec2 end = p.to;
    if (p.turn > 0) {
        if (at_.x - touch > p.centre.x) return true;
        if (!u.empty() && u.back() <= p.centre.x) end = {u.back(), level};
    } else {
        if (at_.x <= p.centre.x) return true;                    // rises from here on
        if (!u.empty() && u.front() < p.centre.x) return false;  // met on the rising side only: the level goes down
        if (!u.empty()) end = {u.front(), level};
    }
    out_.arc(end, p.centre, p.turn);
    at_ = end;
    return false;
}

/// Goes down along the piece as far as the level; true: it is none to go down along.
bool Rougher::dive(const Piece& p, double level, bool fast) {
    return p.turn == 0 ? dive_line(p, level, fast) : dive_arc(p, level);
}

/// Along the part of an arc that rises; true where the contour falls afterwards or does not rise here.
bool Rougher::climb_arc(const Piece& p) {
    Vec2 end = p.to;
    const bool over_top = p.turn > 0 && p.to.x < p.centre.x;
    if (over_top) end = {p.centre.x, p.centre.y + geom::distance(p.from, p.centre)};
    if (geom::distance(at_, end) > profile::slack) out_.arc(end, p.centre, p.turn);
    at_ = end;
    return p.turn > 0;
}

bool Rougher::climb(const Piece& p) {
    if (p.turn != 0) {
        if (p.turn < 0 ? at_.x > p.centre.x : at_.x < p.centre.x) return true;
        return climb_arc(p);
    }
    if (p.to.y + touch < p.from.y) return true;
    if (geom::distance(at_, p.from) > touch) return fail("the contour cannot be followed from here");
    out_.feed(p.to);
    at_ = p.to;
    return false;
}

/// Follows the piece only where it rises and is met at the tool's height; from there on.
void Rougher::climb_only(const Piece& p) {
    if (p.turn == 0 && p.to.y < p.from.y) return;
    const auto u = meetings(p, at_.y);
    if (u.empty()) return;
    if (p.turn == 0) {
        at_.x = u.front();
        out_.feed(at_);
        out_.feed(p.to);
        at_ = p.to;
        return;
    }
    const double met = p.turn < 0 ? u.back() : u.front();
    if (p.turn < 0 ? met > p.centre.x : met < p.centre.x) return;
    at_.x = met;
    out_.feed(at_);
    climb_arc(p);
}

void Rougher::lower_level() {
    if ((level_ - at_.y) / infeed_ > double(most_steps)) return void(fail("the infeed is too small for the contour"));
    while (level_ - touch > at_.y) level_ -= infeed_;
}

/// One cut from where the tool is to u, away at 45 degrees, and back.
void Rougher::cut(double u) {
    const double length = std::abs(u - at_.x);
    const Vec2 end{u, at_.y};
    out_.feed(end);
    // Away at most half of the cut; without escape (0) by nothing.
    const double by = escape_ * std::min(1.0, length / 2 / escape_);
    const Vec2 away = std::isfinite(by) ? Vec2{by, by} : Vec2{};
    out_.rapid(end + away);
    out_.rapid({at_.x - away.x, at_.y + away.y});
    piece_ == 0 ? out_.rapid(at_) : out_.feed(at_);
    level_ -= infeed_;
}

/// Looks for the piece that ends a cut at the tool's height and makes the cut; without one the next piece is due.
void Rougher::scan() {
    for (std::size_t i = piece_; i < pieces_.size(); ++i) {
        const auto u = meetings(pieces_[i], at_.y);
        if (u.empty()) continue;
        const double end = i != piece_ ? u.front() : u.back();
        if (end - touch > at_.x) continue;
        if (std::abs(end - at_.x) >= touch) return cut(end);
        if (i == piece_) continue;
        if (geom::distance(at_, pieces_[i].from) < touch)
            piece_ = i;  // another piece begins here
        else
            level_ -= infeed_;  // a cut without length
        return;
    }
    ++piece_;  // nothing to cut from here: interpreters of early 2.9 went on for ever
}

/// The way down is over: along the contour up to the next pocket, or to its end.
Rougher::Next Rougher::after_dive(bool& deeper) {
    for (; piece_ < pieces_.size() && !fault_; ++piece_) {
        if (pockets_ == 1) {
            climb_only(pieces_[piece_]);
        } else if (climb(pieces_[piece_])) {
            if (pockets_ == 3) {
                if (at_.y > starts_.back().y && starts_.size() > 1) starts_.pop_back();
                if (starts_.size() == 1) starts_.push_back(at_);
            }
            deeper = true;
            return Next::pocket;
        }
    }
    return Next::end;
}

Rougher::Next Rougher::next_pocket(bool& deeper) {
    level_ = starts_.back().y;
    if (pockets_ == 2) {
        while (piece_ < pieces_.size() && !dive(pieces_[piece_], -1e9, piece_ == 0)) ++piece_;
        pockets_ = 3;
    }
    while (piece_ < pieces_.size()) {
        lower_level();
        const bool over = !fault_ && dive(pieces_[piece_], level_, piece_ == 0);
        if (fault_ || !course().room()) return Next::end;
        if (++rounds_ > most_steps) {
            fail("the contour cannot be roughed");
            return Next::end;
        }
        if (over) return after_dive(deeper);
        if (std::abs(at_.y - level_) > touch)
            ++piece_;
        else
            scan();
    }
    return Next::end;
}

Fault Rougher::run(int pockets) {
    pockets_ = pockets;
    starts_.push_back(pieces_.front().from);
    bool deeper = true;
    while (deeper && !fault_) {
        deeper = false;
        if (next_pocket(deeper) == Next::end) break;
    }
    return fault_;
}

}  // namespace

Fault rough_down(ProfilePath& out, const std::vector<Piece>& pieces, double infeed, double escape, int pockets) {
    return Rougher(out, pieces, infeed, escape).run(pockets);
}

namespace {

/// A contour that does not come back to the start point's height, closed so that the last cuts have an end.
void close_contour(Profile& p, Vec2 start, bool across) {
    const Piece first = p.pieces.front(), last = p.pieces.back();
    const Vec2 in = first.to - first.from, out = last.to - last.from;
    const Vec2 end = across ? Vec2{start.x, last.to.y} : Vec2{last.to.x, start.y};
    const bool open = across ? std::abs(out.y) > 0 && in.x * (start.x - last.to.x) < 0
                             : std::abs(out.x) > 0 && in.y * (start.y - last.to.y) < 0;
    if (open) p.pieces.push_back({last.to, end, {}, 0, Corner::none, 0});
}

struct Roughing {
    double infeed = 1, escape = 0.5, distance = 0;
    Vec2 offset;
    int pockets = 0;
};

Roughing roughing_of(Course& c, const ParallelRoughing& d, double unit) {
    Roughing r;
    r.infeed = d.infeed.value_or(unit) / unit;
    r.escape = d.escape.value_or(0.5 * unit) / unit;
    r.distance = d.allowance_side.value_or(0) / unit;
    r.offset = {d.offset_u.value_or(0) / unit, d.offset_v.value_or(0) / unit};
    r.pockets = c.whole(Role::pockets, d.pockets, 0, 0, 2, "the treatment of pockets");
    if (r.infeed <= 0) c.fault(Role::infeed, "the infeed must be greater than 0");
    return r;
}

Fault prepare(Profile& p, const Roughing& r) {
    p.lay();
    if (const Fault f = finish_corners(p)) return f;
    if (const Fault f = check_falling(p)) return f;
    if (const Fault f = keep_distance(p, r.distance)) return f;
    for (Piece& piece : p.pieces)
        for (Vec2* q : {&piece.from, &piece.to, &piece.centre}) *q = *q + r.offset;
    return std::nullopt;
}

void rough(TurningPath& path, const ParallelRoughing& d, const TurningDemand& demand, bool across) {
    Course& c = path.course();
    const ContourStart start = start_of(path, d, demand);
    const Roughing r = roughing_of(c, d, start.unit);
    if (!c.ready()) return;
    path.rapid(start.at);
    Profile p = profile_of(demand.contour, start.at, start.unit);
    if (p.pieces.size() <= 1) return;
    close_contour(p, (1 / start.unit) * start.at, across);
    if (across) p.turn_quarter();
    if (const Fault f = prepare(p, r)) return c.fault(*f);
    ProfilePath out(path, p, start.unit);
    const Vec2 from = p.pieces.front().from, end = p.pieces.back().to;
    out.rapid(from);
    if (end.y < from.y) p.pieces.push_back({end, {end.x, from.y}, {}, 0, Corner::none, 0});
    if (const Fault f = rough_down(out, p.pieces, std::max(r.infeed, 2 * touch), r.escape, r.pockets)) c.fault(*f);
}

}  // namespace

void write_steps(TurningPath& path, const RoughingAlong& d, const TurningDemand& demand) {
    rough(path, d, demand, false);
}
void write_steps(TurningPath& path, const RoughingAcross& d, const TurningDemand& demand) {
    rough(path, d, demand, true);
}

}  // namespace obrys::cycles
