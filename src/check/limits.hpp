#pragma once
/// Travel, spindle speed and feed against the machine.

#include <array>
#include <map>

#include "check/collect.hpp"
#include "shop/machine.hpp"

namespace obrys::check {

class Limits {
public:
    Limits(const shop::Machine& machine, Collector& out);

    void take(const cl::Record& record, const cl::Datum& datum);
    void take(const cl::Record& record, const cl::Axis& axis);
    /// Only its additional axes; the move itself comes as a move.
    void take(const cl::Record& record, const cl::Spline& spline);
    void take(const cl::Record& record, const cl::Spindle& spindle);
    void take(const cl::Feed& feed);
    /// `cuts`: whether the move removes material; nothing where that was not simulated.
    void take(const Move& move, std::optional<bool> cuts);

private:
    struct Travel {
        const shop::MachineAxis* axis = nullptr;  ///< nothing known about it
        double low = INFINITY, high = -INFINITY;  ///< reached since the zero is what it is, workpiece frame
        double worst = 0;                         ///< mm outside, reported last; 0 while inside
    };

    void check_axis(const cl::Record& record, const std::array<char, 8>& name, double low, double high);
    void check_travel(const Move& move);
    void check_feed(const Move& move);
    void check_spindle(const Move& move, std::optional<bool> cuts);
    double excess(Travel& travel, std::size_t i, double low, double high) const;
    double rpm(const Move& move) const;

    const shop::Machine& machine_;
    Collector& out_;
    std::array<Travel, 3> travel_;
    std::map<std::string, double> other_worst_;  ///< of additional axes
    cl::Datum datum_{0, {NAN, NAN, NAN}};
    cl::Feed feed_;
    cl::Spindle spindle_;
    bool feed_reported_ = false, feed_limit_reported_ = false, stopped_reported_ = false, travel_noted_ = false;
};

}  // namespace obrys::check
