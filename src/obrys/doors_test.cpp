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
