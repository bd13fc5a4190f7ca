#include "dialect/heidenhain/cycles.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <string>

#include "base/number.hpp"
#include "base/text.hpp"

namespace obrys::dialect::heidenhain {
namespace {

using Kind = cl::CycleKind;
using Role = cl::CycleRole;

TEST(cycles, AllOfTheControlAreThere) {
    for (const int n : {1,   2,   3,   4,   5,   6,   7,   8,   9,   10,  11,  12,  13,  14,  15,  16,  17,  18,  19,
                        20,  21,  22,  23,  24,  25,  26,  27,  28,  32,  39,  200, 201, 202, 203, 204, 205, 206, 207,
                        208, 209, 210, 211, 212, 213, 214, 215, 220, 221, 230, 231, 232, 240, 241, 247, 251, 252, 253,
                        254, 256, 257, 262, 263, 264, 265, 267, 270, 400, 410, 419, 420, 431, 480, 481, 482, 483}) {
        ASSERT_NE(find_cycle(n), nullptr) << n;
        EXPECT_EQ(find_cycle(n)->number, n);
    }
    for (const int n : {-1, 0, 31, 199, 216, 233, 266, 432, 484, 1000}) EXPECT_EQ(find_cycle(n), nullptr) << n;
}

TEST(cycles, SortedAndComplete) {
    int before = 0;
    for (const Cycle& c : all_cycles()) {
        EXPECT_GT(c.number, before);
        before = c.number;
        EXPECT_FALSE(c.name.empty()) << c.number;
        EXPECT_TRUE(c.use == Cycle::Use::run || !c.text.empty()) << c.number;
        EXPECT_EQ(c.kind == Kind::probe, c.number >= 400) << c.number;
        if (c.number >= 200 && c.number < 400) {
            EXPECT_FALSE(c.parameters.empty()) << c.number;
        }
    }
}

TEST(cycles, ParametersAreUnique) {
    for (const Cycle& c : all_cycles()) {
        std::set<int> qs;
        std::set<Role> roles;
        for (const CycleParameter& p : c.parameters) {
            if (p.q < 0) continue;
            EXPECT_TRUE(p.word.empty()) << c.number;
            EXPECT_TRUE(qs.insert(p.q).second) << c.number << " Q" << p.q;
            EXPECT_TRUE(roles.insert(p.role).second) << c.number << " Q" << p.q;
        }
    }
}

/// A Q number means the same wherever it stands.
TEST(cycles, OneNumberOneMeaning) {
    std::map<int, std::pair<Role, CycleUnit>> meaning;
    for (const Cycle& c : all_cycles())
        for (const CycleParameter& p : c.parameters) {
            if (p.q < 0 || p.q == 356) continue;          // countersinking depth of 263, hole depth of 264
            if (p.q == 256 && c.number == 209) continue;  // a factor of the pitch there, elsewhere a distance
            const auto [known, is_new] = meaning.try_emplace(p.q, p.role, p.unit);
            EXPECT_TRUE(is_new || known->second == std::pair(p.role, p.unit)) << c.number << " Q" << p.q;
        }
}

TEST(cycles, Drilling) {
    const Cycle& c = *find_cycle(200);
    EXPECT_EQ(c.kind, Kind::drill);
    EXPECT_TRUE(c.call_active);
    EXPECT_EQ(find_parameter(c, 201)->role, Role::depth);
    EXPECT_TRUE(find_parameter(c, 201)->length());
    EXPECT_EQ(find_parameter(c, 206)->unit, CycleUnit::feed);
    EXPECT_EQ(find_parameter(c, 211)->unit, CycleUnit::plain);
    EXPECT_EQ(find_parameter(c, 239), nullptr);
    EXPECT_EQ(find_parameter(c, -1), nullptr);
}

TEST(cycles, ActiveAtTheirDefinition) {
    for (const int n : {7, 8, 9, 10, 11, 13, 14, 19, 20, 26, 32, 220, 221, 247, 270, 400})
        EXPECT_FALSE(find_cycle(n)->call_active) << n;
    for (const int n : {1, 4, 12, 18, 22, 25, 200, 208, 232, 251, 267}) EXPECT_TRUE(find_cycle(n)->call_active) << n;
}

TEST(cycles, NumberedForm) {
    const Cycle& peck = *find_cycle(1);
    for (const char* word : {"SET UP", "DIST", "ABST"})
        EXPECT_EQ(find_parameter(peck, 1, word)->role, Role::clearance) << word;
    EXPECT_EQ(find_parameter(peck, 2, "DEPTH")->role, Role::depth);
    EXPECT_EQ(find_parameter(peck, 3, " PLNGNG ")->role, Role::infeed);
    EXPECT_EQ(find_parameter(peck, 5, "F")->role, Role::feed_plunge);
    EXPECT_EQ(find_parameter(peck, 2, "DIST"), nullptr);
    EXPECT_EQ(find_parameter(peck, 2, ""), nullptr);
    EXPECT_EQ(find_parameter_at(peck, 2, 0)->role, Role::depth);
    EXPECT_EQ(find_parameter_at(peck, 2, 1), nullptr);
    const Cycle& pocket = *find_cycle(4);
    EXPECT_EQ(find_parameter(pocket, 3, "F")->role, Role::feed_plunge);
    EXPECT_EQ(find_parameter(pocket, 6, "F")->role, Role::feed_mill);
    EXPECT_EQ(find_parameter(*find_cycle(7), 3, "Z")->role, Role::axis_z);
    EXPECT_EQ(find_parameter(*find_cycle(7), 1, "Z")->role, Role::axis_z);
    EXPECT_EQ(find_parameter(*find_cycle(32), 2, "HSC-MODE")->role, Role::tolerance_mode);
}

TEST(cycles, DinIso) {
    EXPECT_EQ(find_iso_cycle(200)->number, 200);
    EXPECT_EQ(find_iso_cycle(83)->number, 1);
    EXPECT_EQ(find_iso_cycle(125)->number, 25);
    EXPECT_EQ(find_iso_cycle(75)->direction, -1);
    EXPECT_EQ(find_iso_cycle(76)->direction, 1);
    for (const int g : {0, 1, 40, 79, 126, 199, 216}) EXPECT_FALSE(find_iso_cycle(g)) << g;
    const Cycle& pocket = *find_cycle(4);
    const Role order[] = {Role::clearance, Role::depth,  Role::infeed,    Role::feed_plunge,
                          Role::axis_x,    Role::axis_x, Role::feed_mill, Role::corner_radius};
    for (int p = 1; p <= 8; ++p) EXPECT_EQ(find_iso_parameter(pocket, p)->role, order[p - 1]) << p;
    EXPECT_EQ(find_iso_parameter(pocket, 6)->line, 5);
    EXPECT_EQ(find_iso_parameter(pocket, 9), nullptr);
    EXPECT_EQ(find_iso_parameter(pocket, 0), nullptr);
}

/// Reads the definitions of a program: every Q number that stands in one must belong to its cycle.
int definitions_in(const std::filesystem::path& file) {
    std::ifstream in(file, std::ios::binary);
    std::string line;
    const Cycle* cycle = nullptr;
    int found = 0;
    while (std::getline(in, line)) {
        const std::string upper = base::to_upper(line);
        const std::size_t def = upper.find("CYCL DEF ");
        const std::size_t q = upper.find('Q');
        if (def != std::string::npos) {
            const auto number = base::scan_decimal(base::trim(std::string_view(upper).substr(def + 9)));
            cycle = number.integer ? find_cycle(int(number.value)) : nullptr;
            if (number.integer) {
                EXPECT_NE(cycle, nullptr) << file << ": " << line;
            }
            found += cycle != nullptr ? 1 : 0;
        } else if (cycle != nullptr && q != std::string::npos && q < 8) {
            const auto number = base::scan_decimal(std::string_view(upper).substr(q + 1));
            const bool parameter = number.length > 0 && upper.substr(q + 1 + number.length, 1) == "=";
            if (parameter) {
                EXPECT_NE(find_parameter(*cycle, int(number.value)), nullptr) << file << ": " << line;
            }
        } else {
            cycle = nullptr;
        }
    }
    return found;
}

TEST(cycles, ProgramsNobodyHereWrote) {
    const std::filesystem::path shared = std::filesystem::path(OBRYS_SOURCE_DIR) / "../shared/corpus/klartext";
    if (!std::filesystem::exists(shared)) GTEST_SKIP() << "needs ../shared";
    int found = 0;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(shared))
        if (entry.is_regular_file()) found += definitions_in(entry.path());
    EXPECT_EQ(found, 15);
}

}  // namespace
}  // namespace obrys::dialect::heidenhain
