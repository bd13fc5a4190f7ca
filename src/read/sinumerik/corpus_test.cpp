#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <map>

#include "read/sinumerik/reading.hpp"

namespace obrys::read::sinumerik {

namespace fs = std::filesystem;
using testing::Reading;

namespace {

const fs::path shared = fs::path(OBRYS_SOURCE_DIR) / ".." / "shared";

std::vector<fs::path> files_below(const fs::path& folder) {
    std::vector<fs::path> files;
    for (const auto& entry : fs::recursive_directory_iterator(folder))
        if (entry.is_regular_file()) files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    return files;
}

std::string content(const fs::path& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

bool has_syntax_error(const Reading& r) {
    return std::ranges::any_of(r.diagnostics.all(),
                               [](const base::Diagnostic& d) { return d.code == "syntax" || d.code == "unclosed"; });
}

}  // namespace

TEST(SinumerikCorpus, TheGrooveProgramsAreReadCompletely) {
    const fs::path groove = shared / "programs" / "groove";
    if (!fs::exists(groove)) GTEST_SKIP() << "needs ../shared";
    int count = 0;
    for (const fs::path& file : files_below(groove)) {
        if (file.extension() != ".MPF" && file.extension() != ".SPF") continue;
        const Reading r(content(file), file.filename().string());
        EXPECT_EQ(r.messages(), "") << file;
        EXPECT_TRUE(r.unit().problems.empty()) << file;
        EXPECT_EQ(r.unit().name, file.stem().string());
        ++count;
    }
    EXPECT_EQ(count, 6);
}

TEST(SinumerikCorpus, ProgramsAreReadWithoutSyntaxErrors) {
    const fs::path corpus = shared / "corpus" / "sinumerik";
    if (!fs::exists(corpus)) GTEST_SKIP() << "needs ../shared";
    int files = 0, good = 0, good_programs = 0, tests = 0;
    std::map<std::string, int> words;
    for (const fs::path& file : files_below(corpus)) {
        const Reading r(content(file), file.filename().string());
        // These hold wrong blocks on purpose: they test an editor's colouring of them.
        const bool deliberate = file.filename().string().starts_with("syntax_test_");
        ++files;
        tests += deliberate;
        good += !has_syntax_error(r);
        EXPECT_TRUE(deliberate || !has_syntax_error(r)) << r.messages();
        good_programs += !deliberate && !has_syntax_error(r);
        for (const auto& p : r.unit().problems) ++words[p.reason.empty() ? p.text : p.reason];
    }
    std::cout << files << " files, " << good << " without a syntax error; " << tests
              << " files are syntax tests with wrong blocks on purpose\n";
    std::vector<std::pair<int, std::string>> order;
    for (const auto& [word, n] : words) order.emplace_back(n, word);
    std::sort(order.rbegin(), order.rend());
    for (std::size_t i = 0; i < std::min<std::size_t>(order.size(), 10); ++i)
        std::cout << order[i].first << " x " << order[i].second << "\n";
    EXPECT_GE(good_programs * 100, (files - tests) * 95);
}

}  // namespace obrys::read::sinumerik
