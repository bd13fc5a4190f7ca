/// The structs of this room and their tables: what a struct says by roles it reads again.

#include "cycles/mill/families.hpp"
#include "cycles/mill/mill.hpp"
#include "cycles/typed_testing.hpp"

namespace obrys::cycles::test {
namespace {

template <class Cycle>
class typed_milling : public ::testing::Test {};

using All = ::testing::Types<RectangularPocket, CircularPocket, OldRectangularPocket, OldCircularPocket, Slot,
                             RoundSlot, ReciprocatingSlot, ReciprocatingRoundSlot, RectangularStud, CircularStud,
                             RectangularPocketFinishing, RectangularStudFinishing, CircularPocketFinishing,
                             CircularStudFinishing, Multipass, RuledSurface, FaceMilling>;
TYPED_TEST_SUITE(typed_milling, All);

TYPED_TEST(typed_milling, SaysByRolesWhatItReadsAgain) { expect_round_trip<TypeParam>(); }

TYPED_TEST(typed_milling, TheKindSaysTheSameRoles) {
    const auto roles = roles_of_mill(TypeParam::kind);
    EXPECT_TRUE(
        std::equal(roles.begin(), roles.end(), roles_of_cycle<TypeParam>.begin(), roles_of_cycle<TypeParam>.end()));
}

}  // namespace
}  // namespace obrys::cycles::test
