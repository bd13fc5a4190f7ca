/// A machine that is copied at any step goes on as if nothing had happened, and so does the one that it was copied
/// from: every golden program of every control, copied at random steps. Who listens to it, or prints its canonical
/// calls, changes nothing.

#include <gtest/gtest.h>

#include <random>
#include <string>
#include <string_view>
#include <vector>

#include "base/seed_testing.hpp"
#include "cl/text.hpp"
#include "driver/canon.hpp"
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
        for (const std::uint32_t most : {4U, 20U, 60U, 600U})
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

TEST(Machine, GoesOnFromACopyOfTheOthers) {
    EXPECT_GT(copied("fanuc", "haas", shop::MachineKind::mill), 50);
    EXPECT_GT(copied("acramatic", "acramatic-2100", shop::MachineKind::mill), 10);
    EXPECT_GT(copied("nc470", "nc-470", shop::MachineKind::mill), 10);
    EXPECT_GT(copied("apt", "apt-cl", shop::MachineKind::mill), 10);
    EXPECT_GT(copied("fusion", "fusion", shop::MachineKind::mill), 10);
}

// --- who listens changes nothing: the same records, complaints and ends with a listener and without one

/// All that comes of a run.
std::string all_of(const std::string& records, const interp::Outcome& o, const Session& s) {
    std::string out = records + std::to_string(static_cast<int>(o.ending)) + " after " +
                      std::to_string(o.blocks_executed) + " blocks, " + std::to_string(o.statements) + " statements\n";
    for (const auto& p : o.parameters) out += p.name + "=" + std::to_string(p.value) + "\n";
    for (const base::Diagnostic& d : s.diagnostics.all())
        out += std::to_string(d.where.begin) + " " + d.text + " / " + d.remedy + "\n";
    return out;
}

struct ListenedTo {
    std::string folder;
    std::string_view control;
    shop::MachineKind kind = shop::MachineKind::mill;
};

/// Of one program: without and with one who listens. How much is heard.
std::size_t hold_heard(const Case& c, const ListenedTo& way, bool stand_alone) {
    Session alone, heard;
    for (Session* s : {&alone, &heard}) {
        if (!testing::open_case(*s, c, way.control, way.kind)) return 0;
        s->stand_alone = stand_alone;
    }
    std::string plain, beside, calls;
    const interp::Outcome of_plain = interpret(alone, [&](const cl::Record& r) { plain += cl::to_text(r) + "\n"; });
    const interp::Outcome of_heard = print_canon(
        heard, [&](std::string_view line) { calls += line; }, false,
        [&](const cl::Record& r) { beside += cl::to_text(r) + "\n"; });
    EXPECT_EQ(all_of(plain, of_plain, alone), all_of(beside, of_heard, heard))
        << way.control << ", " << c.name << (stand_alone ? ", stand-alone:\n" : ":\n") << c.text;
    return calls.size();
}

/// Compensation that holds moves back, corners, zeros, states: where what is heard has to wait for its place.
const std::vector<std::string_view> words{
    " G41",     " G42",  " G40",  " RL",   " R0",   "\nG1 X5 Y5 F100", "\nG2 X7 Y7 I3 J3", "\nM8", "\nG55",
    "\nG92 X1", "\nG91", "\nG90", "\nG18", "\nG17", "\nG53 G0 X0",     "\nRND R2",         "\nM2"};

TEST(Listener, ListeningChangesNothing) {
    const ListenedTo ways[] = {{"heidenhain", "heidenhain-itnc530"},
                               {"sinumerik", "sinumerik-840d"},
                               {"turning", "sinumerik-840d", shop::MachineKind::lathe},
                               {"fanuc", "fanuc"},
                               {"fanuc", "fanuc", shop::MachineKind::lathe},
                               {"fanuc", "haas"},
                               {"linuxcnc", "linuxcnc"},
                               {"linuxcnc", "linuxcnc", shop::MachineKind::lathe},
                               {"acramatic", "acramatic-2100"},
                               {"nc470", "nc-470"},
                               {"apt", "apt-cl"}};
    const std::uint32_t seed = base::testing_seed();
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    for (const ListenedTo& way : ways) {
        std::size_t said = 0;
        for (const Case& c : testing::golden_cases(way.folder)) {
            Case m = c;
            for (int n = 0; n < 2; ++n, m.text = testing::mutated(c.text, random, words))
                said += hold_heard(m, way, false) + hold_heard(m, way, true);
        }
        EXPECT_GT(said, 1000U) << way.control;
    }
}

/// What is heard while compensation holds a move back comes in its place among the records.
TEST(Listener, StandsInItsPlace) {
    const Case c{"held", "in.ngc",
                 "G21 G90 G17 G54\nT1 M6\nG0 X0 Y0 Z5\nG1 G41 D1 X10 Y0 F100\nX20 Y0\nM8\nX20 Y20\nG40 X30 Y30\nM2\n"};
    Session s;
    ASSERT_TRUE(testing::open_case(s, c, "linuxcnc", shop::MachineKind::mill));
    s.stand_alone = true;
    std::string order;
    const auto take = [&](const cl::Record& r) {
        if (cl::is_move(r.step)) order += "m";
        if (std::holds_alternative<cl::Coolant>(r.step)) order += "c";
    };
    const auto listen = [&](const interp::Heard& what, const base::Span&) {
        if (std::holds_alternative<interp::heard::CoolantWord>(what)) order += "h";
    };
    static_cast<void>(interpret(s, take, interp::Listener(listen)));
    EXPECT_NE(order.find("mhc"), std::string::npos) << order;
    EXPECT_NE(order.rfind('m'), std::string::npos);
    EXPECT_LT(order.find("hc"), order.rfind('m')) << order;
}

}  // namespace
}  // namespace obrys::driver
