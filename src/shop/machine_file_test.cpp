#include "shop/shop_test.hpp"

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
[machine_data]
"$MC_DIAMETER_AX_DEF" = 1
mn_max = 2
)", "m.toml"), r.sources, r.diagnostics);
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
    EXPECT_EQ(m.machine_data, (std::map<std::string, double>{{"$MC_DIAMETER_AX_DEF", 1}, {"$MN_MAX", 2}}));
}

TEST(MachineFile, Mistakes) {
    Reading r;
    (void)read_machine(r.add("kind = \"lath\"\n[spindle]\nmin = 9\nmax = 5\n[[axis]]\nname = \"X\"\nmin = 5\nmax = 5\n[[axis]]\nname = \"x\"\n"
                             "[[axis]]\n[machine_data]\nFOO = 1\n", "m.toml"), r.sources, r.diagnostics);
    EXPECT_EQ(r.complaints(),
              "m.toml:1:8: error: 'kind' cannot be \"lath\" [job-value]\n  kind = \"lath\"\n         ^~~~~~\n  remedy: one of: lathe, mill\n"
              "m.toml:3:7: error: 'min' must not be greater than 'max' [job-value]\n  min = 9\n        ^\n"
              "m.toml:8:7: error: 'max' must be greater than 'min' [job-value]\n  max = 5\n        ^\n"
              "m.toml:10:8: error: axis X is defined twice [job-value]\n  name = \"x\"\n         ^~~\n"
              "m.toml:11:1: error: [[axis]] has no 'name' [job-value]\n  [[axis]]\n  ^\n"
              "m.toml:13:1: error: 'FOO' is not the name of a machine datum [job-file]\n  FOO = 1\n  ^~~\n  remedy: $MN_…, $MC_… or $MA_…\n");
}

TEST(MachineFile, ShippedMachinesAreBuiltInAndRefuseNothing) {
    EXPECT_EQ(shipped_machine_names(), (std::vector<std::string>{"lathe-generic", "mill-generic"}));
    EXPECT_FALSE(shipped_machine("lathe"));
    for (const std::string& name : shipped_machine_names()) {
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

}  // namespace
}  // namespace obrys::shop
