#include <gtest/gtest.h>

#include <chrono>
#include <fstream>

#include "driver/folders.hpp"

namespace obrys::driver {
namespace {

void write(const fs::path& path) { std::ofstream(path) << "M30\n"; }

TEST(Folders, AreListedOnceAndAgainWhenTheyHaveChanged) {
    const fs::path folder = fs::path(::testing::TempDir()) / "obrys_folders";
    fs::remove_all(folder);
    fs::create_directory(folder);
    write(folder / "b.nc");
    write(folder / "table.d");
    Folders folders;
    const Folders::Paths first = folders.list(folder);
    ASSERT_EQ(first->size(), 2u);
    EXPECT_EQ(folders.list(folder), first);
    const Control& fanuc = *find_control("fanuc");
    const auto index = folders.programs(folder, fanuc);
    EXPECT_EQ(folders.programs(folder, fanuc), index);
    EXPECT_TRUE(index->files.contains("B"));
    EXPECT_EQ(folders.shop_files(folder)->size(), 1u);

    write(folder / "O0020.nc");
    fs::last_write_time(folder, fs::last_write_time(folder) + std::chrono::seconds(1));  // clocks of files are coarse
    EXPECT_EQ(folders.list(folder)->size(), 3u);
    EXPECT_TRUE(folders.programs(folder, fanuc)->files.contains("O20"));
    EXPECT_FALSE(index->files.contains("O20"));
    fs::remove_all(folder);
}

TEST(Folders, OneThatIsNotThereIsEmpty) {
    Folders folders;
    EXPECT_TRUE(folders.list("no/such/folder")->empty());
    EXPECT_TRUE(folders.programs("no/such/folder", *find_control("fanuc"))->files.empty());
}

}  // namespace
}  // namespace obrys::driver
