#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <map>

#include "base/diagnostic.hpp"
#include "base/files_testing.hpp"
#include "driver/control.hpp"
#include "driver/programs.hpp"

namespace obrys::driver {

namespace {

using base::testing::content;

const fs::path shared_folder = fs::path(OBRYS_SOURCE_DIR) / ".." / "shared";

void store_text(const fs::path& file, std::string_view text) { std::ofstream(file, std::ios::binary) << text; }

}  // namespace

TEST(Control, IsFoundFromTheTextOfEveryProgramOfTheCorpora) {
    const std::pair<const char*, const char*> corpora[]{
        {"sinumerik", "sinumerik-840d"}, {"klartext", "heidenhain-itnc530"}, {"rs274", "linuxcnc"}};
    for (const auto& [folder, control] : corpora) {
        const fs::path corpus = shared_folder / "corpus" / folder;
        if (!fs::exists(corpus)) GTEST_SKIP() << "needs ../shared";
        for (const auto& entry : fs::recursive_directory_iterator(corpus)) {
            if (!entry.is_regular_file() || entry.path().extension() == ".txt") continue;
            const Guess guess = guess_control(content(entry.path()), entry.path().filename().string());
            EXPECT_EQ(guess.control->name, control) << entry.path();
        }
    }
}

namespace {

Guess guess_of(std::string_view text, std::string_view name) { return guess_control(text, name); }

std::string taken(std::string_view text, std::string_view name) {
    return std::string(guess_of(text, name).control->name);
}

}  // namespace

TEST(Control, WordsOfFanucAndHaasAreKnown) {
    EXPECT_EQ(taken("%\nO1000\nG0 X10. Y10.\nG1 Z-1. F100.\nM30\n%\n", "a.nc"), "fanuc");
    EXPECT_EQ(taken("G21 G90\nG91 G28 Z0.\nG90 G54\nG0 X10. Y10.\nM30\n", "b.nc"), "fanuc");
    EXPECT_EQ(taken("T0101\nG97 S500 M3\nG0 X50. Z2.\nG1 Z-20. F0.2\nM30\n", "c.nc"), "fanuc");
    EXPECT_EQ(taken("N1 T0101\nG0 X50. Z2.\nG71 U2. R1.\nG71 P10 Q20 U0.5 W0.1 F0.2\nN10 G0 X20.\nM30\n", "d.nc"),
              "fanuc");
    EXPECT_EQ(taken("G21 G90 G17\nT2 M6\nM3 S1000\nG43 H2 Z50.\nG0 X10. Y5.\nM30\n", "a.nc"), "fanuc") << "G43 Z first";
    EXPECT_EQ(taken("%\nO1234 (PART)\nG21 G90 G17\nT2 M6\nG43 H2 Z50\nG0 X10 Y5\nM30\n%\n", "a.nc"), "fanuc");
    EXPECT_EQ(taken("G54 G90\nG0 X10. Y10.\nG13 I10. F100. D1\nM30\n", "e.nc"), "haas");
    EXPECT_EQ(taken("G54 G90\nG13 D1 I10. F100.\nM30\n", "e.nc"), "haas");
    EXPECT_EQ(taken("G90\nG154 P5\nG187 P1\nG0 X10. Y10.\nM97 P100\nM30\n", "f.nc"), "haas");
    EXPECT_EQ(taken("G21 G64 P0.01\no100 call\nG0 X#<a>\nM2\n", "g.nc"), "linuxcnc");
}

TEST(Control, AGuessSaysItsReasonsAndItsDoubt) {
    const Guess plain = guess_of("G21\nM3 S10000\nG0 X10 Y10\nG1 Z-1 F300\nX100\nM30\n", "a.cnc");
    EXPECT_EQ(plain.control->name, "linuxcnc");
    EXPECT_TRUE(plain.signs.empty());
    EXPECT_NE(plain.difference.find("X10 without a point is 10 mm on linuxcnc"), std::string::npos) << plain.difference;
    const Guess points = guess_of("G21\nG0 X10. Y10.\nG1 Z-1. F300\nM30\n", "a.nc");
    EXPECT_EQ(points.difference, "") << "with points all read the same";
    const Guess lathe = guess_of("T1\nG96 S200 M3\nG0 X50. Z2.\nG1 Z-20. F0.2\nM30\n", "a.nc");
    EXPECT_NE(lathe.difference.find("X50. is a diameter"), std::string::npos) << lathe.difference;
    const std::string changed = "G21 G18 G90\nT1 M6\nG97 S500 M3\nG0 X40. Z2.\nG1 X24. F100.\nM30\n";
    EXPECT_NE(guess_of(changed, "a.nc").difference.find("X40. is a diameter"), std::string::npos) << "M6 on a lathe";
    const std::string bare = "G21 G90\nT1 M6\nS500 M3\nG0 X40. Z2.\nG1 X24. F100.\nM30\n";
    EXPECT_NE(guess_control(bare, "a.nc", true).difference.find("X40. is a diameter"), std::string::npos);
    EXPECT_EQ(guess_control(bare, "a.nc", false).difference, "");
    EXPECT_EQ(guess_control(changed, "a.nc", false).difference, "");
    const Guess pecks = guess_of("G21 G90 G17\nT2 M6\nG0 G43 H2 Z50.\nG83 X10. Y5. Z-10. R2. Q5 F100.\nM30\n", "a.nc");
    EXPECT_NE(pecks.difference.find("Q5 without a point is 5 mm"), std::string::npos) << pecks.difference;
    const Guess rotary = guess_of("G21 G90 G17\nT2 M6\nG0 X5. A45\nM30\n", "a.nc");
    EXPECT_NE(rotary.difference.find("A45 without a point is 45 degrees"), std::string::npos) << rotary.difference;
    const Guess named = guess_of("G21\nG0 X10 Y10\nM2\n", "a.ngc");
    EXPECT_TRUE(named.by_suffix);
    EXPECT_EQ(named.difference, "");
    const Guess misnamed = guess_of("T0101\nG97 S500 M3\nG0 X50. Z2.\nG71 U2. R1.\nG71 P10 Q20 U0.5\nM30\n", "a.mpf");
    EXPECT_TRUE(misnamed.control->name != "sinumerik-840d" || !misnamed.difference.empty());
    const Guess eding = guess_of("sub user_1\nmsg \"hi\"\nendsub\nif [#5 > 3]\ngosub user_1\nendif\nM30\n", "a.cnc");
    EXPECT_NE(eding.foreign.find("Eding CNC"), std::string::npos);
    const Guess haas = guess_of("G90\nG154 P5\nM97 P100\nM30\n", "f.nc");
    EXPECT_EQ(std::count(haas.signs.begin(), haas.signs.end(), "G154P5"), 1);
}

/// The folders of the corpora tell the truth; what is printed is the table of docs/dialects/detection.md.
TEST(Control, ConfusionOverTheCorpora) {
    const fs::path corpus = shared_folder / "corpus";
    if (!fs::exists(corpus)) GTEST_SKIP() << "needs ../shared";
    struct Truth {
        const char *folder, *name_part, *control;  // control: what it is; "": one that is not read
    };
    const Truth truths[]{
        {"sinumerik", "", "sinumerik-840d"},
        {"klartext", "", "heidenhain-itnc530"},
        {"rs274", "", "linuxcnc"},
        {"fanuc_macro/LinuxCNC__linuxcnc", "", "linuxcnc"},
        {"fanuc_macro/Faberfaction__CNCmacros", "", "haas"},
        {"gcode/CauldronDevelopmentLLC__CAMotics", "", "linuxcnc"},
        {"gcode/dillonhuff__gpr", "HAAS", "haas"},
        {"gcode/dillonhuff__gpr", "mazak", ""},
        {"gcode/dillonhuff__gpr", "camaster", ""},
        {"gcode/Unigraphics__NX.Postprocessor", "Haas", "haas"},
        {"gcode/Unigraphics__NX.Postprocessor", "Micron", "heidenhain-itnc530"},
        {"gcode/Unigraphics__NX.Postprocessor", "Makino", "fanuc"},
        {"gcode/Unigraphics__NX.Postprocessor", "Mori Seiki", "fanuc"},
        {"gcode/Unigraphics__NX.Postprocessor", "MS SH8000", "fanuc"},
        {"gcode/Unigraphics__NX.Postprocessor", "Mitsubishi", "fanuc"},
        {"gcode/Unigraphics__NX.Postprocessor", "Okuma", ""},
    };
    std::map<std::pair<std::string, std::string>, int> table;
    int wrong_and_sure = 0;
    for (const Truth& t : truths) {
        if (!fs::exists(corpus / t.folder)) continue;
        for (const auto& entry : fs::recursive_directory_iterator(corpus / t.folder)) {
            const std::string name = entry.path().filename().string();
            if (!entry.is_regular_file() || entry.path().generic_string().find(t.name_part) == std::string::npos)
                continue;
            if (std::string_view(t.folder) != "gcode/Unigraphics__NX.Postprocessor" &&
                entry.path().extension() == ".txt")
                continue;  // licences and notes
            const Guess g = guess_of(content(entry.path()), name);
            const bool doubted = g.likelihood < 30 || !g.difference.empty() || !g.foreign.empty();
            const std::string truth = *t.control == 0 ? "another" : t.control;
            ++table[{truth, std::string(g.control->name) + (doubted ? ", in doubt" : "")}];
            const bool family = truth == "haas" && g.control->name == "fanuc";  // the same numbers
            if (truth != g.control->name && !family && !doubted) {
                ++wrong_and_sure;
                std::cout << "wrong: " << entry.path().generic_string() << " as " << g.control->name << " "
                          << g.likelihood << "\n";
            }
        }
    }
    std::cout << "it is -> it is taken for: files\n";
    for (const auto& [what, files] : table) std::cout << what.first << " -> " << what.second << ": " << files << "\n";
    EXPECT_EQ(wrong_and_sure, 0);
}

TEST(Control, LinuxCncFindsSubprogramsInTheirFiles) {
    const fs::path folder = fs::temp_directory_path() / "obrys_control_test";
    fs::create_directories(folder);
    store_text(folder / "main.ngc", "o<foo> call\no<own> sub\nX1\no<own> endsub\nM2\n");
    store_text(folder / "foo.ngc", "o<other> sub\nX1\no<other> endsub\no<foo> sub\nX2\no<foo> endsub\n");
    store_text(folder / "100.nc", "o100 sub\nX3\no100 endsub\n");
    store_text(folder / "O200.ngc", "O200\nX4\nM99\n");
    store_text(folder / "own.ngc", "o<own> sub\nX9\no<own> endsub\n");
    store_text(folder / "empty.ngc", "X1\nM2\n");
    const Control* control = find_control("linuxcnc");
    ASSERT_NE(control, nullptr);
    base::Sources sources;
    base::Diagnostics diagnostics;
    Programs programs(*control, sources, diagnostics);
    programs.add_folder(folder);
    const auto main = load(*disk(), folder / "main.ngc", sources, diagnostics);
    ASSERT_TRUE(main.has_value());
    EXPECT_EQ(programs.read(*main)->name, "MAIN");
    for (const char* name : {"O<FOO>", "O<OTHER>", "O100", "O200", "O<OWN>"}) {
        const program::Unit* unit = programs.find(name);
        ASSERT_NE(unit, nullptr) << name;
        EXPECT_EQ(unit->name, name);
    }
    EXPECT_EQ(programs.find("O<OWN>")->file, *main) << "what a text defines goes before a file";
    EXPECT_EQ(programs.find("O200")->jumps.size(), 0U) << "its M99 returns";
    EXPECT_EQ(programs.find("O<EMPTY>"), nullptr) << "the file does not define it";
    EXPECT_EQ(programs.find("O<NOWHERE>"), nullptr);
    fs::remove_all(folder);
}

}  // namespace obrys::driver
