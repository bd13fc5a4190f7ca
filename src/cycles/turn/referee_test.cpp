/// The turning cycles against the canonical calls of the installed LinuxCNC interpreter: the same calls in the same
/// order, over random contours and threads; where it refuses a contour, so do we.

#include <map>

#include "cycles/cycle_testing.hpp"
#include "cycles/rs274_testing.hpp"
#include "cycles/turn/turning.hpp"
#include "cycles/turn/turning_calls_testing.hpp"

namespace obrys::cycles::test {
namespace {

using geom::Vec2;

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
}  // namespace
}  // namespace obrys::cycles::test
