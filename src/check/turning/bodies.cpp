// What goes with the edges and does not cut, against stock and clamps; rapids that need not go straight.
#include <algorithm>
#include <cmath>

#include "base/codes.hpp"
#include "check/touching/rapid_way.hpp"
#include "check/turning/removal.hpp"
#include "geom/boolean.hpp"
#include "geom/sweep.hpp"
#include "sim/turning/swept.hpp"

namespace obrys::check {

using sim::turning::Depth;

namespace {

constexpr double far_away = 1e4;  ///< mm

constexpr const char* stands_off = " does not stand on the turning axis: what it removes there is not simulated";

bool is_known(geom::Vec3 p) { return std::isfinite(p.x) && std::isfinite(p.z); }

std::string_view name_of(Carried::Kind kind) {
    switch (kind) {
        case Carried::Kind::shank: return "shank";
        case Carried::Kind::holder: return "holder";
        case Carried::Kind::edges: return "body above the cutting edges";
        case Carried::Kind::machine: break;
    }
    return "seat of the tool, above its length,";
}

/// All that a body covers on any way towards +Z and +X.
geom::Region quadrant(const geom::Contour& body, geom::Vec2 from) {
    geom::Region all;
    for (const geom::Contour& up : sim::turning::swept(body, {from, from + geom::Vec2{0, far_away}, {}, 0}).contours) {
        if (!(geom::area(up) > 0)) continue;
        const geom::Region right = geom::sweep_straight(up, {far_away, 0});
        all = all.empty() ? right : geom::unite(all, right);
    }
    return all;
}

}  // namespace

/// A rapid to a home of which nothing is known: it lies towards +X and +Z, and on no way there the tool meets `body`.
bool Removal::leaves_towards_home(const Move& move, const geom::Region& body) const {
    const bool home = std::isnan(move.to.x) && std::isnan(move.to.z);
    if (!move.rapid || !home || !std::isfinite(move.from.x) || !std::isfinite(move.from.z) || move.from.x < 0)
        return false;
    const auto is_clear = [&](const geom::Contour& c) {
        const geom::Region met = geom::intersect(body, quadrant(c, {move.from.z, move.from.x}));
        return geom::area(met) <= setup_.tolerances.rapid;
    };
    return is_clear(outline_) &&
           std::all_of(carried_.begin(), carried_.end(), [&](const Carried& c) { return is_clear(c.body); });
}

/// The straight pieces of a rapid, the move itself of others.
std::vector<sim::turning::Move> Removal::ways_of(const Move& move, shop::RapidPath path) const {
    if (!move.rapid || path != shop::RapidPath::dog_leg || !std::holds_alternative<cl::Linear>(move.record.step))
        return {in_turning_plane(move)};
    std::vector<sim::turning::Move> ways;
    geom::Vec3 from{move.from.x, 0, move.from.z};
    for (const geom::Vec3& to :
         motion::corners_of_rapid(setup_.machine, motion::upright_axes, from, {move.to.x, 0, move.to.z})) {
        ways.push_back({{from.z, from.x}, {to.z, to.x}, {}, 0});
        from = to;
    }
    return ways;
}

/// What a rapid would meet only where it bends; the machine file does not say whether it does.
void Removal::judge_if_bent(const Move& move) {
    if (!move.rapid || rapid_path(setup_) != shop::RapidPath::either || !is_known(move.from) || !is_known(move.to))
        return;
    const std::vector<sim::turning::Move> bent = ways_of(move, shop::RapidPath::dog_leg);
    if (bent.size() < 2 || obstacle(move, Wants::place)) return;
    const sim::turning::Move straight = in_turning_plane(move);
    const auto say = [&](std::string_view what, const std::string& into, const Depth& d) {
        out_.unchecked(move.record,
                       met_if_bent(setup_, std::string(what) + " runs into " + into + ": " + mm(d.normal) +
                                               " deep at " + point(d.deepest)),
                       say_rapid_way);
    };
    const auto judge_body = [&](std::string_view what, const geom::Contour& body, const geom::Contour& across) {
        if (body.vertices.empty()) return;
        for (const ClampBody& clamp : clamps_)
            for (const sim::turning::Move& way : bent)
                if (const auto d = depth_in(clamp, body, way, across); d && !depth_in(clamp, body, straight, across)) {
                    say(what, "the clamp " + clamp.name, *d);
                    break;
                }
        if (misses(move)) return;
        for (const sim::turning::Move& way : bent)
            if (const auto d = depth_on_way(body, way, across); d && !depth_on_way(body, straight, across))
                return say(what, "the stock", *d);
    };
    judge_body("tool", outline_, sure_);
    for (const Carried& c : carried_) judge_body(name_of(c.kind), c.body, c.body);
}

/// How deep a body would go into what stands now, threads left out.
std::optional<Depth> Removal::depth_on_way(const geom::Contour& body, const sim::turning::Move& way,
                                           const geom::Contour& across) const {
    geom::Region met = work_->met(body, way, across);
    if (!met.empty() && !threads_.empty()) met = geom::subtract(met, threads_);
    if (met.empty() || !(geom::area(met) > setup_.tolerances.rapid)) return std::nullopt;
    return sim::turning::depth_inside(met, work_->region(), setup_.tolerances.rapid);
}

bool Removal::touches_stock(const sim::turning::Move& way) const {
    const auto is_met = [&](const geom::Contour& body, const geom::Contour& across) {
        return !body.vertices.empty() && geom::area(work_->met(body, way, across)) > setup_.tolerances.rapid;
    };
    return is_met(outline_, sure_) ||
           std::any_of(carried_.begin(), carried_.end(), [&](const Carried& c) { return is_met(c.body, c.body); });
}

/// A drill or mill beside the turning axis: the section through both axes shows whether it meets what turns.
void Removal::pass_beside(const Move& move, const sim::turning::Move& way, Removed& r) {
    r.simulated = !touches_stock(way);
    if (!r.simulated) skipped(move, tool_name(state_.change) + stands_off);
}

/// Both ends are known.
void Removal::cut_along(const Move& move, Removed& r) {
    const auto* thread = std::get_if<cl::Thread>(&move.record.step);
    if (thread != nullptr && !shop::is_milling(tool_->kind))
        return cut_thread(move, in_turning_plane(move), *thread, r);
    sim::turning::Cut all;
    r.simulated = true;
    const std::vector<sim::turning::Move> ways = ways_of(move, rapid_path(setup_));
    if (ways.size() > 1 && !setup_.machine.rapid_path) out_.assumption(bent_as_delivered(setup_), move.record.from);
    for (const sim::turning::Move& way : ways) {
        Removed part;
        if (works_off_axis(move))
            pass_beside(move, way, part);
        else
            cut(move, way, part);
        r.simulated = r.simulated && part.simulated;
        r.cuts = r.cuts || part.cuts;
        if (all.removed.empty()) {
            all = std::move(part.cut);
            continue;
        }
        if (!part.cut.removed.empty()) all.removed = geom::unite(all.removed, part.cut.removed);
        all.area += part.cut.area;
        all.volume += part.cut.volume;
        all.depth_x = std::max(all.depth_x, part.cut.depth_x);
        all.contact_length += part.cut.contact_length;
    }
    r.cut = std::move(all);
}

std::optional<Depth> Removal::depth_in(const ClampBody& clamp, const geom::Contour& body, const sim::turning::Move& way,
                                       const geom::Contour& across) const {
    if (body.vertices.empty()) return std::nullopt;
    const geom::Region met = clamp.body.met(body, way, across);
    if (met.empty()) return std::nullopt;
    return sim::turning::depth_inside(met, clamp.region, setup_.tolerances.rapid);
}

void Removal::say_clamp(const Move& move, const ClampBody& clamp, std::string_view what, const Depth& d) {
    Finding f;
    f.code = base::codes::clamp_collision;
    f.text = "the " + std::string(what) + " runs into the clamp " + clamp.name + ": " + mm(d.normal) + " deep at " +
             point(d.deepest);
    f.amounts = {{"depth_mm", d.normal}, {"z_mm", d.deepest.x}, {"x_mm", d.deepest.y}};
    f.region = d.region;
    f.at = d.deepest;
    out_.finding(move, std::move(f));
}

/// The edge is as long as docs/job-file.md says where nothing is given.
void Removal::say_default_reach(const Move& move, std::string_view effect) {
    const bool blade = tool_->kind == shop::ToolKind::groove;
    out_.assumption(tool_name(state_.change) + ": its " +
                        (blade ? "blade is taken to be long enough for any groove"
                               : "insert is taken to be " + mm(tool_->edge_length) + " long") +
                        ", since its " + (blade ? "cutting_depth" : "edge_length") +
                        " is not given: " + std::string(effect),
                    move.record.from);
}

void Removal::judge_clamp(const Move& move, const ClampBody& clamp, const sim::turning::Move& way) {
    for (const Carried& c : carried_)
        if (const auto d = depth_in(clamp, c.body, way, c.body)) say_clamp(move, clamp, name_of(c.kind), *d);
    const auto d = depth_in(clamp, outline_, way, sure_);
    if (!d) return;
    say_clamp(move, clamp, "tool", *d);
    const bool given = tool_->reach_given || shop::is_milling(tool_->kind);
    if (!given && !depth_in(clamp, sure_, way, sure_))
        say_default_reach(move, "by that it runs into the clamp " + clamp.name);
}

/// A way one of whose ends is not known.
void Removal::judge_open_clamp(const Move& move, const ClampBody& clamp) {
    if (!std::holds_alternative<cl::Linear>(move.record.step)) return;  // said of the stock
    const Box box = box_of(clamp.region);
    const geom::Vec3 from{move.from.x, 0, move.from.z}, to{move.to.x, 0, move.to.z};
    const bool across = from.x < 0 || to.x < 0;
    const geom::Vec3 away{across ? NAN : box.max_x - outline_box_.min_x, NAN, box.max_z - outline_box_.min_z};
    const OpenWay open = open_way(from, to, away);
    if (open.kind == OpenWay::Kind::swept)
        return judge_clamp(move, clamp, {{open.from.z, open.from.x}, {open.to.z, open.to.x}, {}, 0});
    if (is_known(to)) return judge_clamp(move, clamp, {{to.z, to.x}, {to.z, to.x}, {}, 0});
    if (open.kind != OpenWay::Kind::lost || !is_known(from) || leaves_towards_home(move, clamp.region)) return;
    out_.unchecked(
        move.record,
        "the way home is not known: whether the tool meets the clamp " + clamp.name + " on it is not checked",
        "move away from it before, or give home of the axes in the machine file");
}

/// Insert and holder against what holds the workpiece.
void Removal::judge_clamps(const Move& move) {
    if (clamps_.empty() || obstacle(move, Wants::place)) return;
    const bool whole = is_known(move.from) && is_known(move.to);
    for (const ClampBody& clamp : clamps_) {
        if (!whole) {
            judge_open_clamp(move, clamp);
            continue;
        }
        for (const sim::turning::Move& way : ways_of(move, rapid_path(setup_))) judge_clamp(move, clamp, way);
    }
}

/// Says where an insert of default size would cut beyond the axis: what it does there is not known.
void Removal::note_reach(const Move& move, const sim::turning::Move& way) {
    const bool past = way.sweep != 0 || std::min(way.from.y, way.to.y) + outline_box_.min_x < 0;
    if (tool_->reach_given || !past || shop::is_milling(tool_->kind)) return;
    if (!(geom::area(work_->met(outline_, way)) > setup_.tolerances.rapid)) return;
    const bool blade = tool_->kind == shop::ToolKind::groove;
    out_.assumption(tool_name(state_.change) + (blade ? ": its blade" : ": its insert") +
                        " is taken to end before the opposite wall of the bore, since its " +
                        (blade ? "cutting_depth" : "edge_length") + " is not given",
                    move.record.from);
}

/// How deep a body that does not cut reaches into what stands after the move.
std::optional<Depth> Removal::depth_met(const geom::Contour& body, const sim::turning::Move& way) const {
    const geom::Region met = work_->met(body, way);
    if (met.empty()) return std::nullopt;
    return sim::turning::depth_inside(met, work_->region(), setup_.tolerances.rapid);
}

/// A blade of known length whose holder nobody gave: what goes on behind it is wider than the blade.
void Removal::judge_blade(const Move& move, const sim::turning::Move& way) {
    if (behind_.vertices.empty()) return;
    const auto d = depth_met(behind_, way);
    if (!d) return;
    const Box b = box_of(d->region);
    const double high = tool_->direction == shop::BladeDirection::face ? b.max_z - b.min_z : b.max_x - b.min_x;
    Finding f;
    f.code = base::codes::edges_too_short;
    f.cause = tool_name(state_.change) + " blade";
    f.text = "the blade is " + mm(tool_->cutting_depth) + " long (cutting_depth), material stands beside it " +
             mm(high) + " above that, at " + point(d->deepest);
    f.remedy = "take a longer blade, or give the tool's holder if it is no wider";
    f.amounts = {{"depth_mm", high}, {"area_mm2", d->area}, {"z_mm", d->deepest.x}, {"x_mm", d->deepest.y}};
    f.region = d->region;
    f.at = d->deepest;
    out_.finding(move, std::move(f));
}

void Removal::say_carried(const Move& move, Carried::Kind kind, const Depth& deepest) {
    Finding f;
    if (kind == Carried::Kind::edges) {
        f.code = base::codes::edges_too_short;
        f.cause = tool_name(state_.change);
        f.text = "the cutting edges are " + mm(tool_->cutting_length.value_or(0)) +
                 " long, the hole reaches above them, at " + point(deepest.deepest);
        f.remedy = "take a tool with longer cutting edges, or cut less deep; give the tool's shank if it is thinner";
    } else {
        f.code = base::codes::holder_in_stock;
        f.cause =
            tool_name(state_.change) + " " + (kind == Carried::Kind::machine ? "seat" : std::string(name_of(kind)));
        f.text = "the " + std::string(name_of(kind)) + " runs into the stock: " + mm(deepest.normal) + " deep at " +
                 point(deepest.deepest) + ", " + mm2(deepest.area);
        f.remedy = kind == Carried::Kind::holder ? "see that the way is clear for the holder, or take one that fits"
                                                 : "take a longer tool, or drill less deep";
    }
    f.amounts = {{"depth_mm", deepest.normal},
                 {"area_mm2", deepest.area},
                 {"z_mm", deepest.deepest.x},
                 {"x_mm", deepest.deepest.y}};
    f.region = deepest.region;
    f.at = deepest.deepest;
    out_.finding(move, std::move(f));
}

/// What does not cut may not meet what stands after the move. Of bodies of one kind the deepest is told.
void Removal::judge_holder(const Move& move, const sim::turning::Move& way) {
    note_holding(move);
    judge_blade(move, way);
    for (const Carried::Kind kind :
         {Carried::Kind::shank, Carried::Kind::holder, Carried::Kind::edges, Carried::Kind::machine}) {
        // Out of a hole whose drilling has said it.
        if (kind == Carried::Kind::edges && move.rapid && way.to.x >= way.from.x) continue;
        std::optional<Depth> deepest;
        for (const Carried& c : carried_) {
            const auto d = c.kind == kind ? depth_met(c.body, way) : std::nullopt;
            if (d && (!deepest || d->normal > deepest->normal)) deepest = d;
        }
        if (deepest) say_carried(move, kind, *deepest);
    }
}

/// Of tools on the axis: what is not known of what holds them.
void Removal::note_holding(const Move& move) {
    if (!shop::is_milling(tool_->kind)) return;
    if (is_carried_anywhere(*tool_))
        out_.unchecked(move.record,
                       tool_name(state_.change) + ": where its shank and holder are is not known: they are not checked",
                       "give the tool's cutting_length, or its length");
    else if (is_held_by_nothing(*tool_))
        out_.assumption("neither length nor holder of " + tool_name(state_.change) +
                            " is in the job: what holds it is taken to meet nothing",
                        move.record.from);
}

}  // namespace obrys::check
