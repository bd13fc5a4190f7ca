/// The turning cycles against the canonical calls of the installed LinuxCNC interpreter: the same calls in the same
/// order, over random contours and threads; where it refuses a contour, so do we.

#include <map>

#include "cycles/cycle_testing.hpp"
#include "cycles/rs274_testing.hpp"
#include "cycles/turn/turning.hpp"

namespace obrys::cycles::test {
namespace {

using geom::Vec2;

bool is_turning_step(const Call& c) {
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

std::string turning_text(const Call& c) {
    std::string t = c.name;
    for (std::size_t i = 0; i < c.numbers.size() && i < 5; ++i) t += " " + base::fixed(c.numbers[i], 4);
    return t;
}

bool same_turning(const Call& ours, const Call& theirs) {
    if (ours.name != theirs.name || theirs.numbers.size() < ours.numbers.size()) return false;
    for (std::size_t i = 0; i < ours.numbers.size(); ++i)
        if (!(std::abs(ours.numbers[i] - theirs.numbers[i]) < 2.01e-4)) return false;
    return true;
}

std::size_t first_difference(const std::vector<Call>& ours, const std::vector<Call>& theirs) {
    for (std::size_t i = 0; i < std::max(ours.size(), theirs.size()); ++i)
        if (i >= ours.size() || i >= theirs.size() || !same_turning(ours[i], theirs[i])) return i;
    return std::string::npos;
}

/// Without feed moves that end on the way of the next: a rounding error decides whether the control makes them.
std::vector<Call> simplified(const std::vector<Call>& calls) {
    std::vector<Call> out;
    const auto place = [](const Call& c) {
        return c.name == "ARC_FEED" ? Vec2{c.numbers[0], c.numbers[1]} : Vec2{c.numbers[2], c.numbers[0]};
    };
    for (const Call& c : calls) {
        if (c.name == "STRAIGHT_FEED" && !out.empty() && geom::distance(place(out.back()), place(c)) < 1e-3) continue;
        while (c.name == "STRAIGHT_FEED" && out.size() > 1 && out.back().name == "STRAIGHT_FEED") {
            const Vec2 a = place(out[out.size() - 2]), b = place(out.back()), d = place(c);
            if (geom::distance(a, b) + geom::distance(b, d) > geom::distance(a, d) + 1e-4) break;
            out.pop_back();
        }
        out.push_back(c);
    }
    return out;
}

/// A program and the same as a demand.
struct Sheet {
    std::string lines;
    TurningDemand demand;
    double unit = 1;

    void plain(Role role, double v) { demand.cycle.values.push_back({role, v}); }
    void word(char letter, Role role, double v) {
        lines += " " + std::string(1, letter) + base::shortest(v);
        plain(role, v * unit);
    }
    void bare(char letter, Role role, double v) {
        lines += " " + std::string(1, letter) + base::shortest(v);
        plain(role, v);
    }
};

double pick(Random& r, double low, double high, double grid = 0.01) {
    return std::round(r.in(low, high) / grid) * grid;
}

Sheet begin(Random& r, double z, double x) {
    Sheet s;
    s.unit = r.upto(3) == 0 ? 25.4 : 1;
    s.lines = std::string("g18 g90 f100 s500 m3 ") + (s.unit == 1 ? "g21" : "g20") + "\ng0 x" + base::shortest(x) +
              " z" + base::shortest(z) + "\n";
    s.demand.situation.at = {z * s.unit, x * s.unit, 0};
    s.demand.situation.spindle_direction = 1;
    s.plain(Role::length_unit, s.unit);
    return s;
}

/// Compares what both make of it; what came of it.
std::string compare(const Sheet& s, const std::string& label) {
    const Expansion e = expand_turning(s.demand);
    std::vector<Call> theirs;
    std::string error;
    for (const Call& c : referee(s.lines, "turning")) {
        if (is_turning_step(c)) theirs.push_back(c);
        if (error.empty() && c.name.rfind("error", 0) == 0 && c.name.find("Oops") == std::string::npos) error = c.name;
    }
    if (error.find("Segmentation") != std::string::npos || error.find("exit") != std::string::npos) return "crash";
    if (!error.empty()) {
        EXPECT_FALSE(e.ok()) << label << ": " << error << '\n' << s.lines;
        return error.find("Radius to end of arc") != std::string::npos ? "arc" : "refused";
    }
    EXPECT_TRUE(e.ok()) << label << ": " << complaints(e) << '\n' << s.lines;
    if (!e.ok()) return "failed";
    ToTurningCalls ours{s.unit, {}};
    for (const cl::Step& step : e.steps) std::visit(ours, step);
    theirs.erase(theirs.begin());  // to where the cycle begins
    const std::size_t differs = first_difference(ours.calls, theirs);
    if (differs == std::string::npos) return "same";
    if (first_difference(simplified(ours.calls), simplified(theirs)) == std::string::npos) return "same path";
    ADD_FAILURE() << label << " call " << differs << ": ours "
                  << (differs < ours.calls.size() ? turning_text(ours.calls[differs]) : "none") << ", theirs "
                  << (differs < theirs.size() ? turning_text(theirs[differs]) : "none") << '\n'
                  << s.lines;
    return "failed";
}

TEST(turning_referee, Threads) {
    if (!has_referee()) GTEST_SKIP() << "needs /usr/bin/rs274 (package linuxcnc-uspace)";
    std::map<std::string, int> results;
    for (std::uint32_t seed = 1; seed <= 60; ++seed) {
        Random r(seed);
        Sheet s = begin(r, pick(r, -2, 3), pick(r, 8, 12));
        s.demand.cycle.kind = Kind::lathe_thread_degressive;
        s.lines += "g76";
        s.word('p', Role::pitch, pick(r, 0.5, 3));
        s.word('z', Role::target_u, pick(r, -20, 20));
        if (r.upto(3) == 0) s.word('x', Role::target_v, pick(r, 8, 12));
        s.word('i', Role::crest_offset, (r.upto(1) == 0 ? -1 : 1) * pick(r, 0.5, 3));
        s.word('j', Role::first_depth, r.upto(1) == 0 ? 0.1 : pick(r, 0.05, 0.6));
        s.word('k', Role::thread_depth, r.upto(1) == 0 ? 0.8 : pick(r, 0.3, 2));
        if (r.upto(1) == 0) s.bare('r', Role::degression, pick(r, 0.5, 2.5));
        if (r.upto(1) == 0) s.bare('q', Role::infeed_angle, pick(r, -10, 40));
        if (r.upto(1) == 0) s.bare('h', Role::spring_passes, r.upto(4) - 1);
        if (r.upto(1) == 0) s.word('e', Role::taper_length, pick(r, -0.2, 3));
        if (r.upto(1) == 0) s.bare('l', Role::taper_ends, r.upto(3));
        s.lines += "\nm2\n";
        results[compare(s, "seed " + std::to_string(seed))]++;
    }
    EXPECT_GT(results["same"], 40);
}

/// A contour towards smaller Z with rises and pockets, lines and arcs, corners to finish.
void random_contour(Random& r, Sheet& s, double z, double x, bool wild) {
    Vec2 at{z, x};
    const int elements = 2 + r.upto(6);
    int motion = -1;
    for (int k = 0; k < elements; ++k) {
        TurningElement e;
        Vec2 to{at.x - (k == 0 ? 0 : pick(r, 0.2, 5)), k == 0 ? pick(r, 1, 5) : at.y + pick(r, -3, 4)};
        to.x = std::round(to.x * 100) / 100;
        to.y = std::round(to.y * 100) / 100;
        if (k > 0 && r.upto(3) == 0) to.y = at.y;
        if (k > 0 && r.upto(4) == 0 && to.y != at.y) to.x = at.x;
        // The installed interpreter is of early 2.9: it does not close contours that end elsewhere than the later one.
        if (k + 1 == elements) to = {at.x, std::max(at.y, x) + (r.upto(1) == 0 ? 0 : pick(r, 0, 1))};
        if (wild && k + 1 < elements && r.upto(5) == 0) to.x = at.x + pick(r, 0, 2);
        if (to == at) continue;
        e.turn = k == 0 || k + 1 == elements || r.upto(2) != 0 ? 0 : r.upto(1) == 0 ? 1 : -1;
        const int g = e.turn == 0 ? 1 : e.turn > 0 ? 3 : 2;
        if (g != motion) s.lines += "g" + std::to_string(g);
        motion = g;
        s.lines += " x" + base::shortest(to.y) + " z" + base::shortest(to.x);
        if (e.turn != 0) {
            // A centre right of (left of) the chord by a rounded amount: the control forgives the small mismatch.
            const Vec2 chord = to - at, middle = 0.5 * (at + to);
            const double bulge = r.in(0.6, 3);
            const Vec2 centre = middle + (e.turn * bulge) * geom::left_of(chord);
            const double i = std::round((centre.y - at.y) * 1e6) / 1e6, kk = std::round((centre.x - at.x) * 1e6) / 1e6;
            s.lines += " i" + base::fixed(i, 6) + " k" + base::fixed(kk, 6);
            e.centre = s.unit * Vec2{at.x + kk, at.y + i};
        }
        if (k > 0 && r.upto(5) == 0) {
            const double size = pick(r, 0.1, 0.5);
            const bool fillet = r.upto(1) == 0;
            (fillet ? e.fillet : e.chamfer) = size * s.unit;
            s.lines += (fillet ? " a" : " c") + base::shortest(size);
        }
        s.lines += "\n";
        e.to = s.unit * to;
        s.demand.contour.push_back(e);
        at = to;
    }
}

/// `across`: facing; then X and Z of the contour change places.
void exchange(Sheet& s) {
    std::string lines;
    for (const char ch : s.lines) lines += ch == 'x' ? 'z' : ch == 'z' ? 'x' : ch == 'i' ? 'k' : ch == 'k' ? 'i' : ch;
    for (std::size_t i = 0; i + 2 < lines.size(); ++i)
        if (lines[i] == 'g' && lines[i + 2] == ' ' && (lines[i + 1] == '2' || lines[i + 1] == '3'))
            lines[i + 1] = lines[i + 1] == '2' ? '3' : '2';
    s.lines = lines;
    for (TurningElement& e : s.demand.contour) {
        e.to = {e.to.y, e.to.x};
        e.centre = {e.centre.y, e.centre.x};
        e.turn = -e.turn;
    }
    std::swap(s.demand.situation.at.x, s.demand.situation.at.y);
}

Sheet contour_cycle(std::uint32_t seed) {
    Random r(seed);
    const double z = pick(r, 0, 2), x = pick(r, 9, 13);
    Sheet s = begin(r, z, x);
    s.lines += "o100 sub\n";
    random_contour(r, s, z, x + 1, r.upto(4) == 0);
    s.lines += "o100 endsub\n";
    const int which = r.upto(6);
    const bool across = which >= 3 && which < 6;
    if (across) exchange(s);
    if (which == 6) {
        s.demand.cycle.kind = Kind::lathe_finish_offset;
        s.lines += "g70 q100";
        if (r.upto(1) == 0) s.word('d', Role::allowance_first, pick(r, 0, 1, 0.05));
        if (r.upto(1) == 0) s.word('e', Role::allowance_last, pick(r, 0, 0.3, 0.05));
        if (r.upto(1) == 0) s.bare('p', Role::passes, 1 + r.upto(3));
    } else {
        s.demand.cycle.kind = across ? Kind::lathe_rough_across : Kind::lathe_rough_along;
        s.lines += (across ? "g72." : "g71.") + std::to_string(which % 3) + " q100";
        s.plain(Role::pockets, which % 3);
        if (r.upto(1) == 0) s.word('i', Role::infeed, pick(r, 0.2, 2));
        if (r.upto(1) == 0) s.word('r', Role::escape, pick(r, 0.05, 1));
        if (r.upto(1) == 0) s.word('d', Role::allowance_side, pick(r, 0, 0.4));
    }
    if (r.upto(2) == 0) s.word('x', Role::target_v, across ? z + 1 : x + 1);
    s.lines += "\nm2\n";
    return s;
}

TEST(turning_referee, Contours) {
    if (!has_referee()) GTEST_SKIP() << "needs /usr/bin/rs274 (package linuxcnc-uspace)";
    std::map<std::string, int> results;
    for (std::uint32_t seed = 1; seed <= 70; ++seed)
        results[compare(contour_cycle(seed), "seed " + std::to_string(seed))]++;
    EXPECT_GT(results["same"], 35);
    EXPECT_LE(results["same path"], 2);
    EXPECT_GT(results["refused"], 10);
}

/// The contour of a corpus program: lines with G, X, Z, I, K (from the start of the arc) and A.
std::vector<TurningElement> contour_of(const std::string& lines, Vec2 at) {
    std::vector<TurningElement> contour;
    std::istringstream in(lines);
    int motion = 1;
    for (std::string line; std::getline(in, line);) {
        TurningElement e;
        e.to = e.centre = at;
        std::istringstream words(line);
        char letter = 0;
        for (double v = 0; words >> letter >> v;) {
            if (letter == 'G') motion = int(v);
            if (letter == 'X') e.to.y = v;
            if (letter == 'Z') e.to.x = v;
            if (letter == 'I') e.centre.y += v;
            if (letter == 'K') e.centre.x += v;
            if (letter == 'A') e.fillet = v;
        }
        e.turn = motion == 2 ? -1 : motion == 3 ? 1 : 0;
        contour.push_back(e);
        at = e.to;
    }
    return contour;
}

void expect_corpus(const std::string& name, const std::vector<TurningDemand>& demands) {
    const std::string folder = std::string(OBRYS_SOURCE_DIR) + "/../shared/corpus/rs274_expected/";
    std::ifstream file(folder + "LinuxCNC__linuxcnc/tests/interp/" + name + "/expected");
    if (!file) GTEST_SKIP() << "needs ../shared";
    std::vector<Call> theirs;
    for (std::string line; std::getline(file, line);)
        if (const std::size_t at = line.find("N..... "); at != std::string::npos)
            if (const Call c = call_of(std::string_view(line).substr(at + 7)); is_turning_step(c)) theirs.push_back(c);
    ToTurningCalls ours{1, {}};
    for (const TurningDemand& d : demands) {
        const Expansion e = expand_turning(d);
        EXPECT_TRUE(e.ok()) << complaints(e);
        for (const cl::Step& step : e.steps) std::visit(ours, step);
    }
    const std::size_t count = std::min(theirs.size(), ours.calls.size());
    EXPECT_GE(ours.calls.size() + 1, theirs.size());  // at most a move of the program itself follows
    theirs.resize(count);
    ours.calls.resize(count);
    const std::size_t differs = first_difference(ours.calls, theirs);
    EXPECT_EQ(differs, std::string::npos) << turning_text(ours.calls[std::min(differs, count - 1)]) << " against "
                                          << turning_text(theirs[std::min(differs, count - 1)]);
}

TurningDemand corpus_demand(Kind kind, const std::vector<TurningElement>& contour, Vec2 start, Values values) {
    TurningDemand d;
    d.cycle = {kind, with({{Role::target_u, start.x}, {Role::target_v, start.y}}, values)};
    d.contour = contour;
    d.situation.at = {0, 0, 0};
    return d;
}

TEST(turning_corpus, RoughingAndFinishing) {
    const Vec2 start{3.041, 15};
    const auto contour = contour_of(
        "G0 X0.202 Z3.041\nG2 X1.081 Z0.919 I3.0 K0.0\nG1 X3.0 Z-1.0\nG1 Z-4.0\nX2.268 Z-5.268\n"
        "G2 X2.0 Z-6.268 I1.73205 K-1.0\nG1 Z-6.732\nG2 X4.0 Z-8.732 I2.0 K0.0\nG1 X4.5\n"
        "G3 X6.285 Z-12.982 I-0.0 K-2.5\nG2 Z-19.982 I3.57071 K-3.5\nG1 X10 A0.2\nG1 X8.5 Z-22.58\n"
        "G1 X10.0 Z-25.178\nG1 Z-27.178\nG2 X11.014 Z-35.1 I5.70735 K-3.29514\nG1 X12.0 Z-36.1\nG1 Z-38.1\nG0 X15.0\n",
        start);
    const Kind rough = Kind::lathe_rough_along;
    expect_corpus(
        "g71-with-g70",
        {corpus_demand(rough, contour, start,
                       {{Role::pockets, 1}, {Role::allowance_side, 1}, {Role::infeed, 1}, {Role::escape, 0.3}}),
         corpus_demand(rough, contour, start,
                       {{Role::pockets, 2}, {Role::allowance_side, 0.51}, {Role::infeed, 0.5}, {Role::escape, 0.3}}),
         corpus_demand(Kind::lathe_finish_offset, contour, start,
                       {{Role::allowance_last, 0}, {Role::allowance_first, 0.5}, {Role::passes, 2}})});
}

/// Contours on which earlier interpreters did not come to an end.
TEST(turning_corpus, EndlessLoops) {
    const Values roughing = {{Role::allowance_side, 0.04}, {Role::infeed, 0.5}, {Role::escape, 1}};
    const Vec2 start{0, 15};
    const auto contour = contour_of("G1 X10 Z0\nG1 X10 Z-14\nG1 X3\nG1 X7 Z-22\n", start);
    const Kind rough = Kind::lathe_rough_along;
    expect_corpus("g71-endless-loop", {corpus_demand(rough, contour, start, with(roughing, {{Role::pockets, 1}})),
                                       corpus_demand(rough, contour, start, with(roughing, {{Role::pockets, 2}}))});
    const Vec2 second{0, 168};
    expect_corpus("g71-endless-loop2",
                  {corpus_demand(rough, contour_of("Z-333\nG1 X170\nZ-415\n", second), second, {})});
    const auto groove = [](Vec2 from) {
        auto c = contour_of("G1 X9.362975\nZ0\nX9.863\nZ-5\nX10.113\nZ-25\nX10\n", from);
        c[2].chamfer = 0.5;
        return c;
    };
    const Vec2 third{2.8, 10}, fourth{1, 10};
    const Values deep = {{Role::allowance_side, 2}, {Role::infeed, 2}, {Role::escape, 0.3}};
    expect_corpus("g71-endless-loop_2", {corpus_demand(rough, groove(third), third, deep),
                                         corpus_demand(Kind::lathe_finish_offset, groove(fourth), fourth,
                                                       {{Role::allowance_first, 2}, {Role::passes, 1}})});
}

TEST(turning_corpus, Facing) {
    const Vec2 start{0, 50};
    const Values values = {{Role::infeed, 3}, {Role::escape, 0.1}};
    const Kind face = Kind::lathe_rough_across;
    expect_corpus("g72-facing",
                  {corpus_demand(face, contour_of("G1 X50 Z-40\nX100 Z-39.999\n", start), start, values)});
    expect_corpus("g72-missing-iteration",
                  {corpus_demand(face, contour_of("G1 X50 Z-40\nX100 Z-40\n", start), start, values)});
}

}  // namespace
}  // namespace obrys::cycles::test
