#include "check/left/stock_search.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>

#include "base/whole.hpp"
#include "check/certify_shapes.hpp"
#include "check/left/leaving.hpp"

namespace obrys::check {

namespace milling = sim::milling;

using geom::Vec2;
using geom::Vec3;

namespace {

constexpr double way_chord_share = 1.0 / 40;  ///< of the tolerance: chords of a way that is looked at
constexpr std::size_t most_together = 256;    ///< moves that are looked at as one, at most
constexpr std::size_t worth_it = 8;           ///< so many moves
constexpr std::size_t cells_of_many = 24;     ///< for them
constexpr std::size_t cells_of_arc = 60;      ///< for a level quarter of a circle as it is
constexpr double deeper_by = 1.1;             ///< of a depth found: as near as a depth is searched for
constexpr std::size_t cells_of_one = 3000;    ///< for one straight way and part of a tool
constexpr double deeper_tolerances = 0.5;     ///< the same: more than so many are asked for
constexpr std::size_t open_in_full = 4;       ///< pieces of a curve that were not decided: then shorter searches
constexpr std::size_t open_at_all = 32;       ///< the same: then none
constexpr std::size_t cells_when_open = 300;  ///< of a shorter search
constexpr std::size_t most_again = 8;         ///< moves that were not decided: they are looked at again
constexpr std::size_t longer = 4;             ///< times as long

/// Level circles about the tool's axis.
bool is_level(const geom::Circular& c, Vec3 axis) {
    return geom::length(geom::cross(c.normal, axis)) <= 1e-12 * geom::length(c.normal) &&
           std::abs(geom::dot(c.to - c.from, axis)) <= 1e-9;
}

mesh::Box box_of_way(const geom::PathElement& path) {
    mesh::Box box;
    constexpr int stops = 16;
    double bulge = 0;
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
struct StockSearch::Group {
    const milling::Simulation& simulation;
    std::span<const StockPass> passes;
    const std::function<bool()>& stop;
    std::optional<milling::Air> air;
    std::optional<LeftCuts> cuts;  ///< made before the first of them
    std::size_t patience = 1;
    std::uint32_t hint = 0;
    Verdicts done;
};

/// Around what they sweep.
milling::Box3 StockSearch::box_of(const Group& g) const {
    mesh::Box box;
    for (const StockPass& q : g.passes) {
        const mesh::Box way = box_of_way(q.path);
        const auto reach = [&](double a) { return q.part->radius * std::sqrt(std::max(0.0, 1 - a * a)); };
        const Vec3 around{reach(q.axis.x), reach(q.axis.y), reach(q.axis.z)};
        for (const double z : {q.part->bottom, q.part->top}) {
            box.add(way.lo + z * q.axis - around);
            box.add(way.hi + z * q.axis + around);
        }
    }
    const milling::Box3 all = milling::box_of(stock_);
    const auto within = [](double v, double low, double high) { return std::clamp(v, low, high); };
    const auto cut = [&](Vec3 p) {
        return Vec3{within(p.x, all.min.x, all.max.x), within(p.y, all.min.y, all.max.y),
                    within(p.z, all.min.z, all.max.z)};
    };
    const double most = limits_.enough;
    const Vec3 more{most, most, most};
    return {cut(box.lo) - more, cut(box.hi) + more};
}

/// By the box around all tips.
bool StockSearch::clear_together(Group& g, std::size_t first, std::size_t end) const {
    const StockPass& q = g.passes[first];
    const milling::Orientation frame = milling::orientation_of(q.axis);
    mesh::Box tips;  // in the tool's frame
    for (std::size_t i = first; i < end; ++i) {
        const mesh::Box way = box_of_way(g.passes[i].path);
        const bool upright = frame.along == 2;
        if (std::holds_alternative<geom::Straight>(g.passes[i].path)) {
            tips.add(frame.to_tool(geom::point_at(g.passes[i].path, 0)));
            tips.add(frame.to_tool(geom::point_at(g.passes[i].path, 1)));
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
    const LeftSearch search{stock_, *g.air, g.cuts->all(), limits_.allowed, limits_.enough, cells_of_many, &g.hint};
    return all_clear(body, *q.part, search);
}

/// A rapid that meets something on rays: it may be thinner than what can be searched for.
bool StockSearch::has_met(const milling::Simulation& simulation, const StockPass& q) const {
    return !q.body && simulation.engagements()[q.number].depth > limits_.allowed;
}

void StockSearch::judge_range(Group& g, std::size_t first, std::size_t end) const {
    if (end - first == 1) {
        Verdict v;
        if (g.stop && g.stop())
            v.decided = false;
        else
            v = judge_one(g, g.passes[first]);
        if (!v.decided || v.hit.depth > 0) g.done.push_back({g.passes[first].number, v});
        return;
    }
    const auto range = g.passes.subspan(first, end - first);
    const bool met = std::any_of(range.begin(), range.end(), [&](const auto& q) { return has_met(g.simulation, q); });
    if (end - first >= worth_it && !met && clear_together(g, first, end)) return;
    const std::size_t middle = (first + end) / 2;
    judge_range(g, first, middle);
    judge_range(g, middle, end);
}

/// Of the profiles only what may reach into the stock: tools are taken to be as long as any cut.
milling::Heights StockSearch::heights_in_stock(const LeftBody& body) const {
    const milling::Heights stock = milling::heights_along(body.axis, milling::box_of(stock_));
    double first = INFINITY, last = -INFINITY;
    for (int corner = 0; corner < 8; ++corner) {
        Vec3 tip = body.corner;
        for (int k = 0; k < 3; ++k)
            if ((corner >> k & 1) != 0) tip = tip + body.edges[static_cast<std::size_t>(k)];
        const double at = geom::dot(body.axis, tip);
        first = std::min(first, at), last = std::max(last, at);
    }
    return {stock.low - last - 1, stock.high - first + 1};
}

bool StockSearch::all_clear(const LeftBody& way, const StockPart& part, const LeftSearch& search) const {
    LeftBody body = way;
    const milling::Heights heights = heights_in_stock(way);
    return std::all_of(part.profiles.begin(), part.profiles.end(), [&](const std::vector<Vec2>& profile) {
        body.profile = clipped(profile, heights.low, heights.high);
        return body.profile.size() < 2 || surely_clear(body, search);
    });
}

void StockSearch::judge_piece(Verdict& verdict, const LeftBody& way, const StockPart& part,
                              const LeftSearch& search) const {
    LeftBody body = way;
    const milling::Heights heights = heights_in_stock(way);
    for (const std::vector<Vec2>& profile : part.profiles) {
        body.profile = clipped(profile, heights.low, heights.high);
        if (body.profile.size() < 2) continue;
        LeftSearch here = search;  // where it is hardly deeper than what is found does not matter
        if (verdict.hit.depth > 0)
            here.allowed =
                std::max({search.allowed, deeper_by * verdict.hit.depth,
                          std::min(limits_.enough, verdict.hit.depth + deeper_tolerances * limits_.tolerance)});
        const LeftDepth d = deepest_left(body, here);
        verdict.decided = verdict.decided && (d.decided || d.bound <= limits_.tolerance);
        if (d.depth > verdict.hit.depth) verdict.hit = {d.depth, d.at};
    }
}

/// The part of a straight way on which a tool's part may be in the stock's box; none: it passes beside it.
std::optional<geom::Straight> StockSearch::at_stock(const geom::Straight& way, const StockPass& q) const {
    const milling::Box3 box = milling::box_of(stock_);
    double first = 0, last = 1;
    for (int k = 0; k < 3; ++k) {
        const double a = milling::component(q.axis, k), around = q.part->radius * std::sqrt(std::max(0.0, 1 - a * a));
        const double low = milling::component(box.min, k) - around - std::max(a * q.part->bottom, a * q.part->top);
        const double high = milling::component(box.max, k) + around - std::min(a * q.part->bottom, a * q.part->top);
        const double from = milling::component(way.from, k), by = milling::component(way.to, k) - from;
        if (by == 0 && (from < low || from > high)) return std::nullopt;
        if (by == 0) continue;
        first = std::max(first, std::min((low - from) / by, (high - from) / by));
        last = std::min(last, std::max((low - from) / by, (high - from) / by));
    }
    if (!(first <= last)) return std::nullopt;
    return geom::Straight{geom::point_at(way, first), geom::point_at(way, last)};
}

/// A tool that goes back the way it has cut: it touches the material all along, and takes none.
bool StockSearch::retraces(const Group& g, const StockPass& q, const LeftCuts& cuts) const {
    const auto* way = std::get_if<geom::Straight>(&q.path);
    if (q.body || way == nullptr) return false;
    const std::optional<geom::Straight> there = at_stock(*way, q);
    const double top = milling::heights_along(q.axis, milling::box_of(stock_)).high;
    return !there || cuts.hold_way(g.simulation.tool(q.tool).cutting, *there, q.axis, top);
}

/// A tool that leaves where it has cut last, or comes where it has cut before: it touches its cut all over. What is
/// thin and was met by rays stays with the other searches.
bool StockSearch::leaves_own_cut(const Group& g, const StockPass& q, const LeftCuts& cuts,
                                 const LeftSearch& search) const {
    const auto* way = std::get_if<geom::Straight>(&q.path);
    if (q.body || way == nullptr || search.met) return false;
    const std::optional<geom::Straight> there = at_stock(*way, q);
    if (!there) return false;
    for (const auto& [from, to] : {std::pair(there->from, there->to), std::pair(there->to, there->from)}) {
        if (!cuts.was_at(g.simulation.tool(q.tool).cutting, from, q.axis)) continue;
        LeftBody body{from, {to - from, {}, {}}, q.axis, {}, {}};
        const milling::Heights heights = heights_in_stock(body);
        const bool clear = std::all_of(q.part->profiles.begin(), q.part->profiles.end(), [&](const auto& profile) {
            body.profile = clipped(profile, heights.low, heights.high);
            return body.profile.size() < 2 || leaves_clear(body, search);
        });
        if (clear) return true;
    }
    return false;
}

/// Level circles first as they are, by quarters; what is not clear as its chords.
StockSearch::Verdict StockSearch::judge_one(Group& g, const StockPass& q) const {
    Verdict verdict;
    const LeftCuts cuts(*g.air, g.simulation, q.number);
    if (retraces(g, q, cuts)) return verdict;
    LeftSearch search{stock_, *g.air, cuts.all(), limits_.allowed, limits_.enough, g.patience * cells_of_one, &g.hint};
    search.most_inside *= g.patience;
    search.planes = &planes_;
    search.met = has_met(g.simulation, q);
    const auto* circle = std::get_if<geom::Circular>(&q.path);
    const bool level = circle != nullptr && is_level(*circle, q.axis);
    const std::size_t quarters =
        level ? base::clipped<std::size_t>(std::ceil(std::abs(circle->sweep) / (geom::pi / 2) - 1e-9), 1, 64) : 1;
    const std::size_t n = chords_of(q.path, way_chord_share * limits_.tolerance), each = (n + quarters - 1) / quarters;
    std::size_t open = 0;
    for (std::size_t k = 0; k < quarters && verdict.hit.depth < limits_.enough / 2; ++k) {
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
        for (std::size_t i = 0; i < each && verdict.hit.depth < limits_.enough / 2; ++i) {
            if ((g.stop && g.stop()) || open >= open_at_all) return {verdict.hit.depth > 0, verdict.hit};
            const Vec3 a = place(i);
            Verdict piece{true, verdict.hit};
            judge_piece(piece, {a, {place(i + 1) - a, {}, {}}, q.axis, {}, {}}, *q.part, search);
            verdict = {verdict.decided && piece.decided, piece.hit};
            // Of a curve that rubs all along no piece is decided: more of them tell no more.
            if (!piece.decided && ++open == open_in_full) search.planes = nullptr, search.most_cells = cells_when_open;
        }
    }
    if (verdict.hit.depth > 0 || (!verdict.decided && leaves_own_cut(g, q, cuts, search))) verdict.decided = true;
    return verdict;
}

StockSearch::Verdicts StockSearch::judged(std::span<const StockPass> passes, const milling::Simulation& simulation,
                                          const std::function<bool()>& stop, std::size_t patience) const {
    Group g{simulation, passes, stop, {}, {}, patience, 0, {}};
    g.air.emplace(simulation.air_in(box_of(g)));
    if (!g.air->known()) {  // nothing can be told
        for (const StockPass& q : g.passes) g.done.push_back({q.number, {false, {}}});
        return std::move(g.done);
    }
    g.cuts.emplace(*g.air, simulation, passes.front().number);
    judge_range(g, 0, g.passes.size());
    return std::move(g.done);
}

/// The first of them that were not decided, for longer: a tool that has cut and leaves along its own wall touches it
/// all the way.
void StockSearch::look_again(Verdicts& verdicts, const std::vector<StockPass>& passes,
                             const milling::Simulation& simulation, const std::function<bool()>& stop) const {
    std::vector<std::size_t> open;
    for (std::size_t i = 0; i < verdicts.size() && open.size() < most_again; ++i)
        if (!verdicts[i].second.decided) open.push_back(i);
    for_all(
        open.size(), threads_,
        [&](std::size_t n) {
            auto& [number, verdict] = verdicts[open[n]];
            const auto pass = std::find_if(passes.begin(), passes.end(),
                                           [&, wanted = number](const StockPass& q) { return q.number == wanted; });
            const Verdicts again = judged({&*pass, 1}, simulation, stop, longer);
            verdict = again.empty() ? Verdict{} : again.front().second;
        },
        1);
    std::erase_if(verdicts, [](const auto& v) { return v.second.decided && !(v.second.hit.depth > 0); });
}

StockSearch::Verdicts StockSearch::search(const std::vector<StockPass>& passes, const milling::Simulation& simulation,
                                          const std::function<bool()>& stop) const {
    std::vector<std::size_t> ends;
    for (std::size_t i = 0; i < passes.size(); ++i) {
        const std::size_t first = ends.empty() ? 0 : ends.back();
        const bool same = i > first && passes[i].part == passes[first].part && passes[i].axis == passes[first].axis;
        if (i > 0 && (!same || i - first >= most_together)) ends.push_back(i);
    }
    if (passes.empty()) return {};
    ends.push_back(passes.size());
    static_cast<void>(simulation.air_in({}));  // the stock's body is made once, by one thread
    std::vector<Verdicts> found(ends.size());
    for_all(
        ends.size(), threads_,
        [&](std::size_t n) {
            const std::size_t first = n == 0 ? 0 : ends[n - 1];
            found[n] = judged(std::span(passes).subspan(first, ends[n] - first), simulation, stop, 1);
        },
        1);
    Verdicts all;
    for (const Verdicts& group : found) all.insert(all.end(), group.begin(), group.end());
    look_again(all, passes, simulation, stop);
    return all;
}

}  // namespace obrys::check
