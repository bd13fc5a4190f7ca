#include "shop/nearest.hpp"

#include <gtest/gtest.h>

namespace obrys::shop {
namespace {

TEST(Nearest, IsAFewEditsAway) {
    EXPECT_EQ(nearest("fanuk", {"haas", "fanuc"}), "fanuc");
    EXPECT_EQ(nearest("chekc", {"check", "run"}), "check");
    EXPECT_EQ(nearest("colour", {"name", "box"}), "");
}

TEST(Nearest, ElseBeginsAlike) {
    EXPECT_EQ(nearest("heidenhain", {"linuxcnc", "heidenhain-itnc530"}), "heidenhain-itnc530");
    EXPECT_EQ(nearest("tools", {"program", "tool_file", "tool_files"}), "tool_file");
    EXPECT_EQ(nearest("corner", {"number", "corner_radius"}), "corner_radius");
    EXPECT_EQ(nearest("co", {"corner_radius"}), "");  // two letters say nothing
    EXPECT_EQ(nearest("programs_of", {"point_angle"}), "");
}

TEST(Nearest, EveryWordIsListed) {
    EXPECT_EQ(words_remedy("mil", {"lathe", "mill"}), "did you mean \"mill\"? one of: lathe, mill");
    EXPECT_EQ(words_remedy("x", {"lathe", "mill"}, "shipped"), "shipped: lathe, mill");
}

}  // namespace
}  // namespace obrys::shop
