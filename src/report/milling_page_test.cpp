#include "report/milling_page.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <nlohmann/json.hpp>
#include <random>

#include "report/milling_arrays.hpp"
#include "report/page_parts.hpp"

namespace obrys::report {
namespace {

using nlohmann::json;

/// Two lines of a program, three moves, one triangle.
MillingPage small() {
    MillingPage page;
    page.title = "SLOT.NC";
    page.verdict = check::Verdict::findings;
    page.verdict_line = "1 finding";
    page.texts = {{"dir/SLOT.NC", "G0 X1\nG1 X2\n"}};
    page.path.moves = {{true, {0, 1}, 7, 0.5, 1}, {false, {0, 2}, 7, 1.5, 3}, {false, {5, 2}, 8, NAN, 4}};
    page.path.points = {0, 0, 0, 1, 0, 0, 2, 0, 0, 2, 1.5F, 0, 3, 0, -1};
    page.path.move_of_point = {0, 0, 1, 1, 2};
    page.tools = {{}, {}};
    page.tools[1].number = 7;
    page.tools[1].radius = 3;
    page.surface.vertices = {0, 0, 0, 1, 0, 0, 0, 1, 0};
    page.surface.indices = {0, 1, 2};
    page.surface.move_of = {1};
    PageFinding f;
    f.code = "gouge";
    f.text = "cuts into the finished part";
    f.where = {0, 2};
    f.move = 1;
    f.place = geom::Vec3{2, 1, 0};
    page.findings = {f};
    return page;
}

/// The numbers of an element, decoded by other means than they were written with.
template <typename Number>
std::vector<Number> decoded(const std::string& arrays, const std::string& name) {
    const std::string mark = "id=\"array-" + name + "\">";
    const std::size_t start = arrays.find(mark);
    if (start == std::string::npos) return {};
    const std::string letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::vector<unsigned char> bytes;
    unsigned bits = 0;
    int held = 0;
    for (std::size_t at = start + mark.size(); arrays[at] != '<'; ++at) {
        const std::size_t value = letters.find(arrays[at]);
        if (value == std::string::npos) break;
        bits = bits << 6U | static_cast<unsigned>(value);
        held += 6;
        if (held >= 8) bytes.push_back(static_cast<unsigned char>(bits >> static_cast<unsigned>(held -= 8) & 0xFFU));
    }
    std::vector<Number> out(bytes.size() / sizeof(Number));
    if (!out.empty()) std::memcpy(out.data(), bytes.data(), out.size() * sizeof(Number));
    return out;
}

TEST(MillingPage, ArraysHoldMovesPointsAndSurface) {
    const std::string arrays = page_arrays(small());
    EXPECT_EQ(decoded<float>(arrays, "points"), small().path.points);
    EXPECT_EQ(decoded<std::uint32_t>(arrays, "moveOfPoint"), small().path.move_of_point);
    EXPECT_EQ(decoded<std::uint8_t>(arrays, "kind"), (std::vector<std::uint8_t>{1, 0, 0}));
    EXPECT_EQ(decoded<std::uint16_t>(arrays, "file"), (std::vector<std::uint16_t>{0, 0, 0xFFFF}));
    EXPECT_EQ(decoded<std::uint32_t>(arrays, "line"), (std::vector<std::uint32_t>{1, 2, 2}));
    EXPECT_EQ(decoded<std::uint16_t>(arrays, "tool"), (std::vector<std::uint16_t>{1, 1, 0xFFFF}));
    const std::vector<double> seconds = decoded<double>(arrays, "seconds");
    ASSERT_EQ(seconds.size(), 3u);
    EXPECT_EQ(seconds[1], 1.5);
    EXPECT_TRUE(std::isnan(seconds[2]));
    EXPECT_EQ(decoded<std::uint32_t>(arrays, "moveOf"), std::vector<std::uint32_t>{1});
    EXPECT_EQ(arrays.find("array-axes"), std::string::npos);
    EXPECT_EQ(arrays.find("array-deviation"), std::string::npos);
}

TEST(MillingPage, ArraysOfAnyLengthComeBack) {
    std::mt19937 random(20261121);
    for (std::size_t count = 0; count < 40; ++count) {
        MillingPage page;
        for (std::size_t i = 0; i < count; ++i) {
            page.path.moves.push_back({(random() & 1U) != 0, {}, 0, static_cast<double>(random()) / 7, 0, 0});
            page.path.move_of_point.push_back(static_cast<std::uint32_t>(i));
            for (int c = 0; c < 3; ++c) page.path.points.push_back(static_cast<float>(random()) / 3);
        }
        const std::string arrays = page_arrays(page);
        EXPECT_EQ(decoded<float>(arrays, "points"), page.path.points) << count;
        EXPECT_EQ(decoded<std::uint8_t>(arrays, "kind").size(), count);
        const std::vector<double> seconds = decoded<double>(arrays, "seconds");
        ASSERT_EQ(seconds.size(), count);
        for (std::size_t i = 0; i < count; ++i) EXPECT_EQ(seconds[i], page.path.moves[i].end_s);
    }
}

TEST(MillingPage, WhatDoesNotFitIsLeftOut) {
    MillingPage page = small();
    page.path.move_of_point = {0, 0, 1, 0, 2};  // goes back: the path ends before
    page.surface.indices = {0, 1, 2, 0, 1, 3, 2, 1, 0, 1};
    page.surface.move_of = {9};
    page.surface.deviation = {0.5F, 1, -0.25F};
    page.findings[0].move = 3;
    page.findings[0].place = geom::Vec3{NAN, 0, 0};
    page.findings[0].where = {4, 1};
    const std::string arrays = page_arrays(page);
    EXPECT_EQ(decoded<std::uint32_t>(arrays, "moveOfPoint").size(), 3u);
    EXPECT_EQ(decoded<float>(arrays, "points").size(), 9u);
    EXPECT_EQ(decoded<std::uint32_t>(arrays, "indices"), (std::vector<std::uint32_t>{0, 1, 2, 2, 1, 0}));
    EXPECT_EQ(decoded<std::uint32_t>(arrays, "moveOf"), (std::vector<std::uint32_t>{page_none, page_none}));
    EXPECT_EQ(decoded<float>(arrays, "deviation"), (std::vector<float>{0.5F, -0.25F}));
    const json finding = json::parse(milling_page_data(page))["findings"][0];
    EXPECT_TRUE(finding["move"].is_null());
    EXPECT_TRUE(finding["at"].is_null());
    EXPECT_TRUE(finding["where"].is_null());
}

TEST(MillingPage, TheDataLinksFindingsMovesAndLines) {
    const json j = json::parse(milling_page_data(small()));
    EXPECT_EQ(j["head"]["verdict"], "findings");
    EXPECT_EQ(j["head"]["line"], "1 finding");
    const json& f = j["findings"][0];
    EXPECT_EQ(f["where"], (json{{"f", 0}, {"l", 2}, {"n", "dir/SLOT.NC"}}));
    EXPECT_EQ(f["move"], 1);
    EXPECT_EQ(f["at"], (json{2.0, 1.0, 0.0}));
    EXPECT_EQ(j["texts"][0]["text"], "G0 X1\nG1 X2\n");
    EXPECT_EQ(j["tools"][1]["number"], 7);
}

TEST(MillingPage, NoTextCanBecomeMarkup) {
    MillingPage page = small();
    const std::string evil = "</script><script>alert(1)</script>\n<!--\n";
    page.title = evil;
    page.control = page.machine = page.date = page.version = page.verdict_line = evil;
    page.texts = {{evil, evil}};
    page.findings[0].text = page.findings[0].code = page.findings[0].remedy = evil;
    page.findings[0].amounts = {{evil, evil, evil}};
    page.tools[1].name = page.tools[1].kind = evil;
    page.unchecked = {{evil, evil, {}}};
    page.clamps = {{{}, {1, 1, 1}, evil}};
    page.figures = {{evil, evil, evil}};
    const std::string data = milling_page_data(page);
    EXPECT_EQ(data.find('<'), std::string::npos);
    EXPECT_EQ(json::parse(data)["texts"][0]["text"], evil);
    EXPECT_EQ(milling_page(page).find("<script>alert"), std::string::npos);
    EXPECT_EQ(milling_page(page).find("<!--"), std::string::npos);
}

TEST(MillingPage, TextsNeedNotBeUtf8) {
    MillingPage page = small();
    page.texts[0].text = "; \xE4\xF6\n";  // CP1252
    page.machine = "\xFF";
    const json j = json::parse(milling_page_data(page));
    EXPECT_EQ(j["texts"][0]["text"], "; \xC3\xA4\xC3\xB6\n");
}

TEST(MillingPage, NeedsNoNetwork) {
    if (!milling_page_available()) GTEST_SKIP() << "built without the page's script (OBRYS_PAGE)";
    const std::string page = milling_page(small());
    // Nothing may be fetched: the page forbids it itself.
    EXPECT_NE(page.find("default-src 'none'"), std::string::npos);
    for (const char* word : {"<link", "src=\"", "@import", "url(//", "url(http"})
        EXPECT_EQ(page.find(word), std::string::npos) << word;
    for (const char* mark : {"@TITLE@", "@STYLE@", "@MILLING_STYLE@", "@DATA@", "@ARRAYS@", "@SCRIPT@"})
        EXPECT_EQ(page.find(mark), std::string::npos) << mark;
    EXPECT_EQ(milling_js.find("</script"), std::string_view::npos);
}

TEST(MillingPage, AnEmptyRunHasAPageToo) {
    const json j = json::parse(milling_page_data({}));
    EXPECT_EQ(j["head"]["verdict"], "not-fully-checked");
    EXPECT_EQ(decoded<float>(page_arrays({}), "points").size(), 0u);
}

}  // namespace
}  // namespace obrys::report
