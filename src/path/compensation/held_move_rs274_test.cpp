/// Radius compensation by one held move against LinuxCNC's interpreter: seeded random contours, and the interpreter's
/// own test programs.

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <map>
#include <sstream>
#include <string>

#include "base/number.hpp"
#include "path/compensation/refusal.hpp"
#include "path/compensation/rs274_testing.hpp"
#include "path/compensation/compensation_testing.hpp"

namespace obrys::path::test {
namespace {

/// Writes contours that make every kind of corner, with arcs whose ends lie on them to 1e-9.
class Generator {
public:
    explicit Generator(std::uint32_t seed) : random_(seed) {}

    std::string contour(int number) {
        lathe_ = random_.upto(5) == 0;
        // rs274 goes on behind a refusal: what it still holds may make the first G40 fail, but then nothing is held
        block("G40");
        block("G40");
        text_ += "(MSG,c" + std::to_string(number) + ")\n";
        block("M9");
        block(random_.upto(3) == 0 ? "G20" : "G21");
        decimals_ = random_.upto(3) == 0 ? 3 : 9;
        block(lathe_ ? "G40 G18" : "G40 G17");
        at_ = {random_.in(-20, 20), random_.in(-20, 20)};
        w_ = random_.in(-5, 5);
        if (random_.upto(9) == 0) at_ = {std::round(at_.x), std::round(at_.y)};
        block("G0" + plane(at_) + axis(w_));
        select();
        const int moves = 2 + random_.upto(8);
        heading_ = random_.in(-geom::pi, geom::pi);
        for (int i = 0; i < moves; ++i) {
            move(i == 0);
            if (random_.upto(19) == 0) block(random_.upto(1) == 0 ? "M8" : "M9");
            if (random_.upto(39) == 0) block("M0");
        }
        leave();
        return std::exchange(text_, {});
    }

private:
    std::string word(const char* letter, double v) const {
        return std::string(" ") + letter + base::fixed(v, decimals_);
    }
    std::string plane(Vec2 p) const { return word(lathe_ ? "Z" : "X", p.x) + word(lathe_ ? "X" : "Y", p.y); }
    std::string axis(double w) const { return word(lathe_ ? "Y" : "Z", w); }
    void block(const std::string& words) { text_ += "N" + std::to_string(number_ += 1) + " " + words + "\n"; }

    static double rounded(double v) { return std::round(v * 1000) / 1000; }

    void select() {
        static constexpr double radii[]{0.5, 1, 1, 2, 3, 5, 0.001, 0};
        radius_ = radii[random_.upto(29) == 0 ? 6 + random_.upto(1) : random_.upto(5)];
        const double sign = random_.upto(9) == 0 ? -1 : 1;
        std::string words = random_.upto(1) == 0 ? "G41.1" : "G42.1";
        words += word("D", 2 * sign * radius_);
        if (lathe_) words += " L" + std::to_string(random_.upto(9));
        block(words);
    }

    void move(bool entry) {
        const int kind = random_.upto(19);
        if (kind == 0 && !entry) {
            w_ = random_.in(-5, 5);
            return block((random_.upto(2) == 0 ? "G0" : "G1") + axis(w_));
        }
        turn_somehow();
        if (kind <= 9)
            straight(entry);
        else
            bent();
    }

    void turn_somehow() {
        switch (random_.upto(5)) {
            case 0: break;
            case 1: heading_ += random_.in(-0.1, 0.1); break;
            case 2: heading_ += geom::radians(90) * (random_.upto(3) - 1); break;
            case 3: heading_ += geom::pi + random_.in(-0.1, 0.1); break;
            default: heading_ += random_.in(-geom::pi, geom::pi);
        }
    }

    double some_length() {
        return radius_ * (random_.upto(7) == 0 ? random_.in(0.05, 1) : random_.in(1, 12)) + (radius_ < 0.1 ? 3 : 0);
    }

    void straight(bool entry) {
        at_ = at_ + some_length() * Vec2{std::cos(heading_), std::sin(heading_)};
        std::string words = (random_.upto(entry ? 3 : 11) == 0 ? "G0" : "G1") + plane(at_);
        if (random_.upto(9) == 0) words += axis(w_ = random_.in(-5, 5));
        block(words);
    }

    void bent() {
        const double turn = random_.upto(1) == 0 ? 1 : -1;
        const double radius = 0.3 * some_length() + (random_.upto(3) == 0 ? 0 : radius_);
        const Vec2 out{std::cos(heading_), std::sin(heading_)};
        const Vec2 centre = at_ + (turn * radius) * geom::left_of(out);
        double sweep = turn * random_.in(0.05, 2 * geom::pi - 0.05);
        if (random_.upto(9) == 0) sweep = turn * geom::pi;
        const bool full = random_.upto(9) == 0;
        if (full) sweep = turn * 2 * geom::pi;
        const Vec2 from = at_;
        if (!full) at_ = centre + rotated(from - centre, sweep);
        std::string words = turn > 0 ? "G3" : "G2";
        if (!full || random_.upto(1) == 0) words += plane(at_);
        const Vec2 c = centre - from;
        if (decimals_ == 3) at_ = {rounded(at_.x), rounded(at_.y)};
        words += word(lathe_ ? "K" : "I", c.x) + word(lathe_ ? "I" : "J", c.y);
        if (random_.upto(9) == 0) words += axis(w_ = random_.in(-5, 5));
        if (random_.upto(14) == 0) words += " P" + std::to_string(1 + random_.upto(2));
        block(words);
        heading_ += sweep;
    }

    void leave() {
        block("G40");
        if (random_.upto(7) == 0) return again();
        const int kind = random_.upto(9);
        if (kind == 0) return bent();
        if (kind == 1) return block("G1" + axis(w_ = random_.in(-5, 5)));
        turn_somehow();
        straight(false);
    }

    /// Selected anew before the exit move, or behind it.
    void again() {
        if (random_.upto(1) == 0) straight(false);
        select();
        move(true);
        move(false);
        block("G40");
        straight(false);
    }

    Random random_;
    std::string text_;
    int number_ = 0, decimals_ = 9;
    bool lathe_ = false;
    double radius_ = 1, heading_ = 0, w_ = 0;
    Vec2 at_;
};

int environment(const char* name, int otherwise) {
    const char* text = std::getenv(name);
    return text == nullptr ? otherwise : std::atoi(text);
}

/// A refusal of rs274 that is none of the compensation's: rounded ends and centres.
bool foreign(const Stretch& s) { return s.refusal.starts_with("Radius to end of arc differs"); }

void tell(const std::map<std::string, int>& refusals, int contours, int calls) {
    std::printf("%d contours, %d calls compared\n", contours, calls);
    for (const auto& [text, count] : refusals)
        std::printf("%6d  %s\n", count, text.empty() ? "run to the end" : text.c_str());
}

TEST(held_move_rs274, RandomContoursAsLinuxCnc) {
    if (!have_rs274()) GTEST_SKIP() << "needs /usr/bin/rs274";
    const int contours = environment("OBRYS_CONTOURS", 400);
    const int seed = environment("OBRYS_SEED", 4);
    Generator generator(static_cast<std::uint32_t>(seed));
    std::vector<std::string> texts;
    std::string program = "G21 G90 G94 F100\n";
    for (int i = 0; i < contours; ++i) program += texts.emplace_back(generator.contour(i + 1));
    program += "N999998 G40\nN999999 G40\n(MSG,c0)\nM2\n";  // without its end rs274 goes on for ever
    const auto here = run_here(program), there = run_rs274(program);
    ASSERT_EQ(here.size(), there.size());
    std::map<std::string, int> refusals;
    int calls = 0, shown = 0;
    for (std::size_t i = 1; i + 1 < here.size(); ++i) {
        ++refusals[there[i].refusal.substr(0, there[i].refusal.find(foreign(there[i]) ? ": " : " r1 "))];
        calls += static_cast<int>(here[i].calls.size());
        if (foreign(there[i])) continue;
        const std::string different = difference(here[i], there[i]);
        if (different.empty()) continue;
        ADD_FAILURE() << "seed " << seed << ", contour " << i << ": " << different << "\n" << texts[i - 1];
        if (++shown == 5) break;
    }
    EXPECT_GT(refusals[""], contours / 4) << "too many contours are refused to be a test of paths";
    EXPECT_GE(refusals.size(), 9u) << "every kind of refusal is met";
    if (std::getenv("OBRYS_CONTOURS") != nullptr) tell(refusals, contours, calls);
}

/// Blocks that begin with a G word, numbered: rs274 runs on behind a refusal, and the numbers tell what came before.
std::string numbered(const std::string& program) {
    std::istringstream in(program);
    std::string text;
    int n = 0;
    for (std::string line; std::getline(in, line);) {
        const bool plain = !line.empty() && (line.front() == 'g' || line.front() == 'G');
        text += plain ? "N" + std::to_string(++n) + " " + line + "\n" : line + "\n";
    }
    return text;
}

/// What random contours do not come upon, each with the refusal to be expected, if one is.
struct Directed {
    const char* what;
    const char* blocks;
    Refusal refusal = Refusal::none;
};
constexpr Directed directed[]{
    {"arcs about one centre", "G41.1 D2\nG1 X10\nG3 X10 Y10 J5\nG2 X10 Y0 J-5\nG40\nG1 X0\n", Refusal::same_centre},
    {"half turn at the top of an h, tool outside", "G42.1 D2\nG1 X10\nG3 X10 Y10 J5\nG1 X20 Y10\nG40\nG1 Y20\n"},
    {"half turn between arcs as in an m", "G42.1 D2\nG1 X10\nG1 Y10\nG3 X0 Y10 I-5\nG3 X-10 Y10 I-5\nG40\nG1 Y20\n"},
    {"half turn of a line", "G41.1 D2\nG1 X10\nG1 X20\nG1 X10\nG40\nG1 X0\n"},
    {"arc that its start prolongs",
     "G41.1 D4\nG1 X10\nG3 X10.131980 Y4.398020 I0.065990 J2.199010\nG1 Y20\nG40\nG1 X0\n", Refusal::arc_unreachable},
    {"inner corner behind a program stop", "G41.1 D2\nG1 X10\nG1 X20\nM0\nG1 Y10\nG1 X0\nG40\nG1 X0 Y0\n"},
    {"inner corner of an arc behind a program stop",
     "G41.1 D2\nG1 X10\nG3 X20 Y10 J10\nM0\nG1 X10\nG1 X0\nG40\nG1 X0 Y0\n"},
    {"a move along the axis behind a program stop, then an inner corner",
     "G41.1 D2\nG1 X10\nG1 X20\nM0\nG1 Z-1\nG1 Y10\nG40\nG1 X0 Y0\n"},
    {"entry along the axis", "G41.1 D2\nG1 Z-1\n", Refusal::entry_line_short},
    {"entry as long as the radius", "G41.1 D20\nG1 X10\n", Refusal::entry_line_short},
    {"exit along the axis", "G41.1 D2\nG1 X10\nG1 X20\nG40\nG1 Z-1\nG1 X0\n"},
    {"selected for nothing", "G41.1 D2\nG40\nG2 X10 I5\nG1 X0\n"},
    {"radius zero", "G41.1 D0\nG1 X10\nG1 X10 Y0.1\nG1 X0\nG40\nG3 X10 I5\n"},
};

TEST(held_move_rs274, DirectedPrograms) {
    if (!have_rs274()) GTEST_SKIP() << "needs /usr/bin/rs274";
    std::string program = "G21 G90 G94 F100\n";
    int n = 0;
    for (const Directed& d : directed)
        program += "G40\nG40\n(MSG,c" + std::to_string(++n) + ")\nG40\nG0 X1 Y1 Z1\nG0 X0 Y0 Z0\n" + d.blocks;
    program = numbered(program + "G40\nG40\n(MSG,c0)\nM2\n");
    const auto here = run_here(program), there = run_rs274(program);
    ASSERT_EQ(here.size(), there.size());
    for (std::size_t i = 0; i < std::size(directed); ++i) {
        SCOPED_TRACE(directed[i].what);
        Fault f;
        f.refusal = directed[i].refusal;
        EXPECT_EQ(there[i + 1].refusal, message(f));
        EXPECT_EQ(difference(here[i + 1], there[i + 1]), "");
    }
}

/// What the interpreter sees, not the path.
TEST(held_move_rs274, WordsOfBeingOn) {
    if (!have_rs274()) GTEST_SKIP() << "needs /usr/bin/rs274";
    Fault f;
    f.refusal = Refusal::already_on;
    EXPECT_EQ(run_rs274("G41.1 D1\nG42.1 D1\nG40\nM2\n").front().refusal, message(f));
}

const std::string corpus = std::string(OBRYS_SOURCE_DIR) + "/../shared/corpus/";
const std::string tests = "LinuxCNC__linuxcnc/tests/";

void compare(const Stretch& here, const Stretch& there) {
    EXPECT_GT(there.calls.size(), 2u);
    EXPECT_EQ(difference(here, there), "");
}

TEST(held_move_rs274, ProgramsWithExpectedCalls) {
    for (const char* name : {"interp/inside-corners/test.ngc", "interp/inverse-time-with-comp/inverse.ngc"}) {
        SCOPED_TRACE(name);
        const std::string file = corpus + "rs274/" + tests + name;
        const std::string program = whole_file(file);
        if (program.empty()) GTEST_SKIP() << "needs ../shared";
        const std::string folder = std::string(name).substr(0, std::string(name).rfind('/'));
        const auto expected = calls_of(whole_file(corpus + "rs274_expected/" + tests + folder + "/expected"));
        compare(run_here(program).front(), expected.front());
    }
}

/// The tables belong to the tests of the interpreter, too; figures only.
TEST(held_move_rs274, ProgramsWithTools) {
    if (!have_rs274()) GTEST_SKIP() << "needs /usr/bin/rs274";
    const std::vector<TableTool> mills{{2, 0, 0.125}, {3, 0, 0.25}, {4, 0, 1}},
        lathe{{2, 2, 0.1}, {7, 7, 0.1}, {9, 9, 0.1}};
    const std::vector<std::pair<std::string, std::vector<TableTool>>> programs{
        {"ccomp/lathe-comp/test.ngc", lathe},
        {"ccomp/mill-g90g91g92/test.ngc", mills},
        {"ccomp/mill-line-arc-entry/test.ngc", mills},
        {"ccomp/mill-zchanges/test.ngc", mills},
        {"interp/bad/ccomp-gouging.ngc", mills}};
    for (const auto& [name, table] : programs) {
        SCOPED_TRACE(name);
        std::string program = whole_file(corpus + "rs274/" + tests + name);
        if (program.empty()) GTEST_SKIP() << "needs ../shared";
        const std::string root = "[.5*SQRT[2]]";
        for (std::size_t at = program.find(root); at != std::string::npos; at = program.find(root))
            program.replace(at, root.size(), base::fixed(std::sqrt(0.5), 12));
        program = numbered(program + "\nG40\nM2\n");  // some end without; rs274 would go on for ever
        compare(run_here(program, table).front(), run_rs274(program, table).front());
    }
}

}  // namespace
}  // namespace obrys::path::test
