#include "driver/program_blank.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "base/codes.hpp"

namespace obrys::driver {
namespace {

program::Unit with_blank(std::array<double, 3> min, std::array<double, 3> max) {
    program::Unit unit;
    unit.blank.emplace();
    unit.blank->min = min;
    unit.blank->max = max;
    return unit;
}

TEST(ProgramBlank, ABoxInMillimetres) {
    base::Diagnostics d;
    program::Unit unit = with_blank({-1, 0, -2}, {1, 3, 0});
    const auto mm = program_blank(unit, d);
    ASSERT_TRUE(mm);
    EXPECT_EQ(std::get<shop::SolidBox>(mm->solid).min, (geom::Vec3{-1, 0, -2}));
    EXPECT_EQ(std::get<shop::SolidBox>(mm->solid).max, (geom::Vec3{1, 3, 0}));
    ASSERT_EQ(d.all().size(), 1U);
    EXPECT_EQ(d.all()[0].code, base::codes::assumption);
    unit.inch = true;
    EXPECT_EQ(std::get<shop::SolidBox>(program_blank(unit, d)->solid).max, (geom::Vec3{25.4, 3 * 25.4, 0}));
}

TEST(ProgramBlank, NoneAndNoBox) {
    base::Diagnostics d;
    EXPECT_FALSE(program_blank(program::Unit{}, d));
    EXPECT_TRUE(d.all().empty());
    EXPECT_FALSE(program_blank(with_blank({0, 0, 0}, {1, 0, 1}), d));
    EXPECT_FALSE(program_blank(with_blank({0, 0, 0}, {1, std::numeric_limits<double>::quiet_NaN(), 1}), d));
    ASSERT_EQ(d.all().size(), 2U);
    EXPECT_EQ(d.all()[1].code, base::codes::unknown_value);
}

}  // namespace
}  // namespace obrys::driver
