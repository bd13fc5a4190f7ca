#include <cmath>

#include "shop/files/obrys/job_testing.hpp"
#include "shop/files/obrys/tool_file.hpp"

namespace obrys::shop {
namespace {

TEST(MillingJob, TheExampleOfTheIssueIsRead) {
    Reading r;
    const Job j = read_job(r.add(R"(machine = "mill-generic"
[[tool]]
number = 1
kind = "ball"
diameter = 6.0
length = 50.0
[stock]
box = { min = [0.0, 0.0, -10.0], max = [100.0, 100.0, 0.0] }
[part]
file = "part.stl"
)"),
                           r.sources, r.diagnostics);
    EXPECT_EQ(r.complaints(), "");
    EXPECT_EQ(j.machine.name, "mill-generic");
    ASSERT_EQ(j.tools.size(), 1U);
    EXPECT_EQ(j.tools[0].kind, ToolKind::ball);
    EXPECT_EQ(j.tools[0].radius, 3);
    EXPECT_EQ(j.tools[0].corner_radius, 3);
    EXPECT_EQ(j.tools[0].length, 50);
    EXPECT_EQ(cutting_height(j.tools[0]), 50);
    ASSERT_TRUE(j.solid_stock);
    const auto& box = std::get<SolidBox>(j.solid_stock->solid);
    EXPECT_EQ(box.min, (geom::Vec3{0, 0, -10}));
    EXPECT_EQ(box.max, (geom::Vec3{100, 100, 0}));
    ASSERT_TRUE(j.solid_part);
    EXPECT_EQ(j.solid_part->file.path, "part.stl");
    EXPECT_EQ(j.solid_part->file.unit, 1);
    EXPECT_EQ(r.sources.text(j.solid_part->file.where), "\"part.stl\"");
    EXPECT_FALSE(j.stock || j.part || j.tolerances.simulation);
}

const char* const every_kind = R"(
[[tool]]
number = 1
kind = "end-mill"
diameter = 10
length = 120
cutting_length = 22
teeth = 4
plunges = false
shank = [{diameter = 10, length = 30}, {diameter = 10, upper_diameter = 12, length = 3.5}]
holder = [{diameter = 40, length = 50}]
[[tool]]
number = 2
kind = "bull-nose"
radius = 8
corner_radius = 1.5
[[tool]]
number = 3
kind = "drill"
diameter = 8.5
point_angle = 140
[[tool]]
number = 4
kind = "centre-drill"
diameter = 6
[[tool]]
number = 5
kind = "countersink"
diameter = 20
tip_diameter = 2
[[tool]]
number = 6
kind = "tap"
diameter = 8
pitch = 1.25
[[tool]]
number = 7
kind = "reamer"
diameter = 8
[[tool]]
number = 8
kind = "chamfer"
diameter = 12
point_angle = 60
[[tool]]
number = 9
kind = "t-slot"
diameter = 25
width = 11
neck_diameter = 12
corner_radius = 0.5
[[tool]]
number = 10
kind = "form"
profile = [[0, 0], {x = 2, z = 0, r = -3}, [5, 3.0], [5, 20]]
)";

TEST(MillingJob, EveryKindIsRead) {
    Reading r;
    const std::vector<Tool> t = read_tools(r.add(every_kind, "t.toml"), r.sources, r.diagnostics);
    EXPECT_EQ(r.complaints(), "");
    ASSERT_EQ(t.size(), 10U);
    using enum ToolKind;
    const std::array kinds{end_mill, bull_nose, drill, centre_drill, countersink, tap, reamer, chamfer, t_slot, form};
    for (std::size_t i = 0; i < kinds.size(); ++i) {
        EXPECT_EQ(t[i].kind, kinds[i]) << i;
        EXPECT_EQ(assumed_kind(t[i]), kinds[i]) << i;
        EXPECT_TRUE(dimension_fault(t[i]).ok()) << dimension_fault(t[i]).text;
        EXPECT_TRUE(outline(t[i]).vertices.empty());
    }
    EXPECT_EQ(t[0].radius, 5);
    EXPECT_EQ(t[0].teeth, 4);
    EXPECT_EQ(t[0].cutting_length, 22);
    EXPECT_EQ(t[0].plunges, false);
    ASSERT_EQ(t[0].shank.size(), 2U);
    EXPECT_EQ(t[0].shank[0].upper_diameter, 10);
    EXPECT_EQ(t[0].shank[1].lower_diameter, 10);
    EXPECT_EQ(t[0].shank[1].upper_diameter, 12);
    EXPECT_EQ(t[0].shank[1].length, 3.5);
    ASSERT_EQ(t[0].holder.size(), 1U);
    EXPECT_EQ(t[0].holder[0].length, 50);
    EXPECT_EQ(t[1].radius, 8);
    EXPECT_EQ(t[1].corner_radius, 1.5);
    EXPECT_EQ(t[2].point_angle, 140);
    EXPECT_EQ(t[3].point_angle, 90);
    EXPECT_EQ(t[4].point_angle, 90);
    EXPECT_EQ(t[4].tip_diameter, 2);
    EXPECT_EQ(t[5].pitch, 1.25);
    EXPECT_EQ(t[7].point_angle, 60);
    EXPECT_EQ(t[8].width, 11);
    EXPECT_EQ(t[8].neck_diameter, 12);
    EXPECT_EQ(t[9].radius, 5);
    ASSERT_EQ(t[9].profile.size(), 4U);
    EXPECT_EQ(t[9].profile[1].p, (geom::Vec2{2, 0}));
    EXPECT_NEAR(t[9].profile[1].bulge, -std::tan(geom::pi / 8), 1e-12);  // a quarter circle
}

TEST(MillingJob, WhatFollowsFromTheDimensions) {
    Reading r;
    const std::vector<Tool> t = read_tools(r.add(every_kind, "t.toml"), r.sources, r.diagnostics);
    ASSERT_EQ(t.size(), 10U);
    EXPECT_EQ(point_height(t[0]), 0);
    EXPECT_NEAR(point_height(t[2]), 4.25 / std::tan(geom::radians(70)), 1e-12);
    EXPECT_NEAR(point_height(t[4]), 9, 1e-12);
    const std::array plunge{false, true, true, true, false, false, false, true, false, true};
    for (std::size_t i = 0; i < plunge.size(); ++i) EXPECT_EQ(may_plunge(t[i]), plunge[i]) << i;
    EXPECT_EQ(cutting_height(t[0]), 22);
    EXPECT_EQ(cutting_height(t[1]), std::nullopt);
    EXPECT_EQ(cutting_height(t[8]), 11);
    EXPECT_EQ(cutting_height(t[9]), 20);
    Tool no_edge = t[0];
    no_edge.cutting_length.reset();
    EXPECT_EQ(cutting_height(no_edge), 120 - 33.5 - 50);
    Tool ramped = t[1];
    ramped.plunge_angle = 3;
    EXPECT_FALSE(may_plunge(ramped));
}

TEST(MillingJob, AMillIsWhatItsCornerRadiusMakesOfIt) {
    Reading r;
    const auto t = read_tools(r.add("[[tool]]\nnumber = 1\nkind = \"mill\"\ndiameter = 10\ncorner_radius = 5\n"
                                    "[[tool]]\nnumber = 2\nkind = \"mill\"\nradius = 5\ncorner_radius = 1\n"
                                    "[[tool]]\nnumber = 3\nkind = \"mill\"\n"),
                              r.sources, r.diagnostics);
    EXPECT_EQ(r.complaints(), "");
    ASSERT_EQ(t.size(), 3U);
    EXPECT_EQ(t[0].kind, ToolKind::ball);
    EXPECT_EQ(t[1].kind, ToolKind::bull_nose);
    EXPECT_EQ(t[2].kind, ToolKind::other);
    EXPECT_EQ(assumed_kind(t[2]), ToolKind::other);
    Tool unsaid;
    unsaid.radius = 4;
    EXPECT_EQ(assumed_kind(unsaid), ToolKind::end_mill);
}

/// What is wrong with one tool of that kind, and that it is left out.
std::string tool_fault(const std::string& kind, const std::string& keys) {
    Reading r;
    const auto tools =
        read_tools(r.add("[[tool]]\nnumber = 1\nkind = \"" + kind + "\"\n" + keys), r.sources, r.diagnostics);
    std::string out = tools.empty() ? "" : "NOT LEFT OUT ";
    for (const base::Diagnostic& d : r.diagnostics.all()) {
        const base::Position p = r.sources.position(d.where);
        out += (out.empty() ? "" : "; ") + std::to_string(p.line) + ":" + std::to_string(p.column) + ": " + d.text;
    }
    return out;
}

TEST(MillingJob, DimensionsThatMakeNoToolAreSaidWithTheirPlace) {
    EXPECT_EQ(tool_fault("end-mill", "diameter = 0"), "4:12: 'diameter' must be greater than 0, not 0");
    EXPECT_EQ(tool_fault("end-mill", "radius = 0"), "4:10: the diameter must be greater than 0");
    EXPECT_EQ(tool_fault("end-mill", "diameter = -4"), "4:12: 'diameter' must be greater than 0, not -4");
    EXPECT_EQ(tool_fault("end-mill", ""), "1:1: [[tool]] has no 'diameter'");
    EXPECT_EQ(tool_fault("end-mill", "diameter = 4\nradius = 2"), "5:1: [[tool]] has both 'diameter' and 'radius'");
    EXPECT_EQ(tool_fault("end-mill", "diameter = 4\ncutting_length = 0"),
              "5:18: 'cutting_length' must be greater than 0, not 0");
    EXPECT_EQ(tool_fault("end-mill", "diameter = 4\ncorner_radius = 1"),
              "5:1: 'corner_radius' means nothing for a tool of kind \"end-mill\"");
    EXPECT_EQ(tool_fault("end-mill", "diameter = 4\nnose_radius = 1"),
              "5:1: 'nose_radius' means nothing for a tool of kind \"end-mill\"");
    EXPECT_EQ(tool_fault("end-mill", "diamter = 4"),
              "1:1: [[tool]] has no 'diameter'; 4:1: unknown key 'diamter' in [[tool]]");
    EXPECT_EQ(tool_fault("bull-nose", "diameter = 4"), "1:1: [[tool]] has no 'corner_radius'");
    EXPECT_EQ(tool_fault("bull-nose", "diameter = 4\ncorner_radius = 2.5"),
              "5:17: the corner radius (2.5 mm) is greater than the tool's radius (2 mm)");
    EXPECT_EQ(tool_fault("ball", "diameter = 8\ncutting_length = 3"),
              "5:18: the cutting length (3 mm) is shorter than the corner radius (4 mm)");
    EXPECT_EQ(tool_fault("drill", "diameter = 8\npoint_angle = 190"),
              "5:15: the point angle must be above 0 and at most 180 degrees, it is 190");
    EXPECT_EQ(tool_fault("drill", "diameter = 8\npoint_angle = 90\ncutting_length = 3"),
              "6:18: the cutting length (3 mm) is shorter than the point, which is 4.000 mm high");
    EXPECT_EQ(tool_fault("chamfer", "diameter = 8\npoint_angle = 180"),
              "5:15: the point angle must be above 0 and below 180 degrees, it is 180");
    EXPECT_EQ(tool_fault("countersink", "diameter = 8\ntip_diameter = 8"),
              "5:16: the tip diameter (8 mm) must be smaller than the diameter (8 mm)");
    EXPECT_EQ(tool_fault("t-slot", "diameter = 8\nwidth = 2"), "1:1: [[tool]] has no 'neck_diameter'");
    EXPECT_EQ(tool_fault("t-slot", "diameter = 8\nwidth = 2\nneck_diameter = 9"),
              "6:17: the neck diameter (9 mm) must be smaller than the diameter (8 mm)");
    EXPECT_EQ(tool_fault("t-slot", "diameter = 8\nwidth = 2\nneck_diameter = 4\ncorner_radius = 1.5"),
              "7:17: two corner radii of 1.5 mm do not fit on a width of 2 mm");
    EXPECT_EQ(tool_fault("end-mill", "diameter = 8\nshank = [{diameter = 8}, {diameter = 0, length = 1}]"),
              "5:10: a body of 'shank' has no 'length'; 5:38: 'diameter' must be greater than 0, not 0");
    const std::string bodies =
        "diameter = 8\nshank = [{diameter = 8, length = 20}]\nholder = [{diameter = 60, length = 40}]\n";
    EXPECT_EQ(tool_fault("end-mill", bodies + "length = 60"),
              "7:10: the length (60 mm) leaves nothing for the edges: shank and holder are 60 mm long together");
    EXPECT_EQ(tool_fault("end-mill", bodies + "cutting_length = 15\nlength = 75"), "NOT LEFT OUT ");
    EXPECT_EQ(
        tool_fault("end-mill", "diameter = 8\ncutting_length = 65\nlength = 40"),
        "5:18: the cutting edges (65 mm) are longer than the tool, which reaches 40 mm from the gauge plane to the "
        "tip ('length')");
    EXPECT_EQ(tool_fault("end-mill", "diameter = 8\ncutting_length = 40\nlength = 40"), "NOT LEFT OUT ");
    EXPECT_EQ(tool_fault("tap", "diameter = 8\npitch = 0"), "5:9: 'pitch' must be greater than 0, not 0");
    EXPECT_EQ(tool_fault("tap", "diameter = inf"), "4:12: 'diameter' must be a finite number");
}

TEST(MillingJob, ProfilesOfFormToolsAreHeldToTheAxis) {
    EXPECT_EQ(tool_fault("form", ""), "1:1: [[tool]] has no 'profile'");
    EXPECT_EQ(tool_fault("form", "profile = 3"), "4:11: 'profile' must be an array of points, not a whole number");
    EXPECT_EQ(tool_fault("form", "profile = []"), "4:1: the profile is empty");
    EXPECT_EQ(tool_fault("form", "profile = [[0, 0]]"), "4:1: the profile has only one point");
    EXPECT_EQ(tool_fault("form", "profile = [[0, 0], [1]]"),
              "4:20: a point of a tool's profile must be [radius, height] or {x, z}");
    EXPECT_EQ(tool_fault("form", "profile = [[0, 0], [-1, 2]]"),
              "4:21: the radius of a profile point must not be negative, it is -1");
    EXPECT_EQ(tool_fault("form", "profile = [[0, 1], [1, 2]]"),
              "4:12: the profile begins at height 0, the tip, not at 1");
    EXPECT_EQ(tool_fault("form", "profile = [[0, 0], [1, 2], [3, 1]]"),
              "4:20: the profile goes down behind this point");
    EXPECT_EQ(tool_fault("form", "profile = [[0, 0], [3, 0]]"), "4:1: the profile has no height");
    EXPECT_EQ(tool_fault("form", "profile = [[0, 0], [3, 0], [3, 0]]"), "4:20: this point is the same as the next one");
    // ball end as an arc from the tip: fine; the same arc the other way round goes down behind its highest point
    EXPECT_EQ(tool_fault("form", "profile = [{x = 0, z = 0, r = 3}, [3, 3], [3, 9]]"), "NOT LEFT OUT ");
    EXPECT_EQ(tool_fault("form", "profile = [{x = 3, z = 0, r = 3, large = true}, [3, 3]]"),
              "4:12: the profile goes down behind this point");
    EXPECT_EQ(tool_fault("form", "profile = [{x = 0, z = 0, r = 1}, [3, 3]]"),
              "4:31: radius 1 mm is too small: the next point is 4.243 mm away");
    // a half circle of radius 2 about (1, 2), open towards the axis side
    EXPECT_EQ(tool_fault("form", "profile = [{x = 1, z = 0, r = -2}, [1, 4]]"),
              "4:12: the arc from this point crosses the tool's axis");
    EXPECT_EQ(tool_fault("form", "profile = [[1, 0], {x = 1, z = 4, r = 2}]"),
              "4:39: 'r' on the last point: no edge follows it");
}

TEST(MillingJob, StockPartAndClampsArePlaced) {
    Reading r;
    const Job j = read_job(r.add(R"([stock]
cylinder = { diameter = 50, min = -20, max = 5, axis = "x", centre = [7, 8] }
offset = [1, 2, 3]
[part]
file = "p.stl"
unit = "inch"
offset = [0, 0, -1.5]
[check]
tolerance = 0.02
[[clamp]]
name = "vice"
box = { min = [0, 0, 0], max = [1, 2, 3] }
offset = [10, 0, 0]
[[clamp]]
file = "jaw.stl"
[[clamp]]
cylinder = { radius = 4, min = 0, max = 9 }
)"),
                           r.sources, r.diagnostics);
    EXPECT_EQ(r.complaints(), "");
    EXPECT_EQ(j.machine.kind, MachineKind::mill);
    const auto& bar = std::get<SolidCylinder>(j.solid_stock.value().solid);
    EXPECT_EQ(bar.axis, 0);
    EXPECT_EQ(bar.radius, 25);
    EXPECT_EQ(bar.centre, (geom::Vec3{0, 9, 11}));
    EXPECT_EQ(bar.min, -19);
    EXPECT_EQ(bar.max, 6);
    EXPECT_EQ(j.solid_part.value().file.unit, 25.4);
    EXPECT_EQ(j.solid_part->file.offset, (geom::Vec3{0, 0, -1.5}));
    EXPECT_EQ(j.tolerances.simulation, 0.02);
    ASSERT_EQ(j.clamps.size(), 3U);
    EXPECT_EQ(j.clamps[0].name, "vice");
    EXPECT_EQ(std::get<SolidBox>(j.clamps[0].solid).min, (geom::Vec3{10, 0, 0}));
    EXPECT_EQ(j.clamps[1].name, "clamp 2");
    EXPECT_EQ(std::get<SolidFile>(j.clamps[1].solid).path, "jaw.stl");
    EXPECT_EQ(std::get<SolidCylinder>(j.clamps[2].solid).axis, 2);
}

TEST(MillingJob, NamesOfStepFiles) {
    for (const char* name : {"a.step", "a.stp", "b/A.STEP", "a.stl.Stp"}) EXPECT_TRUE(is_step_name(name)) << name;
    for (const char* name : {"a.stl", "step", "a.step.stl", "a.stepx", "stp.", ""}) EXPECT_FALSE(is_step_name(name));
}

TEST(MillingJob, MistakesOfBodies) {
    EXPECT_EQ(job_places("[stock]\nbox = { min = [0, 0, 5], max = [1, 1, 5] }\n"),
              "2:39: 'max' must be greater than 'min' in z: 5 is not greater than 5\n");
    EXPECT_EQ(job_places("[stock]\nbox = { min = [0, 0], max = 3 }\n"),
              "2:15: 'min' must be an array of three numbers: x, y, z\n2:29: 'max' must be an array of three numbers: "
              "x, y, z\n");
    EXPECT_EQ(job_places("[stock]\nbox = { min = [0, 0, \"a\"] }\n"),
              "2:7: 'box' has no 'max'\n2:22: a coordinate of 'min' must be a number, not text\n");
    EXPECT_EQ(job_places("[stock]\nbox = 3\n"), "2:7: 'box' must be a table, not a whole number\n");
    EXPECT_EQ(job_places("[stock]\ncylinder = { diameter = 0, min = 4, max = 4 }\n"),
              "2:25: 'diameter' must be greater than 0, not 0\n");
    EXPECT_EQ(job_places("[stock]\ncylinder = { min = 4, max = 4, centre = [1] }\n"),
              "2:12: 'cylinder' has no 'diameter'\n2:41: 'centre' must be an array of two numbers: the centre in the "
              "two other axes\n");
    EXPECT_EQ(job_places("[stock]\ncylinder = { radius = 2, min = 4, max = 4 }\n"),
              "2:41: 'max' must be greater than 'min'\n");
    EXPECT_EQ(job_places("[stock]\nbox = { min = [0, 0, 0], max = [1, 1, 5] }\nfile = \"a.stl\"\n"),
              "3:1: [stock] has both 'box' and 'file'\n");
    EXPECT_EQ(job_places("[stock]\nfile = \"a.stl\"\nunit = \"cm\"\n"), "3:8: 'unit' cannot be \"cm\"\n");
    EXPECT_EQ(job_places("[stock]\nfile = \"a.Stp\"\nunit = \"mm\"\n"),
              "3:8: 'unit' does not go with a STEP file, which says its unit itself\n");
    EXPECT_EQ(job_places("[stock]\nbox = { min = [0, 0, 0], max = [1, 1, 5] }\nunit = \"mm\"\n"),
              "3:8: 'unit' means nothing without a 'file'\n");
    EXPECT_EQ(job_places("[stock]\nbar = { diameter = 5, length = 5 }\noffset = [0, 0, 0]\n"),
              "3:1: 'offset' means nothing for this stock\n");
    EXPECT_EQ(job_places("[stock]\nbar = { diameter = 5, length = 5 }\n[part]\nfile = \"a.stl\"\n"),
              "3:1: this part is milled, and the stock is one of turning\n");
    EXPECT_EQ(job_places("[[clamp]]\nname = \"a\"\n"), "1:1: [[clamp]] says nothing\n");
    EXPECT_EQ(job_places("[part]\nfile = \"\"\n"), "2:8: 'file' is empty\n");
}

}  // namespace
}  // namespace obrys::shop
