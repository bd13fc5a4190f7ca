#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "shop/files/linuxcnc/ini.hpp"
#include "shop/files/linuxcnc/parameters.hpp"
#include "shop/reading_testing.hpp"

namespace obrys::shop {
namespace {

struct ParametersOf : Reading {
    LinuxcncParameters p;
    explicit ParametersOf(const std::string& text) {
        p = read_linuxcnc_parameters(add(text, "a.var"), sources, diagnostics);
    }
};

std::string all_needed() {
    std::string out;
    for (const int n : needed_parameters()) out += std::to_string(n) + "\t0.000000\n";
    return out;
}

/// The numbers that `rs274` 2.9 writes into a file that had none of them.
TEST(LinuxcncParameters, NeededNumbers) {
    const auto& n = needed_parameters();
    EXPECT_EQ(n.size(), 119U);
    EXPECT_EQ(n.front(), 5161);
    EXPECT_EQ(n.back(), 5390);
    EXPECT_TRUE(std::is_sorted(n.begin(), n.end()));
    for (const int there : {5169, 5181, 5189, 5210, 5219, 5220, 5230, 5241, 5250, 5261, 5381})
        EXPECT_TRUE(std::binary_search(n.begin(), n.end(), there)) << there;
    for (const int no : {5160, 5170, 5180, 5190, 5209, 5231, 5240, 5251, 5260, 5391})
        EXPECT_FALSE(std::binary_search(n.begin(), n.end(), no)) << no;
    EXPECT_EQ(ParametersOf(all_needed()).complaints(), "");
}

TEST(LinuxcncParameters, ValuesAndMistakes) {
    const ParametersOf f("; comment\n31 4.5 ; c\r\n5161\t+1e2\n\nword\n5163 1x\n5161 3\n5602 1\n0 1\n5162 -2\n" +
                         all_needed().substr(28));
    EXPECT_EQ(values_of(f.p).at(31), 4.5);
    EXPECT_EQ(value_of(f.p, 5161), 100);
    EXPECT_EQ(value_of(f.p, 5162), -2);
    EXPECT_EQ(value_of(f.p, 0), std::nullopt);
    EXPECT_EQ(f.complaints(),
              "a.var:5:1: warning: this line is no parameter [job-file]\n  word\n  ^~~~\n"
              "  remedy: a parameter is its number, a tab and its value\n"
              "a.var:6:1: warning: this line is no parameter [job-file]\n  5163 1x\n  ^~~~~~~\n"
              "  remedy: a parameter is its number, a tab and its value\n"
              "a.var:7:1: error: parameter 5161 does not come after 5161 [job-value]\n  5161 3\n  ^~~~\n"
              "  remedy: LinuxCNC refuses the file: bring the lines into the order of their numbers, each once\n"
              "a.var:8:1: error: a parameter has a number from 1 to 5601 [job-value]\n  5602 1\n  ^~~~\n"
              "a.var:9:1: error: a parameter has a number from 1 to 5601 [job-value]\n  0 1\n  ^\n");
    EXPECT_EQ(ParametersOf("5220 1\n").complaints(),
              "a.var:1:1: note: 118 of the parameters that LinuxCNC keeps are not in the file, the first is 5161 "
              "[assumption]\n"
              "  5220 1\n  ^\n  remedy: they count as 0\n");
}

TEST(LinuxcncParameters, ValuesAreSetInTheirPlace) {
    ParametersOf f("; c\n5161 1 x\n5163\t2");
    EXPECT_EQ(set_parameter(f.p, 5161, 0.1), std::nullopt);
    EXPECT_EQ(set_parameter(f.p, 5162, -1), std::nullopt);
    EXPECT_EQ(set_parameter(f.p, 5390, 3), std::nullopt);
    EXPECT_EQ(set_parameter(f.p, 31, 4), std::nullopt);
    EXPECT_TRUE(set_parameter(f.p, 0, 4));
    EXPECT_TRUE(set_parameter(f.p, 5602, 4));
    EXPECT_TRUE(set_parameter(f.p, 31, INFINITY));
    EXPECT_EQ(write_linuxcnc_parameters(f.p),
              "; c\n31\t4.000000\n5161 0.100000 x\n5162\t-1.000000\n5163\t2\n5390\t3.000000");
    ParametersOf none("");
    EXPECT_EQ(set_parameter(none.p, 5220, 1), std::nullopt);
    EXPECT_EQ(write_linuxcnc_parameters(none.p), "5220\t1.000000\n");
}

RC_GTEST_PROP(LinuxcncParameters, AnyTextComesBackAndSettingKeepsTheOrder, (const std::string& noise)) {
    RC_PRE(!noise.starts_with("\xEF\xBB\xBF"));
    std::string text = noise + "\n";
    for (const int n : *rc::gen::container<std::vector<int>>(rc::gen::inRange(-2, 5605)))
        text += std::to_string(n) + "\t1.5\n";
    ParametersOf f(text);
    RC_ASSERT(write_linuxcnc_parameters(f.p) == text);
    const auto before = values_of(f.p);
    const int number = *rc::gen::inRange(1, 5602);
    RC_ASSERT(!set_parameter(f.p, number, 7));
    const ParametersOf again(write_linuxcnc_parameters(f.p));
    auto expected = before;
    expected[number] = 7;
    // A line out of order may have stood above the place of the new one; it stays without effect.
    for (const auto& [n, v] : expected) RC_ASSERT(value_of(again.p, n) == v);
}

struct IniOf : Reading {
    LinuxcncIni ini;
    explicit IniOf(const std::string& text) { ini = read_linuxcnc_ini(add(text, "m.ini"), sources, diagnostics); }
    LinuxcncSettings settings() { return settings_of(ini, diagnostics); }
};

/// Each line with what `rs274` 2.9 makes of it.
TEST(LinuxcncIni, KeysAreFoundAsTheControlFindsThem) {
    const IniOf f(
        "# c\n; c\n[A]\nK1 = 1\nK2=2\n  K3 = 3  \nk4 = 4\nK5 = 5 # c\nK8 =\nK9 = 9\nK9 = 99\nK10 = 1\\\n0\nK11 = "
        "+1.5e2\n"
        "K12 = \"12\"\nK13 = 0x10\n[ B ]\nK1 = 21\n[C] ; x\nK1 = 31\n[a]\nK1 = 41\n[A]\nK16 = 16\n");
    EXPECT_EQ(ini_number(f.ini, "a", "k1"), 1);
    EXPECT_EQ(ini_number(f.ini, "A", "K2"), 2);
    EXPECT_EQ(ini_number(f.ini, "a", "k3"), 3);
    EXPECT_EQ(ini_number(f.ini, "a", "k4"), std::nullopt);
    EXPECT_EQ(ini_number(f.ini, "a", "k5"), std::nullopt);
    EXPECT_EQ(find(f.ini, "A", "K5")->value, "5 # c");
    EXPECT_EQ(ini_number(f.ini, "a", "k8"), std::nullopt);
    EXPECT_EQ(ini_number(f.ini, "a", "k9"), 9);
    EXPECT_EQ(find(f.ini, "A", "K9", 1)->value, "99");
    EXPECT_EQ(find(f.ini, "A", "K9", 2), nullptr);
    EXPECT_EQ(ini_number(f.ini, "a", "k10"), 10);
    EXPECT_EQ(ini_number(f.ini, "a", "k11"), 150);
    EXPECT_EQ(ini_number(f.ini, "a", "k12"), std::nullopt);
    EXPECT_EQ(ini_number(f.ini, "a", "k13"), std::nullopt);
    EXPECT_EQ(ini_number(f.ini, "b", "k1"), std::nullopt);
    EXPECT_EQ(ini_number(f.ini, "c", "k1"), 31);
    EXPECT_EQ(find(f.ini, "a", "K1")->value, "41");
    EXPECT_EQ(ini_number(f.ini, "a", "k16"), std::nullopt);
    EXPECT_EQ(ini_number(f.ini, "z", "k1"), std::nullopt);
    EXPECT_EQ(f.sources.position(find(f.ini, "A", "K3")->where).column, 8U);
    EXPECT_EQ(f.complaints(),
              "m.ini:23:1: warning: section [A] is already there [job-file]\n  [A]\n  ^~~\n"
              "  remedy: LinuxCNC sees the first one only: put the keys together\n");
}

TEST(LinuxcncIni, Settings) {
    IniOf f(
        "[EMC]\nRS274NGC_STARTUP_CODE = G1\n[DISPLAY]\nPROGRAM_PREFIX = ../../nc_files\n[RS274NGC]\nPARAMETER_FILE = "
        "a.var\n"
        "RS274NGC_STARTUP_CODE = G17 G20\nSUBROUTINE_PATH = macros::~/lib:.\nFEATURES = 18\nOWORD_NARGS = 0\n"
        "DISABLE_FANUC_STYLE_SUB = 1\nCENTER_ARC_RADIUS_TOLERANCE_MM = 0.0001\n[TRAJ]\nLINEAR_UNITS = inch\n"
        "[AXIS_X]\nMIN_LIMIT = -10\nMAX_LIMIT = 20\n[AXIS_C]\nMAX_LIMIT = 360\nMAX_VELOCITY = 90\n"
        "[EMCIO]\nTOOL_TABLE = tool.tbl\nRANDOM_TOOLCHANGER = yes\n");
    const LinuxcncSettings s = f.settings();
    EXPECT_EQ(f.complaints(), "");
    EXPECT_EQ(s.mm_per_unit, 25.4);
    EXPECT_EQ(s.tool_table, "tool.tbl");
    EXPECT_TRUE(s.random_tool_changer);
    EXPECT_EQ(s.parameter_file, "a.var");
    EXPECT_EQ(s.startup_code, "G17 G20");
    EXPECT_EQ(s.program_prefix, "../../nc_files");
    EXPECT_EQ(s.subroutine_path, (std::vector<std::string>{"macros", "~/lib", "."}));
    EXPECT_FALSE(s.fanuc_subprograms);
    EXPECT_FALSE(s.oword_nargs);  // its own key wins over the bit
    EXPECT_TRUE(s.no_downcase_oword);
    EXPECT_FALSE(s.ini_vars);
    EXPECT_TRUE(s.g92_stays);
    EXPECT_EQ(s.arc_tolerance_mm, 0.001);
    EXPECT_NEAR(s.arc_tolerance_inch, 0.002828427, 1e-9);
    ASSERT_EQ(s.axes.size(), 2U);
    EXPECT_DOUBLE_EQ(s.axes[0].low, -254);
    EXPECT_DOUBLE_EQ(s.axes[0].high, 508);
    EXPECT_TRUE(std::isnan(s.axes[0].max_velocity));
    EXPECT_EQ(s.axes[1].letter, 'C');
    EXPECT_EQ(s.axes[1].high, 360);
    EXPECT_EQ(s.axes[1].max_velocity, 90);
}

TEST(LinuxcncIni, SettingsNotSaidAndWrong) {
    IniOf none("");
    const LinuxcncSettings s = none.settings();
    EXPECT_EQ(none.complaints(), "m.ini:1:1: note: [TRAJ]LINEAR_UNITS is not there: mm is assumed [assumption]\n");
    EXPECT_TRUE(s.ini_vars && s.hal_pin_vars && s.fanuc_subprograms && s.axes.empty());
    IniOf wrong(
        "key = 1\n[TRAJ]\nLINEAR_UNITS = foot\n[X\n[AXIS_X]\nMIN_LIMIT = left\nnothing\n= 3\n[RS274NGC]\n"
        "OWORD_NARGS = perhaps\nFEATURES = 1e99\n");
    const LinuxcncSettings w = wrong.settings();
    std::string seen;
    for (const base::Diagnostic& d : wrong.diagnostics.all()) {
        const base::Position p = wrong.sources.position(d.where);
        seen += std::to_string(p.line) + ":" + std::to_string(p.column) + ": " + d.text + "\n";
    }
    EXPECT_EQ(seen,
              "4:1: a section name without ]\n7:1: this line is no section, key or comment\n"
              "8:1: this line is no section, key or comment\n3:16: [TRAJ]LINEAR_UNITS: the unit must be mm or inch\n"
              "10:15: [RS274NGC]OWORD_NARGS: the value must be 0 or 1\n6:13: [AXIS_X]MIN_LIMIT: the value must be a "
              "number\n");
    EXPECT_EQ(w.mm_per_unit, 1);
    EXPECT_TRUE(std::isnan(w.axes.at(0).low));
    for (const auto& [text, unit] : {std::pair("mm", 1.0),
                                     {"metric", 1.0},
                                     {"Imperial", 25.4},
                                     {"in", 25.4},
                                     {"1.0", 1.0},
                                     {"0.03937007874016", 25.4}}) {
        IniOf u(std::string("[TRAJ]\nLINEAR_UNITS = ") + text + "\n");
        EXPECT_EQ(u.settings().mm_per_unit, unit) << text;
        EXPECT_EQ(u.complaints(), "");
    }
}

RC_GTEST_PROP(LinuxcncIni, AnyTextIsRead, (const std::string& noise)) {
    const std::string alphabet[] = {
        "[A]", "\n", "\\\n", "=", "K", " ", "#", "[", "]", "[RS274NGC]", "FEATURES=", "[TRAJ]\nLINEAR_UNITS=", "\\"};
    std::string text = noise;
    for (int i = *rc::gen::inRange(0, 30); i > 0; --i)
        text += alphabet[*rc::gen::inRange<std::size_t>(0, std::size(alphabet))];
    IniOf f(text);
    (void)f.settings();
    const std::size_t size = f.sources[0].text.size();
    for (const IniEntry& e : f.ini.entries) RC_ASSERT(e.where.begin <= e.where.end && e.where.end <= size);
    for (const base::Diagnostic& d : f.diagnostics.all())
        RC_ASSERT(d.where.begin <= d.where.end && d.where.end <= size);
    (void)f.complaints();
}

}  // namespace
}  // namespace obrys::shop
