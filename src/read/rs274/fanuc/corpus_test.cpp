#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <map>

#include "base/files_testing.hpp"
#include "read/rs274/fanuc/reading.hpp"

namespace obrys::read::rs274 {

namespace fs = std::filesystem;
using base::testing::content;
using base::testing::files_below;
using testing::Reading;

namespace {

const fs::path corpus = fs::path(OBRYS_SOURCE_DIR) / ".." / "shared" / "corpus";

/// Every problem has its text and lies in the file; the last program reaches to the end of what is read.
void check_complete(const Reading& r, const fs::path& file) {
    const std::size_t size = r.sources[r.file].text.size();
    ASSERT_FALSE(r.units.empty()) << file;
    for (const program::Unit& u : r.units) {
        EXPECT_LE(u.begin, u.end) << file;
        EXPECT_LE(u.end, size) << file;
        for (const program::Problem& p : u.problems) EXPECT_FALSE(p.text.empty() && p.reason.empty()) << file;
        for (const program::Statement& s : u.statements) EXPECT_LE(s.begin + s.length, size) << file;
    }
}

}  // namespace

TEST(FanucCorpus, EveryFileIsReadToItsEndAndWhatIsNotRunIsNamed) {
    if (!fs::exists(corpus)) GTEST_SKIP() << "needs ../shared";
    int files = 0;
    std::map<std::string, int> named;
    for (const char* folder : {"fanuc_macro", "gcode", "rs274"})
        for (const fs::path& file : files_below(corpus / folder)) {
            const std::string text = content(file);
            for (const testing::Reader reader : {testing::Reader(read_fanuc), testing::Reader(read_haas)}) {
                const Reading r(text, file.filename().string(), reader);
                check_complete(r, file);
                if (std::string_view(folder) == "gcode")
                    for (const program::Unit& u : r.units)
                        for (const program::Problem& p : u.problems) ++named[p.text + ": " + p.reason];
            }
            ++files;
        }
    EXPECT_GT(files, 400);
    std::cout << files << " files; not run in gcode/:\n";
    for (const auto& [what, count] : named)
        if (count > 4) std::cout << "  " << count << " " << what << "\n";
}

/// Programs of shops and post processors for these controls: nothing but what obrys says it does not run.
TEST(FanucCorpus, ProgramsForTheseControlsHaveNoSyntaxErrors) {
    if (!fs::exists(corpus)) GTEST_SKIP() << "needs ../shared";
    int good = 0, bad = 0;
    for (const char* folder :
         {"fanuc_macro/Faberfaction__CNCmacros", "gcode/dillonhuff__gpr", "gcode/Unigraphics__NX.Postprocessor"})
        for (const fs::path& file : files_below(corpus / folder)) {
            const std::string text = content(file);
            const Reading r(text, file.filename().string(), read_haas);
            const bool wrong = std::ranges::any_of(r.diagnostics.all(), [](const base::Diagnostic& d) {
                return d.code == "syntax" || d.code == "unclosed";
            });
            (wrong ? bad : good) += 1;
            if (wrong) std::cout << file.filename() << ": " << r.first_message() << "\n";
        }
    // HAAS_sample.NCF has `P` without a value, camaster_sample.tap is for another control, Micron WF21D is DIN/ISO of
    // HEIDENHAIN, the text of NL1500Y_polar goes on behind its program.
    EXPECT_EQ(bad, 4);
    EXPECT_EQ(good, 13);
}

namespace {

/// The control that the texts' own signs ask for.
bool is_fanuc(const fs::path& file) {
    const std::string path = file.generic_string();
    if (path.find("Faberfaction") != std::string::npos) return true;
    return path.find("corpus/gcode/") != std::string::npos && path.find("CAMotics") == std::string::npos &&
           path.find("camaster") == std::string::npos && path.find("Micron") == std::string::npos;
}

}  // namespace

TEST(FanucCorpus, ProgramsAreRecognised) {
    if (!fs::exists(corpus)) GTEST_SKIP() << "needs ../shared";
    int wrong = 0, all = 0, least = 100, most = 0;
    for (const char* folder : {"fanuc_macro", "gcode", "rs274", "sinumerik", "klartext"})
        for (const fs::path& file : files_below(corpus / folder)) {
            const std::string text = content(file), name = file.filename().string();
            const int fanuc = std::max(fanuc_likelihood(text, name), haas_likelihood(text, name));
            const bool taken = fanuc >= 35;
            ++all;
            (is_fanuc(file) ? least : most) = is_fanuc(file) ? std::min(least, fanuc) : std::max(most, fanuc);
            if (taken == is_fanuc(file)) continue;
            ++wrong;
            std::cout << file.lexically_relative(corpus) << " " << fanuc << "\n";
        }
    std::cout << wrong << " of " << all << " guessed wrong; likelihood at least " << least
              << " for programs of these controls, at most " << most << " for others\n";
    EXPECT_EQ(wrong, 0);
}

/// Against LinuxCNC's reader, whose programs look most like these.
TEST(FanucCorpus, ProgramsAreToldFromThoseOfLinuxcnc) {
    if (!fs::exists(corpus)) GTEST_SKIP() << "needs ../shared";
    int wrong = 0, all = 0;
    for (const char* folder : {"fanuc_macro", "gcode", "rs274"})
        for (const fs::path& file : files_below(corpus / folder)) {
            const std::string text = content(file), name = file.filename().string();
            if (name == "camaster_sample.tap" || file.generic_string().find("Micron") != std::string::npos) continue;
            const int fanuc = std::max(fanuc_likelihood(text, name), haas_likelihood(text, name));
            const int linuxcnc = linuxcnc_likelihood(text, name);
            ++all;
            if ((fanuc > linuxcnc) == is_fanuc(file)) continue;
            ++wrong;
            std::cout << file.lexically_relative(corpus) << " fanuc " << fanuc << " linuxcnc " << linuxcnc << "\n";
        }
    std::cout << wrong << " of " << all << " guessed wrong\n";
    EXPECT_LE(wrong, 3);
}

TEST(FanucCorpus, LathesAreRecognised) {
    if (!fs::exists(corpus)) GTEST_SKIP() << "needs ../shared";
    for (const fs::path& file : files_below(corpus / "gcode")) {
        if (!is_fanuc(file)) continue;
        const std::string path = file.generic_string();
        const bool lathe = path.find("NL1500Y") != std::string::npos || path.find("mazak") != std::string::npos;
        EXPECT_EQ(guess_machine(content(file)).machine == dialect::rs274::FanucMachine::lathe, lathe) << file;
    }
}

}  // namespace obrys::read::rs274
