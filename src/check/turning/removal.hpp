#pragma once
/// Removes the stock move by move and holds what was removed to part, allowance and rapids.

#include <cmath>

#include "check/collect.hpp"
#include "check/open_way.hpp"
#include "check/result.hpp"
#include "check/setup.hpp"
#include "check/time_up.hpp"
#include "check/turning/axis_use.hpp"
#include "check/turning/rest.hpp"
#include "check/turning/thread_passes.hpp"
#include "check/turning/turned_thread.hpp"
#include "check/turning/turning_tool.hpp"
#include "check/words.hpp"
#include "motion/state.hpp"
#include "sim/turning/turning.hpp"

namespace obrys::check {

/// Whether the arc lies in the (z, x) plane, in which the removal works.
[[nodiscard]] inline bool lies_in_turning_plane(const cl::Arc& arc) { return std::abs(arc.normal.y) >= 1 - 1e-9; }

/// The move in the (z, x) plane.
[[nodiscard]] sim::turning::Move in_turning_plane(const Move& move);

/// What the removal made of a move.
struct Removed {
    bool simulated = false;  ///< computed, or proved to touch nothing
    bool cuts = false;       ///< material was removed
    sim::turning::Cut cut;
};

class Removal {
public:
    /// `state`: what the moves that are taken are made with; it outlives this.
    Removal(const Setup& setup, const motion::State& state, Collector& out);

    void tool_changed();
    Removed take(const Move& move);
    /// Notes, rest material and the figures of the stock. `end`: the last record.
    void finish(const cl::Record& end, bool whole);
    /// A rotary axis of a lathe moves: until the next tool, tools are taken to be driven ones.
    void take(const cl::AxisEnd& axis) { positioned_ = positioned_ || (axis.rotary && is_lathe()); }
    /// Whether the move is made by a tool that a spindle of its own turns, of which the stream does not tell.
    [[nodiscard]] bool driven(const Move& move) const { return positioned_ || (is_lathe() && works_off_axis(move)); }
    [[nodiscard]] geom::Region stock() const { return work_ ? work_->region() : geom::Region{}; }
    /// Index in Result::tools + 1 of the tool in use; 0: none.
    [[nodiscard]] std::uint32_t tool_in_use() const { return use_; }

private:
    void first_use(const Move& move);
    enum class Wants : std::uint8_t { removal, place };  ///< where the tool is can be known of driven ones, too
    std::optional<std::string> obstacle(const Move& move, Wants wants = Wants::removal) const;
    /// Without an offset (D0) the edge stands elsewhere than programmed, nobody knows where: on any way but one away.
    [[nodiscard]] bool is_astray(const Move& move) const;
    /// A drill or mill on a lathe, beside the turning axis.
    [[nodiscard]] bool works_off_axis(const Move& move) const;
    [[nodiscard]] bool is_lathe() const { return setup_.machine.kind == shop::MachineKind::lathe; }
    [[nodiscard]] bool misses(const Move& move) const;
    void skipped(const Move& move, std::string why);
    void cut(const Move& move, const sim::turning::Move& way, Removed& r);
    [[nodiscard]] Removed cut_open(const Move& move);
    void cut_along(const Move& move, Removed& r);
    void pass_beside(const Move& move, const sim::turning::Move& way, Removed& r);
    void judge_if_bent(const Move& move);
    [[nodiscard]] std::optional<sim::turning::Depth> depth_on_way(const geom::Contour& body,
                                                                  const sim::turning::Move& way,
                                                                  const geom::Contour& across) const;
    [[nodiscard]] bool touches_stock(const sim::turning::Move& way) const;
    [[nodiscard]] bool leaves_towards_home(const Move& move, const geom::Region& body) const;
    void judge(const Move& move, const sim::turning::Cut& cut);
    [[nodiscard]] sim::turning::Cut beside_threads(const Move& move, const sim::turning::Cut& cut) const;
    void judge_holder(const Move& move, const sim::turning::Move& way);
    void judge_blade(const Move& move, const sim::turning::Move& way);
    [[nodiscard]] std::optional<sim::turning::Depth> depth_met(const geom::Contour& body,
                                                               const sim::turning::Move& way) const;
    void note_reach(const Move& move, const sim::turning::Move& way);
    void cut_thread(const Move& move, const sim::turning::Move& way, const cl::Thread& thread, Removed& r);
    void judge_thread(const Move& move, const ThreadPass& pass);
    void say_too_wide(const Move& move, const ThreadPass& pass);
    void add_to_threads(const geom::Region& band);
    void note_fallen(const Move& move, const sim::turning::Cut& cut);
    void judge_clamps(const Move& move);
    struct ClampBody;
    [[nodiscard]] std::optional<sim::turning::Depth> depth_in(const ClampBody& clamp, const geom::Contour& body,
                                                              const sim::turning::Move& way,
                                                              const geom::Contour& across) const;
    void judge_open_clamp(const Move& move, const ClampBody& clamp);
    void judge_clamp(const Move& move, const ClampBody& clamp, const sim::turning::Move& way);
    void say_clamp(const Move& move, const ClampBody& clamp, std::string_view what, const sim::turning::Depth& d);
    void say_default_reach(const Move& move, std::string_view effect);
    [[nodiscard]] std::vector<sim::turning::Move> ways_of(const Move& move, shop::RapidPath path) const;
    void say_carried(const Move& move, Carried::Kind kind, const sim::turning::Depth& deepest);
    void note_holding(const Move& move);
    void require_room(const cl::Record& end);
    void count_use(const Move& move, const Removed& removed);
    void require_contact();
    void require_balance(const StockFigures& before, const StockFigures& after);

    const Setup& setup_;
    const motion::State& state_;
    Collector& out_;
    std::optional<sim::turning::Workpiece> work_;
    std::optional<sim::turning::Kept> part_, allowance_;
    struct ClampBody {
        std::string name;
        geom::Region region;
        sim::turning::Workpiece body;
    };
    std::vector<ClampBody> clamps_;
    Box stock_box_;
    const shop::Tool* tool_ = nullptr;
    geom::Contour outline_, sure_;  ///< shop: outline, sure_outline
    geom::Contour behind_;          ///< behind_blade
    std::vector<Carried> carried_;  ///< carried_by
    Box outline_box_;               ///< with all of these
    AxisUse use_on_axis_;
    std::string held_by_nothing_;    ///< tools on the axis
    geom::Region threads_;           ///< what threads take from the stock, which stays in the model
    geom::Region fallen_;            ///< parted off
    geom::Region ridges_;            ///< what stands in the model because threads are not cut into it: no rest material
    double pitch_ = 0;               ///< mm, of the last thread
    geom::Vec2 thread_along_{1, 0};  ///< its direction
    ThreadPasses passes_;
    std::optional<ThreadGround> ground_;  ///< of the thread that the last move was part of
    bool in_front_ = false;               ///< a tool has stood in front of the stock's right face
    bool positioned_ = false;             ///< the workpiece is an axis
    bool had_tool_ = false, changed_ = false, cut_without_tool_ = false;
    bool emptied_ = false;  ///< tool 0 was selected behind another one
    std::uint32_t use_ = 0;
    Whereabouts whereabouts_;
    std::uint64_t start_moves_ = 0;  ///< moves before start position and first tool were known
    double removed_area_ = 0;        ///< mm2, of all cuts
    bool complete_ = true;           ///< no removal was left out
    LastCuts last_cuts_;
    TimeUp time_up_;
};

}  // namespace obrys::check
