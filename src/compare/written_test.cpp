/// What is written from a program is held to more than a second program of anybody is.

#include "compare/streams_testing.hpp"

namespace obrys::compare {
namespace {

const Tolerance written{.is_written_from_a = true};

bool differs(const Result& r, Aspect a) { return r.of(a) != nullptr; }

TEST(Written, AToolThatIsCalledAgainForNothing) {
    const Steps once = steps_of({"tool 1 edge 1 \"\" lengthened", "rapid 1 0 5", "linear 2 0 0", "linear 3 0 0"});
    Steps again = once;
    again.insert(again.begin() + 3, *step_of("tool 1 edge 1 \"\" lengthened"));
    EXPECT_TRUE(differs(compared(once, again, written), Aspect::events));
    EXPECT_FALSE(differs(compared(again, again, written), Aspect::events));
    EXPECT_FALSE(differs(compared(once, again), Aspect::events)) << "a second program may call it as often as it likes";
}

TEST(Written, AnEndThatIsMissing) {
    const Steps ends = steps_of({"rapid 1 0 5", "linear 2 0 0", "stop end"});
    const Steps lacks(ends.begin(), ends.end() - 1);
    EXPECT_TRUE(differs(compared(ends, lacks, written), Aspect::events));
    EXPECT_FALSE(differs(compared(lacks, ends, written), Aspect::events));
    const Result alone = compared(ends, lacks);
    ASSERT_NE(alone.of(Aspect::events), nullptr);
    EXPECT_FALSE(alone.of(Aspect::events)->is_done) << "nothing turns: it ends as well";
}

TEST(Written, LengthsOfSeveralToolsThatTheProgramNeverCompensates) {
    const auto steps = [](const std::string& lengthened) {
        return steps_of({"tool 1 edge 1 \"\"" + lengthened, "rapid 1 0 5", "linear 1 0 0",
                         "tool 2 edge 1 \"\"" + lengthened, "rapid 2 0 5", "linear 2 0 0"});
    };
    EXPECT_TRUE(compared(steps(""), steps(" lengthened"), written).lengths);
    EXPECT_FALSE(compared(steps(" lengthened"), steps(" lengthened"), written).lengths);
    EXPECT_TRUE(differs(compared(steps(" lengthened"), steps(""), written), Aspect::tool));
}

/// G40 in a block of its own, and sides that change in one block.
TEST(Written, TheEndOfCompensationBeforeItsOtherSide) {
    const auto stream = [](std::uint32_t end_at) {
        Path path(1e-4);
        const auto take = [&](const std::string& line, std::uint32_t at) {
            path.take({*step_of(line), {0, at, at + 1}, 0});
        };
        take("linear 0 0 0", 0);
        take("compensation left radius 3 offset 1 normal", 1);
        take("programmed 0 0 0 to 9 0 0", 1);
        take("linear 9 3 0", 1);
        take("compensation-end", end_at);
        take("compensation right radius 3 offset 1 normal", 3);
        take("programmed 9 0 0 to 9 9 0", 3);
        take("linear 12 9 0", 3);
        return path;
    };
    const Path own = stream(2), same = stream(3), again = stream(3);
    EXPECT_TRUE(differs(compare(own, same, written), Aspect::compensation));
    EXPECT_FALSE(differs(compare(same, again, written), Aspect::compensation));
}

}  // namespace
}  // namespace obrys::compare
