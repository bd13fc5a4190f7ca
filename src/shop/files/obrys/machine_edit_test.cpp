/// Values put into the text of a machine file: what is read of it afterwards, and that the rest stays.

#include "shop/files/obrys/machine_edit.hpp"

#include "shop/files/obrys/machine_file.hpp"
#include "shop/reading_testing.hpp"

namespace obrys::shop {
namespace {

constexpr const char* plain = R"(# a mill
name = "mill"
kind = "mill"   # of the shop
[motion]
jerk = 20000   # m/s3 are 20
[[axis]]
name = "X"
rapid = 9000   # mm/min
[[axis]]
name = "Y"
)";

TEST(MachineEdit, values_are_replaced_or_added_and_read_back) {
    Reading r;
    const std::uint32_t file = r.add(plain, "m.toml");
    const std::vector<NewValue> values{{"motion.jerk", "31000", "calibrated from \"a.csv\""},
                                       {"motion.servo_gain", "17.5", "calibrated"},
                                       {"axis.X.rapid", "9500", "calibrated"},
                                       {"axis.Y.rapid", "9600", "calibrated"},
                                       {"tool_change_time", "6.5", "calibrated"}};
    const auto text = with_values(file, r.sources, values);
    ASSERT_TRUE(text);
    EXPECT_NE(text->find("jerk = 31000   # m/s3 are 20\n"), std::string::npos) << *text;
    EXPECT_NE(text->find("kind = \"mill\"   # of the shop\n"), std::string::npos) << *text;
    const Machine m = read_machine(r.add(*text, "n.toml"), r.sources, r.diagnostics);
    EXPECT_EQ(r.complaints(), "") << *text;
    EXPECT_EQ(m.motion.jerk, 31000);
    EXPECT_EQ(m.motion.servo_gain, 17.5);
    EXPECT_EQ(m.axes[0].rapid, 9500);
    EXPECT_EQ(m.axes[1].rapid, 9600);
    EXPECT_EQ(m.tool_change_time, 6.5);
    EXPECT_EQ(m.origins.at("motion.jerk"), "calibrated from \"a.csv\"");
    EXPECT_EQ(m.origins.at("axis.Y.rapid"), "calibrated");

    // Once more over the result: values and origins are replaced, nothing is said twice.
    const std::vector<NewValue> again{{"axis.Y.rapid", "9700", "data sheet"}};
    const auto second = with_values(r.add(*text, "o.toml"), r.sources, again);
    ASSERT_TRUE(second);
    const Machine n = read_machine(r.add(*second, "p.toml"), r.sources, r.diagnostics);
    EXPECT_EQ(r.complaints(), "") << *second;
    EXPECT_EQ(n.axes[1].rapid, 9700);
    EXPECT_EQ(n.origins.at("axis.Y.rapid"), "data sheet");
}

TEST(MachineEdit, origins_are_of_values_that_the_file_says) {
    Reading r;
    const Machine m = read_machine(r.add(R"(kind = "mill"
tool_change_time = 4
[[axis]]
name = "X"
rapid = 9000
[origin]
tool_change_time = "stop watch"
"axis.rapid" = "data sheet"
"motion.jerk" = "assumed"
"motion.jrek" = "assumed"
)",
                                         "m.toml"),
                                   r.sources, r.diagnostics);
    EXPECT_EQ(m.origins.at("tool_change_time"), "stop watch");
    EXPECT_EQ(m.origins.at("axis.rapid"), "data sheet");
    EXPECT_FALSE(m.origins.contains("motion.jerk"));
    EXPECT_NE(r.complaints().find("m.toml:9:1: "), std::string::npos) << r.complaints();
    EXPECT_NE(r.complaints().find("m.toml:10:1: "), std::string::npos) << r.complaints();
}

}  // namespace
}  // namespace obrys::shop
