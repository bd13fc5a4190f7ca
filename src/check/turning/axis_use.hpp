#pragma once
/// How drills, taps, reamers and mills are used that stand on a lathe's axis, while the workpiece turns: a right-hand
/// one cuts with M3, which turns the spindle so that a right-hand screw would be driven into the workpiece
/// (ISO 6983-1).

#include <utility>

#include "check/collect.hpp"
#include "check/setup.hpp"
#include "check/words.hpp"
#include "motion/state.hpp"
#include "sim/turning/turning.hpp"

namespace obrys::check {

class AxisUse {
public:
    AxisUse(const Setup& setup, const motion::State& state, Collector& out) : setup_(setup), state_(state), out_(out) {}

    void tool_changed();
    /// Before the removal: what a tap does is judged where it goes along its axis within `stock`.
    void take(const Move& move, const sim::turning::Move& way, const Box& stock);
    /// What the move has removed.
    void cut(const Move& move, const sim::turning::Move& way, const sim::turning::Cut& cut);

private:
    struct Coupled {
        int hand = 0;  ///< of the thread: +1 right, -1 left; 0: not coupled to the spindle
        double per_rev = NAN, speed_rpm = NAN;
    };
    [[nodiscard]] Coupled coupled(const Move& move, double way) const;
    void judge_out(const Move& move, const sim::turning::Move& way);
    void judge_in(const Move& move, const sim::turning::Move& way);
    void judge_pitch(const Move& move, const Coupled& c);
    void judge_rotation(const Move& move);
    [[nodiscard]] const shop::Tool& tool() const { return *state_.tool; }

    const Setup& setup_;
    const motion::State& state_;
    Collector& out_;
    double mouth_ = NAN, bottom_ = NAN;  ///< Z where a tap set out into its thread and where it is; NaN: in none
    Coupled in_;                         ///< how it went there
    int turned_wrong_ = 0;               ///< sense of the spindle, found last with this tool
    bool no_tap_ = false;                ///< found with this tool
};

}  // namespace obrys::check
