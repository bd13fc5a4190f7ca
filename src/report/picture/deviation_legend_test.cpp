#include "report/picture/deviation_legend.hpp"

#include <gtest/gtest.h>

namespace obrys::report::picture {
namespace {

std::string texts(const std::vector<double>& deviations) {
    mesh::CompareOptions allowed;
    allowed.gouge = allowed.excess = 0.1;
    const auto colours = mesh::deviation_colours(deviations, allowed, 2);
    std::string all;
    for (const PictureLegend& entry : deviation_legend(colours, 0.1, 2)) all += entry.text + "; ";
    return all;
}

TEST(DeviationLegend, NothingThatIsNotThere) {
    EXPECT_EQ(texts({}), "within 0.1 mm; ");
    EXPECT_EQ(texts({0.05, -0.09}), "within 0.1 mm; ");
}

TEST(DeviationLegend, TheRangesThatThereAre) {
    EXPECT_EQ(texts({-0.2}), "within 0.1 mm; too deep 0.100 \u2013 0.338 mm; ");
    EXPECT_EQ(texts({5, 0.2, 0.7}), "within 0.1 mm; too high 0.100 \u2013 0.338 mm; too high over 1.762 mm; ");
}

}  // namespace
}  // namespace obrys::report::picture
