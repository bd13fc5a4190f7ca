/// The expansions of the canned cycles against the canonical calls of the installed LinuxCNC interpreter: the same
/// calls in the same order, in all planes, both units, from above and below the retract plane.

#include <map>
#include <optional>

#include "cycles/hole/hole_testing.hpp"
#include "cycles/rs274_testing.hpp"

namespace obrys::cycles::test {
namespace {

/// Calls that stand for the mode of the path and for overrides: not steps of the tool.
bool is_step(const Call& c) {
    for (const char* name : {"STRAIGHT_TRAVERSE", "STRAIGHT_FEED", "DWELL", "STOP_SPINDLE_TURNING", "ORIENT_SPINDLE",
                             "START_SPINDLE_CLOCKWISE", "START_SPINDLE_COUNTERCLOCKWISE", "PROGRAM_STOP"})
        if (c.name == name) return true;
    return c.name.rfind("error", 0) == 0;
}

/// Working plane: which axis of x, y, z is u, v, w.
struct Plane {
    const char* g;
    int u, v, w;
};
constexpr Plane planes[] = {{"g17", 0, 1, 2}, {"g18", 2, 0, 1}, {"g19", 1, 2, 0}};

struct ToCalls {
    const Plane& plane;
    double unit;
    std::vector<Call> calls;

    void operator()(const cl::Linear& s) {
        std::vector<double> p(3);
        p[std::size_t(plane.u)] = s.to.x / unit;
        p[std::size_t(plane.v)] = s.to.y / unit;
        p[std::size_t(plane.w)] = s.to.z / unit;
        calls.push_back({s.rapid ? "STRAIGHT_TRAVERSE" : "STRAIGHT_FEED", p});
    }
    void operator()(const cl::Dwell& s) { calls.push_back({"DWELL", {s.seconds}}); }
    void operator()(const cl::Spindle& s) {
        calls.push_back({s.direction == 0  ? "STOP_SPINDLE_TURNING"
                         : s.direction > 0 ? "START_SPINDLE_CLOCKWISE"
                                           : "START_SPINDLE_COUNTERCLOCKWISE",
                         {}});
        if (s.held) calls.push_back({"ORIENT_SPINDLE", {}});
    }
    void operator()(const cl::Auxiliary& s) { calls.push_back({s.number == 19 ? "ORIENT_SPINDLE" : "?", {}}); }
    void operator()(const cl::Stop&) { calls.push_back({"PROGRAM_STOP", {}}); }
    template <class Other>
    void operator()(const Other&) {
        calls.push_back({"?", {}});
    }
};

std::string text(const Call& c) {
    std::string t = c.name;
    for (std::size_t i = 0; i < c.numbers.size() && i < 3; ++i) t += " " + base::fixed(c.numbers[i], 4);
    return t;
}

bool same(const Call& ours, const Call& theirs) {
    if (ours.name != theirs.name || theirs.numbers.size() < ours.numbers.size()) return false;
    for (std::size_t i = 0; i < ours.numbers.size(); ++i)
        if (!(std::abs(ours.numbers[i] - theirs.numbers[i]) < 1.01e-4)) return false;
    return true;
}

/// A random program of canned cycles and the same through `expand`.
class Program {
public:
    explicit Program(std::uint32_t seed)
        : random_(seed),
          plane_(planes[random_.upto(2)]),
          unit_(random_.upto(1) == 0 ? 1 : 25.4),
          ours_{plane_, unit_, {}} {
        lines_ = std::string(plane_.g) + (unit_ == 1 ? " g21" : " g20") + " g90 f100 s1000 m3\n";
        situation_.spindle_speed = 1000;
        situation_.spindle_direction = 1;
        ours_.calls.push_back({"START_SPINDLE_CLOCKWISE", {}});
        situation_.at = {0, 0, 0};
        for (int cycles = 0; cycles < 12; ++cycles) add();
        lines_ += "m2\n";
    }
    [[nodiscard]] const std::string& lines() const { return lines_; }
    [[nodiscard]] const std::vector<Call>& ours() const { return ours_.calls; }

private:
    double pick(double low, double high) { return std::round(random_.in(low, high) * 100) / 100; }
    std::string word(char letter, double v) const { return " " + std::string(1, letter) + base::shortest(v); }
    void value(Role role, double v) { values_.push_back({role, v * unit_}); }
    void plain(Role role, double v) { values_.push_back({role, v}); }
    void letter(char l, Role role, double v) {
        lines_ += word(l, v);
        value(role, v);
    }
    void dwell(Role role) {
        const double p = pick(0, 3);
        lines_ += word('p', p);
        plain(role, p);
        last_dwell_ = p;
    }

    void add() {
        values_.clear();
        const double w = random_.upto(2) == 0 ? pick(-4, 0) : pick(0, 9);
        lines_ += std::string("g0") + word("xyz"[plane_.w], w) + "\n";
        situation_.at.z = w * unit_;
        step(cl::Linear{.to = situation_.at, .rapid = true});
        const bool to_initial = random_.upto(1) == 0;
        const double r = pick(-2, 3), bottom = random_.upto(9) == 0 ? r : pick(-8, -2);
        lines_ += to_initial ? "g98" : "g99";
        const Kind kind = motion(r, bottom);
        hole(kind, r, bottom, to_initial ? std::optional(w * unit_) : std::nullopt, 1);
        if (kind == Kind::canned_drill && lines_.find(" g81", lines_.rfind("g9")) != std::string::npos)
            go_on(w * unit_);
    }
    /// Further holes of a G81, whose retract planes lie above and below the tool and the level of the series.
    void go_on(double initial) {
        for (std::uint32_t more = random_.upto(3); more > 0; --more) {
            values_.clear();
            const bool to_initial = random_.upto(1) == 0;
            lines_ += to_initial ? "g98" : "g99";
            const double r = pick(-4, 10);
            if (initial < r * unit_) {  // before each line whose R lies above where the series began
                situation_.at.z = r * unit_;
                step(cl::Linear{.to = situation_.at, .rapid = true});
            }
            hole(Kind::canned_drill, r, pick(-8, -4), to_initial ? std::optional(initial) : std::nullopt, 2);
        }
    }
    /// The rest of the line, and its calls; `initial`: G98 goes back to it.
    void hole(Kind kind, double r, double bottom, std::optional<double> initial, double rise) {
        const double targets[] = {pick(-5, 5), pick(-5, 5)};
        letter("xyz"[plane_.u], Role::target_u, targets[0]);
        letter("xyz"[plane_.v], Role::target_v, targets[1]);
        letter("xyz"[plane_.w], Role::bottom, bottom);
        letter('r', Role::retract_plane, r);
        plain(Role::rise_first, rise);
        const double end = initial ? std::max(r * unit_, *initial) : r * unit_;
        if (initial) values_.push_back({Role::return_level, end});
        lines_ += "\n";
        const Expansion e = expand_hole({kind, values_}, situation_);
        if (!e.ok()) ours_.calls.push_back({"complaint: " + complaints(e), {}});
        for (const cl::Step& s : e.steps) step(s);
        situation_.at = {targets[0] * unit_, targets[1] * unit_, end};
    }

    Kind motion(double r, double bottom) {
        switch (random_.upto(10)) {
            case 0: return peck(Kind::canned_chip_break, Role::chip_break_distance, " g73", r, bottom);
            case 1: return peck(Kind::canned_peck, Role::stop_distance_first, " g83", r, bottom);
            case 2:
                lines_ += " g82";
                dwell(Role::dwell_bottom);
                return Kind::canned_drill;
            case 3: return tap(1, " g84");
            case 4: return tap(-1, " g74");
            case 5: lines_ += " g85"; return Kind::canned_bore_feed;
            case 6:
                lines_ += " g86";
                dwell(Role::dwell_bottom);
                return Kind::canned_bore_stop;
            case 7: return back_bore(bottom);
            case 8:
                lines_ += " g88";
                dwell(Role::dwell_bottom);
                return Kind::canned_bore_manual;
            case 9:
                lines_ += " g89";
                dwell(Role::dwell_bottom);
                plain(Role::feed_out, 1);
                return Kind::canned_bore_feed;
            default: lines_ += " g81"; return Kind::canned_drill;
        }
    }
    Kind peck(Kind kind, Role back, const char* g, double r, double bottom) {
        lines_ += g;
        // Also infeeds that divide the depth, where the control's rounding error decides.
        const double whole = std::round((r - bottom) * 10) / 100;
        letter('q', Role::infeed, random_.upto(1) == 0 && whole > 0 ? whole : pick(0.3, 4));
        value(back, unit_ == 1 ? 0.254 : 0.01);
        plain(Role::length_unit, unit_);
        return kind;
    }
    Kind tap(int hand, const char* g) {
        const std::size_t at = lines_.rfind('\n') + 1;
        if (situation_.spindle_direction != hand) {
            lines_.insert(at, hand > 0 ? "m3\n" : "m4\n");
            step(cl::Spindle{.speed = 1000, .direction = static_cast<std::int8_t>(hand)});
            situation_.spindle_direction = hand;
        }
        lines_ += g;
        plain(Role::spindle_direction, hand);
        plain(Role::feed_out, 1);
        plain(Role::turned_axes, plane_.w == 1 ? 1 : plane_.w == 0 ? 2 : 0);
        if (random_.upto(1) == 0)
            dwell(Role::dwell);
        else
            plain(Role::dwell, last_dwell_);  // the control keeps it over all canned cycles
        return Kind::canned_tap_floating;
    }
    Kind back_bore(double bottom) {
        lines_ += " g87";
        letter("ijk"[plane_.u], Role::shift_u, pick(-2, 2));
        letter("ijk"[plane_.v], Role::shift_v, pick(-2, 2));
        letter("ijk"[plane_.w], Role::counterbore_top, bottom + 1);
        plain(Role::feed_out, 1);
        return Kind::canned_back_bore;
    }
    void step(const cl::Step& s) { std::visit(ours_, s); }

    Random random_;
    const Plane& plane_;
    double unit_;
    double last_dwell_ = 0;
    Situation situation_;
    Values values_;
    std::string lines_;
    ToCalls ours_;
};

TEST(canned_referee, SameCallsAsLinuxCnc) {
    if (!has_referee()) GTEST_SKIP() << "needs /usr/bin/rs274 (package linuxcnc-uspace)";
    std::map<std::string, int> compared;
    for (std::uint32_t seed = 1; seed <= 60; ++seed) {
        const Program p(seed);
        std::vector<Call> theirs;
        for (const Call& c : referee(p.lines(), "canned"))
            if (is_step(c)) theirs.push_back(c);
        ASSERT_GT(theirs.size(), 10u) << "seed " << seed;
        ASSERT_EQ(theirs.back().name, "STOP_SPINDLE_TURNING") << "seed " << seed << '\n' << p.lines();
        theirs.pop_back();  // of M2
        const std::vector<Call>& ours = p.ours();
        for (std::size_t i = 0; i < std::min(ours.size(), theirs.size()); ++i) {
            ASSERT_TRUE(same(ours[i], theirs[i])) << "seed " << seed << " call " << i << ": ours " << text(ours[i])
                                                  << ", theirs " << text(theirs[i]) << '\n'
                                                  << p.lines();
            compared[ours[i].name]++;
        }
        ASSERT_EQ(ours.size(), theirs.size()) << "seed " << seed << '\n' << p.lines();
    }
    EXPECT_GT(compared["STRAIGHT_FEED"], 500);
    EXPECT_GT(compared["ORIENT_SPINDLE"], 20);
    EXPECT_GT(compared["PROGRAM_STOP"], 20);
    EXPECT_GT(compared["START_SPINDLE_COUNTERCLOCKWISE"], 50);
}

}  // namespace
}  // namespace obrys::cycles::test
