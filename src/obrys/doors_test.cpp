/// The doors as a stranger uses them.

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <thread>

#include "obrys/check.hpp"
#include "obrys/run.hpp"
#include "obrys/translate.hpp"
#include "obrys/version.hpp"

namespace obrys::api {
namespace {

constexpr const char* plate = R"(0 BEGIN PGM PLATE MM
1 BLK FORM 0.1 Z X+0 Y+0 Z-10
2 BLK FORM 0.2 X+60 Y+40 Z+0
3 TOOL CALL 1 Z S3000 F400
4 Q1 = 2
5 L Z+50 R0 FMAX M3
6 L X-10 Y+20 R0 FMAX
7 L Z-Q1 R0 FMAX
8 L X+70 R0 F
9 L Z+50 R0 FMAX M30
10 END PGM PLATE MM
)";
constexpr const char* tools = "[[tool]]\nnumber = 1\nkind = \"end-mill\"\ndiameter = 10.0\nlength = 60.0\n";

Image prepared(Workspace& workspace, const Options& more = {}) {
    workspace.put("PLATE.H", plate);
    workspace.put("tools.toml", tools);
    Options options = more;
    options.tools = {"tools.toml"};
    return workspace.prepare("PLATE.H", options);
}

TEST(Doors, RunsATextFromMemory) {
    Workspace workspace = Workspace::in_memory();
    const Image image = prepared(workspace);
    ASSERT_TRUE(image.usable());
    EXPECT_EQ(image.control(), "heidenhain-itnc530");
    EXPECT_EQ(image.program(), "PLATE.H");
    std::vector<Move> moves;
    const Ran ran = run(image, [&](const Move& m) { moves.push_back(m); });
    EXPECT_EQ(ran.ending, Ending::regular);
    ASSERT_EQ(moves.size(), 5u);
    EXPECT_TRUE(std::isnan(moves[0].from[2]));
    EXPECT_EQ(moves[3].to, (Point{70, 20, -2}));
    EXPECT_FALSE(moves[3].rapid);
    EXPECT_EQ(moves[3].feed, 400);
    EXPECT_EQ(moves[3].speed, 3000);
    EXPECT_EQ(moves[3].spindle, 1);
    EXPECT_EQ(moves[3].tool, 1u);
    EXPECT_EQ(moves[3].where.line, 9u);
    EXPECT_EQ(ran.parameters.at("Q1"), 2);
    EXPECT_NE(stream(image).find("linear 70 20 -2"), std::string::npos);
}

/// Of a control: how its programs select a zero, and what the stream calls it.
struct Zeros {
    std::string control, begin, end;
    struct Named {
        std::string word, key;
        std::uint32_t number;
    };
    std::vector<Named> all;
};

std::vector<Zeros> zeros_of_controls() {
    std::vector<Zeros::Named> plain;
    for (std::uint32_t n = 54; n < 60; ++n) plain.push_back({"G" + std::to_string(n), "G" + std::to_string(n), n});
    const auto with = [&](const Zeros::Named& more) {
        std::vector<Zeros::Named> out(plain.begin(), plain.begin() + 4);
        out.push_back(more);
        return out;
    };
    return {{"sinumerik-840d", "G90 G17\nT1 D1\nM6\nS1000 M3\n", "M30\n", with({"G505", "G505", 505})},
            {"fanuc", "%\nO0001\nG90 G17 G21\nT1 M6\nS1000 M3\n", "M30\n%\n", with({"G54.1 P2", "\"G54.1 P2\"", 5402})},
            {"haas", "%\nO0001\nG90 G17 G21\nT1 M6\nS1000 M3\n", "M30\n%\n", plain},
            {"linuxcnc", "G90 G17 G21\nT1 M6\nS1000 M3\n", "M2\n", with({"G59.2", "\"G59.2\"", 592})},
            {"heidenhain-itnc530",
             "0 BEGIN PGM P MM\n1 TOOL CALL 1 Z S1000\n",
             "END PGM P MM\n",
             {{"CYCL DEF 247 DATUM SETTING Q339=+5", "preset5", 1005},
              {"CYCL DEF 247 DATUM SETTING Q339=+7", "preset7", 1007}}}};
}

/// The zero of every move is the last one that its program has selected, also of the first move, before which nothing
/// in the stream could tell a wrong one: its place is that of the job, and points are the numbers of the program.
TEST(Doors, EveryMoveCountsFromTheZeroThatItsProgramHasSelected) {
    for (const Zeros& zeros : zeros_of_controls()) {
        const bool klartext = zeros.control.starts_with("heidenhain");
        std::string datum = "[datum]\n";
        const auto place = [](std::uint32_t n) {
            return Point{double(n % 100) * 10, double(n % 7) - 3, 200 + double(n % 11)};
        };
        for (const Zeros::Named& z : zeros.all) {
            const Point p = place(z.number);
            datum += z.key + " = {x = " + std::to_string(p[0]) + ", y = " + std::to_string(p[1]) +
                     ", z = " + std::to_string(p[2]) + "}\n";
        }
        for (std::size_t first = 0; first < zeros.all.size(); ++first)
            for (std::size_t second = 0; second < zeros.all.size(); ++second)
                for (const bool both_before : {false, true}) {
                    const auto move = [&](int x) {
                        return (klartext ? "L X+" + std::to_string(x) + " Y+2 Z+30 R0 FMAX"
                                         : "G0 X" + std::to_string(x) + ". Y2. Z30.") +
                               "\n";
                    };
                    const std::string text = zeros.begin + zeros.all[first].word + "\n" + (both_before ? "" : move(1)) +
                                             zeros.all[second].word + "\n" + move(11) + move(12) + zeros.end;
                    SCOPED_TRACE(zeros.control + "\n" + text);
                    Workspace workspace = Workspace::in_memory();
                    workspace.put("P.txt", text);
                    workspace.put("p.job.toml",
                                  "program = \"P.txt\"\ncontrol = \"" + zeros.control + "\"\n" + tools + datum);
                    const Image image = workspace.prepare("p.job.toml");
                    ASSERT_TRUE(image.usable()) << image.messages().at(0).text;
                    std::vector<Move> moves;
                    const Ran ran = run(image, [&](const Move& m) { moves.push_back(m); });
                    ASSERT_EQ(ran.ending, Ending::regular);
                    ASSERT_EQ(moves.size(), both_before ? 2U : 3U);
                    for (const Move& m : moves) {
                        const bool begins = !both_before && m.index == 0;
                        const std::uint32_t number = zeros.all[begins ? first : second].number;
                        EXPECT_EQ(m.zero.number, number) << m.index;
                        EXPECT_EQ(m.zero.origin, place(number)) << m.index;
                        EXPECT_EQ(m.to, (Point{begins ? 1. : m.index + 1 == moves.size() ? 12. : 11., 2, 30}));
                    }
                }
    }
}

/// A five-axis program as a stranger follows it: how the tool stands at both ends, and where each rotary axis.
TEST(Doors, FiveAxesAreFollowedByMovesAlone) {
    Workspace workspace = Workspace::in_memory();
    workspace.put("FIVE.H", R"(0 BEGIN PGM FIVE MM
1 TOOL CALL 1 Z S3000 F400
2 L X+0 Y+0 Z+50 R0 FMAX M3
3 L B+30 C+90 R0 FMAX
4 PLANE SPATIAL SPA+0 SPB+30 SPC+0 STAY
5 L X+10 Y+0 Z+5 F200
6 L C-45 F100
7 PLANE RESET STAY
8 L Z+50 R0 FMAX M30
9 END PGM FIVE MM
)");
    workspace.put("tools.toml", tools);
    Options options;
    options.tools = {"tools.toml"};
    const Image image = workspace.prepare("FIVE.H", options);
    std::vector<Move> moves;
    run(image, [&](const Move& m) { moves.push_back(m); });
    ASSERT_GE(moves.size(), 4U) << stream(image);
    EXPECT_TRUE(std::isnan(moves[0].axis_from[2]));
    EXPECT_TRUE(moves[0].axes.empty());
    const Move& turn = moves[1];
    ASSERT_EQ(turn.axes.size(), 2U);
    EXPECT_EQ(turn.axes[0].name, "B");
    EXPECT_TRUE(std::isnan(turn.axes[0].from));
    EXPECT_EQ(turn.axes[0].to, 30);
    EXPECT_TRUE(turn.axes[0].rotary);
    EXPECT_EQ(turn.axes[1].name, "C");
    EXPECT_EQ(turn.axes[1].to, 90);
    // Every move goes on from where the one before it ended.
    bool tilted = false, turned_back = false;
    for (std::size_t i = 1; i < moves.size(); ++i) {
        EXPECT_EQ(moves[i].axis_from, moves[i - 1].axis_to) << i;
        for (const AxisWay& was : moves[i - 1].axes)
            for (const AxisWay& now : moves[i].axes)
                if (was.name == now.name) {
                    EXPECT_EQ(now.from, was.to) << i;
                    turned_back = turned_back || (now.name == "C" && now.from == 90 && now.to == -45);
                }
        const double length = std::hypot(moves[i].axis_to[0], moves[i].axis_to[1], moves[i].axis_to[2]);
        EXPECT_NEAR(length, 1, 1e-9) << i;
        tilted = tilted || std::abs(moves[i].axis_to[0] - 0.5) < 1e-9;
    }
    EXPECT_TRUE(tilted) << stream(image);
    EXPECT_TRUE(turned_back) << stream(image);
}

TEST(Doors, OtherValuesAreOfOneRun) {
    Workspace workspace = Workspace::in_memory();
    const Image image = prepared(workspace);
    const auto depth = [&](const Inputs& inputs) {
        double lowest = 0;
        run(
            image, [&](const Move& m) { lowest = std::min(lowest, m.to[2]); }, inputs);
        return lowest;
    };
    Inputs deeper;
    deeper.set["q1"] = 5;
    EXPECT_EQ(depth({}), -2);
    EXPECT_EQ(depth(deeper), -5);
    EXPECT_EQ(depth({}), -2);
}

TEST(Doors, ChecksAndSaysWhere) {
    Workspace workspace = Workspace::in_memory();
    workspace.put("PLATE.H", plate);
    workspace.put("plate.job.toml", std::string("program = \"PLATE.H\"\n[check]\nscope = \"collisions\"\n") + tools);
    const Image image = workspace.prepare("plate.job.toml");
    const Checked good = check(image, {}, {true, true, false});
    EXPECT_EQ(good.verdict, Verdict::clean) << good.text;
    EXPECT_EQ(good.moves, 5u);
    EXPECT_FALSE(good.assumptions.empty());
    EXPECT_NE(good.json.find("\"verdict\""), std::string::npos);
    EXPECT_NE(good.text.find("clean"), std::string::npos);
    EXPECT_TRUE(good.html.empty());
    const std::size_t beside = std::string(plate).find("X-10 Y");
    workspace.put("PLATE.H", std::string(plate).replace(beside, 6, "X+10 Y"));
    const Checked bad = check(workspace.prepare("plate.job.toml"));
    ASSERT_EQ(bad.verdict, Verdict::findings);
    ASSERT_FALSE(bad.findings.empty());
    const Finding& first = bad.findings[0];
    EXPECT_EQ(first.message.where.line, 8u) << first.message.text;
    EXPECT_EQ(first.message.where.file, "PLATE.H");
    EXPECT_EQ(first.first_move, 2u);
    EXPECT_NEAR(first.amounts.at("depth_mm"), 2, 0.1);
}

TEST(Doors, AnImageKeepsWhatItWasMadeOf) {
    Workspace workspace = Workspace::in_memory();
    const Image image = prepared(workspace);
    const std::string before = stream(image);
    workspace.put("PLATE.H", "0 BEGIN PGM PLATE MM\n1 END PGM PLATE MM\n");
    EXPECT_TRUE(workspace.remove("tools.toml"));
    EXPECT_EQ(stream(image), before);
    EXPECT_EQ(translate(image, "same").proof, Proof::same);
}

TEST(Doors, WhatCannotBeUsedIsSaid) {
    Workspace workspace = Workspace::in_memory();
    const Image none = workspace.prepare("NONE.H");
    EXPECT_FALSE(none.usable());
    ASSERT_FALSE(none.messages().empty());
    EXPECT_NE(none.messages()[0].text.find("there is no file NONE.H"), std::string::npos);
    EXPECT_THROW(run(none), std::invalid_argument);
    EXPECT_THROW(static_cast<void>(check(none)), std::invalid_argument);
    // Memory is all there is: no file of the machine is seen.
    EXPECT_FALSE(workspace.prepare("/etc/passwd").usable());
    workspace.put("A.txt", "hello");
    EXPECT_EQ(check(workspace.prepare("A.txt")).verdict, Verdict::not_fully_checked);
}

TEST(Doors, TranslatesAndProves) {
    Workspace workspace = Workspace::in_memory();
    const Image image = prepared(workspace);
    const Translated fanuc = translate(image, "fanuc");
    EXPECT_EQ(fanuc.proof, Proof::same);
    EXPECT_NE(fanuc.text.find("G0"), std::string::npos);
    const Translated none = translate(image, "fanoc");
    EXPECT_EQ(none.proof, Proof::not_compared);
    EXPECT_TRUE(none.text.empty());
    EXPECT_FALSE(none.messages.empty());
}

TEST(Doors, ThreadsTranslateOneImage) {
    Workspace workspace = Workspace::in_memory();
    const Image image = prepared(workspace);
    const std::string fanuc = translate(image, "fanuc").text, same = translate(image, "same").text;
    const auto work = [&](const char* post, const std::string& expected) {
        for (int i = 0; i < 50; ++i) {
            const Translated t = translate(image, post);
            if (t.text != expected || t.proof != Proof::same) return false;
        }
        return true;
    };
    bool good = false;
    std::thread beside([&] { good = work("fanuc", fanuc); });
    EXPECT_TRUE(work("same", same));
    beside.join();
    EXPECT_TRUE(good);
}

/// A milled job with a part: what runs share of it does not change.
TEST(Doors, ThreadsMillOneImage) {
    Workspace workspace = Workspace::in_memory();
    workspace.put("PLATE.H", plate);
    workspace.put(
        "part.stl",
        "solid p\nfacet normal 0 0 -1\nouter loop\nvertex 0 0 -9\nvertex 0 40 -9\nvertex 60 0 -9\nendloop\nendfacet\n"
        "facet normal 0 -1 0\nouter loop\nvertex 0 0 -9\nvertex 60 0 -9\nvertex 0 0 -3\nendloop\nendfacet\n"
        "facet normal -1 0 0\nouter loop\nvertex 0 0 -9\nvertex 0 0 -3\nvertex 0 40 -9\nendloop\nendfacet\n"
        "facet normal 1 1 1\nouter loop\nvertex 60 0 -9\nvertex 0 40 -9\nvertex 0 0 -3\nendloop\nendfacet\nendsolid "
        "p\n");
    workspace.put("plate.job.toml", std::string("program = \"PLATE.H\"\n[part]\nfile = \"part.stl\"\n") + tools);
    const Image image = workspace.prepare("plate.job.toml");
    ASSERT_TRUE(image.usable()) << image.messages().at(0).text;
    Inputs deep;
    deep.set["Q1"] = 4;
    const auto json = [&](const Inputs& inputs) { return check(image, inputs, {true, false, false}).json; };
    const std::string two = json({}), four = json(deep);
    EXPECT_NE(two, four);
    const auto work = [&](bool first) {
        for (int i = 0; i < 4; ++i, first = !first)
            if (json(first ? Inputs{} : deep) != (first ? two : four)) return false;
        return true;
    };
    bool good = false;
    std::thread beside([&] { good = work(true); });
    EXPECT_TRUE(work(false));
    beside.join();
    EXPECT_TRUE(good);
}

TEST(Doors, AnEditorsTextStandsInFrontOfTheFile) {
    const std::filesystem::path folder = std::filesystem::temp_directory_path() / "obrys-doors-test";
    std::filesystem::create_directories(folder);
    std::ofstream(folder / "PLATE.H") << plate;
    const std::string name = (folder / "PLATE.H").string();
    Workspace workspace = Workspace::over_disk();
    const std::string saved = stream(workspace.prepare(name));
    workspace.put(name, std::string(plate).replace(std::string(plate).find("Q1 = 2"), 6, "Q1 = 3"));
    EXPECT_NE(stream(workspace.prepare(name)), saved);
    EXPECT_TRUE(workspace.remove(name));
    EXPECT_EQ(stream(workspace.prepare(name)), saved);
    std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace obrys::api
