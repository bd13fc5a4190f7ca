#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>

#include "base/diagnostic.hpp"
#include "driver/control.hpp"
#include "driver/programs.hpp"

namespace obrys::driver {

namespace {

const fs::path shared = fs::path(OBRYS_SOURCE_DIR) / ".." / "shared";

std::string content(const fs::path& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

void store_text(const fs::path& file, std::string_view text) { std::ofstream(file, std::ios::binary) << text; }

}  // namespace

TEST(Control, IsFoundFromTheTextOfEveryProgramOfTheCorpora) {
    const std::pair<const char*, const char*> corpora[]{
        {"sinumerik", "sinumerik-840d"}, {"klartext", "heidenhain-itnc530"}, {"rs274", "linuxcnc"}};
    for (const auto& [folder, control] : corpora) {
        const fs::path corpus = shared / "corpus" / folder;
        if (!fs::exists(corpus)) GTEST_SKIP() << "needs ../shared";
        for (const auto& entry : fs::recursive_directory_iterator(corpus)) {
            if (!entry.is_regular_file() || entry.path().extension() == ".txt") continue;
            const Guess guess = guess_control(content(entry.path()), entry.path().filename().string());
            EXPECT_EQ(guess.control->name, control) << entry.path();
        }
    }
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
    const auto main = load(folder / "main.ngc", sources, diagnostics);
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
