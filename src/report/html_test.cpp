#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "report/page_data.hpp"
#include "report/sample.hpp"

namespace obrys::report {
namespace {

using nlohmann::json;

TEST(Page, NeedsNoNetwork) {
    std::string page = to_html(sample::make().subject());
    // The name of SVG is a name, not an address that is fetched.
    for (std::size_t at; (at = page.find("http://www.w3.org/2000/svg")) != std::string::npos;) page.erase(at, 26);
    for (const char* word : {"http:", "https:", "src=", "@import", "url(//", "fetch(", "XMLHttpRequest", "import("})
        EXPECT_EQ(page.find(word), std::string::npos) << word;
    for (const char* mark : {"@TITLE@", "@STYLE@", "@DATA@", "@SCRIPT@"})
        EXPECT_EQ(page.find(mark), std::string::npos) << mark;
}

TEST(Page, ProgramTextCannotBecomeMarkup) {
    sample::Sample s = sample::make();
    s.sources.add("EVIL.SPF", "</script><script>alert(1)</script>\n<!--\n", base::BlockNumbers::n_word);
    s.result.findings[0].text = "<img onerror=x>";
    const std::string data = page_data(s.subject(), {});
    EXPECT_EQ(data.find('<'), std::string::npos);
    EXPECT_EQ(json::parse(data)["files"][2]["lines"][0], "</script><script>alert(1)</script>");
    std::string page = to_html(s.subject());
    std::size_t scripts = 0;
    for (std::size_t at = 0; (at = page.find("<script", at)) != std::string::npos; ++at) ++scripts;
    EXPECT_EQ(scripts, 2u);
}

TEST(Page, TheDataLinksMovesAndLines) {
    const json j = json::parse(page_data(sample::make().subject(), {}));
    EXPECT_EQ(j["head"]["verdict"], "not-fully-checked");
    EXPECT_EQ(j["files"][1]["lines"][1], "N5 G1 X=18 Z2 ; ö");
    const json& m = j["moves"];
    EXPECT_EQ(m["n"], 2);
    EXPECT_EQ(m["kind"], "rf");
    EXPECT_EQ(m["p"], (json{5.0, -30.0, 2.0, -18.0}));
    EXPECT_EQ(m["f"], (json{0, 1}));
    EXPECT_EQ(m["l"], (json{1, 2}));
    EXPECT_EQ(m["removed"]["1"], "M2 -18L4 -18L4 -19.25L2 -19.25Z");
    EXPECT_EQ(m["stacks"]["1"][0]["n"], "MAIN.MPF");
    EXPECT_EQ(j["findings"][0]["where"]["f"], 1);
    EXPECT_EQ(j["findings"][0]["where"]["l"], 2);
    EXPECT_EQ(j["marks"][0], (json{{"label", "1"}, {"at", {2.0, -18.0}}, {"no", 1}}));
}

TEST(Page, CurvesAreChainsOfPoints) {
    sample::Sample s = sample::make();
    s.result.moves[1].via = {{4, 25}, {3, 20}};
    const json j = json::parse(page_data(s.subject(), {}));
    EXPECT_EQ(j["moves"]["via"], (json{{"1", {4.0, -25.0, 3.0, -20.0}}}));
    EXPECT_EQ(j["moves"]["arc"], json::object());
}

TEST(Page, ClampsOfALathe) {
    sample::Sample s = sample::make();
    EXPECT_EQ(json::parse(page_data(s.subject(), {}))["regions"]["clamp"], "");
    s.setup.turned_clamps = {{"jaws", {{{{{{-30, 0}, 0}, {{5, 0}, 0}, {{5, 60}, 0}, {{-30, 60}, 0}}, true}}}}};
    EXPECT_EQ(json::parse(page_data(s.subject(), {}))["regions"]["clamp"], "M-30 0L5 0L5 -60L-30 -60Z");
}

TEST(Page, LargeProgramsAreCutAndSaySo) {
    const sample::Sample s = sample::make();
    HtmlOptions options;
    options.most_moves = 1;
    options.most_lines = 2;
    const json j = json::parse(page_data(s.subject(), options));
    EXPECT_EQ(j["moves"]["n"], 1);
    EXPECT_EQ(j["head"]["moves_all"], 2);
    EXPECT_EQ(j["files"][0]["lines"].size(), 2u);
    EXPECT_EQ(j["files"][0]["cut"], 2);
    EXPECT_EQ(j["files"][1]["lines"].size(), 0u);
}

}  // namespace
}  // namespace obrys::report
