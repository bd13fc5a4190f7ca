#include "check/turning/removal.hpp"

#include <algorithm>
#include <cmath>

#include "base/codes.hpp"
#include "base/number.hpp"
#include "check/turning/beside.hpp"
#include "check/turning/turning_tool.hpp"
#include "cl/totals.hpp"
#include "cl/unknown_tool.hpp"
#include "geom/boolean.hpp"

namespace obrys::check {

namespace {

/// Not of a place that is not known.
bool is_off_axis(double x) {
    constexpr double on_axis = 1e-6;  // mm
    return std::abs(x) > on_axis;
}

bool known(geom::Vec3 p) { return std::isfinite(p.x) && std::isfinite(p.z); }

/// A tool that the list has with another edge alone is not to be added: its edge is to be given.
std::string remedy_of_missing(const std::vector<shop::Tool>& tools, const cl::ToolChange& wanted) {
    for (const shop::Tool& t : tools)
        if (wanted.number != 0 && t.number == wanted.number)
            return "the list has it with edge = " + std::to_string(t.edge) +
                   ": add a [[tool]] with edge = " + std::to_string(wanted.edge) + ", or correct the program";
    return "add it to the job file, or give the tool file of the machine";
}

}  // namespace

Removal::Removal(const Setup& setup, const motion::State& state, Collector& out)
    : setup_(setup),
      state_(state),
      out_(out),
      use_on_axis_(setup, state, out),
      passes_(state, out),
      time_up_(setup.out_of_time) {
    if (!setup.stock || setup.stock->empty() || setup.machine.kind != shop::MachineKind::lathe) return;
    work_.emplace(*setup.stock);
    if (setup.part && judges_part(setup.scope)) part_.emplace(*setup.part);
    if (setup.allowance && judges_part(setup.scope)) allowance_.emplace(*setup.allowance);
    for (const TurnedClamp& c : setup.turned_clamps) {
        // What it holds is not it: inside of the bar a chuck has room for drills and boring bars.
        const geom::Region body = geom::subtract(c.body, *setup.stock);
        if (!body.empty()) clamps_.push_back({c.name, body, sim::turning::Workpiece(body)});
    }
    stock_box_ = box_of(*setup.stock);
    last_cuts_ = LastCuts(stock_box_);
    out_.result().before = StockFigures{work_->area(), work_->volume()};
}

void Removal::tool_changed() {
    emptied_ = !state_.any_tool && (emptied_ || had_tool_);
    had_tool_ = state_.any_tool;
    passes_.judge();
    changed_ = true;
    positioned_ = false;
    tool_ = state_.tool;
    outline_ = tool_ != nullptr ? turning_outline(*tool_) : geom::Contour{};
    sure_ = tool_ != nullptr ? shop::sure_outline(*tool_) : geom::Contour{};
    behind_ = tool_ != nullptr ? behind_blade(*tool_) : geom::Contour{};
    carried_ = tool_ != nullptr ? carried_by(*tool_) : std::vector<Carried>{};
    use_on_axis_.tool_changed();
    outline_box_ = box_of(outline_);
    outline_box_.cover(box_of(behind_));
    for (const Carried& c : carried_) outline_box_.cover(box_of(c.body));
}

/// The first move with a tool: enters it into the list of tools, complains where the shop does not have it.
void Removal::first_use(const Move& move) {
    changed_ = false;
    use_ = 0;
    if (!state_.any_tool || cl::is_unknown(state_.change)) return;
    const cl::ToolChange& tool = state_.change;
    auto& uses = out_.result().tools;
    for (std::size_t i = 0; i < uses.size() && use_ == 0; ++i)
        if (uses[i].number == tool.number && uses[i].edge == tool.edge && uses[i].name == tool.name)
            use_ = static_cast<std::uint32_t>(i + 1);
    if (use_ != 0) return;
    std::optional<std::size_t> listed;
    if (tool_ != nullptr) listed = static_cast<std::size_t>(tool_ - setup_.tools.data());
    uses.push_back({tool.number, tool.edge, tool.name, listed, move.record.from, move.record.from, 0, 0, 0, 0});
    use_ = static_cast<std::uint32_t>(uses.size());
    const auto another = [&](const ToolUse& u) { return u.number != tool.number || u.name != tool.name; };
    if (work_ && std::any_of(uses.begin(), uses.end(), another))
        out_.assumption(
            "the swing of the turret to another tool is not checked: how far its tools stand out is not given",
            state_.changed);
    if (tool_ != nullptr) return;
    if (!setup_.tools_given && setup_.scope == shop::Scope::motion) return;
    if (!setup_.tools_given)
        return out_.unchecked({state_.change, state_.changed, state_.changed_from},
                              "no tool list is given: tools are not checked", "name the tools in a job file");
    Finding f;
    f.code = base::codes::tool_missing;
    f.text = tool_name(tool) + " is not in the tool list";
    f.remedy = remedy_of_missing(setup_.tools, tool);
    f.where = state_.changed;
    f.stack = out_.stacks().sites(state_.changed_from);
    if (!(move.record.from == state_.changed)) f.related.push_back({move.record.from, "first move with it"});
    out_.finding(move, std::move(f));
}

bool Removal::is_astray(const Move& move) const {
    return state_.any_tool && state_.change.edge == 0 && !leads_away(move, stock_box_);
}

bool Removal::works_off_axis(const Move& move) const {
    return tool_ != nullptr && shop::is_milling(tool_->kind) && (is_off_axis(move.from.x) || is_off_axis(move.to.x));
}

/// Why the removal of a move cannot be computed.
std::optional<std::string> Removal::obstacle(const Move& move, Wants wants) const {
    const std::string tool = state_.any_tool ? tool_name(state_.change) : "";
    if (!state_.any_tool) return "no tool is selected: removal not simulated";
    if (cl::is_unknown(state_.change)) return "which tool is in use is not known: removal not simulated";
    if (tool_ == nullptr) return tool + " is not known: its removal is not simulated";
    if (is_astray(move))
        return tool + (move.rapid
                           ? " comes to the stock without its offset: where its edge stands is not known: removal "
                             "not simulated"
                           : " cuts without its offset (D0): where its edge stands is not known: removal not "
                             "simulated");
    if (outline_.vertices.empty()) return tool + " has no outline: its removal is not simulated";
    if (std::holds_alternative<cl::Spline>(move.record.step)) return "spline: removal not simulated";
    const auto* arc = std::get_if<cl::Arc>(&move.record.step);
    if (arc != nullptr && !lies_in_turning_plane(*arc)) return "arc outside the turning plane: removal not simulated";
    if (wants == Wants::removal && positioned_ && !move.rapid)
        return "the workpiece stands or turns as an axis: what a driven tool cuts is not simulated";
    if (std::abs(move.to.y) > 1e-6 || std::abs(move.from.y) > 1e-6) return "Y is not 0: removal not simulated";
    return std::nullopt;
}

/// True where the coordinates that are known prove that the tool passes beside the stock.
bool Removal::misses(const Move& move) const {
    const cl::Step& step = move.record.step;                                      // a curve goes further than its ends
    const bool off = std::abs(move.from.y) > 1e-6 || std::abs(move.to.y) > 1e-6;  // then X is no radius
    if (off || outline_box_.empty() || std::holds_alternative<cl::Arc>(step) ||
        std::holds_alternative<cl::Spline>(step))
        return false;
    return beside_in_x(move.from.x, move.to.x, outline_box_, stock_box_) ||
           beside_in_z(move.from.z, move.to.z, outline_box_, stock_box_);
}

void Removal::skipped(const Move& move, std::string why) {
    if (move.rapid && (!whereabouts_.began() || (!state_.any_tool && use_ == 0))) {
        ++start_moves_;
        return;
    }
    complete_ = false;
    out_.unchecked(move.record, std::move(why));
}

void Removal::cut(const Move& move, const sim::turning::Move& way, Removed& r) {
    r.simulated = true;
    if (shop::is_milling(tool_->kind)) use_on_axis_.take(move, way, stock_box_);
    r.cut = work_->cut(outline_, way, sure_);
    if (shop::is_milling(tool_->kind)) use_on_axis_.cut(move, way, r.cut);
    if (tool_->kind == shop::ToolKind::tap) add_to_threads(work_->met(whole_tap(*tool_), way));
    removed_area_ += r.cut.area;
    r.cuts = r.cut.area > setup_.tolerances.rapid;
    if (!r.cut.removed.empty()) judge(move, r.cut);
    note_fallen(move, r.cut);
    note_reach(move, way);
    judge_holder(move, way);
}

/// A move one of whose ends is not known.
Removed Removal::cut_open(const Move& move) {
    constexpr const char* why = "position not known: removal not simulated";
    Removed r;
    if (!std::holds_alternative<cl::Linear>(move.record.step)) {
        skipped(move, why);
        return r;
    }
    // From beyond the axis a tool comes from its own side; at first it may stand anywhere along the stock.
    const bool across = move.from.x < 0 || move.to.x < 0;
    // Along Z a first move may come from either side, or begin beside the stock.
    geom::Vec3 away{across ? NAN : stock_box_.max_x - outline_box_.min_x, NAN,
                    whereabouts_.began() ? stock_box_.max_z - outline_box_.min_z : NAN};
    if (leaves_towards_home(move, work_->region())) away.z = std::min(away.z, move.from.z);
    const auto in_plane = [](geom::Vec3 p) { return geom::Vec3{p.x, 0, p.z}; };
    const OpenMove open = whereabouts_.open(in_plane(move.from), in_plane(move.to), move.rapid, away);
    if (open.start) ++start_moves_;
    if (open.assumed)
        out_.assumption("a position that is not known, such as home, is taken to lie away from the stock",
                        move.record.from);
    geom::Vec3 from = open.way.from, to = open.way.to;
    const bool turns = shop::is_milling(tool_->kind), ends = open.way.kind == OpenWay::Kind::end;
    if (turns && ends) from = to + geom::Vec3{0, 0, geom::distance(from, to)};  // on its axis
    if (ends || open.way.kind == OpenWay::Kind::swept) {
        const sim::turning::Move way{{from.z, from.x}, {to.z, to.x}, {}, 0};
        if (turns && (is_off_axis(from.x) || is_off_axis(to.x))) {
            pass_beside(move, way, r);
            if (!r.simulated) return r;
        } else {
            cut(move, way, r);
        }
    }
    if (open.left_out) skipped(move, why);
    r.simulated = !open.left_out && open.way.kind != OpenWay::Kind::end;
    return r;
}

Removed Removal::take(const Move& move) {
    Removed r;
    if (changed_) first_use(move);
    if (!state_.any_tool && !move.rapid && !cut_without_tool_) {
        cut_without_tool_ = true;
        Finding f;
        f.code = base::codes::tool_missing;
        f.text = emptied_ ? "no tool is in use at this feed move: tool 0 has replaced the one before"
                          : "no tool is selected at the first feed move";
        if (emptied_) f.related.push_back({state_.changed, "tool 0"});
        f.remedy = emptied_ ? "select the tool that cuts before it"
                            : "select a tool with T and D before it, or name the one in use in the job: first_tool = 1";
        out_.finding(move, std::move(f));
    }
    passes_.follow(move);
    if (work_) {
        judge_clamps(move);
        judge_if_bent(move);
        const bool astray = is_astray(move);
        if (state_.any_tool && !astray && state_.change.edge == 0)
            out_.assumption(
                "a tool without its offset is taken to be away from the stock on rapids that lead away from it",
                move.record.from);
        if (!astray && misses(move)) {
            r.simulated = true;
        } else if (time_up_.before(move.index)) {
            complete_ = false;
            out_.unchecked(move.record, time_up_.text(), TimeUp::remedy);
        } else if (std::optional<std::string> why = obstacle(move)) {
            skipped(move, std::move(*why));
        } else if (!known(move.from) || !known(move.to)) {
            r = cut_open(move);
        } else {
            cut_along(move, r);
        }
        in_front_ = in_front_ || (move.to.z >= stock_box_.max_z && move.to.x < stock_box_.max_x);
    }
    if (!std::holds_alternative<cl::Thread>(move.record.step)) ground_.reset();
    whereabouts_.known({move.to.x, 0, move.to.z});
    count_use(move, r);
    return r;
}

void Removal::count_use(const Move& move, const Removed& removed) {
    if (use_ == 0) return;
    ToolUse& use = out_.result().tools[use_ - 1];
    ++use.moves;
    use.last = move.record.from;
    use.volume_mm3 += removed.cut.volume;
    const double length = cl::move_length(move.from, move.record.step);
    if (std::isfinite(length)) (move.rapid ? use.rapid_length_mm : use.feed_length_mm) += length;
}

/// What was there must be what was removed and what is left. Where it is not, the removal went wrong and nothing it
/// says can be trusted.
void Removal::require_balance(const StockFigures& before, const StockFigures& after) {
    const double difference = before.area_mm2 - after.area_mm2 - removed_area_;
    const double allowed = 1e-4 + 1e-8 * before.area_mm2;  // mm2; rounding of 60 000 cuts makes 3e-8
    if (std::abs(difference) <= allowed) return;
    out_.unchecked("the removed material and the rest do not add up to the stock (" + mm2(difference) +
                       " differ): the removal cannot be trusted",
                   "please report this program as a fault of obrys");
}

/// A stock that the program never meets, or that does not hold the part, is one drawn about another zero point: a check
/// against it says nothing.
void Removal::require_contact() {
    constexpr const char* remedy = "see whether stock, part and program use the same zero point (docs/job-file.md)";
    if (out_.result().stats.feed_moves > 0 && removed_area_ == 0 && threads_.empty() && complete_)
        out_.unchecked("not one move met the stock: nothing was checked against it", remedy);
    if (setup_.part && geom::intersect(*setup_.part, *setup_.stock).empty())
        out_.unchecked("the part lies outside the stock", remedy);
}

/// A part that stands out of its stock cannot be made of it.
void Removal::require_room(const cl::Record& end) {
    if (!part_ || geom::intersect(*setup_.part, *setup_.stock).empty()) return;
    std::optional<sim::turning::Depth> worst;
    for (auto& d : sim::turning::pieces_outside(*setup_.part, *setup_.stock, setup_.tolerances.gouge))
        if (!worst || d.normal > worst->normal) worst = std::move(d);
    if (!worst) return;
    Finding f;
    f.code = base::codes::gouge;
    f.text = "the stock does not hold the part: it stands out of it by " + mm(worst->normal) + " at " +
             point(worst->deepest) + ", " + mm2(worst->area);
    f.remedy = "see whether stock and part use the same zero point and the right diameters";
    f.cause = "stock";
    f.amounts = {
        {"depth_mm", worst->normal}, {"area_mm2", worst->area}, {"z_mm", worst->deepest.x}, {"x_mm", worst->deepest.y}};
    f.region = worst->region;
    f.at = worst->deepest;
    out_.finding(end, std::move(f));
}

void Removal::finish(const cl::Record& end, bool whole) {
    Result& result = out_.result();
    if (whole) passes_.judge();
    if (!work_) {
        if (result.stats.moves == 0) return;
        if (setup_.milling) return;  // what is wrong with its stock has been said
        if (setup_.scope == shop::Scope::motion) return;
        out_.unchecked("no stock: removal not simulated", "describe the stock in a job file");
        return;
    }
    if (start_moves_ > 0)
        out_.assumption("start position or tool not known: the first " + std::to_string(start_moves_) +
                        (start_moves_ == 1 ? " rapid move was" : " rapid moves were") + " not simulated");
    result.after = StockFigures{work_->area(), work_->volume()};
    result.stock_after = work_->region();
    if (result.before) require_balance(*result.before, *result.after);
    require_contact();
    require_room(end);
    if (!judges_part(setup_.scope)) return;
    if (!setup_.part && !setup_.allowance)
        out_.unchecked("no part contour: gouges and rest material not checked",
                       "give the finished contour in the job file");
    else if (!whole)
        out_.assumption(rest_of_a_part_run);
    else if (complete_)
        find_rest(setup_, {result.stock_after, ridges_, in_front_}, last_cuts_, end, out_);
    else
        out_.unchecked("rest material not judged, since not every move was simulated");
}

}  // namespace obrys::check
