#include "check/stream/check.hpp"

#include <algorithm>
#include <utility>

#include "check/collect.hpp"
#include "check/limits/limits.hpp"
#include "check/milling/milling.hpp"
#include "check/trace.hpp"
#include "check/turning/removal.hpp"
#include "cl/spline.hpp"
#include "cl/totals.hpp"
#include "motion/cursor.hpp"
#include "motion/stand.hpp"
#include "sim/milling/lattice.hpp"

namespace obrys::check {

struct Check::State {
    State(Setup s, const cl::CallStacks& stacks)
        : setup(std::move(s)),
          out(stacks, setup.findings_per_code),
          cursor(setup.tools),
          stand(setup.machine),
          limits(setup.machine, setup.tools, stand, cursor.state(), out),
          removal(setup, cursor.state(), out),
          trace(setup.keep_moves) {
        if (setup.milling) waiting.emplace();
    }

    bool waits(const cl::Record& record);
    void begin_milling();
    void coarsen();

    void move(const motion::Step& step);
    void take(const cl::Record& record);
    void take(const cl::Datum& datum) {
        stand.take(datum);
        limits.stand_changed();
    }
    void take(const cl::ToolChange& tool) {
        removal.tool_changed();
        if (milling) milling->tool_changed();
        if (setup.machine.kind != shop::MachineKind::mill) return;
        stand.take_tool(cursor.state().tool, tool.edge != 0, tool.raised);
        limits.stand_changed();
    }
    void take(const cl::Record& record, const cl::AxisEnd& to) {
        removal.take(to);
        limits.take(record, to);
        stand.take_face(to);
        if (setup.machine.kind != shop::MachineKind::mill) return;
        stand.take(to);
        limits.stand_changed();
    }
    void spindle_changed(const cl::Record& record, const cl::Spindle& before) {
        limits.spindle_changed(record, before);
        if (milling) milling->spindle_changed(before);
    }
    void keep(const Move& m, Removed removed);

    Setup setup;
    Collector out;
    motion::Cursor cursor;
    motion::Stand stand;
    Limits limits;
    Removal removal;
    std::optional<Milling> milling;
    Trace trace;
    std::uint64_t cuts = 0;                          ///< Stats::cuts
    std::optional<std::vector<cl::Record>> waiting;  ///< from before the first tool that can cut
    cl::Totals totals;
    cl::Record end{cl::Stop{}, nowhere, 0};  ///< place of the last record
    geom::Vec3 tip{NAN, NAN, NAN};           ///< of the tool, frame of the stock
    geom::Vec3 axis{0, 0, 1};                ///< of the tool, as programmed last
    bool tip_swivelled = false;              ///< that is not where the program's last point is
};

namespace {

/// From the programmed frame into the stock's: as the tool stands, then by the way between their zeros.
struct Placing {
    const geom::Frame* frame = nullptr;  ///< none: as programmed
    geom::Vec3 axis{0, 0, 1};
    geom::Vec3 by;
    [[nodiscard]] bool moves() const { return frame != nullptr || !(by == geom::Vec3{}); }
    // Points that are shifted alone keep the coordinates that are known.
    [[nodiscard]] geom::Vec3 point(geom::Vec3 p) const { return (frame != nullptr ? geom::apply(*frame, p) : p) + by; }
    [[nodiscard]] geom::Vec3 way(geom::Vec3 v) const { return frame != nullptr ? geom::apply_direction(*frame, v) : v; }
};

cl::Record placed(cl::Record record, const Placing& at) {
    if (auto* linear = std::get_if<cl::Linear>(&record.step)) {
        linear->to = at.point(linear->to);
        if (at.frame != nullptr) linear->axis = at.axis;
    }
    if (auto* thread = std::get_if<cl::Thread>(&record.step)) {
        thread->to = at.point(thread->to);
        if (at.frame != nullptr) thread->axis = at.axis;
    }
    if (auto* spline = std::get_if<cl::Spline>(&record.step)) {
        spline->to = at.point(spline->to);
        for (geom::Vec3* k : {&spline->k1, &spline->k2, &spline->k3}) *k = at.way(*k);
        if (at.frame != nullptr) spline->axis = at.axis;
    }
    if (auto* arc = std::get_if<cl::Arc>(&record.step)) {
        arc->to = at.point(arc->to);
        arc->centre = at.point(arc->centre);
        arc->normal = at.way(arc->normal);
        if (at.frame != nullptr) arc->axis = at.axis;
    }
    return record;
}

bool turns_rotary(const cl::Step& step) {
    const auto* spline = std::get_if<cl::Spline>(&step);
    return spline != nullptr &&
           std::any_of(spline->axes.begin(), spline->axes.end(), [](const cl::SplineAxis& a) { return a.rotary; });
}

constexpr geom::Vec3 z_axis{0, 0, 1};

}  // namespace

void Check::State::move(const motion::Step& step) {
    const cl::Record& record = step.record;
    const geom::Vec3 from = step.from, to = step.to, by = step.to_stock;
    totals.position = from;  // not where the last move ended, if the zero offset has changed since
    const bool turning = stand.turning() || turns_rotary(record.step);
    const Move programmed{record, step.index, from, to, step.rapid, turning};
    axis = *cl::tool_axis_of(record.step);
    const bool swivelled = !stand.plain() || !(axis == z_axis);
    const motion::Stand::View& view = stand.view(axis);
    const Placing at{view.frame == geom::Frame{} ? nullptr : &view.frame, view.axis, by};
    const cl::Record in_stock_frame = at.moves() ? placed(record, at) : cl::Record{};
    const Move m{at.moves() ? in_stock_frame : record,
                 step.index,
                 swivelled || tip_swivelled || turning ? tip : from + by,
                 at.point(to),
                 programmed.rapid,
                 turning};
    if (!m.rapid && !(std::holds_alternative<cl::Linear>(record.step) && from == to)) ++cuts;
    Removed removed = removal.take(m);
    if (milling) {
        std::vector<shop::ToolPose> swing;
        if (turning && programmed.rapid && std::holds_alternative<cl::Linear>(record.step))
            swing = stand.swing(from, to);
        for (shop::ToolPose& pose : swing) pose.tip = pose.tip + by;
        milling->take(m, removal.tool_in_use(), view, swing);
    }
    // What a milling move cuts is known later: Milling says where it does so with a standing spindle.
    limits.take(programmed,
                milling             ? std::optional(false)
                : removed.simulated ? std::optional(removed.cuts)
                                    : std::nullopt,
                removal.driven(m));
    if (trace.keeps_more()) keep(m, std::move(removed));
    tip = view.problem.empty() ? m.to : geom::Vec3{NAN, NAN, NAN};
    tip_swivelled = swivelled;
    stand.moved();
    if (const auto* spline = std::get_if<cl::Spline>(&record.step); spline != nullptr && milling)
        for (const cl::SplineAxis& a : spline->axes) stand.take(cl::AxisEnd{a.name, a.to, a.rotary, false});
}

void Check::State::keep(const Move& m, Removed removed) {
    MoveTrace t;
    t.from = {m.from.z, m.from.x};
    t.to = {m.to.z, m.to.x};
    const auto* arc = std::get_if<cl::Arc>(&m.record.step);
    if (arc != nullptr && lies_in_turning_plane(*arc)) {
        t.centre = {arc->centre.z, arc->centre.x};
        t.sweep = arc->normal.y < 0 ? -arc->sweep : arc->sweep;
    } else {
        cl::points_between(m.from, m.record.step, drawn_chord, drawn_chords, [&t](geom::Vec3 p) {
            t.via.push_back({p.z, p.x});
        });
    }
    t.rapid = m.rapid;
    t.where = m.record.from;
    t.stack = m.record.stack;
    t.tool = removal.tool_in_use();
    t.area = removed.cut.area;
    t.volume = removed.cut.volume;
    t.depth_x = removed.cut.depth_x;
    t.contact_length = removed.cut.contact_length;
    t.removed = std::move(removed.cut.removed);
    trace.add(std::move(t));
    if (trace.wants_snapshot()) trace.add(removal.stock());
}

Check::Check(Setup setup, const cl::CallStacks& stacks) : state_(std::make_unique<State>(std::move(setup), stacks)) {}
Check::~Check() = default;
Check::Check(Check&&) noexcept = default;
Check& Check::operator=(Check&&) noexcept = default;

const Setup& Check::setup() const { return state_->setup; }

void Check::State::take(const cl::Record& record) {
    const cl::Spindle spindle = cursor.state().spindle;
    if (const cl::AxisEnds* ends = cl::ends_of(record.step))
        for (const cl::AxisEnd& axis_end : *ends) take(record, axis_end);
    if (const auto* spline = std::get_if<cl::Spline>(&record.step)) limits.take(record, *spline);
    if (const auto step = cursor.take(record))
        move(*step);
    else if (const auto* tool = std::get_if<cl::ToolChange>(&record.step))
        take(*tool);
    else if (std::holds_alternative<cl::Feed>(record.step))
        limits.feed_changed();
    else if (std::holds_alternative<cl::Spindle>(record.step))
        spindle_changed(record, spindle);
    else if (const auto* datum = std::get_if<cl::Datum>(&record.step))
        take(*datum);
    else if (std::holds_alternative<cl::CycleBegin>(record.step) && milling)
        milling->begin_cycle(record.from);
    else if (std::holds_alternative<cl::CycleEnd>(record.step) && milling)
        milling->end_cycle();
    totals(record);
    end.from = record.from;
    end.stack = record.stack;
}

/// The rays of a stock cost memory and time: they are made when a tool is in use that can take something from it.
bool Check::State::waits(const cl::Record& record) {
    constexpr std::size_t most_waiting = 20'000;
    if (!waiting) return false;
    const auto* tool = std::get_if<cl::ToolChange>(&record.step);
    const bool cuts_now = tool != nullptr && motion::find_tool(setup.tools, *tool) != nullptr;
    if (cuts_now || waiting->size() >= most_waiting) {
        begin_milling();
        return false;
    }
    waiting->push_back(record);
    return true;
}

void Check::State::begin_milling() {
    const std::vector<cl::Record> before = std::move(*waiting);
    waiting.reset();
    milling.emplace(setup, cursor.state(), out);
    if (!milling->ready()) milling.reset();
    for (const cl::Record& record : before) take(record);
}

/// No tool can cut: the rays only say how large the stock is. Against a part they also show where it stands out.
void Check::State::coarsen() {
    constexpr double enough = 5e7, coarsest = 1;  // bytes, mm
    MillingSetup& m = *setup.milling;
    if (m.part != nullptr) return;
    const sim::milling::Box3 box = sim::milling::box_of(m.stock);
    while (m.tolerance < coarsest && !(sim::milling::resolve(box, m.tolerance, 1, m.memory_bytes).bytes < enough))
        m.tolerance *= 2;
}

void Check::take(const cl::Record& record) {
    if (!state_->waits(record)) state_->take(record);
}

Result Check::finish(bool whole) {
    State& s = *state_;
    if (s.waiting) {
        s.coarsen();
        s.begin_milling();
    }
    Stats& stats = s.out.result().stats;
    stats.moves = s.totals.moves;
    stats.rapid_moves = s.totals.rapid_moves;
    stats.feed_moves = s.totals.feed_moves;
    stats.rapid_length_mm = s.totals.rapid_length_mm;
    stats.feed_length_mm = s.totals.feed_length_mm;
    stats.cuts = s.cuts;
    if (s.milling)
        s.milling->finish(whole);
    else
        s.removal.finish(s.end, whole);
    s.trace.finish(s.out.result());
    Result result = std::move(s.out.result());
    // Milling says what moves met after limits have judged later ones.
    if (s.milling)
        std::stable_sort(result.findings.begin(), result.findings.end(), [](const Finding& a, const Finding& b) {
            constexpr std::uint64_t last = UINT64_MAX;
            return a.move.value_or(last) < b.move.value_or(last);
        });
    result.verdict = verdict_of(result);
    return result;
}

}  // namespace obrys::check
