#pragma once
/// Steps of turning cycles as canonical calls (mm or inch, x a radius), to be held to those of LinuxCNC's interpreter.

#include "cycles/cycle_testing.hpp"
#include "cycles/rs274_testing.hpp"

namespace obrys::cycles::test {

inline bool is_turning_step(const Call& c) {
    return c.name == "STRAIGHT_TRAVERSE" || c.name == "STRAIGHT_FEED" || c.name == "ARC_FEED" ||
           c.name == "START_SPEED_FEED_SYNC" || c.name == "STOP_SPEED_FEED_SYNCH";
}

/// Steps as calls in the program's unit.
struct ToTurningCalls {
    double unit;
    std::vector<Call> calls;
    double pitch = 0;  ///< of the coupling in force

    void couple(double wanted) {
        if (wanted == pitch) return;
        pitch = wanted;
        if (wanted == 0)
            calls.push_back({"STOP_SPEED_FEED_SYNCH", {}});
        else
            calls.push_back({"START_SPEED_FEED_SYNC", {wanted}});
    }
    void operator()(const cl::Linear& s) {
        couple(0);
        calls.push_back(
            {s.rapid ? "STRAIGHT_TRAVERSE" : "STRAIGHT_FEED", {s.to.y / unit, s.to.z / unit, s.to.x / unit}});
    }
    void operator()(const cl::Thread& s) {
        couple(s.pitch / unit);
        calls.push_back({"STRAIGHT_FEED", {s.to.y / unit, s.to.z / unit, s.to.x / unit}});
    }
    void operator()(const cl::Arc& s) {
        calls.push_back(
            {"ARC_FEED",
             {s.to.x / unit, s.to.y / unit, s.centre.x / unit, s.centre.y / unit, s.sweep > 0 ? 1.0 : -1.0}});
    }
    template <class Other>
    void operator()(const Other&) {
        calls.push_back({"?", {}});
    }
};

inline std::string turning_text(const Call& c) {
    std::string t = c.name;
    for (std::size_t i = 0; i < c.numbers.size() && i < 5; ++i) t += " " + base::fixed(c.numbers[i], 4);
    return t;
}

inline bool same_turning(const Call& ours, const Call& theirs) {
    if (ours.name != theirs.name || theirs.numbers.size() < ours.numbers.size()) return false;
    for (std::size_t i = 0; i < ours.numbers.size(); ++i)
        if (!(std::abs(ours.numbers[i] - theirs.numbers[i]) < 2.01e-4)) return false;
    return true;
}

inline std::size_t first_difference(const std::vector<Call>& ours, const std::vector<Call>& theirs) {
    for (std::size_t i = 0; i < std::max(ours.size(), theirs.size()); ++i)
        if (i >= ours.size() || i >= theirs.size() || !same_turning(ours[i], theirs[i])) return i;
    return std::string::npos;
}

}  // namespace obrys::cycles::test
