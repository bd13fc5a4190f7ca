#include "check/milling/milling.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "base/number.hpp"
#include "base/whole.hpp"
#include "check/certify_shapes.hpp"
#include "check/milling_tool.hpp"
#include "check/words.hpp"
#include "cl/path_element.hpp"
#include "cl/spline.hpp"
#include "cl/totals.hpp"
#include "cl/unknown_tool.hpp"
#include "motion/technology.hpp"

namespace obrys::check {

namespace milling = sim::milling;

namespace {

constexpr std::uint32_t most_pieces_in_all = 200'000;  ///< in all; the moves behind them count as a whole
constexpr std::size_t batch = 32'768;                  ///< passes that wait for the simulation
constexpr double drill_rub = 0.02;     ///< mm by which the assumed body of a drill stands out of its hole
constexpr double stock_chords = 0.02;  ///< of what is allowed: of a round stock
constexpr double fallback_radius = 1;  ///< mm, where no tool of the list has a shape

/// The smallest radius that a tool of the list can leave: what the lattice must resolve.
double smallest_radius(const Setup& setup) {
    double smallest = 0;
    for (const shop::Tool& t : setup.tools) {
        const milling::MadeShape made = milling::shape_of(cutter_of(t));
        if (!made.ok()) continue;
        const double r = milling::smallest_radius(made.shape, setup.milling->tolerance);
        if (r > 0 && (smallest == 0 || r < smallest)) smallest = r;
    }
    return smallest > 0 ? smallest : fallback_radius;
}

std::string megabytes(double bytes) { return base::fixed(bytes / 1e6, 0) + " MB"; }

/// The tool stays where it is, as far as that is known: such a record tells its axis alone.
bool on_the_spot(geom::Vec3 a, geom::Vec3 b) {
    const auto same = [](double x, double y) { return x == y || (std::isnan(x) && std::isnan(y)); };
    return same(a.x, b.x) && same(a.y, b.y) && same(a.z, b.z);
}

}  // namespace

Milling::Milling(const Setup& setup, const motion::State& state, Collector& out)
    : setup_(setup), state_(state), out_(out), pieces_left_(most_pieces_in_all), time_up_(setup.out_of_time) {
    begin();
}

void Milling::begin() {
    const MillingSetup& m = *setup_.milling;
    if (const std::string problem = milling::problem_of(m.stock); !problem.empty())
        return out_.unchecked("stock: " + problem + ": removal not simulated");
    const milling::Box3 box = milling::box_of(m.stock);
    const milling::Resolution fine = milling::resolve(box, m.tolerance, smallest_radius(setup_), m.memory_bytes);
    if (!fine.lattice) {
        const std::string needed = std::isfinite(fine.bytes) ? megabytes(fine.bytes) : "more than any memory";
        return out_.unchecked(
            "a tolerance of " + base::shortest(m.tolerance) + " mm needs " + needed + " for this stock, of which " +
                megabytes(m.memory_bytes) + " may be used: removal not simulated",
            std::isfinite(fine.fits) && fine.fits <= shop::largest_tolerance
                ? "a tolerance of " + base::shortest(std::ceil(fine.fits * 1e5) / 1e5) + " mm would fit (--tolerance)"
                : std::string());
    }
    const auto& lattice = fine.lattice;
    judge_crossing();
    simulation_.emplace(m.stock, *lattice, m.tolerance, m.threads);
    if (simulation_->open_rays() > 0)
        out_.unchecked("the stock's surface is not closed: " + std::to_string(simulation_->open_rays()) +
                       " rays enter it and do not leave");
    known_tools_.resize(setup_.tools.size());
    figures_.tolerance_mm = m.tolerance;
    figures_.step = lattice->step;
    figures_.before_mm3 = milling::volume(*simulation_);
    const milling::Box3 stock = milling::box_of(m.stock);
    all_ = m.part != nullptr ? mesh::bounds(m.part->mesh()) : mesh::Box{};
    all_.add(stock.min);
    all_.add(stock.max);
    if (m.part != nullptr && judges_part(setup_.scope)) {
        const double allowed = std::max(setup_.tolerances.gouge, m.tolerance);
        certificate_.emplace(m, allowed);
        part_guard_.emplace(m.part, allowed, m.threads, before_of(m.stock, stock_chords * allowed));
    }
    if (simulation_->open_rays() == 0 && !crossed_)
        stock_guard_.emplace(m.stock, setup_.tolerances.rapid,
                             std::max({lattice->step.x, lattice->step.y, lattice->step.z}), m.tolerance, m.threads);
    add_clamps(m.memory_bytes - fine.bytes);
}

Milling::~Milling() = default;

void Milling::add_clamps(double left) {
    for (const check::Clamp& c : setup_.milling->clamps) {
        if (const std::string problem = milling::problem_of(c.body); !problem.empty()) {
            out_.unchecked("clamp " + c.name + ": " + problem + ": collisions with it are not checked");
            continue;
        }
        const milling::Box3 box = milling::box_of(c.body);
        const geom::Vec3 size = box.max - box.min;
        const double step = std::clamp(std::max({size.x, size.y, size.z}) / 200, 0.1, 1.0);
        const auto lattice = milling::make_lattice(box, step);
        const double needed = lattice ? milling::bytes_for(*lattice) : std::nan("");
        if (!(needed <= left)) {
            out_.unchecked("clamp " + c.name + " is too large: collisions with it are not checked",
                           "give the part of it that stands near the workpiece");
            continue;
        }
        left -= needed;
        clamps_.push_back({c.name,
                           milling::Simulation(c.body, *lattice, setup_.milling->tolerance, setup_.milling->threads),
                           std::make_unique<BodyGuard>(c.body, setup_.tolerances.rapid, setup_.milling->threads)});
    }
}

void Milling::spindle_changed(const cl::Spindle& before) {
    const bool stands = motion::turning_sense(state_.spindle) == 0;
    const bool oriented = stands && state_.spindle.held.has_value();
    const bool stops = stands && (motion::turning_sense(before) != 0 || (oriented && !before.held));
    // Not held, a program's own stop says nothing of where the edge stands; a cycle's does.
    const bool bar_stands = oriented || (is_placed(cycle_) && stands);
    if (bar_stands && stops && !moves_.empty()) stopped_at_ = moves_.back().to;
    const bool swings = before.held && state_.spindle.held && *before.held != *state_.spindle.held;  // NaN: not told
    edge_away_ = bar_stands && !swings && (edge_away_ || (stops && !moves_.empty()));
    edge_leaves_.reset();
    judge_reversal(before);
}

void Milling::tool_changed() {
    const shop::Tool* before = tool_;
    const cl::ToolChange& tool = state_.change;
    tool_ = state_.tool;
    tool_name_ = !state_.any_tool       ? ""
                 : cl::is_unknown(tool) ? "?"
                 : tool.name.empty()    ? "T" + std::to_string(tool.number)
                                        : "\"" + tool.name + "\"";
    tool_ready_ = false;
    if (before != nullptr && tool_ != nullptr && before->length != tool_->length)
        out_.assumption("a new tool's tip is taken to be where the last one's was, until the program moves it",
                        state_.changed);
}

/// A tool thinner than the rays' distance may go between them and take nothing.
void Milling::require_fine_enough(const Move& move, double radius) {
    const geom::Vec3 step = simulation_->dexels().lattice().step;
    const double apart = std::max({step.x, step.y, step.z});
    if (apart <= radius) return;
    complete_ = false;
    const MillingSetup& m = *setup_.milling;
    out_.unchecked(move.record,
                   "a tolerance of " + base::shortest(m.tolerance) + " mm sets rays " + base::fixed(apart, 3) +
                       " mm apart: tool " + tool_name_ + " of " + base::fixed(2 * radius, 3) +
                       " mm may pass between them",
                   "take a tolerance of at most " +
                       base::shortest(std::floor(m.tolerance * radius * radius / (apart * apart) * 1e4) / 1e4) +
                       " mm (--tolerance)");
}

std::uint32_t Milling::add_tool(const milling::ToolShape& shape) {
    if (certificate_) certificate_->add_tool(shape);
    if (part_guard_) part_guard_->add_tool(shape);
    if (stock_guard_) stock_guard_->add_tool(shape);
    for (Clamp& c : clamps_) {  // the same number in each
        static_cast<void>(c.simulation.add_tool(shape));
        c.guard->add_tool(shape);
    }
    return simulation_->add_tool(shape);
}

/// Why the tool cannot be simulated stands in the notes; each tool is made once.
bool Milling::tool_in_use(const Move& move) {
    if (tool_ready_) return true;
    if (tool_ == nullptr) {
        out_.unchecked(move.record,
                       cl::is_unknown(state_.change) ? "which tool is in use is not known: removal not simulated"
                       : tool_name_.empty()          ? "no tool is selected: removal not simulated"
                                            : "tool " + tool_name_ + " is not known: its removal is not simulated");
        return false;
    }
    auto& known = known_tools_[static_cast<std::size_t>(tool_ - setup_.tools.data())];
    if (!known) {
        const milling::Cutter cutter = cutter_of(*tool_, drill_rub + 2 * setup_.tolerances.rapid);
        milling::MadeShape made = milling::shape_of(cutter);
        if (!made.ok()) {
            out_.unchecked(move.record, "tool " + tool_name_ + ": " + made.problem + ": its removal is not simulated");
            return false;
        }
        require_fine_enough(move, made.shape.cutting.radius);
        if (!tool_->holder.empty() && !(tool_->length > 0) && cutter.cutting_length >= unknown_height)
            out_.unchecked(move.record, "tool " + tool_name_ + ": where its holder is is not known: it is not checked",
                           "give the tool's length");
        if (tool_->holder.empty() && !stands_in_spindle(*tool_))
            in_nothing_ += (in_nothing_.empty() ? "" : ", ") + tool_name_;
        const bool shank = !cutter.shank.empty() || tool_->kind == shop::ToolKind::t_slot;
        known = KnownTool{add_tool(made.shape), shank, !cutter.holder.empty(), made.shape.holder.bottom};
        // A thin disc, narrower by the tolerance: a hole as wide is not met.
        const double thin = setup_.milling->tolerance, radius = core_on_slant(*tool_);
        if (radius > 2 * thin) {
            milling::ToolShape disc;
            disc.cutting = milling::make_shape({milling::cylinder(0, thin, radius - thin)});
            known->core = add_tool(disc);
            known->core_radius = radius;
        }
    }
    sim_tool_ = known->number;
    tool_parts_ = *known;
    tool_ready_ = true;
    return true;
}

void Milling::take(const Move& move, std::uint32_t use, const motion::Stand::View& view,
                   const std::vector<shop::ToolPose>& swing) {
    if (move.rapid && !move.turning && !(view.axis == axis_) && on_the_spot(move.from, move.to)) {
        axis_ = view.axis;
        return;
    }
    if (time_up_.before(move.index)) {
        complete_ = false;
        return out_.unchecked(move.record, time_up_.text(), TimeUp::remedy);
    }
    if (moves_.size() >= setup_.milling->most_simulated) return leave_to_memory(move);
    if (!geom::is_finite(move.from) || !geom::is_finite(move.to)) return take_open(move, use, view);
    whereabouts_.known(move.to);
    const auto leave_out = [&](std::string why, std::string remedy = {}) {
        complete_ = false;
        out_.unchecked(move.record, std::move(why), std::move(remedy));
    };
    if (!view.problem.empty()) return leave_out(view.problem, view.remedy);
    if (!view.doubt.empty()) out_.unchecked(move.record, view.doubt, view.remedy);
    const geom::Vec3 axis = view.axis;
    const bool turns = move.turning || (passes_ > 0 && geom::distance(axis, axis_) > 1e-9);
    if (turns && (!move.rapid || swing.empty()))
        leave_out("rotary axes turn on the way: the move is simulated as they stand at its end",
                  move.rapid
                      ? "give the zero offset in [datum] of the job, the tool's length, and a machine with a chain"
                      : "");
    else if (turns)
        out_.assumption("a rapid with which rotary axes turn is simulated in steps of a degree, all axes evenly",
                        move.record.from);
    axis_ = axis;
    if (move.rapid && tool_ == nullptr && tool_name_.empty())
        return out_.assumption("no tool is in the spindle: rapids without one are not simulated", move.record.from);
    if (!tool_in_use(move)) {
        complete_ = false;
        return;
    }
    const auto element = cl::element_of(move.from, move.record.step);
    if (!element) return leave_out("the way of this move is not known: removal not simulated");
    MilledMove m;
    m.index = move.index;
    m.where = move.record.from;
    m.stack = move.record.stack;
    m.from = move.from;
    m.to = move.to;
    m.tool = use;
    m.rapid = move.rapid;
    m.along = is_placed(cycle_) && !(m.where == cycle_);
    m.plunging = leads_down(*element, axis);
    const double length = cl::move_length(move.from, move.record.step);
    m.seconds = seconds_of(move, length);
    keep_technology(move, length, m);
    keep_points(move, m);
    moves_.push_back(m);
    judge_tap_out(move, m);
    if (move.rapid) {
        queue_rapid(move, m, *element, view, swing);
    } else {
        queue(*element, m, true);
        keep_thread(move);
        judge_tapping(move, m);
    }
    if (queued_.size() >= batch) carry_out();
}

void Milling::leave_to_memory(const Move& move) {
    if (std::exchange(memory_full_, true)) return;
    complete_ = false;
    out_.unchecked(move.record,
                   std::to_string(moves_.size()) + " moves are simulated: from move " + std::to_string(move.index) +
                       " on nothing is, so that the memory suffices",
                   "raise simulated_moves in [budget] of the job: a thousand moves take about half a megabyte");
}

void Milling::carry_out() {
    simulation_->flush();
    if (certificate_) certificate_->carry_out();
    if (part_guard_) part_guard_->carry_out();
    if (stock_guard_) stock_guard_->carry_out(*simulation_, setup_.out_of_time);
    for (Clamp& c : clamps_) {
        c.simulation.flush();
        c.guard->carry_out();
    }
    for (std::size_t i = 0; i < queued_.size(); ++i) judge(i);
    judge_cores();
    queued_.clear();
    if (setup_.progress && !moves_.empty()) setup_.progress(moves_.back().index + 1);
}

/// What single moves took is known along one direction of rays only, off by parts of a cell at walls; all together is
/// known better, so their shares are scaled to it.
void Milling::balance() {
    double sum = 0;
    for (const MilledMove& m : moves_) sum += m.volume_mm3;
    if (!(sum > 0)) return;
    const double factor = (figures_.before_mm3 - figures_.after_mm3) / sum;
    for (MilledMove& m : moves_) m.volume_mm3 *= factor;
    for (ToolUse& t : out_.result().tools) t.volume_mm3 *= factor;
}

void Milling::finish(bool whole) {
    if (!simulation_) return;
    carry_out();
    whole_ = whole;
    if (start_moves_ > 0)
        out_.assumption("start position not known: the first " + std::to_string(start_moves_) +
                        (start_moves_ == 1 ? " rapid move was" : " rapid moves were") + " not simulated");
    if (!in_nothing_.empty())
        out_.assumption("neither length nor holder of " + in_nothing_ +
                        " is in the job: what holds it is taken to meet nothing");
    auto milled = std::make_shared<Milled>();
    figures_.after_mm3 = milling::volume(*simulation_);
    figures_.memory_mb = static_cast<double>(simulation_->bytes()) / 1e6;
    balance();
    for (const MilledMove& m : moves_) figures_.contact_length_mm += m.contact_length_mm;
    milled->figures = figures_;
    milled->moves = std::move(moves_);
    milled->points = std::move(points_);
    milled->moves_with_points = moves_with_points_;
    judge_surface(*milled);
    if (setup_.milling->at) keep_at_move(*milled, *setup_.milling->at);
    out_.result().milled = std::move(milled);
}

}  // namespace obrys::check
