#include "check/stock_guard.hpp"

#include <algorithm>
#include <cmath>
#include <span>

#include "base/whole.hpp"
#include "check/certify_shapes.hpp"

namespace obrys::check {

namespace certify = sim::certify;
namespace milling = sim::milling;

using geom::Vec2;
using geom::Vec3;

namespace {

constexpr double round_share = 0.25;  ///< of what is allowed: chords of a round stock
constexpr double hidden = 4;          ///< times the rays' distance: what is deeper they see
constexpr double seen = 0.5;          ///< times that: a depth of a shank or holder that they have found
constexpr std::size_t most_deep =
    200;  ///< rapids that the rays see deep in the stock and that are searched all the same
constexpr std::size_t most_bodies = 600;    ///< moves of shanks and holders beside material that are searched
constexpr double chords = 0.1;              ///< of the tolerance: curves were cut as chords
constexpr double chord_share = 1.0 / 40;    ///< of the tolerance: chords of a way that is looked at
constexpr std::size_t together = 256;       ///< moves that are looked at as one, at most
constexpr std::size_t worth_it = 8;         ///< so many moves
constexpr std::size_t cells_of_many = 24;   ///< for them
constexpr std::size_t cells_of_arc = 60;    ///< for a level quarter of a circle as it is
constexpr std::size_t cells_of_one = 3000;  ///< for one straight way and part of a tool
constexpr std::size_t most_refined = 1000;  ///< depths of clipped edges
constexpr double most_chords = 4096;        ///< of one way

/// Points around a round piece, so that their hull holds it and stands off by no more than `off`.
void add_round(std::vector<Vec2>& profile, const milling::Piece& p, double off) {
    const auto angle_at = [&](double z) { return std::asin(std::clamp((z - p.centre) / p.arc, -1.0, 1.0)); };
    const double from = angle_at(p.z0), to = angle_at(p.z1), step = 2 * std::acos(p.arc / (p.arc + off));
    const auto n = base::clipped<std::size_t>(std::ceil((to - from) / step), 1, 1000);
    const double turn = (to - from) / static_cast<double>(n), far = p.arc / std::cos(turn / 2);
    profile.push_back({p.r0, p.z0});
    for (std::size_t i = 0; i < n; ++i) {
        const double at = from + (static_cast<double>(i) + 0.5) * turn;
        profile.push_back({p.ring + far * std::cos(at), std::clamp(p.centre + far * std::sin(at), p.z0, p.z1)});
    }
    profile.push_back({p.r1, p.z1});
}

/// Into how many chords a way is cut.
std::size_t pieces_of(const geom::PathElement& path, double off) {
    double bend = 0;
    if (const auto* c = std::get_if<geom::Circular>(&path)) {
        const Vec3 out = c->from - c->centre;
        bend = c->sweep * c->sweep * geom::length(out);
    } else if (const auto* k = std::get_if<geom::Cubic>(&path)) {
        bend = std::max(geom::length(2.0 * k->k2), geom::length(2.0 * k->k2 + 6.0 * k->k3));
    }
    return base::clipped<std::size_t>(std::ceil(std::sqrt(bend / (8 * off))), 1, static_cast<std::size_t>(most_chords));
}

/// Level circles about the tool's axis.
bool is_level(const geom::Circular& c, Vec3 axis) {
    return geom::length(geom::cross(c.normal, axis)) <= 1e-12 * geom::length(c.normal) &&
           std::abs(geom::dot(c.to - c.from, axis)) <= 1e-9;
}

mesh::Box box_of(const geom::PathElement& path) {
    mesh::Box box;
    constexpr int stops = 16;
    double bulge = 0;
    if (const auto* c = std::get_if<geom::Circular>(&path)) bulge = geom::length(c->from - c->centre) * 0.1;
    if (const auto* k = std::get_if<geom::Cubic>(&path))
        bulge = std::max(geom::length(2.0 * k->k2), geom::length(2.0 * k->k2 + 6.0 * k->k3)) / (8.0 * stops * stops);
    const bool straight = std::holds_alternative<geom::Straight>(path);
    if (const auto* c = std::get_if<geom::Circular>(&path))
        bulge = geom::length(c->from - c->centre) * c->sweep * c->sweep / (8.0 * stops * stops);
    for (int i = 0; i <= stops; i += straight ? stops : 1) {
        const Vec3 p = geom::point_at(path, static_cast<double>(i) / stops), more{bulge, bulge, bulge};
        box.add(p - more);
        box.add(p + more);
    }
    return box;
}

}  // namespace

/// Moves that are looked at together.
struct StockGuard::Group {
    const milling::Simulation& simulation;
    const milling::Air& air;
    const std::function<bool()>& stop;
    const LeftCuts& cuts;  ///< made before the first of them
    std::vector<std::pair<std::uint32_t, Verdict>> done;
    std::uint32_t hint = 0;
};

StockGuard::StockGuard(const milling::Stock& stock, double allowed, double apart, double tolerance, int threads)
    : body_(stock),
      stock_(mesh_of(stock, round_share * allowed)),
      planes_(planes_of(stock)),
      allowed_(allowed),
      apart_(apart),
      tolerance_(tolerance),
      least_(std::max(allowed, chords * tolerance)),
      threads_(threads),
      judge_(stock_, allowed) {}

StockGuard::Part StockGuard::made(const milling::Shape& shape) const {
    Part part{certified_shape(shape, round_share * allowed_), {}, shape.radius, shape.bottom, shape.top};
    for (std::size_t first = 0; first < shape.pieces.size();) {
        const std::size_t end = convex_end(shape.pieces, first);
        std::vector<Vec2> profile;
        for (; first < end; ++first) {
            const milling::Piece& p = shape.pieces[first];
            if (p.kind == milling::PieceKind::round) {
                add_round(profile, p, round_share * least_);
                continue;
            }
            profile.push_back({p.r0, p.z0});
            profile.push_back({p.r1, p.z1});
        }
        profile.erase(std::unique(profile.begin(), profile.end()), profile.end());
        part.profiles.push_back(std::move(profile));
    }
    return part;
}

void StockGuard::add_tool(const milling::ToolShape& tool) {
    tools_.push_back({made(tool.cutting), made(tool.shank), made(tool.holder)});
}

void StockGuard::add(std::uint32_t number, const milling::Pass& pass) {
    if (pass.tool >= tools_.size()) return;
    const Part& part = tools_[pass.tool][static_cast<std::size_t>(pass.part)];
    const double size = geom::length(pass.axis);
    if (!part.profiles.empty() && size > 0)
        queued_.push_back({number, pass.path, (1 / size) * pass.axis, &part, pass.part != milling::Part::cutting});
}

/// Around what they sweep.
milling::Box3 StockGuard::box_of(std::size_t first, std::size_t end) const {
    mesh::Box box;
    for (std::size_t i = first; i < end; ++i) {
        const Queued& q = queued_[i];
        const mesh::Box way = check::box_of(q.path);
        const auto reach = [&](double a) { return q.part->radius * std::sqrt(std::max(0.0, 1 - a * a)); };
        const Vec3 around{reach(q.axis.x), reach(q.axis.y), reach(q.axis.z)};
        for (const double z : {q.part->bottom, q.part->top}) {
            box.add(way.lo + z * q.axis - around);
            box.add(way.hi + z * q.axis + around);
        }
    }
    const milling::Box3 all = milling::box_of(body_);
    const auto within = [](double v, double low, double high) { return std::clamp(v, low, high); };
    const auto cut = [&](Vec3 p) {
        return Vec3{within(p.x, all.min.x, all.max.x), within(p.y, all.min.y, all.max.y),
                    within(p.z, all.min.z, all.max.z)};
    };
    const double most = hidden * apart_;
    const Vec3 more{most, most, most};
    return {cut(box.lo) - more, cut(box.hi) + more};
}

/// By the box around all tips.
bool StockGuard::clear_together(Group& g, std::size_t first, std::size_t end) const {
    const Queued& q = queued_[first];
    const milling::Orientation frame = milling::orientation_of(q.axis);
    mesh::Box tips;  // in the tool's frame
    for (std::size_t i = first; i < end; ++i) {
        const mesh::Box way = check::box_of(queued_[i].path);
        const bool upright = frame.along == 2;
        if (std::holds_alternative<geom::Straight>(queued_[i].path)) {
            tips.add(frame.to_tool(geom::point_at(queued_[i].path, 0)));
            tips.add(frame.to_tool(geom::point_at(queued_[i].path, 1)));
        } else if (upright) {
            tips.add(frame.to_tool(way.lo));
            tips.add(frame.to_tool(way.hi));
        } else {
            return false;
        }
    }
    const Vec3 size = tips.size();
    const LeftBody body{
        frame.to_stock(tips.lo), {size.x * frame.x, size.y * frame.y, size.z * frame.z}, q.axis, {}, {}};
    const LeftSearch search{body_, g.air, g.cuts.all(), least_, hidden * apart_, cells_of_many, &g.hint};
    return all_clear(body, *q.part, search);
}

/// A rapid that meets something on rays: it may be thinner than what can be searched for.
bool StockGuard::has_met(const milling::Simulation& simulation, const Queued& q) const {
    return !q.body && simulation.engagements()[q.number].depth > allowed_;
}

void StockGuard::judge_range(Group& g, std::size_t first, std::size_t end) const {
    if (end - first == 1) {
        Verdict v;
        if (g.stop && g.stop())
            v.decided = false;
        else
            v = judge_one(g, queued_[first]);
        if (!v.decided || v.hit.depth > 0) g.done.push_back({queued_[first].number, v});
        return;
    }
    const auto met = [&](const Queued& q) { return has_met(g.simulation, q); };
    const auto range = std::span(queued_).subspan(first, end - first);
    if (end - first >= worth_it && std::none_of(range.begin(), range.end(), met) && clear_together(g, first, end))
        return;
    const std::size_t middle = (first + end) / 2;
    judge_range(g, first, middle);
    judge_range(g, middle, end);
}

namespace {

/// The part of a profile between two heights; less than two points: nothing.
std::vector<Vec2> clipped(const std::vector<Vec2>& profile, double low, double high) {
    std::vector<Vec2> part;
    for (std::size_t i = 0; i < profile.size(); ++i) {
        const Vec2 at = profile[i];
        for (const double z : {low, high}) {
            if (i == 0 || !(profile[i - 1].y < z && at.y > z)) continue;
            const Vec2 before = profile[i - 1];
            part.push_back({before.x + (at.x - before.x) * (z - before.y) / (at.y - before.y), z});
        }
        if (at.y >= low && at.y <= high) part.push_back(at);
    }
    return part;
}

}  // namespace

/// Of the profiles only what may reach into the stock: tools are taken to be as long as any cut.
StockGuard::Heights StockGuard::heights_in_stock(const LeftBody& body) const {
    const milling::Box3 box = milling::box_of(body_);
    double low = INFINITY, high = -INFINITY, first = INFINITY, last = -INFINITY;
    for (const double x : {box.min.x, box.max.x})
        for (const double y : {box.min.y, box.max.y})
            for (const double z : {box.min.z, box.max.z}) {
                const double at = geom::dot(body.axis, {x, y, z});
                low = std::min(low, at), high = std::max(high, at);
            }
    for (int corner = 0; corner < 8; ++corner) {
        Vec3 tip = body.corner;
        for (int k = 0; k < 3; ++k)
            if ((corner >> k & 1) != 0) tip = tip + body.edges[static_cast<std::size_t>(k)];
        const double at = geom::dot(body.axis, tip);
        first = std::min(first, at), last = std::max(last, at);
    }
    return {low - last - 1, high - first + 1};
}

bool StockGuard::all_clear(const LeftBody& way, const Part& part, const LeftSearch& search) const {
    LeftBody body = way;
    const Heights heights = heights_in_stock(way);
    return std::all_of(part.profiles.begin(), part.profiles.end(), [&](const std::vector<Vec2>& profile) {
        body.profile = clipped(profile, heights.low, heights.high);
        return body.profile.size() < 2 || surely_clear(body, search);
    });
}

void StockGuard::judge_piece(Verdict& verdict, const LeftBody& way, const Part& part, const LeftSearch& search) const {
    LeftBody body = way;
    const Heights heights = heights_in_stock(way);
    for (const std::vector<Vec2>& profile : part.profiles) {
        body.profile = clipped(profile, heights.low, heights.high);
        if (body.profile.size() < 2) continue;
        const LeftDepth d = deepest_left(body, search);
        verdict.decided = verdict.decided && d.decided;
        if (d.depth > verdict.hit.depth) verdict.hit = {d.depth, d.at};
    }
}

/// Level circles first as they are, by quarters; what is not clear as its chords.
StockGuard::Verdict StockGuard::judge_one(Group& g, const Queued& q) const {
    Verdict verdict;
    const LeftCuts cuts(g.air, g.simulation, q.number);
    LeftSearch search{body_, g.air, cuts.all(), least_, hidden * apart_, cells_of_one, &g.hint};
    search.planes = &planes_;
    search.met = has_met(g.simulation, q);
    const auto* circle = std::get_if<geom::Circular>(&q.path);
    const bool level = circle != nullptr && is_level(*circle, q.axis);
    const std::size_t quarters =
        level ? base::clipped<std::size_t>(std::ceil(std::abs(circle->sweep) / (geom::pi / 2) - 1e-9), 1, 64) : 1;
    const std::size_t n = pieces_of(q.path, chord_share * tolerance_), each = (n + quarters - 1) / quarters;
    for (std::size_t k = 0; k < quarters && verdict.hit.depth < hidden * apart_ / 2; ++k) {
        const auto place = [&](std::size_t i) {
            return geom::point_at(q.path,
                                  (static_cast<double>(k) + static_cast<double>(i) / static_cast<double>(each)) /
                                      static_cast<double>(quarters));
        };
        const Vec3 from = place(0), to = place(each);
        if (level && each > 1) {
            const Vec3 chord = to - from;
            Vec3 bulge = 0.5 * (from + to) - circle->centre;
            const double far = geom::length(bulge), radius = geom::length(circle->from - circle->centre);
            if (far > 0.5 * radius) {
                bulge = ((radius - far) / far) * bulge;
                const LeftBody body{from, {chord, bulge, {}}, q.axis, {}, ArcWay{circle->centre, radius, from, to}};
                LeftSearch quick = search;
                quick.most_cells = cells_of_arc;
                if (all_clear(body, *q.part, quick)) continue;
            }
        }
        for (std::size_t i = 0; i < each && verdict.hit.depth < hidden * apart_ / 2; ++i) {
            if (g.stop && g.stop()) return {false, verdict.hit};
            const Vec3 a = place(i);
            judge_piece(verdict, {a, {place(i + 1) - a, {}, {}}, q.axis, {}, {}}, *q.part, search);
        }
    }
    if (verdict.hit.depth > 0) verdict.decided = true;
    return verdict;
}

/// Beside an edge of the stock that no cut has come near, its own depth in the tool counts.
StockGuard::Hit StockGuard::refined(const Queued& q, Hit hit, const milling::Simulation& simulation) const {
    const double most = hidden * apart_;
    const certify::Move move{q.path, q.axis, &q.part->shape};
    if (judge_.rough(move) > most) return hit;
    const certify::Depth d = judge_.deepest(move);
    if (!(d.depth > hit.depth) || !(2 * d.depth < most)) return hit;
    const Vec3 around{most, most, most};
    const milling::Air air = simulation.air_in({d.at - around, d.at + around});
    const LeftCuts cuts(air, simulation, q.number);
    const bool alone = std::none_of(cuts.all().begin(), cuts.all().end(), [&](const LeftCut& c) {
        return c.farthest({d.at, 0}, q.axis) <= 2 * d.depth;
    });
    return alone ? Hit{d.depth, d.at} : hit;
}

bool StockGuard::is_worth_search(const Queued& q) {
    if (!q.body || searched_++ < most_bodies) return true;
    if (!rays_from_) rays_from_ = q.number;
    return false;
}

void StockGuard::carry_out(const milling::Simulation& simulation, const std::function<bool()>& stop) {
    std::vector<char> clear(queued_.size());
    const auto met = simulation.engagements();
    for (std::size_t i = 0; i < queued_.size(); ++i) {
        // What the rays see so deep they measure well enough; of rapids the first ones better.
        const bool deep = met[queued_[i].number].depth > (queued_[i].body ? seen : hidden) * apart_;
        clear[i] = deep && (queued_[i].body || deep_rapids_++ >= most_deep) ? 1 : 0;
    }
    for_all(queued_.size(), threads_, [&](std::size_t i) {
        clear[i] =
            clear[i] != 0 || judge_.is_clear({queued_[i].path, queued_[i].axis, &queued_[i].part->shape}) ? 1 : 0;
    });
    std::size_t kept = 0;
    for (std::size_t i = 0; i < queued_.size(); ++i)
        if (clear[i] == 0 && is_worth_search(queued_[i])) {
            if (kept != i) queued_[kept] = std::move(queued_[i]);
            ++kept;
        }
    queued_.resize(kept);
    // Shank and holder of one move after the other are queued in turn.
    std::stable_sort(queued_.begin(), queued_.end(),
                     [](const Queued& a, const Queued& b) { return std::less<>{}(a.part, b.part); });
    std::vector<std::size_t> ends;
    for (std::size_t i = 0; i < queued_.size(); ++i) {
        const std::size_t first = ends.empty() ? 0 : ends.back();
        const bool same = i > first && queued_[i].part == queued_[first].part && queued_[i].axis == queued_[first].axis;
        if (i > 0 && (!same || i - first >= together)) ends.push_back(i);
    }
    if (!queued_.empty()) ends.push_back(queued_.size());
    if (!ends.empty()) static_cast<void>(simulation.air_in({}));  // the stock's body is made once, by one thread
    std::vector<std::vector<std::pair<std::uint32_t, Verdict>>> found(ends.size());
    for_all(
        ends.size(), threads_,
        [&](std::size_t n) {
            const std::size_t first = n == 0 ? 0 : ends[n - 1];
            const milling::Air air = simulation.air_in(box_of(first, ends[n]));
            if (!air.known()) return;
            const LeftCuts cuts(air, simulation, queued_[first].number);
            Group g{simulation, air, stop, cuts, {}, 0};
            judge_range(g, first, ends[n]);
            found[n] = std::move(g.done);
        },
        1);
    for (const auto& group : found)
        for (const auto& [number, verdict] : group)
            if (verdict.hit.depth > 0)
                hits_[number] = verdict.hit;
            else
                undecided_.insert(number);
    for (const Queued& q : queued_) {
        const auto hit = hits_.find(q.number);
        if (hit == hits_.end() || refined_ >= most_refined || (stop && stop())) continue;
        ++refined_;
        hit->second = refined(q, hit->second, simulation);
    }
    queued_.clear();
}

StockGuard::Hit StockGuard::hit_by(std::uint32_t number) const {
    const auto at = hits_.find(number);
    return at == hits_.end() ? Hit{} : at->second;
}

}  // namespace obrys::check
