#include "driver/documents/stream_table.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace obrys::driver {
namespace {

/// A move to a start and a spline with one rotary axis; z was never given.
const std::vector<cl::Record> records{
    {cl::Feed{100, cl::FeedMode::per_minute}, {0, 0, 2}, 0},
    {cl::Linear{{3, 0, NAN}, {0, 0, 1}, true}, {0, 0, 2}, 0},
    {cl::Tolerance{0.05, 0.1, cl::Filter::finishing}, {0, 3, 5}, 0},
    {cl::Spline{{1, 2, NAN}, {1, -2, 0}, {0.5, 0, 0}, {0.5, 0, 0}, {0, 0, 1}, {{{'A'}, 10, -1, 2, 0.25, true}}},
     {0, 3, 5},
     0}};

base::Sources sources() {
    base::Sources s;
    s.add("P.H", "L1\nL2\n");
    return s;
}

TEST(StreamTable, CsvHasARowForASpline) {
    const base::Sources s = sources();
    std::string out;
    const auto take = [&out](std::string_view text) { out += text; };
    CsvWriter writer(s, take);
    for (const cl::Record& r : records) writer(r);
    EXPECT_EQ(out,
              "i,file,line,block,kind,x,y,z,feed,cx,cy,cz,sense\n"
              "0,P.H,1,,rapid,3.000000000,0.000000000,,,,,,\n"
              "1,P.H,2,,spline,1.000000000,2.000000000,,100.000000000,,,,\n");
}

TEST(StreamTable, JsonHoldsTheCoefficientsOfASpline) {
    const base::Sources s = sources();
    std::string out;
    const auto take = [&out](std::string_view text) { out += text; };
    JsonWriter writer(s, take);
    for (const cl::Record& r : records) writer(r);
    writer.finish();
    const auto j = nlohmann::json::parse(out);
    ASSERT_EQ(j.size(), 2u);
    EXPECT_FALSE(j[0].contains("k1_mm"));
    EXPECT_EQ(j[1]["kind"], "spline");
    EXPECT_TRUE(j[1]["z_mm"].is_null());
    EXPECT_EQ(j[1]["k3_mm"], nlohmann::json({0.5, 0.0, 0.0}));
    EXPECT_EQ(j[1]["k2_mm"], nlohmann::json({0.5, 0.0, 0.0}));
    EXPECT_EQ(j[1]["k1_mm"], nlohmann::json({1.0, -2.0, 0.0}));
    EXPECT_EQ(j[1]["axes"],
              nlohmann::json::parse(R"([{"name":"A","unit":"deg","to":10.0,"k3":0.25,"k2":2.0,"k1":-1.0}])"));
}

}  // namespace
}  // namespace obrys::driver
