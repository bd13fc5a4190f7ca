#include "shop/home.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace obrys::shop {
namespace {

MachineAxis axis(std::string name, std::optional<double> min, std::optional<double> max) {
    MachineAxis a;
    a.name = std::move(name);
    a.min = min, a.max = max;
    return a;
}

TEST(Home, IsThatOfTheFileWhateverIsTaken) {
    Machine m;
    m.axes.push_back(axis("Z", {}, {}));
    m.axes.back().home = 11;
    for (const bool at_zero : {false, true}) {
        EXPECT_EQ(home_of(m, "Z", at_zero).at, 11);
        EXPECT_FALSE(home_of(m, "Z", at_zero).is_assumed);
    }
}

TEST(Home, IsNotKnownUnlessZeroIsTaken) {
    EXPECT_TRUE(std::isnan(home_of({}, "Z", false).at));
    EXPECT_EQ(home_of({}, "Z", true).at, 0);
    EXPECT_TRUE(home_of({}, "Z", true).is_assumed);
}

TEST(Home, IsZeroOnlyAtAnEndOfTheTravelThatIsGiven) {
    Machine m;
    m.axes = {axis("X", -400, 0), axis("Y", 0, 300), axis("Z", -200, 200), axis("W", {}, 10)};
    EXPECT_EQ(home_of(m, "X", true).at, 0);
    EXPECT_EQ(home_of(m, "Y", true).at, 0);
    EXPECT_TRUE(std::isnan(home_of(m, "Z", true).at));
    EXPECT_TRUE(std::isnan(home_of(m, "W", true).at));
}

TEST(Home, OfAnAxisThatTheMachineLacksIsNotKnown) {
    Machine m;
    m.axes = {axis("X", {}, {})};
    EXPECT_TRUE(std::isnan(home_of(m, "Y", true).at));
    m.more_axes = true;
    EXPECT_EQ(home_of(m, "Y", true).at, 0);
}

}  // namespace
}  // namespace obrys::shop
