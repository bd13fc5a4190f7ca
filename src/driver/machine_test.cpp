/// A machine that is copied at any step goes on as if nothing had happened, and so does the one that it was copied
/// from: every golden program of every control, copied at random steps.

#include <gtest/gtest.h>

#include <random>
#include <string>
#include <string_view>

#include "base/seed_testing.hpp"
#include "cl/text.hpp"
#include "driver/golden_cases_testing.hpp"
#include "interp/flow/machine.hpp"

namespace obrys::driver {
namespace {

using testing::Case;

/// What a run hands out from some step on.
struct Told {
    std::string records;
    base::Diagnostics said;
    cl::CallStacks stacks;
    std::string text() const {
        std::string out = records;
        for (const base::Diagnostic& d : said.all()) out += std::to_string(d.where.begin) + " " + d.text + "\n";
        return out;
    }
};

std::string ending(interp::Machine& machine) {
    while (machine.step()) {
    }
    const interp::Outcome o = machine.finish();
    std::string out = std::to_string(static_cast<int>(o.ending)) + " after " + std::to_string(o.blocks_executed) + "\n";
    for (const auto& p : o.parameters) out += p.name + "=" + std::to_string(p.value) + "\n";
    return out;
}

/// Of one program: undisturbed, and copied at `at`, with original and copy taking turns. False where it has ended
/// before.
bool goes_on_alike(const Case& c, std::string_view control, shop::MachineKind kind, std::uint64_t at) {
    Session session;
    if (!testing::open_case(session, c, control, kind)) return false;
    const EnvironmentOf parts(session);
    Told whole;
    const auto all = [&](const cl::Record& r) { whole.records += cl::to_text(r) + "\n"; };
    interp::Machine plain(*session.main, parts.environment, whole.stacks, all, whole.said);
    std::size_t copied_at = 0, said_before = 0;
    for (std::uint64_t n = 0; n < at; ++n)
        if (!plain.step()) return false;
    copied_at = whole.records.size();
    said_before = whole.said.all().size();
    Told rest;
    rest.stacks = whole.stacks;
    const auto behind = [&](const cl::Record& r) { rest.records += cl::to_text(r) + "\n"; };
    interp::Machine copy(plain, rest.stacks, behind, rest.said);
    for (int turn = 0; turn < 3 && plain.step(); ++turn) {
    }
    const std::string end_of_copy = ending(copy), end = ending(plain);
    EXPECT_EQ(end_of_copy, end) << c.name << " at " << at;
    Told tail;
    tail.records = whole.records.substr(copied_at);
    for (std::size_t i = said_before; i < whole.said.all().size(); ++i) tail.said.add(whole.said.all()[i]);
    EXPECT_EQ(rest.text(), tail.text()) << c.name << " at " << at;
    return true;
}

int copied(const std::string& folder, std::string_view control, shop::MachineKind kind) {
    const std::uint32_t seed = base::testing_seed();
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    int made = 0;
    for (const Case& c : testing::golden_cases(folder))
        for (const std::uint32_t most : {4U, 20U, 60U})
            made += goes_on_alike(c, control, kind, random() % most) ? 1 : 0;
    return made;
}

TEST(Machine, GoesOnFromACopyOfHeidenhain) {
    EXPECT_GT(copied("heidenhain", "heidenhain-itnc530", shop::MachineKind::mill), 200);
}

TEST(Machine, GoesOnFromACopyOfSinumerik) {
    EXPECT_GT(copied("sinumerik", "sinumerik-840d", shop::MachineKind::mill), 200);
    EXPECT_GT(copied("sinumerik", "sinumerik-840d", shop::MachineKind::lathe), 200);
}

TEST(Machine, GoesOnFromACopyOfFanuc) {
    EXPECT_GT(copied("fanuc", "fanuc", shop::MachineKind::mill), 50);
    EXPECT_GT(copied("fanuc", "fanuc", shop::MachineKind::lathe), 50);
}

TEST(Machine, GoesOnFromACopyOfLinuxCnc) {
    EXPECT_GT(copied("linuxcnc", "linuxcnc", shop::MachineKind::mill), 50);
    EXPECT_GT(copied("linuxcnc", "linuxcnc", shop::MachineKind::lathe), 50);
}

}  // namespace
}  // namespace obrys::driver
