#pragma once
/// Shared by the tests of this folder and its rooms: demands, expansions as one line of text, walks along the steps.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "base/number.hpp"
#include "cl/totals.hpp"
#include "cl/verify.hpp"
#include "cycles/cycle.hpp"

namespace obrys::cycles::test {

using Kind = cl::CycleKind;
using Role = cl::CycleRole;
using Values = std::vector<cl::CycleValue>;

inline Situation situation(double w = 100) {
    return {.at = {10, 20, w},
            .tool_radius = 5,
            .tool_corner_radius = 0,
            .tool_point_angle = 90,
            .spindle_speed = 1000,
            .spindle_direction = 1,
            .feed = 80};
}

/// `base` with some values replaced or added.
inline Values with(Values base, const Values& changes) {
    base.insert(base.end(), changes.begin(), changes.end());
    return base;
}

inline std::string number(double v) { return base::shortest(std::round(v * 1e6) / 1e6); }

/// One word a step: R rapid, L feed, A arc (degrees), T thread, F, S (signed by direction), D, M; moves name the
/// coordinates that change.
class Script {
public:
    explicit Script(geom::Vec3 from) : at_(from) {}
    std::string text;

    void operator()(const cl::Linear& s) { move(s.rapid ? "R" : "L", s.to); }
    void operator()(const cl::Arc& s) { move("A" + number(geom::degrees(s.sweep)), s.to); }
    void operator()(const cl::Thread& s) { move("T" + number(s.pitch), s.to); }
    void operator()(const cl::Feed& s) { word("F" + number(s.value)); }
    void operator()(const cl::Spindle& s) { word("S" + number(s.direction * s.speed) + (s.held ? " held" : "")); }
    void operator()(const cl::Dwell& s) { word("D" + number(s.seconds)); }
    void operator()(const cl::Coolant& s) { word(s == cl::Coolant{} ? "M9" : "M8"); }
    void operator()(const cl::Auxiliary& s) { word("M" + number(double(s.number))); }
    template <class Other>
    void operator()(const Other&) {
        word("?");
    }

private:
    void word(const std::string& w) { text += (text.empty() ? "" : " ") + w; }
    void move(std::string w, geom::Vec3 to) {
        const auto differs = [](double a, double b) { return !(std::abs(a - b) < 1e-9); };
        if (differs(at_.x, to.x)) w += " u" + number(to.x);
        if (differs(at_.y, to.y)) w += " v" + number(to.y);
        if (differs(at_.z, to.z)) w += " w" + number(to.z);
        at_ = to;
        word(w);
    }
    geom::Vec3 at_;
};

inline std::string script(const Expansion& e, geom::Vec3 from) {
    Script s(from);
    for (const cl::Step& step : e.steps) std::visit(s, step);
    return s.text;
}

inline std::string complaints(const Expansion& e) {
    std::string text;
    for (const Complaint& c : e.complaints) text += c.text + "\n";
    return text;
}

/// The script of a call that must succeed; else what was complained of.
inline std::string script_or_complaints(const Expansion& e, const Situation& s) {
    return e.ok() ? script(e, s.at) : "complaint: " + complaints(e);
}

struct Walk {
    double lowest = 1e300, highest_feed = -1e300, feed_length = 0;
    std::size_t feed_moves = 0;
    geom::Vec3 end;
};

inline Walk walk(const Expansion& e, geom::Vec3 from) {
    Walk w;
    for (const cl::Step& step : e.steps) {
        if (!cl::is_move(step)) continue;
        const geom::Vec3 to = cl::position_after(from, step);
        w.lowest = std::min(w.lowest, to.z);
        if (!cl::is_rapid(step)) {
            w.highest_feed = std::max({w.highest_feed, from.z, to.z});
            w.feed_length += cl::move_length(from, step);
            w.feed_moves++;
        }
        from = to;
    }
    w.end = from;
    return w;
}

/// Number of rules of the stream that the steps break.
inline std::size_t broken_rules(const Expansion& e, geom::Vec3 from) {
    base::Diagnostics d;
    cl::Verifier verifier(d);
    verifier(cl::Record{cl::Linear{.to = from, .rapid = true}, {}, 0});
    for (const cl::Step& s : e.steps) verifier(cl::Record{s, {}, 0});
    return d.all().size() + d.dropped();
}

class Random {
public:
    explicit Random(std::uint32_t seed) : engine_(seed) {}
    double in(double low, double high) { return std::uniform_real_distribution<double>(low, high)(engine_); }
    int upto(int n) { return std::uniform_int_distribution<int>(0, n)(engine_); }

private:
    std::mt19937 engine_;
};

/// A sound call of every kind that is expanded; every value in it is used.
struct Sample {
    Kind kind;
    Values values;
};

}  // namespace obrys::cycles::test
