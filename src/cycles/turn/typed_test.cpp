/// The structs of this room and their tables: what a struct says by roles it reads again.

#include "cycles/turn/path.hpp"
#include "cycles/typed_testing.hpp"

namespace obrys::cycles::test {
namespace {

template <class Cycle>
class typed_turning : public ::testing::Test {};

using All = ::testing::Types<OffsetFinishing, RoughingAlong, RoughingAcross, ContourFinishing, RemovalAlong,
                             RemovalAcross, PatternRepeating, PecksAlong, PecksAcross, BoxAlong, BoxAcross, BoxThread,
                             ThreadPasses, DegressiveThread>;
TYPED_TEST_SUITE(typed_turning, All);

TYPED_TEST(typed_turning, SaysByRolesWhatItReadsAgain) { expect_round_trip<TypeParam>(); }

TYPED_TEST(typed_turning, TheKindSaysTheSameRoles) {
    const auto roles = roles_of_turning(TypeParam::kind);
    EXPECT_TRUE(
        std::equal(roles.begin(), roles.end(), roles_of_cycle<TypeParam>.begin(), roles_of_cycle<TypeParam>.end()));
}

}  // namespace
}  // namespace obrys::cycles::test
