/// Looking ahead leaves no trace: with some statements tried before every one that is run, each golden program makes
/// the same moves, the same parameters and the same complaints. Nor does it repeat itself.

#include <gtest/gtest.h>

#include <string>
#include <string_view>

#include "cl/text.hpp"
#include "driver/golden_cases_testing.hpp"

namespace obrys::driver {
namespace {

using testing::Case;

std::string outcome(const Case& c, std::string_view of, shop::MachineKind kind, std::uint32_t ahead) {
    Session s;
    s.looked_ahead_in_vain = ahead;
    if (!testing::open_case(s, c, of, kind)) return {};
    std::string out;
    const auto end = interpret(s, [&](const cl::Record& r) {
        const std::string line = cl::to_text(r);
        out += line.substr(0, line.find(" @")) + "\n";
    });
    for (const auto& p : end.parameters) out += p.name + "=" + std::to_string(p.value) + "\n";
    for (const base::Diagnostic& d : s.diagnostics.all()) out += std::to_string(d.where.begin) + " " + d.text + "\n";
    return out;
}

/// Compares every case of a folder; the number of those that made something.
int compare_with_tries(const std::string& folder, std::string_view control, shop::MachineKind kind) {
    int compared = 0;
    for (const Case& c : testing::golden_cases(folder)) {
        const std::string plain = outcome(c, control, kind, 0);
        if (plain.empty()) continue;
        EXPECT_EQ(plain, outcome(c, control, kind, 7)) << c.name;
        ++compared;
    }
    return compared;
}

TEST(LookAhead, LeavesNoTraceOnHeidenhain) {
    EXPECT_GT(compare_with_tries("heidenhain", "heidenhain-itnc530", shop::MachineKind::mill), 100);
}

TEST(LookAhead, LeavesNoTraceOnSinumerik) {
    EXPECT_GT(compare_with_tries("sinumerik", "sinumerik-840d", shop::MachineKind::mill), 100);
    EXPECT_GT(compare_with_tries("sinumerik", "sinumerik-840d", shop::MachineKind::lathe), 100);
}

TEST(LookAhead, LeavesNoTraceOnFanuc) {
    EXPECT_GT(compare_with_tries("fanuc", "fanuc", shop::MachineKind::mill), 20);
    EXPECT_GT(compare_with_tries("fanuc", "fanuc", shop::MachineKind::lathe), 20);
}

TEST(LookAhead, LeavesNoTraceOnLinuxCnc) {
    EXPECT_GT(compare_with_tries("linuxcnc", "linuxcnc", shop::MachineKind::mill), 20);
    EXPECT_GT(compare_with_tries("linuxcnc", "linuxcnc", shop::MachineKind::lathe), 20);
}

/// A row of approaches, each of which wants the element behind itself.
std::uint64_t statements_of_a_row(int approaches) {
    std::string text = "0 BEGIN PGM A MM\n1 TOOL CALL 1 Z S1000\n2 L X-50 Y-50 Z+5 R0 FMAX M3\n";
    for (int i = 0; i < approaches; ++i) text += "APPR LT X+0 Y+" + std::to_string(i) + " LEN5 RL F100\n";
    text += "L X+50\nL X+60 Y+60 R0\nL Z+50 FMAX M30\nEND PGM A MM\n";
    Session s;
    EXPECT_TRUE(testing::open_case(s, {"row", "A.H", text}, "heidenhain-itnc530", shop::MachineKind::mill));
    return interpret(s, [](const cl::Record&) {}).statements;
}

TEST(LookAhead, IsNotRepeatedByWhatIsLookedAt) {
    const std::uint64_t one = statements_of_a_row(1), many = statements_of_a_row(22);
    EXPECT_GT(one, 5U);
    // Every approach looks through those behind it once: 22 of them through 22 * 21 / 2 and the contour's first block.
    EXPECT_LE(many, one + 21 * 2 + 22 * 21 / 2 + 22);
}

}  // namespace
}  // namespace obrys::driver
