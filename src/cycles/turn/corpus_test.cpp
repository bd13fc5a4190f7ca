/// The turning cycles against the canonical calls that LinuxCNC's own tests keep of its G70 to G72.

#include <map>

#include "cycles/cycle_testing.hpp"
#include "cycles/rs274_testing.hpp"
#include "cycles/turn/turning.hpp"
#include "cycles/turn/turning_calls_testing.hpp"

namespace obrys::cycles::test {
namespace {

using geom::Vec2;

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
