#include "base/shared_value.hpp"

#include <gtest/gtest.h>

#include <string>

namespace obrys::base {
namespace {

TEST(SharedValue, CopiesShareAndCompareByWhatTheyHold) {
    const SharedValue<std::string> none, a{"a"}, copy = a, again{"a"}, b{"b"};
    EXPECT_TRUE(none->empty());
    EXPECT_EQ(&*a, &*copy);
    EXPECT_NE(&*a, &*again);
    EXPECT_EQ(a, again);
    EXPECT_FALSE(a == b);
    EXPECT_FALSE(a == none);
}

TEST(SharedValue, ReplacingOneLeavesItsCopies) {
    SharedValue<int> a{1};
    const SharedValue<int> before = a;
    a = SharedValue<int>{2};
    EXPECT_EQ(*before, 1);
    EXPECT_EQ(*a, 2);
}

}  // namespace
}  // namespace obrys::base
