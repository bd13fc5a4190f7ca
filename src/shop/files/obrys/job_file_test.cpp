#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <fstream>
#include <sstream>

#include "base/number.hpp"
#include "shop/files/obrys/job_testing.hpp"
#include "shop/files/obrys/machine_file.hpp"

namespace obrys::shop {
namespace {

const char* const everything = R"(program = "HLAVNI.MPF"
control = "sinumerik-840d"
machine = "lathe-generic"
tool_file = "tools.toml"
tool_files = ["T1.TOA", "T2.TOA"]
search = ["lib", "../cycles"]
skip = [0, 3, 3]

[defaults]
diameter_programming = false
inch = true
feed_per_rev = true
plane = 19
circle_tolerance = 0.05

[[tool]]
number = 5
edge = 2
name = "GROOVER"
kind = "groove"
width = 3
corner_radius = 0.2
corner_radius_right = 0.4
reference = "right"
direction = "in"
cutting_depth = 20
length = 41.5
parameters = {DP7 = 2.5}

[[tool]]
number = 6
kind = "turning"
nose_radius = 0.8
orientation = 2
tip_angle = 55
entering_angle = 93
edge_length = 11

[[tool]]
number = 7
kind = "mill"
radius = 5

[stock]
bar = {diameter = 80, length = 100}
[part]
program = "KONTURA.SPF"
[allowance]
normal = 0.5
[set]
R3 = 150
r4 = -1.5
[datum]
G54 = {x = 10, z = 250}
G505 = {y = 3}
[check]
gouge = 0.01
rest_material = 0.02
rapid = 0.03
[budget]
blocks = 1000
loop_passes = 500
simulated_moves = 700
call_depth = 12
seconds = 2.5
[variables]
_gud = 1.5
count = 3
flag = true
word = "abc"
"#517" = 3.2
my = [[1, 2], ["x"]]
)";

std::string as_text(const GivenValues& values) {
    std::string text;
    for (const auto& [key, v] : values) {
        const std::string number = base::shortest(v.number);
        const bool is_text = v.kind == GivenKind::text, is_truth = v.kind == GivenKind::truth;
        text += key + "=" + (is_text ? "'" + v.text + "'" : (is_truth ? "true" : "") + number) + " ";
    }
    return text;
}

std::vector<std::string> paths(const std::vector<NamedFile>& files) {
    std::vector<std::string> out;
    for (const NamedFile& f : files) out.push_back(f.path);
    return out;
}

TEST(JobFile, EveryKeyIsRead) {
    Reading r;
    const Job j = read_job(r.add(everything), r.sources, r.diagnostics);
    EXPECT_EQ(r.complaints(), "");
    EXPECT_EQ(j.program, "HLAVNI.MPF");
    EXPECT_EQ(r.sources.text(j.program_where), "\"HLAVNI.MPF\"");
    EXPECT_EQ(j.control, "sinumerik-840d");
    EXPECT_EQ(j.machine_name, "lathe-generic");
    EXPECT_FALSE(j.machine_is_file);
    EXPECT_EQ(paths(j.tool_files), (std::vector<std::string>{"tools.toml", "T1.TOA", "T2.TOA"}));
    ASSERT_EQ(j.search.size(), 2u);
    EXPECT_EQ(j.search[0].path, "lib");
    EXPECT_EQ(j.search[1].path, "../cycles");
    EXPECT_EQ(j.skip_levels, (std::vector<int>{0, 3}));
    EXPECT_EQ(j.part_program->program, "KONTURA.SPF");
    EXPECT_FALSE(j.part);
    EXPECT_EQ(j.allowance->normal, 0.5);
    ASSERT_EQ(j.overrides.size(), 2U);
    EXPECT_EQ(j.overrides[1].name, "R4");
    EXPECT_EQ(j.overrides[1].value, -1.5);
    EXPECT_EQ(r.sources.text(j.overrides[0].where), "R3");
    EXPECT_EQ(j.machine.datums.at(54), (geom::Vec3{10, 0, 250}));
    EXPECT_EQ(j.machine.datums.at(505), (geom::Vec3{0, 3, 0}));
    EXPECT_EQ(j.tolerances.gouge, 0.01);
    EXPECT_EQ(j.tolerances.rest_material, 0.02);
    EXPECT_EQ(j.tolerances.rapid, 0.03);
    EXPECT_EQ(j.budgets.blocks, 1000U);
    EXPECT_EQ(j.budgets.loop_passes, 500U);
    EXPECT_EQ(j.budgets.simulated_moves, 700U);
    EXPECT_EQ(j.budgets.call_depth, 12U);
    EXPECT_EQ(j.budgets.seconds, 2.5);
    EXPECT_EQ(as_text(j.variables), "#517=3.2 COUNT=3 FLAG=true1 MY[0,0]=1 MY[0,1]=2 MY[1,0]='x' WORD='abc' _GUD=1.5 ");
}

TEST(JobFile, VariablesAreGivenOnceAndElementsOneByOne) {
    const std::string text =
        "program = \"A.MPF\"\n[variables]\n\"A[ 1 ]\" = 2\nA = [5, 6, 7]\n\"B[0]\" = [1]\nC = [[[[1]]]]\n";
    Reading r;
    EXPECT_EQ(as_text(read_job(r.add(text), r.sources, r.diagnostics).variables), "A[0]=5 A[1]=2 A[2]=7 ");
    EXPECT_EQ(job_places(text),
              "4:9: 'A[1]' is given twice (capitals and small letters are the same)\n"
              "5:10: 'B[0]' is one element and cannot hold an array\n"
              "6:8: an array has at most three dimensions\n");
}

TEST(JobFile, EveryToolKeyIsRead) {
    Reading r;
    const Job j = read_job(r.add(everything), r.sources, r.diagnostics);
    ASSERT_EQ(j.tools.size(), 3U);
    const Tool& g = j.tools[0];
    EXPECT_EQ(g.number, 5U);
    EXPECT_EQ(g.edge, 2U);
    EXPECT_EQ(g.name, "GROOVER");
    EXPECT_EQ(g.kind, ToolKind::groove);
    EXPECT_EQ(g.width, 3);
    EXPECT_EQ(g.corner_radius_left, 0.2);
    EXPECT_EQ(g.corner_radius_right, 0.4);
    EXPECT_EQ(g.reference, ReferenceCorner::right);
    EXPECT_EQ(g.direction, BladeDirection::in);
    EXPECT_EQ(g.cutting_depth, 20);
    EXPECT_EQ(g.length, 41.5);
    EXPECT_EQ(parameter(g, 7), 2.5);
    EXPECT_EQ(parameter(g, 3), 41.5);
    EXPECT_FALSE(parameter(g, 8));
    const Tool& t = j.tools[1];
    EXPECT_EQ(t.kind, ToolKind::turning);
    EXPECT_EQ(t.nose_radius, 0.8);
    EXPECT_EQ(t.orientation, 2);
    EXPECT_EQ(t.tip_angle, 55);
    EXPECT_EQ(t.entering_angle, 93);
    EXPECT_EQ(t.edge_length, 11);
    EXPECT_EQ(parameter(t, 2), 2);
    EXPECT_EQ(parameter(t, 6), 0.8);
    EXPECT_EQ(j.tools[2].kind, ToolKind::end_mill);
    EXPECT_EQ(j.tools[2].radius, 5);
    EXPECT_EQ(parameter(j.tools[2], 6), 5);
}

TEST(JobFile, TheJobsDefaultsStandAboveTheMachines) {
    Reading r;
    Job j = read_job(r.add(everything), r.sources, r.diagnostics);
    EXPECT_TRUE(shipped_machine("lathe-generic")->defaults.diameter_programming);
    EXPECT_FALSE(j.machine.defaults.diameter_programming);
    EXPECT_TRUE(j.machine.defaults.inch);
    EXPECT_TRUE(j.machine.defaults.feed_per_rev);
    EXPECT_EQ(j.machine.defaults.plane, 19);
    EXPECT_EQ(j.machine.defaults.circle_tolerance, 0.05);
    Machine other;
    other.name = "other";
    other.defaults.diameter_programming = true;
    other.datums[54] = {1, 1, 1};
    other.datums[55] = {2, 2, 2};
    use_machine(j, other);
    EXPECT_EQ(j.machine.name, "other");
    EXPECT_FALSE(j.machine.defaults.diameter_programming);
    EXPECT_EQ(j.machine.datums.at(54), (geom::Vec3{10, 0, 250}));
    EXPECT_EQ(j.machine.datums.at(55), (geom::Vec3{2, 2, 2}));
}

TEST(JobFile, MachineIsGenericShippedOrAFile) {
    const auto job = [](const std::string& text) {
        Reading r;
        Job j = read_job(r.add("program = \"A\"\n" + text), r.sources, r.diagnostics);
        EXPECT_EQ(r.complaints(), "");
        return j;
    };
    EXPECT_EQ(job("").machine.name, "mill-generic");
    EXPECT_EQ(job("[stock]\nbar = {diameter = 2, length = 3}").machine.name, "lathe-generic");
    EXPECT_EQ(job("[[tool]]\nnumber = 1\nkind = \"turning\"").machine.name, "lathe-generic");
    EXPECT_EQ(job("machine = \"mill-generic\"").machine.name, "mill-generic");
    EXPECT_TRUE(job("machine = \"m/mine.toml\"").machine_is_file);
    EXPECT_EQ(job("machine = \"m/mine.toml\"").machine_name, "m/mine.toml");
}

TEST(JobFile, AnythingGivesAJobAndPlacedComplaints) {
    for (const char* text :
         {"=", "program", "[", "[[tool]", "program = \"", "[stock]\nprofile = [{z=1", "\r\n\r\nx", "tool = [1, 2]",
          "[stock]\nprofile = [[1,2],[3,4]]", "[set]\nR1 = 2024-01-01", "datum = 3", "[[stock]]"}) {
        Reading r;
        const Job j = read_job(r.add(text), r.sources, r.diagnostics);
        EXPECT_TRUE(r.diagnostics.has_errors()) << text;
        for (const base::Diagnostic& d : r.diagnostics.all()) EXPECT_LE(d.where.end, r.sources[0].text.size()) << text;
        EXPECT_FALSE(r.complaints().empty());
        EXPECT_EQ(j.program, "");
    }
}

TEST(JobFile, NumbersBeyondAnyShopAreRefused) {
    EXPECT_EQ(job_places("program = \"A\"\n[stock]\nbar = {diameter = 1e300, length = 1}\n"),
              "3:19: 'diameter' is too large: at most 1000000\n");
}

RC_GTEST_PROP(JobFileProperty, ADamagedFileNeverBreaksTheReader, ()) {
    std::string text = everything;
    text += "[other]\nprofile = [{z=0,x=1,r=2,direction=\"cw\"},{z=3,x=1,r=-9,large=true},{z=9,x=2}]\n";
    const int edits = *rc::gen::inRange(1, 6);
    const std::string letters = "[]{}=\"'#\n\r.,-+019eaz \t\xC5\x9A";
    for (int i = 0; i < edits; ++i) {
        const std::size_t at = *rc::gen::inRange<std::size_t>(0, text.size());
        const std::size_t count = *rc::gen::inRange<std::size_t>(0, 4);
        text.replace(at, count, std::string(1, letters[*rc::gen::inRange<std::size_t>(0, letters.size())]));
    }
    Reading r;
    (void)read_job(r.add(text), r.sources, r.diagnostics);
    for (const base::Diagnostic& d : r.diagnostics.all()) {
        RC_ASSERT(d.where.begin <= d.where.end);
        RC_ASSERT(d.where.end <= r.sources[0].text.size());
        RC_ASSERT(!base::render(d, r.sources).empty());
    }
}

/// The first TOML example of a page of the documentation.
std::string documented(const std::string& page) {
    std::ifstream in(std::string(OBRYS_SOURCE_DIR) + "/docs/" + page);
    std::stringstream text;
    text << in.rdbuf();
    const std::string all = text.str();
    const std::size_t begin = all.find("```toml\n");
    return begin == std::string::npos ? "" : all.substr(begin + 8, all.find("```\n", begin + 8) - begin - 8);
}

TEST(Documentation, ItsExamplesAreRead) {
    Reading r;
    const Job j = read_job(r.add(documented("job-file.md")), r.sources, r.diagnostics);
    const Machine m = read_machine(r.add(documented("machine-file.md"), "m.toml"), r.sources, r.diagnostics);
    EXPECT_EQ(r.complaints(), "");
    EXPECT_TRUE(j.stock && j.part && j.allowance);
    EXPECT_EQ(j.machine.name, "lathe-generic");
    EXPECT_EQ(m.axes.size(), 2U);
}

TEST(JobFile, HeidenhainDatumsAndFolders) {
    Reading r;
    const Job j = read_job(r.add("program = \"A.H\"\ndatum_tables = [\"A.D\", \"B.D\"]\npreset_tables = \"P.PR\"\n"
                                 "prints = \"out\"\n[datum]\npreset0 = {x = 1}\nPRESET99999 = {z = 2}\n"
                                 "active_preset = {y = 3}\n"),
                           r.sources, r.diagnostics);
    EXPECT_EQ(r.complaints(), "");
    EXPECT_EQ(paths(j.datum_tables), (std::vector<std::string>{"A.D", "B.D"}));
    EXPECT_EQ(paths(j.preset_tables), (std::vector<std::string>{"P.PR"}));
    EXPECT_EQ(j.prints, "out");
    EXPECT_EQ(j.machine.datums.at(first_preset), (geom::Vec3{1, 0, 0}));
    EXPECT_EQ(j.machine.datums.at(first_preset + 99999), (geom::Vec3{0, 0, 2}));
    EXPECT_EQ(j.machine.datums.at(500), (geom::Vec3{0, 3, 0}));
    EXPECT_EQ(job_places("program = \"A.H\"\n[datum]\npreset100000 = {}\npreset = {}\n"),
              "3:1: unknown key 'preset100000' in [datum]\n4:1: unknown key 'preset' in [datum]\n");
}

}  // namespace
}  // namespace obrys::shop
