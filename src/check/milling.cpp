#include "check/milling.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/number.hpp"
#include "base/whole.hpp"
#include "check/milling_tool.hpp"
#include "check/words.hpp"
#include "cl/path_element.hpp"
#include "cl/spline.hpp"
#include "cl/totals.hpp"

namespace obrys::check {

namespace milling = sim::milling;

namespace {

constexpr double piece = 0.1;                   ///< mm in which the way in the material is measured
constexpr double short_way = 1;                 ///< mm; moves up to that count as a whole
constexpr std::uint32_t most_pieces = 200'000;  ///< in all; the moves behind them count as a whole
constexpr std::size_t batch = 32'768;           ///< passes that wait for the simulation
constexpr double drawn_chord = 0.01;            ///< mm the picture of a curve may leave it
constexpr int most_chords = 256;
constexpr double rub = 0.02;           ///< mm by which the assumed body of a drill stands out of its hole
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

/// Straight down along the axis all the way: a full turn of a helix ends below its start, too.
bool leads_down(const geom::PathElement& e, geom::Vec3 axis) {
    const auto* s = std::get_if<geom::Straight>(&e);
    if (s == nullptr) return false;
    const geom::Vec3 way = s->to - s->from;
    const double down = -geom::dot(way, axis);
    return down > 1e-9 && geom::length(way + down * axis) < 1e-9 * down;
}

bool goes_down(const geom::PathElement& e, geom::Vec3 axis) {
    return geom::dot(geom::point_at(e, 1) - geom::point_at(e, 0), axis) < -1e-9;
}

geom::PathElement part_of(const geom::PathElement& e, double u0, double u1) {
    if (const auto* s = std::get_if<geom::Straight>(&e))
        return geom::Straight{s->from + u0 * (s->to - s->from), s->from + u1 * (s->to - s->from)};
    if (const auto* c = std::get_if<geom::Circular>(&e)) {
        geom::Circular part = *c;
        part.from = u0 == 0 ? c->from : geom::point_at(e, u0);
        part.to = u1 == 1 ? c->to : geom::point_at(e, u1);
        part.centre = c->centre + u0 * geom::dot(c->to - c->from, c->normal) * c->normal;
        part.sweep = (u1 - u0) * c->sweep;
        return part;
    }
    return e;
}

}  // namespace

Milling::Milling(const Setup& setup, Collector& out) : setup_(setup), out_(out), pieces_left_(most_pieces) { begin(); }

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
    simulation_.emplace(m.stock, *lattice, m.tolerance, m.threads);
    if (simulation_->open_rays() > 0)
        out_.unchecked("the stock's surface is not closed: " + std::to_string(simulation_->open_rays()) +
                       " rays enter it and do not leave");
    known_tools_.resize(setup_.tools.size());
    figures_.tolerance_mm = m.tolerance;
    figures_.step = lattice->step;
    figures_.before_mm3 = milling::volume(*simulation_);
    if (m.part != nullptr && judges_part(setup_.scope))
        certificate_.emplace(m, std::max(setup_.tolerances.gouge, m.tolerance));
    if (simulation_->open_rays() == 0)
        rapid_guard_.emplace(m.stock, setup_.tolerances.rapid,
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
                           std::make_unique<ClampGuard>(c.body, setup_.tolerances.rapid, setup_.milling->threads)});
    }
}

void Milling::take(const cl::Record& record, const cl::ToolChange& tool) {
    const shop::Tool* before = tool_;
    tool_ = nullptr;
    tool_name_ = tool.name.empty() ? "T" + std::to_string(tool.number) : "\"" + tool.name + "\"";
    if (tool.number == 0 && tool.name.empty()) tool_name_.clear();
    for (const shop::Tool& t : setup_.tools) {
        const bool same = tool.number != 0 ? t.number == tool.number : !tool.name.empty() && t.name == tool.name;
        if (!same || (tool.edge != 0 && t.edge != tool.edge)) continue;
        tool_ = &t;
        break;
    }
    tool_ready_ = false;
    if (before != nullptr && tool_ != nullptr && before->length != tool_->length)
        out_.assumption("a new tool's tip is taken to be where the last one's was, until the program moves it",
                        record.from);
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
    if (rapid_guard_) rapid_guard_->add_tool(shape);
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
        out_.unchecked(move.record, tool_name_.empty()
                                        ? "no tool is selected: removal not simulated"
                                        : "tool " + tool_name_ + " is not known: its removal is not simulated");
        return false;
    }
    auto& known = known_tools_[static_cast<std::size_t>(tool_ - setup_.tools.data())];
    if (!known) {
        const milling::Cutter cutter = cutter_of(*tool_, rub + 2 * setup_.tolerances.rapid);
        milling::MadeShape made = milling::shape_of(cutter);
        if (!made.ok()) {
            out_.unchecked(move.record, "tool " + tool_name_ + ": " + made.problem + ": its removal is not simulated");
            return false;
        }
        require_fine_enough(move, made.shape.cutting.radius);
        if (!cutter.holder.empty() && !(tool_->length > 0) && cutter.cutting_length >= unknown_height)
            out_.unchecked(move.record, "tool " + tool_name_ + ": where its holder is is not known: it is not checked",
                           "give the tool's length");
        const bool shank = !cutter.shank.empty() || tool_->kind == shop::ToolKind::t_slot;
        known = KnownTool{add_tool(made.shape), shank, !cutter.holder.empty()};
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

/// Minutes that each of X, Y and Z needs for its part of a rapid; nothing where the machine does not say its speed.
std::optional<std::array<double, 3>> Milling::needs_of_rapid(geom::Vec3 way) const {
    std::array<double, 3> needs{};
    for (std::size_t k = 0; k < needs.size(); ++k) {
        const double part = std::abs(milling::component(way, static_cast<int>(k)));
        if (part == 0) continue;
        const auto axis = std::find_if(setup_.machine.axes.begin(), setup_.machine.axes.end(),
                                       [k](const shop::MachineAxis& a) { return a.name == std::string(1, "XYZ"[k]); });
        if (axis == setup_.machine.axes.end() || !(axis->rapid > 0)) return std::nullopt;
        needs[k] = part / axis->rapid;
    }
    return needs;
}

/// Where a rapid comes by when every axis goes at its own speed (dog-leg): the axes stop one after another.
std::vector<geom::Vec3> Milling::corners_of_rapid(const Move& move) const {
    const geom::Vec3 way = move.to - move.from;
    const auto needs = setup_.machine.rapid_path == shop::RapidPath::dog_leg ? needs_of_rapid(way) : std::nullopt;
    if (!needs) return {move.to};
    std::vector<geom::Vec3> corners;
    std::array<double, 3> stops = *needs;
    std::sort(stops.begin(), stops.end());
    for (const double at : stops) {
        geom::Vec3 p = move.to;
        for (int k = 0; k < 3; ++k)
            if (const double need = (*needs)[static_cast<std::size_t>(k)]; need > at)
                milling::set_component(p, k, milling::component(move.from, k) + at / need * milling::component(way, k));
        if (at > 0 || at == stops[2]) corners.push_back(p);
    }
    return corners;
}

void Milling::take(const Move& move, std::uint32_t use, const Stand::View& view,
                   const std::vector<shop::ToolPose>& swing) {
    if (move.rapid && !move.turning && !(view.axis == axis_) && on_the_spot(move.from, move.to)) {
        axis_ = view.axis;
        return;
    }
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
        queue_rapid(move, m, view, swing);
    } else {
        queue(*element, m, true);
        keep_thread(move);
        judge_tapping(move, m);
    }
    if (queued_.size() >= batch) carry_out();
}

void Milling::queue_rapid(const Move& move, const MilledMove& m, const Stand::View& view,
                          const std::vector<shop::ToolPose>& swing) {
    const geom::Vec3 axis = axis_;
    for (std::size_t i = 1; i < swing.size(); ++i) {
        axis_ = swing[i].axis;
        queue(geom::Straight{swing[i - 1].tip, swing[i].tip}, m, false);
    }
    axis_ = axis;
    if (!swing.empty()) return;
    // The corners are those of the machine's axes.
    const bool swivelled = !(view.frame == geom::Frame{}) || geom::distance(view.axis, {0, 0, 1}) > 1e-9;
    if (setup_.machine.rapid_path == shop::RapidPath::dog_leg && swivelled)
        out_.unchecked(move.record, "rapids that bend are simulated straight while the rotary axes are swivelled");
    geom::Vec3 from = move.from;
    for (const geom::Vec3& to : swivelled ? std::vector{move.to} : corners_of_rapid(move)) {
        queue(geom::Straight{from, to}, m, false);
        from = to;
    }
}

/// Chained to the move before; a gap between them (moves that were left out) is a point that is not known.
void Milling::keep_points(const Move& move, MilledMove& m) {
    if (moves_.size() >= setup_.milling->keep_moves) return;
    const bool begins = points_.empty() || geom::distance(points_.back(), move.from) > 1e-6;
    if (begins && !points_.empty()) points_.push_back({NAN, NAN, NAN});
    if (begins) points_.push_back(move.from);
    cl::points_between(move.from, move.record.step, drawn_chord, most_chords,
                       [this](geom::Vec3 p) { points_.push_back(p); });
    points_.push_back(move.to);
    m.points_end = static_cast<std::uint32_t>(points_.size());
    ++moves_with_points_;
}

/// Where a tap has been, the part may show the thread by any of its diameters.
void Milling::keep_thread(const Move& move) {
    if (tool_ == nullptr || shop::assumed_kind(*tool_) != shop::ToolKind::tap) return;
    const geom::Vec3 way = move.to - move.from;
    const double along = std::abs(geom::dot(way, axis_));
    if (!(along > 0) || geom::length(way) - along > 1e-9 * along) return;
    thread_bands_.add(move.from, move.to, axis_, core_radius(*tool_), tool_->radius + tool_->delta_radius);
}

/// At the programmed feed; rapids in straight lines at the slowest axis' rapid.
double Milling::seconds_of(const Move& move, double way) const {
    if (move.rapid) {
        double slowest = INFINITY;
        for (const shop::MachineAxis& a : setup_.machine.axes)
            if (!a.rotary) slowest = std::min(slowest, a.rapid);
        return std::isfinite(slowest) && slowest > 0 ? 60 * way / slowest : NAN;
    }
    switch (feed_.mode) {
        case cl::FeedMode::per_minute: return feed_.value > 0 ? 60 * way / feed_.value : NAN;
        case cl::FeedMode::per_rev: return feed_.value * speed_ > 0 ? 60 * way / (feed_.value * speed_) : NAN;
        case cl::FeedMode::inverse_time: return feed_.value > 0 ? 60 / feed_.value : NAN;
    }
    return NAN;
}

/// What chip thickness follows from.
void Milling::keep_technology(const Move& move, double way, MilledMove& m) const {
    m.sinking = way > 0 ? std::clamp(-geom::dot(move.to - move.from, axis_) / way, -1.0, 1.0) : 0;
    m.spindle = spindle_;
    m.speed_rpm = spindle_ == 0 ? 0 : speed_;
    if (move.rapid) return;
    const auto* thread = std::get_if<cl::Thread>(&move.record.step);
    if (thread != nullptr) m.thread = thread->pitch < 0 ? -1 : 1;
    if (thread != nullptr)
        m.feed_per_rev_mm = std::abs(thread->pitch);
    else if (feed_.mode == cl::FeedMode::per_rev)
        m.feed_per_rev_mm = feed_.value > 0 ? feed_.value : NAN;
    else if (way > 0)
        m.feed_mm_per_min = 60 * way / m.seconds;
    if (std::isnan(m.feed_mm_per_min))
        m.feed_mm_per_min = m.feed_per_rev_mm * m.speed_rpm;
    else if (m.speed_rpm > 0)
        m.feed_per_rev_mm = m.feed_mm_per_min / m.speed_rpm;
}

void Milling::queue(const geom::PathElement& element, const MilledMove& move, bool feed) {
    using Kind = QueuedPass::Kind;
    if (!feed && rapid_guard_) rapid_guard_->add(passes_, element, axis_, sim_tool_);
    if (!feed) queue_pass(Kind::rapid_probe, milling::Part::cutting, false, element);
    if (certificate_) certificate_->add(static_cast<std::uint32_t>(moves_.size() - 1), element, axis_, sim_tool_);
    double way = geom::distance(move.from, move.to);
    if (const auto* c = std::get_if<geom::Circular>(&element)) {
        const geom::Vec3 spoke = c->from - c->centre;
        const double radius = geom::length(spoke - geom::dot(spoke, c->normal) * c->normal);
        way = geom::length(geom::Vec2{radius * c->sweep, geom::dot(c->to - c->from, c->normal)});
    }
    std::uint32_t pieces = 1;
    if (feed && !std::holds_alternative<geom::Cubic>(element) && way > short_way && way / piece < pieces_left_) {
        pieces = base::clipped<std::uint32_t>(std::ceil(way / piece), 1, pieces_left_);
        pieces_left_ -= pieces;
    }
    const double core = tool_parts_.core_radius;
    if (feed && core > 0 && !move.plunging && !std::holds_alternative<geom::Cubic>(element) &&
        goes_down(element, axis_))
        pieces = std::max(pieces, base::clipped<std::uint32_t>(std::ceil(2 * way / core), 1, most_pieces));
    for (std::uint32_t i = 0; i < pieces; ++i) {
        const geom::PathElement part =
            pieces == 1 ? element : part_of(element, double(i) / pieces, double(i + 1) / pieces);
        if (core > 0) queue_core(part, feed, move.plunging);
        queue_pass(Kind::cut, milling::Part::cutting, true, part);
        queued_.back().length = static_cast<float>(way / pieces);
        if (feed) figures_.contact_accuracy_mm = std::max(figures_.contact_accuracy_mm, way / pieces);
    }
    if (tool_parts_.shank) queue_pass(Kind::shank, milling::Part::shank, false, element);
    if (tool_parts_.holder) queue_pass(Kind::holder, milling::Part::holder, false, element);
    queue_clamps(element);
}

/// What the simulation does not take is not simulated: said, once each reason.
void Milling::require(milling::Taken taken) {
    if (taken == milling::Taken::taken || taken == milling::Taken::no_motion) return;
    complete_ = false;
    const MilledMove& m = moves_.back();
    const cl::Record record{cl::Linear{m.to, axis_, m.rapid}, m.where, m.stack};
    out_.unchecked(record, taken == milling::Taken::too_long
                               ? "this move is too long for the tolerance asked for: it is not simulated"
                               : "the way or the tool of this move is not known: it is not simulated");
}

void Milling::queue_pass(QueuedPass::Kind kind, milling::Part part, bool cut, const geom::PathElement& element) {
    require(simulation_->add({element, axis_, sim_tool_, part, cut}));
    QueuedPass q;
    q.kind = kind;
    q.move = static_cast<std::uint32_t>(moves_.size() - 1);
    q.pass = passes_++;
    q.low = std::min(geom::dot(geom::point_at(element, 0), axis_), geom::dot(geom::point_at(element, 1), axis_));
    q.axis = axis_;
    q.down = leads_down(element, axis_);
    move_of_pass_.push_back(q.move);
    queued_.push_back(q);
}

void Milling::queue_clamps(const geom::PathElement& element) {
    const double low =
        std::min(geom::dot(geom::point_at(element, 0), axis_), geom::dot(geom::point_at(element, 1), axis_));
    for (std::size_t i = 0; i < clamps_.size(); ++i) {
        Clamp& c = clamps_[i];
        for (const auto& [kind, part] : {std::pair{QueuedPass::Kind::cut, milling::Part::cutting},
                                         std::pair{QueuedPass::Kind::shank, milling::Part::shank},
                                         std::pair{QueuedPass::Kind::holder, milling::Part::holder}}) {
            const milling::Pass pass{element, axis_, sim_tool_, part, false};
            require(c.simulation.add(pass));
            c.guard->add(pass);
            QueuedPass q;
            q.kind = kind;
            q.move = static_cast<std::uint32_t>(moves_.size() - 1);
            q.clamp = static_cast<std::uint32_t>(i + 1);
            q.pass = static_cast<std::uint32_t>(c.simulation.engagements().size() - 1);
            q.low = low;
            q.axis = axis_;
            q.down = leads_down(element, axis_);
            queued_.push_back(q);
        }
    }
}

void Milling::carry_out() {
    simulation_->flush();
    if (certificate_) certificate_->carry_out();
    if (rapid_guard_) rapid_guard_->carry_out(*simulation_);
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

void Milling::finish(bool complete) {
    if (!simulation_) return;
    carry_out();
    complete_ = complete_ && complete;
    if (start_moves_ > 0)
        out_.assumption("start position not known: the first " + std::to_string(start_moves_) +
                        (start_moves_ == 1 ? " rapid move was" : " rapid moves were") + " not simulated");
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
    out_.result().milled = std::move(milled);
}

}  // namespace obrys::check
