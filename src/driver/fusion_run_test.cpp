/// Intermediate files from bytes to stream.

#include <gtest/gtest.h>

#include "driver/apt_testing.hpp"
#include "driver/files.hpp"
#include "driver/storage.hpp"
#include "read/fusion/fusion_testing.hpp"

namespace obrys::driver {

using read::fusion::testing::Bytes;
using testing::AnyRun;
using testing::run_for;

namespace {

AnyRun ran(const Bytes& b) {
    AnyRun r = run_for("fusion", b.listing());
    EXPECT_EQ(r.faults, "");
    return r;
}

Bytes drilling(std::string_view name) {
    Bytes b = Bytes().operation().rapid(1, 2, 15).whole(300).text(name);
    return b.parameter("clearance", 5)
        .parameter("retract", 4)
        .parameter("stock", -1)
        .parameter("depth", 9)
        .parameter("feedrate", 400);
}

}  // namespace

TEST(FusionRun, ArcsTurnAboutTheirNormal) {
    Bytes b = Bytes().operation().rapid(10, 0, 0);
    b.whole(110).singles({0, 10, 0, 0, 0, 0, 0, 0, 1, 100}).whole(0x20000);
    b.whole(111).singles({10, 0, 0, 0, 0, 0, 0, 0, 1, 100}).whole(0x20000);
    EXPECT_EQ(ran(b.end_operation()).moves,
              "rapid 10 0 0\narc 0 10 0 centre 0 0 0 normal 0 0 1 sweep 1.5707963267948966\n"
              "arc 10 0 0 centre 0 0 0 normal 0 0 1 sweep -1.5707963267948966\n");
}

TEST(FusionRun, ATiltedOperationCountsInItsOwnPlane) {
    const AnyRun r = ran(Bytes().operation(0.6, 0.8).rapid(0, 0, 10).linear(5, 0, 10, 100).end_operation());
    EXPECT_EQ(r.moves.substr(0, r.moves.find('\n')), "rapid ? ? ? axis 0.8 0 0.6");
    EXPECT_NE(r.moves.find("rapid 8 0 6 axis 0.8 0 0.6"), std::string::npos) << r.moves;
    EXPECT_NE(r.moves.find("linear 11 0 2 axis 0.8 0 0.6"), std::string::npos) << r.moves;
}

TEST(FusionRun, PointsWithAnAxisCountInTheSetup) {
    Bytes b = Bytes().operation(0, 1);  // its Z is the setup's X
    b.whole(121).singles({1, 2, 3, 0, 0, 1}).whole(0);
    b.whole(120).singles({1, 2, 4, 0.6, 0, 0.8, 500}).whole(0x20008);
    EXPECT_EQ(ran(b.end_operation()).moves, "rapid 3 2 -1 axis 1 0 0\nlinear 4 2 -1 axis 0.8 0 -0.6\n");
}

TEST(FusionRun, AHoleGoesFromTheClearanceToTheClearance) {
    const AnyRun r = ran(drilling("counter-boring")
                             .parameter("dwell", 0.5)
                             .linear(1, 2, -10, 0)
                             .linear(7, 2, -10, 0)
                             .whole(301)
                             .end_operation());
    EXPECT_EQ(r.moves,
              "rapid 1 2 15\nrapid 1 2 5\nrapid 1 2 5\nrapid 1 2 4\nlinear 1 2 -10\nrapid 1 2 5\n"
              "rapid 7 2 5\nrapid 7 2 5\nrapid 7 2 4\nlinear 7 2 -10\nrapid 7 2 5\n");
}

TEST(FusionRun, AnotherFeedOutIsRun) {
    const AnyRun r =
        ran(drilling("reaming").parameter("retractFeedrate", 900).linear(1, 2, -10, 0).whole(301).end_operation());
    EXPECT_EQ(r.moves, "rapid 1 2 15\nrapid 1 2 5\nrapid 1 2 4\nlinear 1 2 -10\nlinear 1 2 4\nrapid 1 2 5\n");
    std::string feeds;
    for (const cl::Record& record : r.records)
        if (const auto* f = std::get_if<cl::Feed>(&record.step))
            feeds += std::to_string(static_cast<int>(f->value)) + " ";
    EXPECT_EQ(feeds, "400 900 ");
}

TEST(FusionRun, ABinaryFileIsLoadedAsItsListing) {
    Memory files;
    const Bytes b = Bytes().operation().rapid(1, 2, 3).end_operation();
    files.put("part.cnc", b.get());
    files.put("other.cnc", std::string(100, '\1'));
    base::Sources sources;
    base::Diagnostics diagnostics;
    const auto file = load(files, "part.cnc", sources, diagnostics);
    ASSERT_TRUE(file);
    EXPECT_EQ(sources[*file].text, b.listing());
    EXPECT_FALSE(load(files, "other.cnc", sources, diagnostics));
    EXPECT_EQ(diagnostics.all().size(), 1);
}

}  // namespace obrys::driver
