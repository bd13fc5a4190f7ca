#include "dialect/sinumerik/tables.hpp"

#include <gtest/gtest.h>

namespace obrys::dialect::sinumerik {

using program::Modal;

TEST(SinumerikTables, GFunctions) {
    EXPECT_EQ(find_g(0)->modal, Modal::rapid);
    EXPECT_EQ(find_g(54)->modal, Modal::datum);
    EXPECT_EQ(find_g(505)->modal, Modal::datum);
    EXPECT_EQ(find_g(599)->code, 599);
    EXPECT_EQ(find_g(25)->use, Use::unsupported_block);
    EXPECT_EQ(find_g(500)->modal, Modal::datum);
    EXPECT_FALSE(find_g(504));
    EXPECT_FALSE(find_g(600));
    EXPECT_FALSE(find_g(-1));
    EXPECT_FALSE(find_g(99999));
}

TEST(SinumerikTables, Words) {
    ASSERT_NE(find_word("CFTCP"), nullptr);
    EXPECT_EQ(find_word("CFTCP")->use, Use::modal);
    EXPECT_EQ(find_word("STOPRE")->use, Use::ignored);
    EXPECT_EQ(find_word("CYCLE93")->use, Use::control_cycle);
    EXPECT_EQ(find_word("WHENEVER")->use, Use::unsupported_block);
    EXPECT_EQ(find_word("AMIRROR")->number, 1);
    EXPECT_EQ(find_word("A"), nullptr);
    EXPECT_EQ(find_word("ZZZZ"), nullptr);
    EXPECT_EQ(find_word("stopre"), nullptr);
}

TEST(SinumerikTables, FunctionsAndVariables) {
    EXPECT_EQ(find_function("ROUNDUP"), program::Function::round_up);
    EXPECT_FALSE(find_function("FOO"));
    EXPECT_EQ(find_reference("ACN"), program::Reference::negative);
    EXPECT_EQ(find_system_variable("$P_TOOLR"), program::SystemVariable::tool_radius);
    EXPECT_EQ(find_system_variable("$TC_DP3"), program::SystemVariable::tool_parameter);
    EXPECT_EQ(find_system_variable("$TC_DPCE"), program::SystemVariable::unknown);
    EXPECT_EQ(find_system_variable("$MC_DIAMETER_AX_DEF"), program::SystemVariable::machine_data);
    EXPECT_EQ(find_type("AXIS"), program::Type::axis);
}

}  // namespace obrys::dialect::sinumerik
