// The loader with modules of our own (fake_module.cpp): a part comes out, or a complaint; never a crash, never a wait.
#include <gtest/gtest.h>

#include <chrono>
#include <cstdlib>
#include <string>

#include "driver/loadable.hpp"
#include "driver/step_file.hpp"

namespace obrys::driver {
namespace {

struct Read {
    std::optional<StepFile> file;
    std::string said;
    base::Span where;    ///< of the last complaint
    std::string remedy;  ///< of the last complaint
};

Read read_bytes(const std::string& bytes, double tolerance = 0.01) {
    Guard guard;
    guard.seconds = 2;
    guard.memory_bytes = 2e8;
    base::Diagnostics out;
    Read r;
    r.file = read_step(0, bytes, tolerance, guard, out, {7, 1, 2});
    for (const base::Diagnostic& d : out.all()) {
        r.said += std::string(d.code) + (d.where.file == 7 ? " in the job: " : ": ") + d.text + "\n";
        r.remedy = d.remedy;
        r.where = d.where;
    }
    return r;
}

Read read(const std::string& what) { return read_bytes("ISO-10303-21;\nFAKE " + what + "\nEND-ISO-10303-21;\n"); }

class Loader : public testing::Test {
protected:
    void SetUp() override { use(OBRYS_FAKE_MODULES "/good"); }
    void TearDown() override { unsetenv("OBRYS_MODULES"); }
    static void use(const char* folders) { setenv("OBRYS_MODULES", folders, 1); }
};

TEST_F(Loader, BodiesAreJoinedAndMeasured) {
    const Read r = read("one box");
    ASSERT_TRUE(r.file) << r.said;
    EXPECT_EQ(r.said, "");
    ASSERT_EQ(r.file->solids.size(), 1U);
    EXPECT_EQ(r.file->solids[0].vertices.size(), 8U);
    EXPECT_DOUBLE_EQ(mesh::volume(r.file->solids[0]), 1000);
    EXPECT_TRUE(r.file->closed);
    EXPECT_EQ(read("two boxes").file->solids.size(), 2U);
    EXPECT_EQ(read("odd entries").said,
              "assumption: of the STEP file 2 entries are not as Open CASCADE expects: what they say may be missing\n");
    EXPECT_EQ(read("loose faces").said, "assumption: 3 faces that bound no solid left out\n");
}

TEST_F(Loader, TheDeflectionFollowsTheTolerance) {
    EXPECT_DOUBLE_EQ(step_deflection(0.01), 0.002);
    EXPECT_DOUBLE_EQ(step_deflection(1), 0.2);
    EXPECT_DOUBLE_EQ(step_deflection(1e-6), 0.0005);
    for (const double tolerance : {0.01, 0.02}) {
        const Read r = read_bytes("ISO-10303-21;\nfineness\nEND-ISO-10303-21;", tolerance);
        ASSERT_TRUE(r.file) << r.said;
        EXPECT_LE(mesh::bounds(r.file->solids[0]).lo.x, 1000 * step_deflection(tolerance));
        EXPECT_GE(mesh::bounds(r.file->solids[0]).lo.x, 500 * step_deflection(tolerance));
    }
}

TEST_F(Loader, HolesAndCrashesAreTriedTheOtherWay) {
    for (const std::string what : {"hole", "weak"}) {
        const Read r = read(what);
        ASSERT_TRUE(r.file) << r.said;
        EXPECT_TRUE(r.file->closed);
        EXPECT_EQ(r.said, "");
    }
    const Read r = read("open");
    ASSERT_TRUE(r.file);
    EXPECT_FALSE(r.file->closed);
    EXPECT_EQ(r.said, "mesh-not-closed: 1 face could not be made into triangles: there are holes\n");
}

TEST_F(Loader, WhatAModuleMustNotDo) {
    EXPECT_NE(read("crash").said.find("mesh-file: Open CASCADE, which reads STEP files, crashed on this one"),
              std::string::npos);
    EXPECT_NE(read("throw").said.find("crashed"), std::string::npos);
    EXPECT_NE(read("memory").said.find("crashed"), std::string::npos);
    EXPECT_EQ(read("leave").said, "mesh-file: what Open CASCADE makes of the STEP file is no mesh\n");
    EXPECT_EQ(read("beyond").said, "mesh-file: what Open CASCADE makes of the STEP file is no mesh\n");
    EXPECT_EQ(read("refuse").said, "mesh-file: it does not please\n");
    for (const std::string what : {"crash", "throw", "memory", "leave", "beyond", "refuse"})
        EXPECT_FALSE(read(what).file) << what;
}

TEST_F(Loader, ADamagedLineIsShown) {
    const base::Span where = read("refuse a line").where;  // the second one
    EXPECT_EQ(where.begin, 14U);
    EXPECT_EQ(where.end, 14U + 18U);
    EXPECT_EQ(read("refuse").where.end, 0U);
}

TEST_F(Loader, TimeAndMemoryAreLimited) {
    const auto begin = std::chrono::steady_clock::now();
    EXPECT_EQ(read("hang").said, "mesh-file: reading the STEP file was given up after 2 s\n");
    EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(10));
    const std::string said = read("endless").said;
    EXPECT_TRUE(said.find("more triangles than there is memory for") != std::string::npos ||
                said.find("given up") != std::string::npos)
        << said;
}

TEST_F(Loader, WhatItPrintsIsNotSeen) {
    testing::internal::CaptureStdout();
    const Read r = read("chatter");
    EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
    EXPECT_TRUE(r.file);
}

TEST_F(Loader, ModulesThatAreNotThereOrNotOurs) {
    use(OBRYS_FAKE_MODULES "/none");
    EXPECT_NE(read("box").said.find("mesh-file in the job: STEP files need a module that is not installed"),
              std::string::npos);
    EXPECT_NE(read("box").remedy.find("obrys-step"), std::string::npos);
    use(OBRYS_FAKE_MODULES "/old");
    EXPECT_NE(read("box").said.find("belongs to another version of obrys"), std::string::npos);
    use(OBRYS_FAKE_MODULES "/broken");
    EXPECT_NE(read("box").said.find("cannot be used"), std::string::npos);
    use(OBRYS_FAKE_MODULES "/none:" OBRYS_FAKE_MODULES "/good");
    EXPECT_TRUE(read("box").file);
}

TEST_F(Loader, FilesThatAreNoStepFilesAreSeenWithoutAModule) {
    use(OBRYS_FAKE_MODULES "/none");
    EXPECT_EQ(read_bytes("").said, "file-empty: the STEP file is empty\n");
    EXPECT_EQ(read_bytes(" \n").said, "file-empty: the STEP file is empty\n");
    EXPECT_EQ(read_bytes("solid x\nendsolid\n").said,
              "mesh-file: this is no STEP file: it does not begin with ISO-10303-21\n");
    EXPECT_EQ(read_bytes("ISO-10303-21;\nDATA;\n#1=CARTESIAN_PO").said,
              "mesh-file: the STEP file is cut off: there is no END-ISO-10303-21 at its end\n");
    EXPECT_EQ(read_bytes(std::string("ISO-10303-21;\0\0\nEND-ISO-10303-21;", 33)).said,
              "mesh-file: the STEP file is damaged: it holds bytes that are no text\n");
}

}  // namespace
}  // namespace obrys::driver
