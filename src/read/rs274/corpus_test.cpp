#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>

#include "base/files_testing.hpp"
#include "read/rs274/reading.hpp"

namespace obrys::read::rs274 {

namespace fs = std::filesystem;
using base::testing::content;
using base::testing::files_below;
using testing::Reading;

namespace {

const fs::path shared = fs::path(OBRYS_SOURCE_DIR) / ".." / "shared";

}  // namespace

namespace {

/// Programs that rs274 refuses too; of the rest a reader of LinuxCNC programs knows every word but the codes that a
/// remapping of the machine defines.
constexpr std::array<std::string_view, 5> refused{
    "tests/interp/bad/nested.ngc",
    "tests/interp/nested-sub-error/subs/nested.ngc",
    "06-error-mixed-sub-styles/O...-sub-ended-with-M99.ngc",
    "06-error-mixed-sub-styles/O...-sub-called-with-M98.ngc",
    "GlobalNamedTest/data/stdin",
};
/// Codes of remappings: numbers that LinuxCNC itself does not have.
bool is_remapped(const std::string& text) { return text.starts_with("LinuxCNC has no "); }

bool is_refused(const std::string& file) {
    return std::any_of(refused.begin(), refused.end(), [&](std::string_view end) { return file.ends_with(end); });
}

}  // namespace

TEST(Rs274Corpus, LinuxCncProgramsAreRead) {
    const fs::path corpus = shared / "corpus" / "rs274";
    if (!fs::exists(corpus)) GTEST_SKIP() << "needs ../shared";
    int files = 0, complained = 0, remapped = 0;
    for (const fs::path& file : files_below(corpus)) {
        if (file.extension() != ".ngc" && file.filename() != "stdin") continue;
        const Reading r(content(file), file.filename().string());
        ++files;
        bool found = false;
        for (const base::Diagnostic& d : r.diagnostics.all()) {
            if (d.code != "syntax") continue;
            remapped += is_remapped(d.text);
            found = found || !is_remapped(d.text);
            EXPECT_TRUE(is_remapped(d.text) || is_refused(file.string())) << file << ": " << d.text;
        }
        EXPECT_EQ(found, is_refused(file.string())) << file;
        complained += found;
    }
    std::cout << files << " files, " << complained << " with a syntax error, " << remapped << " remapped codes\n";
    EXPECT_GE(files, 380);
}

/// Other controls' programs: nothing crashes, and what is not known has a place and a name.
TEST(Rs274Corpus, OtherProgramsAreReadToTheirEnd) {
    for (const char* folder : {"gcode", "fanuc_macro", "sinumerik", "klartext", "apt"}) {
        if (!fs::exists(shared / "corpus" / folder)) GTEST_SKIP() << "needs ../shared";
        int files = 0;
        for (const fs::path& file : files_below(shared / "corpus" / folder)) {
            const Reading r(content(file), file.filename().string());
            ++files;
            for (const auto& unit : r.units)
                for (const auto& p : unit.problems) EXPECT_LE(p.where.end, r.sources[r.file].text.size());
        }
        std::cout << folder << ": " << files << " files\n";
    }
}

}  // namespace obrys::read::rs274
