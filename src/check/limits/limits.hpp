#pragma once
/// Travel, spindle speed and feed against the machine.

#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "check/collect.hpp"
#include "motion/stand.hpp"
#include "motion/state.hpp"
#include "shop/machine.hpp"
#include "shop/tool.hpp"

namespace obrys::check {

class Limits {
public:
    /// `state`: what the moves that are taken are made with. All outlive this.
    Limits(const shop::Machine& machine, const std::vector<shop::Tool>& tools, const motion::Stand& stand,
           const motion::State& state, Collector& out);

    /// Zero, tool or rotary axes have changed.
    void stand_changed() { changed_ = true; }
    void take(const cl::Record& record, const cl::AxisEnd& axis);
    /// Only its additional axes; the move itself comes as a move.
    void take(const cl::Record& record, const cl::Spline& spline);
    /// The spindle has been told something, in `before`'s place.
    void spindle_changed(const cl::Record& record, const cl::Spindle& before);
    void feed_changed();
    /// `cuts`: whether the move removes material; nothing where that was not simulated. `driven`: by a tool that its
    /// own spindle turns, of which the stream does not tell.
    void take(const Move& move, std::optional<bool> cuts, bool driven = false);

private:
    /// A linear axis of the machine, as it follows the programmed points.
    struct Travel {
        const shop::MachineAxis* axis = nullptr;
        geom::Vec3 along;
        double known = 0, from_zero = NAN;        ///< as in Stand::Way
        double low = INFINITY, high = -INFINITY;  ///< reached since the zero is what it is, counted from it
        double worst = 0;                         ///< mm outside, reported last; 0 while inside
    };

    void check_axis(const cl::Record& record, const std::array<char, 8>& name, double low, double high);
    void check_travel(const Move& move);
    void check_feed(const Move& move);
    void check_feed_mode(const Move& move, bool cuts);
    void check_spindle(const Move& move, std::optional<bool> cuts);
    void check_thread_speed(const Move& move);
    void check_far(const Move& move);
    void check_surface_speed(const Move& move);
    void check_speed_on_axis(const Move& move);
    void check_compensation(const Move& move);
    void follow_stand();
    static double excess(Travel& travel, double low, double high);
    double rpm(const Move& move) const;

    const shop::Machine& machine_;
    const std::vector<shop::Tool>& tools_;
    Collector& out_;
    const motion::Stand& stand_;
    const motion::State& state_;
    std::vector<Travel> travel_;
    std::map<std::string, double> other_worst_;  ///< of additional axes
    std::optional<cl::CompensationBegin> judged_compensation_;
    bool changed_ = true;
    bool feed_reported_ = false, feed_implausible_reported_ = false, feed_limit_reported_ = false,
         stopped_reported_ = false, travel_noted_ = false, far_reported_ = false, surface_noted_ = false,
         on_axis_reported_ = false, thread_speed_reported_ = false;
};

}  // namespace obrys::check
