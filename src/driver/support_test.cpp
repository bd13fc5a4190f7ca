/// What the support matrix of a control calls run does run: the tables are held to the reader and the interpreter.

#include <gtest/gtest.h>

#include <map>

#include "base/codes.hpp"
#include "cycles/contour/contour.hpp"
#include "cycles/expand/expand.hpp"
#include "dialect/heidenhain/cycles.hpp"
#include "dialect/heidenhain/functions.hpp"
#include "dialect/heidenhain/m_functions.hpp"
#include "driver/session.hpp"
#include "read/heidenhain/read.hpp"

namespace obrys::driver {
namespace {

namespace dialect = obrys::dialect::heidenhain;

/// Complaints of kind `unsupported` that reading and running the blocks makes, as text.
std::string refused(const std::string& blocks) {
    Session s;
    const auto file =
        s.sources.add("T.H", "0 BEGIN PGM T MM\n" + blocks + "\nEND PGM T MM\n", base::BlockNumbers::leading);
    s.programs = std::make_unique<Programs>(*find_control("heidenhain-itnc530"), s.sources, s.diagnostics);
    s.main = s.programs->read(file);
    static_cast<void>(interpret(s, [](const cl::Record&) {}));
    std::string out;
    for (const base::Diagnostic& d : s.diagnostics.all())
        if (d.code == base::codes::unsupported || d.code == base::codes::unknown_word) out += d.text + "\n";
    return out;
}

TEST(SupportMatrix, CyclesThatRunOnCallHaveAnExpansion) {
    for (const dialect::Cycle& c : dialect::all_cycles()) {
        if (!c.call_active || c.use != dialect::Cycle::Use::run) continue;
        const bool known =
            cycles::is_expanded(c.kind) || cycles::is_contour_cycle(c.kind) || c.kind == cl::CycleKind::program_call;
        EXPECT_TRUE(known) << "cycle " << c.number;
    }
}

TEST(SupportMatrix, CyclesThatActAtTheirDefinitionDo) {
    for (const dialect::Cycle& c : dialect::all_cycles()) {
        if (c.call_active || c.use != dialect::Cycle::Use::run) continue;
        const std::string n = std::to_string(c.number);
        std::string text = "1 CYCL DEF " + n + " X";
        bool named = false;
        for (const dialect::CycleParameter& p : c.parameters) named = named || p.q >= 0;
        if (named)
            for (const dialect::CycleParameter& p : c.parameters) text += " ~\n  Q" + std::to_string(p.q) + "=+0";
        else
            text = "1 CYCL DEF " + n + ".0 X\n2 CYCL DEF " + n + ".1 ";
        if (c.number == 14) text += "LBL 1";
        if (c.number == 11) text += "SCL 1";
        EXPECT_EQ(refused(text), "") << text;
    }
}

TEST(SupportMatrix, MFunctionsThatRunAreNotRefused) {
    for (const dialect::MFunction& m : dialect::all_m()) {
        if (m.use != dialect::Use::run) continue;
        EXPECT_EQ(refused("1 L X+1 M" + std::to_string(m.number)), "") << m.text;
    }
}

TEST(SupportMatrix, FunctionsThatRunAreNotRefused) {
    const std::map<int, std::string> samples{{0, "Q1 = +1"},
                                             {1, "Q1 = +1 + +2"},
                                             {2, "Q1 = +1 - +2"},
                                             {3, "Q1 = +1 * +2"},
                                             {4, "Q1 = +1 DIV +2"},
                                             {5, "Q1 = SQRT 4"},
                                             {6, "Q1 = SIN 4"},
                                             {7, "Q1 = COS 4"},
                                             {8, "Q1 = +1 LEN +2"},
                                             {9, "IF +1 EQU +2 GOTO LBL 1"},
                                             {10, "IF +1 NE +1 GOTO LBL 1"},
                                             {11, "IF +1 GT +2 GOTO LBL 1"},
                                             {12, "IF +2 LT +1 GOTO LBL 1"},
                                             {13, "Q1 = +1 ANG +2"},
                                             {14, "ERROR = 1000"},
                                             {15, "PRINT 1"},
                                             {16, "F-PRINT TNC:\\M.A / TNC:\\P.TXT"},
                                             {17, "SYSWRITE ID50 NR1 IDX1 = +1"},
                                             {18, "SYSREAD Q1 = ID10 NR103 IDX0"},
                                             {25, "PRESET = X / +0 / +0"},
                                             {26, "TABOPEN TNC:\\A.TAB"},
                                             {27, "TABWRITE 1 / \"A\" = Q5"},
                                             {28, "TABREAD Q1 = 1 / \"A\""},
                                             {37, "EXPORT QL1"},
                                             {38, "SEND /\"text\""}};
    for (const dialect::FnFunction& f : dialect::all_fn()) {
        if (f.use != dialect::Use::run) continue;
        const auto sample = samples.find(f.number);
        ASSERT_NE(sample, samples.end()) << "no sample of FN " << f.number;
        EXPECT_EQ(refused("1 LBL 1\n2 FN " + std::to_string(f.number) + ": " + sample->second), "") << f.number;
    }
}

}  // namespace
}  // namespace obrys::driver
