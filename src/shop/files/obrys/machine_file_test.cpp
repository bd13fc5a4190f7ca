#include <array>
#include <fstream>
#include <sstream>

#include "shop/files/obrys/machine_file.hpp"
#include "shop/reading_testing.hpp"

namespace obrys::shop {
namespace {

TEST(MachineFile, EveryKeyIsRead) {
    Reading r;
    const Machine m = read_machine(r.add(R"(name = "SUI 80"
kind = "lathe"
max_feed = 8000
tool_change_time = 1.5
[defaults]
diameter_programming = true
[spindle]
min = 20
max = 2500
[[axis]]
name = "x"
min = -10
max = 250.5
rapid = 7500
home = 240
[[axis]]
name = "C2"
rotary = true
[datum]
diameter = true
G54 = {x = 20, z = 300}
[control]
g_code_system = "B"
whole_numbers = "units"
increment = 0.0001
[machine_data]
"$MC_DIAMETER_AX_DEF" = 1
mn_max = 2
)",
                                         "m.toml"),
                                   r.sources, r.diagnostics);
    EXPECT_EQ(r.complaints(), "");
    EXPECT_EQ(m.name, "SUI 80");
    EXPECT_EQ(m.kind, MachineKind::lathe);
    EXPECT_EQ(m.max_feed, 8000);
    EXPECT_EQ(m.tool_change_time, 1.5);
    EXPECT_TRUE(m.defaults.diameter_programming);
    EXPECT_EQ(m.defaults.plane, 18);
    EXPECT_EQ(m.spindle.min, 20);
    EXPECT_EQ(m.spindle.max, 2500);
    ASSERT_EQ(m.axes.size(), 2U);
    EXPECT_EQ(m.axes[0].name, "X");
    EXPECT_EQ(m.axes[0].min, -10);
    EXPECT_EQ(m.axes[0].max, 250.5);
    EXPECT_EQ(m.axes[0].rapid, 7500);
    EXPECT_EQ(m.axes[0].home, 240);
    EXPECT_TRUE(m.axes[1].rotary);
    EXPECT_FALSE(m.axes[1].min);
    EXPECT_EQ(m.datums.at(54), (geom::Vec3{10, 0, 300}));
    EXPECT_EQ(m.control.g_code_system, 'B');
    EXPECT_EQ(m.control.whole_numbers_count, false);
    EXPECT_EQ(m.control.increments_per_mm, 10000);
    EXPECT_EQ(m.machine_data, (std::map<std::string, double>{{"$MC_DIAMETER_AX_DEF", 1}, {"$MN_MAX", 2}}));
}

TEST(MachineFile, Mistakes) {
    Reading r;
    (void)read_machine(r.add("kind = \"lath\"\n[spindle]\nmin = 9\nmax = 5\n[[axis]]\nname = \"X\"\nmin = 5\nmax = "
                             "5\n[[axis]]\nname = \"x\"\n"
                             "[[axis]]\n[machine_data]\nFOO = 1\n",
                             "m.toml"),
                       r.sources, r.diagnostics);
    EXPECT_EQ(r.complaints(),
              "m.toml:1:8: error: 'kind' cannot be \"lath\" [job-value]\n  kind = \"lath\"\n         ^~~~~~\n  remedy: "
              "did you mean \"lathe\"? one of: lathe, mill\n"
              "m.toml:3:7: error: 'min' must not be greater than 'max' [job-value]\n  min = 9\n        ^\n"
              "m.toml:8:7: error: 'max' must be greater than 'min' [job-value]\n  max = 5\n        ^\n"
              "m.toml:10:8: error: axis X is defined twice [job-value]\n  name = \"x\"\n         ^~~\n"
              "m.toml:11:1: error: [[axis]] has no 'name' [job-value]\n  [[axis]]\n  ^\n"
              "m.toml:13:1: error: 'FOO' is not the name of a machine datum [job-file]\n  FOO = 1\n  ^~~\n  remedy: "
              "$MN_…, $MC_… or $MA_…\n");
}

TEST(MachineFile, ShippedMachinesAreBuiltInAndTheGenericOnesRefuseNothing) {
    EXPECT_EQ(shipped_machine_names(),
              (std::vector<std::string>{"fv25cnc-a", "hermle-u1130", "lathe-generic", "mill-generic", "vmc500"}));
    EXPECT_FALSE(shipped_machine("lathe"));
    for (const std::string& name : shipped_machine_names()) {
        Reading r;
        std::ifstream in(std::string(OBRYS_SOURCE_DIR) + "/machines/" + name + ".toml");
        std::stringstream text;
        text << in.rdbuf();
        const Machine read = read_machine(r.add(text.str(), name), r.sources, r.diagnostics);
        EXPECT_EQ(r.complaints(), "");
        EXPECT_EQ(read.name, shipped_machine(name)->name);
    }
    for (const std::string name : {"lathe-generic", "mill-generic"}) {
        const Machine m = shipped_machine(name).value();
        EXPECT_EQ(m.name, name);
        EXPECT_EQ(m.max_feed, 0);
        for (const MachineAxis& a : m.axes) EXPECT_FALSE(a.min || a.max);
    }
    const Machine lathe = shipped_machine("lathe-generic").value();
    EXPECT_EQ(lathe.kind, MachineKind::lathe);
    EXPECT_TRUE(lathe.defaults.diameter_programming);
    EXPECT_EQ(lathe.defaults.plane, 18);
    EXPECT_EQ(lathe.axes.size(), 3U);
    EXPECT_EQ(lathe.axes[0].rapid, 10000);
    EXPECT_EQ(shipped_machine("mill-generic")->defaults.plane, 17);
}

TEST(MachineFile, TheFv25HasTheFiguresOfItsDataSheet) {
    const Machine m = shipped_machine("fv25cnc-a").value();
    EXPECT_EQ(m.min_feed, 2.5);
    EXPECT_EQ(m.max_feed, 3000);
    EXPECT_EQ(m.spindle.min, 50);
    EXPECT_EQ(m.spindle.max, 6000);
    EXPECT_EQ(m.spindle.power, 5.5);
    ASSERT_EQ(m.axes.size(), 3U);
    const std::array travel{760.0, 355.0, 152.0};
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_EQ(*m.axes[i].max - *m.axes[i].min, travel[i]);
        EXPECT_EQ(m.axes[i].rapid, 9000);
    }
    EXPECT_EQ(m.rapid_path, RapidPath::straight);
    EXPECT_EQ(m.tool_change_position, (std::map<std::string, double>{{"Z", 0}}));
}

TEST(MachineFile, KinematicsAreRead) {
    Reading r;
    const Machine m = read_machine(r.add(R"(kind = "mill"
rapid = "dog-leg"
min_feed = 2
max_feed = 5000
chain = ["c", "X", "Y", "Z", "S1"]
tool_change_position = { z = 1, X = -5 }
[spindle]
power = 11
[[axis]]
name = "X"
[[axis]]
name = "Y"
direction = [0, 3, 4]
[[axis]]
name = "Z"
[[axis]]
name = "C"
rotary = true
centre = [1, 2, 3]
direction = [0, 0, -1]
[[axis]]
name = "S1"
rotary = true
direction = [0, 1, 0]
)",
                                         "m.toml"),
                                   r.sources, r.diagnostics);
    EXPECT_EQ(r.complaints(), "");
    EXPECT_EQ(m.chain, (std::vector<std::size_t>{3, 0, 1, 2, 4}));
    EXPECT_EQ(m.rapid_path, RapidPath::dog_leg);
    EXPECT_EQ(m.spindle.power, 11);
    EXPECT_EQ(m.axes[0].direction, (geom::Vec3{1, 0, 0}));
    EXPECT_NEAR(m.axes[1].direction.y, 0.6, 1e-15);
    EXPECT_EQ(m.axes[3].direction, (geom::Vec3{0, 0, -1}));
    EXPECT_EQ(m.axes[3].centre, (geom::Vec3{1, 2, 3}));
    EXPECT_EQ(m.tool_change_position, (std::map<std::string, double>{{"X", -5}, {"Z", 1}}));
}

TEST(MachineFile, MistakesOfKinematics) {
    Reading r;
    const Machine m = read_machine(
        r.add(
            "kind = \"mill\"\nrapid = \"bent\"\nmin_feed = 9\nmax_feed = 5\nchain = [\"X\", \"Q\", 3, \"x\", \"S1\"]\n"
            "tool_change_position = { q = 1 }\n[spindle]\npower = 0\n[[axis]]\nname = \"X\"\ncentre = [1, 2, 3]\n"
            "direction = [0, 0, 0]\n[[axis]]\nname = \"S1\"\nrotary = true\n",
            "m.toml"),
        r.sources, r.diagnostics);
    std::string places;
    for (const base::Diagnostic& d : r.diagnostics.all()) {
        const base::Position p = r.sources.position(d.where);
        places += std::to_string(p.line) + ":" + std::to_string(p.column) + ": " + d.text + "\n";
    }
    EXPECT_EQ(places,
              "2:9: 'rapid' cannot be \"bent\"\n"
              "3:12: 'min_feed' must not be greater than 'max_feed'\n"
              "5:15: 'chain' names an axis that the machine does not have: Q\n"
              "5:20: an item of 'chain' must be the name of an axis\n"
              "5:23: 'chain' names axis X twice\n"
              "5:28: axis S1 has no 'direction', and its name does not say one\n"
              "6:26: 'tool_change_position' names an axis that the machine does not have: q\n"
              "8:9: 'power' must be greater than 0, not 0\n"
              "11:1: 'centre' means nothing for an axis that does not turn\n"
              "12:13: 'direction' must not be 0\n");
    EXPECT_TRUE(m.chain.empty());
}

}  // namespace
}  // namespace obrys::shop
