#include <gtest/gtest.h>

#include "read/fusion/fusion_testing.hpp"

namespace obrys::read::fusion {

using testing::Bytes;

namespace {

/// What the listing says behind its first line.
std::string behind_first(const std::string& listing) {
    const std::size_t end = listing.find('\n');
    return end == std::string::npos ? "" : listing.substr(end + 1);
}

constexpr std::size_t first_record = 4 + 54 + 7;  ///< bytes of the header
std::string at(std::size_t more, const std::string& rest) {
    return std::to_string(first_record + more) + " " + rest + "\n";
}

}  // namespace

TEST(FusionListing, OneRecordALine) {
    const Bytes b = Bytes().rapid(-25, 10, 15).linear(0.1, -1.5e-12, 1e9, 400, 0x20003).parameter("dwell", 0.25);
    EXPECT_EQ(b.listing().substr(0, b.listing().find('\n')),
              "0 compact-nci \"http://www.example.com/namespace/nc/format/compact-nci\" version 1 1 1 1 1 1 1");
    EXPECT_EQ(behind_first(b.listing()), at(0, "rapid -25 10 15") +
                                             at(20, "linear 0.1 -1.5e-12 1e+09 feed 400 cutting first last") +
                                             at(44, "parameter \"dwell\" 0.25"));
}

TEST(FusionListing, SinglesAsTheShortestDecimals) {
    const Bytes b = Bytes().rapid(-24.764999389, 16777216, 0.333333333333);
    EXPECT_EQ(behind_first(b.listing()), at(0, "rapid -24.765 16777216 0.33333334"));
    // A double that has been a single stands as one, another with all its digits.
    EXPECT_EQ(behind_first(Bytes().parameter("a", double{0.1F}).parameter("b", 0.1).listing()),
              at(0, "parameter \"a\" 0.1") + at(17, "parameter \"b\" 0.1"));
}

TEST(FusionListing, TextsAreQuoted) {
    const Bytes narrow = Bytes().whole(10).text("a").text("one \"two\"\n\tthree\\");
    EXPECT_EQ(behind_first(narrow.listing()), at(0, R"(parameter "a" "one \"two\"\n\x09three\\")"));
    Bytes wide = Bytes().whole(11).text("a").whole(4);
    wide.whole(0x00E10041).whole(0xDE00D83D);  // A, á and one sign of two halves
    EXPECT_EQ(behind_first(wide.listing()), at(0, "parameter \"a\" \"A\xC3\xA1\xF0\x9F\x98\x80\""));
    EXPECT_NE(Bytes().whole(10).text("a").text(std::string(5000, 'x')).listing().find("xx\"...\n"), std::string::npos);
}

TEST(FusionListing, UnknownFlagsAndMovementsAreSaid) {
    EXPECT_EQ(behind_first(Bytes().linear(0, 0, 0, 1, 0x310400).listing()),
              at(0, "linear 0 0 0 feed 1 movement 49 flags 1024"));
}

TEST(FusionListing, NumbersThatAreNoneAreSaid) {
    const Bytes b = Bytes().whole(101).whole(0x7FC00000).whole(0x7F800000).whole(0).whole(0);
    EXPECT_EQ(behind_first(b.listing()), at(0, "rapid nan inf 0"));
}

TEST(FusionListing, AFileThatIsCutOffSaysSo) {
    const std::string all = Bytes().rapid(1, 2, 3).whole(10).text("name").text("value").get();
    for (std::size_t n = first_record; n <= all.size(); ++n) {
        const std::string listing = behind_first(*listing_of(all.substr(0, n), 1 << 20));
        const bool whole = n == first_record || n == first_record + 20 || n == all.size();
        EXPECT_EQ(listing.find("cut-off") == std::string::npos, whole) << n << listing;
    }
    EXPECT_EQ(behind_first(*listing_of(all.substr(0, first_record - 1), 1 << 20)), "0 cut-off 64\n");
}

TEST(FusionListing, CountsBehindTheFileAreCutOff) {
    EXPECT_EQ(behind_first(Bytes().whole(10).whole(0xFFFFFFFF).listing()), at(0, "cut-off 73"));
    EXPECT_EQ(behind_first(Bytes().whole(11).text("").whole(0x80000000).listing()), at(0, "cut-off 77"));
    std::string tool = Bytes(false).tool(1, 1, 1).get();
    tool.replace(236, 4, "\xFF\xFF\xFF\x7F");
    EXPECT_NE(listing_of(Bytes().get() + tool, 1 << 20)->find("cut-off"), std::string::npos);
}

TEST(FusionListing, AnUnknownRecordEndsIt) {
    EXPECT_EQ(behind_first(Bytes().whole(4711).rapid(1, 2, 3).listing()), at(0, "unknown-record 4711"));
}

TEST(FusionListing, ALongListingIsNone) {
    Bytes b;
    for (int i = 0; i < 1000; ++i) b.whole(31);
    EXPECT_FALSE(listing_of(b.get(), 5000));
    EXPECT_TRUE(listing_of(b.get(), 50'000));
}

TEST(FusionListing, OnlySuchFilesAreKnown) {
    EXPECT_TRUE(is_intermediate(Bytes().get()));
    EXPECT_FALSE(is_intermediate(""));
    EXPECT_FALSE(is_intermediate("G0 X0 Y0\nM30\n"));
    EXPECT_FALSE(is_intermediate(Bytes(false).text("http://www.example.com/other").get()));
    EXPECT_EQ(likelihood(Bytes().listing(), "x"), 100);
    EXPECT_EQ(likelihood("0 compact", "x.cnc"), 0);
}

}  // namespace obrys::read::fusion
