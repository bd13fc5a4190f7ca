#include "check/left/inside.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <queue>

#include "check/left/room.hpp"
#include "check/left/swept_depth.hpp"
#include "check/left/tiny_lp.hpp"

namespace obrys::check {

namespace milling = sim::milling;

using geom::Vec2;
using geom::Vec3;

namespace {

constexpr double good_enough = 0.01;      ///< of a depth: so well it is known
constexpr double least_gap = 1e-7;        ///< mm: the same
constexpr int most_planes = 40;           ///< of the body, for one cell
constexpr std::ptrdiff_t most_near = 12;  ///< of them, that parts of it begin with
constexpr std::size_t most_holding = 6;   ///< cuts that are weighed against each other
constexpr double before_wall = 0.4;       ///< of the way to a round wall: so far before it a box has its face
constexpr double least_share = 0.5;       ///< of what is allowed: the same, no less; of what is thin: ways
constexpr double flat_enough = 0.5;       ///< width of a box's face at a wall, of one before it
constexpr double slope_step = 1e-4;       ///< mm, for slopes
constexpr double on_face = 5e-5;          ///< mm: so near the stock's face counts as in the stock

struct InsideCell {
    std::vector<Halfspace<3>> planes;
    std::vector<Halfspace<4>> near;  ///< planes of the body that bound it
    double bound = 0;                ///< nothing in it is deeper
    bool held = false;               ///< as deep as that the place lies in the body
    Vec3 at;                         ///< where that would be
    bool operator<(const InsideCell& other) const { return bound < other.bound; }
};

class PlaneSearch {
public:
    PlaneSearch(const LeftBody& body, const InsideSearch& s);
    LeftDepth run();

private:
    [[nodiscard]] bool bounded(InsideCell& cell);
    void keep_near(InsideCell& cell) const;
    void push(InsideCell cell);
    void split(const InsideCell& cell);
    void leave_out(const InsideCell& cell, const Room& room);
    void look(Vec3 p);
    [[nodiscard]] double beside_stock(Vec3 p) const;
    [[nodiscard]] bool round_stock(Vec3 p);
    [[nodiscard]] bool takes(const LeftCut& cut, Vec3 p) const;
    [[nodiscard]] const LeftCut* roomiest(Vec3 p) const;
    [[nodiscard]] double way_out(const LeftCut& cut, Vec3 p, Vec3 along) const;
    [[nodiscard]] StockPlane nearest_face(const LeftCut& cut, Vec3 p) const;
    [[nodiscard]] Vec3 slope(const LeftCut& cut, Vec3 p) const;
    [[nodiscard]] Room room_in(const LeftCut& cut, Vec3 p) const;
    [[nodiscard]] double threshold() const { return std::max(s_.allowed, (1 + 3 * good_enough) * best_.depth); }

    const InsideSearch& s_;
    Vec3 axis_, middle_;
    double size_ = 0;  ///< from the middle to the farthest of the body, at most
    SweptDepth swept_;
    std::vector<Halfspace<4>> stock_rows_;
    std::vector<Halfspace<4>> rows_;  ///< of the program that is solved
    std::priority_queue<InsideCell> open_;
    LeftDepth best_;
    std::size_t cells_ = 0;
};

/// Whether the body goes on beyond the stock on that side, all along its way.
bool is_open(const LeftBody& body, const milling::Stock& stock, bool above) {
    const double sign = above ? 1 : -1, end = above ? body.profile.back().y : body.profile.front().y;
    const double from = sign * geom::dot(body.axis, body.corner),
                 to = from + sign * geom::dot(body.axis, body.edges[0]);
    return std::min(from, to) + sign * end > milling::heights_along(sign * body.axis, milling::box_of(stock)).high;
}

PlaneSearch::PlaneSearch(const LeftBody& body, const InsideSearch& s)
    : s_(s),
      axis_(body.axis),
      middle_(body.corner + 0.5 * body.edges[0] + (0.5 * (body.profile.front().y + body.profile.back().y)) * body.axis),
      swept_(body.profile, body.axis, body.corner, body.edges[0], is_open(body, s.stock, false),
             is_open(body, s.stock, true)) {
    double r = 0;
    for (const Vec2& at : body.profile) r = std::max(r, at.x);
    size_ = r + 0.5 * (geom::length(body.edges[0]) + body.profile.back().y - body.profile.front().y) + 1;
    for (const StockPlane& p : s.planes.planes)
        stock_rows_.push_back({{p.out.x, p.out.y, p.out.z, 0}, p.at - geom::dot(p.out, middle_)});
}

/// How far a place lies outside of the stock; 0: not.
double PlaneSearch::beside_stock(Vec3 p) const { return s_.planes.whole ? 0 : std::max(0.0, -s_.air.outside(0, p)); }

/// Beside a round stock: one more plane of it.
bool PlaneSearch::round_stock(Vec3 p) {
    const auto* bar = std::get_if<milling::CylinderStock>(&s_.stock);
    if (bar == nullptr) return false;
    Vec3 out = p - bar->centre;
    milling::set_component(out, bar->axis, 0);
    const double far = geom::length(out);
    if (!(far > bar->radius + least_gap)) return false;
    out = (1 / far) * out;
    stock_rows_.push_back({{out.x, out.y, out.z, 0}, bar->radius + geom::dot(out, bar->centre - middle_)});
    return true;
}

/// Finds the bound of a cell. False: nothing in it is deep enough.
bool PlaneSearch::bounded(InsideCell& cell) {
    rows_.clear();
    for (const Halfspace<3>& h : cell.planes) rows_.push_back({{h.a[0], h.a[1], h.a[2], 0}, h.c});
    rows_.insert(rows_.end(), stock_rows_.begin(), stock_rows_.end());
    rows_.insert(rows_.end(), cell.near.begin(), cell.near.end());
    for (int i = 0; i < most_planes; ++i) {
        const auto best = tiny_lp::solve<4>(rows_, {0, 0, 0, 1}, {size_, size_, size_, s_.enough});
        if (!best) return false;
        cell.bound = (*best)[3];
        if (cell.bound <= threshold()) return false;
        cell.at = middle_ + Vec3{(*best)[0], (*best)[1], (*best)[2]};
        if (round_stock(cell.at)) {
            rows_.push_back(stock_rows_.back());
            continue;
        }
        const SweptDepth::Nearest near = swept_.nearest(cell.at);
        cell.held = cell.bound - near.depth <= std::max(least_gap, good_enough * cell.bound);
        if (cell.held) break;
        const double share = std::sqrt(0.5);  // a row of unit length
        const Vec3 n = share * near.out;
        rows_.push_back({{n.x, n.y, n.z, share}, share * near.depth + geom::dot(n, cell.at - middle_)});
    }
    keep_near(cell);
    return true;
}

/// Of the body's planes those that come next to the cell's deepest place.
void PlaneSearch::keep_near(InsideCell& cell) const {
    const Vec3 p = cell.at - middle_;
    const auto room = [&](const Halfspace<4>& h) {
        return h.c - h.a[0] * p.x - h.a[1] * p.y - h.a[2] * p.z - h.a[3] * cell.bound;
    };
    cell.near.clear();
    std::copy_if(rows_.begin(), rows_.end(), std::back_inserter(cell.near),
                 [](const Halfspace<4>& h) { return h.a[3] > 0; });
    if (std::ssize(cell.near) <= most_near) return;
    std::nth_element(cell.near.begin(), cell.near.begin() + most_near, cell.near.end(),
                     [&](const Halfspace<4>& a, const Halfspace<4>& b) { return room(a) < room(b); });
    cell.near.resize(std::size_t{most_near});
}

void PlaneSearch::push(InsideCell cell) {
    if (bounded(cell)) open_.push(std::move(cell));
}

bool PlaneSearch::takes(const LeftCut& cut, Vec3 p) const {
    const mesh::Box& b = cut.box();
    const double t = s_.thin;
    return p.x >= b.lo.x - t && p.y >= b.lo.y - t && p.z >= b.lo.z - t && p.x <= b.hi.x + t && p.y <= b.hi.y + t &&
           p.z <= b.hi.z + t && cut.farthest({p, 0}, axis_) <= least_share * t;
}

void PlaneSearch::look(Vec3 p) {
    if (s_.air.outside(0, p) < -on_face) return;
    const double depth = swept_.nearest(p).depth;
    if (!(depth > std::max(s_.allowed, best_.depth))) return;
    if (std::any_of(s_.cuts.begin(), s_.cuts.end(), [&](const LeftCut& c) { return takes(c, p); })) return;
    best_.depth = std::min(depth, s_.enough), best_.at = p;
}

/// How far it goes on within a cut.
double PlaneSearch::way_out(const LeftCut& cut, Vec3 p, Vec3 along) const {
    constexpr int steps = 40;
    double in = 0, out = 2 * size_;
    if (takes(cut, p + out * along)) return out;
    for (int i = 0; i < steps && out - in > 0.1 * s_.thin; ++i) {
        const double half = 0.5 * (in + out);
        (takes(cut, p + half * along) ? in : out) = half;
    }
    return in;
}

/// Of the cuts that took the place the one whose walls are farthest.
const LeftCut* PlaneSearch::roomiest(Vec3 p) const {
    const LeftCut* best = nullptr;
    double most = -1;
    std::size_t n = 0;
    for (const LeftCut& cut : s_.cuts) {
        if (!takes(cut, p)) continue;
        double least = INFINITY;
        const Vec3 out = cut.outwards({p, 0}), up = cut.axis();
        const Vec3 first = out == Vec3{} ? milling::orientation_of(up).x : out;
        for (const Vec3& along : {first, -1.0 * first, up, -1.0 * up}) least = std::min(least, way_out(cut, p, along));
        if (least > most) most = least, best = &cut;
        if (++n == most_holding) break;
    }
    return best;
}

/// Of the distance from a cut, beside it.
Vec3 PlaneSearch::slope(const LeftCut& cut, Vec3 p) const {
    Vec3 g;
    for (int k = 0; k < 3; ++k) {
        Vec3 more;
        milling::set_component(more, k, slope_step);
        milling::set_component(g, k, cut.farthest({p + more, 0}, axis_) - cut.farthest({p - more, 0}, axis_));
    }
    const double size = geom::length(g);
    return size > 0 ? (1 / size) * g : Vec3{};
}

/// Direction and how far it is.
StockPlane PlaneSearch::nearest_face(const LeftCut& cut, Vec3 p) const {
    const Vec3 out = cut.outwards({p, 0}), up = cut.axis();
    const Vec3 first = out == Vec3{} ? milling::orientation_of(up).x : out;
    StockPlane best{first, INFINITY};
    for (const Vec3& along : {first, -1.0 * first, -1.0 * up, up}) {
        const double far = way_out(cut, p, along);
        if (!(far < 2 * size_)) continue;
        const Vec3 n = slope(cut, p + (far + 2 * slope_step) * along);
        const double off = far * geom::dot(n, along);
        if (!(n == Vec3{}) && off >= 0 && off < best.at) best = {n, off};
    }
    return best;
}

/// A box as large as can be within a cut, flush with the face that is nearest.
Room PlaneSearch::room_in(const LeftCut& cut, Vec3 p) const {
    const auto holds = [&](const Room& r) { return cut.holds(r.corners(), s_.thin); };
    const StockPlane face = nearest_face(cut, p);
    const double all = 4 * size_, to = std::min(all, face.at), fine = least_share * s_.thin;
    const std::array<Vec3, 3> axes = axes_of(face.out, cut.axis());
    const auto grown = [&](double ahead) {
        Room room{p, axes, {}};
        grow(room, 0, 1, ahead, fine, holds);
        widen(room, std::max(fine, to / 64), all, fine, holds);
        grow(room, 0, 1, all, fine, holds);
        return room;
    };
    Room flush = grown(to);
    const double gap = std::max(least_share * s_.allowed, before_wall * to);
    if (!(gap < to)) return flush;
    Room behind = grown(to - gap);
    const auto as_wide = [&](std::size_t k) {
        const auto width = [&](const Room& r) { return r.size[k][0] + r.size[k][1]; };
        return width(flush) >= flat_enough * width(behind);
    };
    return as_wide(1) && as_wide(2) ? flush : behind;
}

/// What lies beyond the faces of a room, each piece once.
void PlaneSearch::leave_out(const InsideCell& cell, const Room& room) {
    std::vector<Halfspace<3>> planes = cell.planes;
    for (std::size_t k = 0; k < 3; ++k)
        for (const std::size_t side : {0U, 1U}) {
            const Vec3 n = (side == 1 ? 1.0 : -1.0) * room.axes[k];
            const double at = geom::dot(n, room.at - middle_) + room.size[k][side];
            InsideCell beyond;
            beyond.planes = planes;
            beyond.near = cell.near;
            beyond.planes.push_back({{-n.x, -n.y, -n.z}, -at});
            push(std::move(beyond));
            planes.push_back({{n.x, n.y, n.z}, at});
        }
}

void PlaneSearch::split(const InsideCell& cell) {
    const Vec3 p = cell.at;
    if (const double off = beside_stock(p); off > on_face) {
        Room room{p, {Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}}, {}};
        for (auto& size : room.size) size = {0.57 * off, 0.57 * off};
        return leave_out(cell, room);
    }
    const LeftCut* cut = roomiest(p);
    if (cut == nullptr) {
        look(p);
        if (!cell.held) push(cell);
        return;
    }
    const StockPlane face = nearest_face(*cut, p);
    if (std::isfinite(face.at)) look(p + (face.at + 3 * s_.thin) * face.out);
    leave_out(cell, room_in(*cut, p));
}

LeftDepth PlaneSearch::run() {
    push({});
    while (!open_.empty()) {
        const InsideCell cell = open_.top();
        if (cell.bound <= threshold() || best_.depth >= s_.enough) break;
        if (cells_ >= s_.most_cells) {
            best_.bound = cell.bound;
            return best_;  // something deeper may be there
        }
        open_.pop();
        ++cells_;
        split(cell);
    }
    best_.decided = true;
    return best_;
}

}  // namespace

LeftDepth deepest_inside(const LeftBody& body, const InsideSearch& search) {
    if (body.profile.size() < 2) return {true, 0, {}};
    return PlaneSearch(body, search).run();
}

}  // namespace obrys::check
