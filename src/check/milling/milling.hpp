#pragma once
/// Milling: removes the stock move by move on rays (sim/milling) and says what rapid moves, shanks, holders and clamps
/// meet. Lengths in mm, frame of the stock.

#include <array>
#include <cmath>
#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "check/collect.hpp"
#include "check/gouge/certify.hpp"
#include "check/gouge/thread_band.hpp"
#include "check/milling/core.hpp"
#include "check/open_way.hpp"
#include "check/result.hpp"
#include "check/setup.hpp"
#include "check/time_up.hpp"
#include "check/touching/body_guard.hpp"
#include "check/touching/stock_guard.hpp"
#include "motion/stand.hpp"
#include "motion/state.hpp"
#include "sim/milling/cut/simulation.hpp"

namespace obrys::sim::milling {
struct Refined;
}

namespace obrys::check {

struct Machined;

/// One part of a tool on its way, queued in the simulation; what it met is known when the queue has been carried out.
struct QueuedPass {
    enum class Kind : std::uint8_t { cut, rapid_probe, shank, holder };
    Kind kind = Kind::cut;
    std::uint32_t move = 0;   ///< index in Milling::moves_
    std::uint32_t clamp = 0;  ///< of passes against a clamp: its number from 1
    std::uint32_t pass = 0;   ///< number in its simulation
    float length = 0;         ///< mm of way
    double low = 0;           ///< height of the tip along the axis, the lower end of the way
    geom::Vec3 axis;          ///< unit vector
    bool down = false;        ///< straight down along it
    bool if_bent = false;     ///< of the way that the move takes only where its rapid bends
};

/// Straight down along the axis all the way: a full turn of a helix ends below its start, too.
[[nodiscard]] bool leads_down(const geom::PathElement& e, geom::Vec3 axis);

class Milling {
public:
    /// The stock must be there; what is wrong with it, or too fine for the memory, is said in `out` and `ready` is
    /// false.
    /// `state`: what the moves that are taken are made with; it outlives this.
    Milling(const Setup& setup, const motion::State& state, Collector& out);
    ~Milling();
    [[nodiscard]] bool ready() const { return simulation_.has_value(); }

    void tool_changed();
    /// The spindle has been told something, in `before`'s place.
    void spindle_changed(const cl::Spindle& before);
    /// The brackets of a cycle; moves inside that come from elsewhere run along an element of its contour.
    void begin_cycle(const base::Span& call) {
        cycle_ = call;
        cycle_sense_ = 0;
    }
    void end_cycle() {
        cycle_ = nowhere;
        edge_away_ = false;
    }
    /// `use`: index in Result::tools + 1. Queues the move; findings come later, in the order of the moves.
    void take(const Move& move, std::uint32_t use, const motion::Stand::View& view,
              const std::vector<shop::ToolPose>& swing);
    /// Carries out what is queued, judges the surface and fills in Result::milling.
    void finish(bool whole);

private:
    void leave_to_memory(const Move& move);
    struct Clamp {
        std::string name;
        sim::milling::Simulation simulation;
        std::unique_ptr<BodyGuard> guard;
    };
    void begin();
    /// `left`: bytes that they may take together.
    void add_clamps(double left);
    [[nodiscard]] bool tool_in_use(const Move& move);
    std::uint32_t add_tool(const sim::milling::ToolShape& shape);
    void require_fine_enough(const Move& move, double radius);
    void take_open(const Move& move, std::uint32_t use, const motion::Stand::View& view);
    void queue(const geom::PathElement& element, const MilledMove& move, bool feed);
    void queue_pass(QueuedPass::Kind kind, sim::milling::Part part, bool cut, const geom::PathElement& element,
                    bool goes_on = false);
    void require(sim::milling::Taken taken);
    [[nodiscard]] std::string name_of(const QueuedPass& pass, const MilledMove& move) const;
    [[nodiscard]] bool leaves_the_wall(const geom::Straight& way) const;
    [[nodiscard]] bool is_on_its_way_out(const geom::Straight& way, const geom::Vec3& from, const geom::Vec3& to) const;
    /// A tool of the simulation: a cylinder as high as the edges of the tool in use.
    [[nodiscard]] std::uint32_t bar_of(double radius);
    void queue_bar(const geom::Straight& way, const MilledMove& move);
    void queue_cutting(const geom::PathElement& element, const MilledMove& move, bool feed);
    [[nodiscard]] bool is_above(const geom::PathElement& element, double height) const;
    void queue_clamps(const geom::PathElement& element);
    void queue_rapid(const Move& move, const MilledMove& m, const geom::PathElement& way,
                     const motion::Stand::View& view, const std::vector<shop::ToolPose>& swing);
    void queue_if_bent(geom::Vec3 from, const std::vector<geom::Vec3>& corners);
    void queue_body(const geom::PathElement& element);
    [[nodiscard]] double seconds_of(const Move& move, double way) const;
    void keep_technology(const Move& move, double way, MilledMove& m) const;
    void keep_points(const Move& move, MilledMove& m);
    void carry_out();
    void balance();
    [[nodiscard]] bool assumed_body(const MilledMove& move) const;
    [[nodiscard]] bool is_tap(const MilledMove& move) const;
    /// How deep a part of the tool went into material, and where.
    struct Reach {
        double depth = 0;
        geom::Vec3 at;
    };
    [[nodiscard]] const sim::milling::Engagement& met_by(const QueuedPass& pass) const;
    [[nodiscard]] Reach reach_of(const QueuedPass& pass) const;
    [[nodiscard]] Reach ray_reach_of(const QueuedPass& pass) const;
    [[nodiscard]] Reach deepest_reach(std::size_t queued) const;
    [[nodiscard]] std::optional<sim::certify::Depth> deepest_in_part(std::size_t queued) const;
    void judge(std::size_t queued);
    void judge_if_bent(std::size_t queued);
    void say_undecided(std::size_t queued);
    [[nodiscard]] std::string open_of(const QueuedPass& pass) const;
    void judge_reach(const QueuedPass& pass, const MilledMove& move, Reach reach,
                     const std::optional<sim::certify::Depth>& in_part);
    void judge_entered_part(const std::vector<MilledMove>& moves);
    void judge_cut(const QueuedPass& pass, MilledMove& move, const sim::milling::Engagement& met);
    void judge_use(const MilledMove& move);
    void say_stopped(const MilledMove& move);
    [[nodiscard]] bool may_not_cut(const MilledMove& move) const;
    [[nodiscard]] bool asks_for_narrow_cuts(const std::vector<MilledMove>& moves) const;
    void judge_narrow_cuts(const Milled& milled);
    [[nodiscard]] sim::milling::Refined make_surface(Milled& milled) const;
    void judge_tap(const Move& at, const MilledMove& move, const shop::Tool& tool);
    void judge_driven_in(const MilledMove& move);
    void judge_pitch_not_given(const Move& at, const MilledMove& move, const shop::Tool& tool);
    void judge_rotation(const MilledMove& move, const shop::Tool& tool);
    void judge_feed(const MilledMove& move, const shop::Tool& tool);
    void judge_tapping(const Move& move, const MilledMove& milled);
    void judge_no_tap(const Move& move, const MilledMove& milled);
    void judge_reversal(const cl::Spindle& before);
    void say_no_tap(const MilledMove& milled);
    void judge_pitch_out(const MilledMove& milled);
    void judge_tap_out(const Move& move, const MilledMove& milled);
    void keep_in_thread(const Move& move);
    void queue_core(const geom::PathElement& element, bool feed, bool straight_down);
    void judge_cores();
    [[nodiscard]] bool meets_core(const CoreDescent::Steep& steep, geom::Vec3 axis) const;
    void judge_plunge(const QueuedPass& pass, const MilledMove& move, const sim::milling::Engagement& met);
    void keep_thread(const Move& move);
    void judge_crossing();
    [[nodiscard]] std::function<bool()> surface_ends() const;
    void judge_open(const sim::milling::Refined& refined);
    void add_thin(mesh::Comparison& found, const Machined& machined, const mesh::CompareOptions& options);
    void add_filled(mesh::Comparison& found, const Machined& machined, const mesh::CompareOptions& options);
    /// Of the move that made a cut: its index in `moves_` + 1; 0: the stock's own face.
    [[nodiscard]] std::uint32_t tag_of(std::uint32_t cut) const {
        return cut == 0 ? 0 : move_of_pass_[simulation_->pass_of(cut)] + 1;
    }
    void keep_at_move(Milled& milled, std::uint64_t index);
    void judge_surface(Milled& milled);
    void judge_place(const Milled& milled, const mesh::Place& place, bool gouge);
    void judge_gouge(const Milled& milled, const Gouge& gouge);
    void judge_undecided(const Milled& milled);
    void judge_no_contact(const Milled& milled);
    [[nodiscard]] const MilledMove* left_by(const Milled& milled, const mesh::Place& place,
                                            const MilledMove* owner) const;
    void found(const MilledMove& move, Finding f);
    void found(const Milled& milled, const mesh::Place& place, Finding f);

    struct KnownTool {
        std::uint32_t number = 0;  ///< in the simulation
        bool shank = false, holder = false;
        double holder_from = 0;  ///< mm above the tip
        std::uint32_t core = 0;  ///< the number of its end that does not cut, if that is so on slants
        double core_radius = 0;  ///< of that; 0: it cuts everywhere
    };
    /// A piece of way of a tool that does not cut at its centre.
    struct CorePiece {
        std::array<geom::Vec3, 5> points;    ///< x and y across the axis
        std::uint32_t move = 0, tool = 0;    ///< index in `moves_`; number of the tool's core
        std::optional<std::uint32_t> probe;  ///< number of the pass of its core, where it goes down
        std::uint32_t pass = 0;              ///< number of the pass that cuts along it
        geom::Vec3 axis;
        double radius = 0;    ///< of the core
        bool leaves = false;  ///< a rapid
    };
    /// A shank or holder that has entered the finished part, and how deep it is in the stock.
    struct Entered {
        QueuedPass pass;
        Reach stock;
        sim::certify::Depth part;
    };
    const Setup& setup_;
    const motion::State& state_;
    Collector& out_;
    std::optional<sim::milling::Simulation> simulation_;
    std::deque<Clamp> clamps_;
    std::optional<Certificate> certificate_;  ///< where there is a part to be held to
    std::vector<MilledMove> moves_;
    std::vector<geom::Vec3> points_;
    std::size_t moves_with_points_ = 0;
    std::vector<QueuedPass> queued_;
    std::optional<StockGuard> stock_guard_;
    bool crossed_ = false;                 ///< the stock's surface goes through itself
    std::optional<BodyGuard> part_guard_;  ///< for what does not cut, where there is a part to be held to
    std::vector<Entered> entered_part_;
    std::vector<CorePiece> core_pieces_;
    CoreDescent core_descent_;
    std::uint32_t core_tool_ = 0;   ///< that `core_descent_` was begun for
    std::uint32_t core_found_ = 0;  ///< index of the move that was found last, + 1
    ThreadBands thread_bands_;
    std::uint32_t plunged_ = 0;                ///< index of the move whose plunge was said last, + 1
    std::vector<std::uint32_t> move_of_pass_;  ///< of the stock's simulation
    MillingFigures figures_;
    std::string tool_name_;
    std::string in_nothing_;  ///< tools of which neither holder nor length is known
    const shop::Tool* tool_ = nullptr;
    std::vector<std::optional<KnownTool>> known_tools_;  ///< by index in Setup::tools
    KnownTool tool_parts_;
    mesh::Box all_;  ///< around stock and part
    std::uint32_t sim_tool_ = 0;
    std::uint32_t passes_ = 0, pieces_left_ = 0;
    geom::Vec3 axis_{0, 0, 1};
    base::Span cycle_ = nowhere;  ///< call of the cycle being run
    /// A boring bar stands at an angle, or its cycle has stopped it: the edge leaves the wall.
    bool edge_away_ = false;
    std::optional<geom::Vec3> edge_leaves_;                           ///< to where, by the program's own way
    geom::Vec3 stopped_at_;                                           ///< the tip then
    std::map<std::pair<std::uint32_t, double>, std::uint32_t> bars_;  ///< by tool in the simulation and radius
    bool if_bent_ = false;                                            ///< what is queued is a way that a rapid may take
    bool tool_ready_ = false, complete_ = true, memory_full_ = false, whole_ = true, stopped_reported_ = false;
    std::optional<geom::Vec3> tap_bottom_;  ///< where a tap has stopped in its thread
    std::optional<geom::Vec3> tap_mouth_;   ///< where it set out into it
    std::int8_t tap_sense_ = 0;             ///< MilledMove::thread of its way in
    double tap_way_ = NAN;                  ///< mm a revolution that it went there; NaN: not coupled to the spindle
    int cycle_sense_ = 0;                   ///< of the spindle, last in the cycle being run; 0: not told yet
    std::uint32_t no_tap_ = 0;              ///< MilledMove::tool that was found last
    double slow_feed_ = NAN;                ///< mm/min, found last
    std::pair<std::uint32_t, std::int8_t> turned_wrong_{};  ///< tool and sense of the spindle that were found last
    std::uint64_t start_moves_ = 0;
    Whereabouts whereabouts_;
    TimeUp time_up_;
};

}  // namespace obrys::check
