#include "driver/storage.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

namespace obrys::driver {
namespace {

using Kind = StoredEntry::Kind;

std::vector<std::string> names(const Storage& s, const fs::path& folder) {
    std::vector<std::string> all;
    for (const fs::path& p : s.list(folder)) all.push_back(p.generic_string());
    std::sort(all.begin(), all.end());
    return all;
}

TEST(Memory, HoldsFilesAndTheirFolders) {
    Memory m;
    m.put("jobs/a/../A.H", "1");
    m.put("B.H", "22");
    EXPECT_EQ(m.look("jobs/A.H").kind, Kind::file);
    EXPECT_EQ(m.look("./B.H").size, 2u);
    EXPECT_EQ(m.look("jobs").kind, Kind::folder);
    EXPECT_EQ(m.look("jobs/").kind, Kind::folder);
    EXPECT_EQ(m.look(".").kind, Kind::folder);
    EXPECT_EQ(m.look("job").kind, Kind::nothing);
    EXPECT_EQ(m.look("jobs/a").kind, Kind::nothing);
    EXPECT_EQ(names(m, ""), std::vector<std::string>{"B.H"});
    EXPECT_EQ(names(m, "jobs"), std::vector<std::string>{"jobs/A.H"});
    std::string bytes;
    EXPECT_EQ(m.read("jobs/A.H", 1, bytes), 0);
    EXPECT_EQ(bytes, "1");
    EXPECT_NE(m.read("jobs/C.H", 1, bytes), 0);
}

TEST(Memory, ChangesAreSeen) {
    Memory m;
    m.put("A.H", "1");
    const auto before = m.changed(".");
    m.put("B.H", "1");
    EXPECT_NE(m.changed("."), before);
    EXPECT_TRUE(m.remove("B.H"));
    EXPECT_FALSE(m.remove("B.H"));
    EXPECT_EQ(m.look("B.H").kind, Kind::nothing);
}

TEST(Memory, StandsInFrontOfTheDisk) {
    const fs::path folder = fs::temp_directory_path() / "obrys-storage-test";
    fs::create_directories(folder);
    std::ofstream(folder / "A.H") << "disk";
    std::ofstream(folder / "B.H") << "disk";
    Memory m(disk());
    m.put(folder / "A.H", "memory");
    m.put(folder / "C.H", "memory");
    const auto content = [&](const char* name) {
        std::string bytes;
        const StoredEntry entry = m.look(folder / name);
        EXPECT_EQ(entry.kind, Kind::file);
        EXPECT_EQ(m.read(folder / name, entry.size, bytes), 0);
        return bytes;
    };
    EXPECT_EQ(content("A.H"), "memory");
    EXPECT_EQ(content("B.H"), "disk");
    EXPECT_EQ(content("C.H"), "memory");
    EXPECT_EQ(m.list(folder).size(), 3u);
    EXPECT_TRUE(m.remove(folder / "A.H"));
    EXPECT_EQ(content("A.H"), "disk");
    fs::remove_all(folder);
}

}  // namespace
}  // namespace obrys::driver
