#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <map>

#include "base/text.hpp"
#include "read/rs274/reading.hpp"

namespace obrys::read::rs274 {

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

}  // namespace

TEST(Rs274Corpus, ProgramsAreRead) {
    int files = 0, good = 0;
    std::map<std::string, int> words;
    for (const char* folder : {"rs274", "gcode"}) {
        if (!fs::exists(shared / "corpus" / folder)) GTEST_SKIP() << "needs ../shared";
        for (const fs::path& file : files_below(shared / "corpus" / folder)) {
            const Reading r(content(file), file.lexically_relative(shared).string());
            ++files;
            const bool bad = std::ranges::any_of(r.diagnostics.all(), [](const auto& d) { return d.code == "syntax"; });
            good += !bad;
            std::cout << r.messages();
            for (const auto& u : r.units)
                for (const auto& p : u.problems)
                    if (!p.reason.empty()) ++words[p.reason];
        }
    }
    std::cout << files << " files, " << good << " without a syntax error\n";
    for (const auto& [word, n] : words) std::cout << n << " x " << word << "\n";
}

}  // namespace obrys::read::rs274
