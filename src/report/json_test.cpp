#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <set>

#include "report/sample.hpp"

namespace obrys::report {
namespace {

using nlohmann::json;

TEST(JsonReport, HasTheDocumentedShape) {
    const sample::Sample s = sample::make();
    const json j = json::parse(to_json(s.subject()));
    EXPECT_EQ(j["format"], "obrys-check");
    EXPECT_EQ(j["version"], 2);
    EXPECT_EQ(j["verdict"], "not-fully-checked");
    const json& f = j["findings"].at(0);
    EXPECT_EQ(f["code"], "gouge");
    EXPECT_EQ(f["severity"], "error");
    EXPECT_EQ(f["message"], "cuts into the finished part: 1.250 mm deep along X");
    EXPECT_EQ(f["where"]["file"], "with blank/SUB.SPF");
    EXPECT_EQ(f["where"]["line"], 2);
    EXPECT_EQ(f["where"]["column"], 1);
    EXPECT_EQ(f["where"]["block"], 5);
    EXPECT_EQ(f["where"]["text"], "N5 G1 X=18 Z2 ; ö");
    EXPECT_EQ(f["where"]["stack"].at(0)["file"], "MAIN.MPF");
    EXPECT_EQ(f["where"]["stack"].at(0)["line"], 2);
    EXPECT_EQ(f["where"]["stack"].at(0)["block"], 20);
    EXPECT_EQ(f["times"], 1);
    EXPECT_EQ(f["first_move"], 1);
    EXPECT_FALSE(f.contains("lines"));
    EXPECT_FALSE(f.contains("moves"));
    EXPECT_EQ(f["move"], 1);
    EXPECT_EQ(f["depth_mm"], 1.0);
    EXPECT_EQ(f["depth_x_mm"], 1.25);
    EXPECT_EQ(f["area_mm2"], 3.5);
    EXPECT_EQ(f["from_mm"]["x"], 30.0);
    EXPECT_TRUE(f["from_mm"]["y"].is_null());
    EXPECT_EQ(j["unchecked"].at(0)["code"], "unknown-word");
    EXPECT_EQ(j["unchecked"].at(0)["times"], 2);
    EXPECT_EQ(j["unchecked"].at(0)["where"]["column"], 5);
    EXPECT_EQ(j["assumptions"].at(0)["message"], "R3 = 150 is set from outside");
    EXPECT_TRUE(j["assumptions"].at(0)["where"]["file"].is_null());
    EXPECT_EQ(j["stats"], (json{{"moves", 2},
                                {"rapid_moves", 1},
                                {"feed_moves", 1},
                                {"rapid_length_mm", 0.0},
                                {"feed_length_mm", 12.369},
                                {"blocks_executed", 7}}));
    EXPECT_EQ(j["stock"]["before"]["volume_mm3"], 50000.0);
}

TEST(JsonReport, MovesOfOneCauseAreOneFinding) {
    sample::Sample s = sample::make();
    check::Finding other = s.result.findings[0];
    other.move = 9;
    other.where = sample::span(s, 0, "N10 G0 X30 Z5");
    other.amounts[0].value = 7;
    for (check::Finding* f : {&s.result.findings[0], &other}) f->cause = "tool 1 holder";
    s.result.findings.push_back(other);
    const json f = json::parse(to_json(s.subject(), true))["findings"];
    ASSERT_EQ(f.size(), 1u);
    EXPECT_EQ(f[0]["times"], 2);
    EXPECT_EQ(f[0]["move"], 9);
    EXPECT_EQ(f[0]["depth_mm"], 7);
    EXPECT_EQ(f[0]["where"]["file"], "MAIN.MPF");
    EXPECT_EQ(f[0]["first_move"], 1);
    EXPECT_EQ(f[0]["lines"],
              json::parse(R"([{"file": "MAIN.MPF", "lines": [1]}, {"file": "with blank/SUB.SPF", "lines": [2]}])"));
    ASSERT_EQ(f[0]["moves"].size(), 2u);
    EXPECT_EQ(f[0]["moves"][0]["move"], 1);
    const json sarif = json::parse(to_sarif(s.subject()));
    EXPECT_EQ(sarif["runs"][0]["results"][0]["occurrenceCount"], 2);
    EXPECT_EQ(json::parse(to_sarif(s.subject(), true))["runs"][0]["results"].size(), 4u);
}

TEST(JsonReport, EmptyListsAreThere) {
    sample::Sample s = sample::make();
    s.result = {};
    const json j = json::parse(to_json(s.subject()));
    EXPECT_EQ(j["verdict"], "clean");
    for (const char* list : {"findings", "unchecked", "assumptions", "listed", "tools"})
        EXPECT_TRUE(j[list].is_array()) << list;
    EXPECT_TRUE(j["stock"]["after"].is_null());
}

TEST(JsonReport, SurvivesTextThatIsNotUtf8) {
    sample::Sample s = sample::make();
    s.result.findings[0].text = "word \xF6";
    EXPECT_EQ(json::parse(to_json(s.subject()))["findings"][0]["message"],
              "word \xEF\xBF\xBD");  // the replacement character
}

TEST(Sarif, HoldsWhatTheStandardRequires) {
    sample::Sample s = sample::make();
    s.result.findings[0].related = {{sample::span(s, 0, "N10"), "first move with it"}};
    const json j = json::parse(to_sarif(s.subject()));
    EXPECT_EQ(j["version"], "2.1.0");
    ASSERT_EQ(j["runs"].size(), 1u);
    const json& run = j["runs"][0];
    EXPECT_EQ(run["properties"]["verdict"], "not-fully-checked");
    const json& driver = run["tool"]["driver"];
    EXPECT_EQ(driver["name"], "obrys");
    std::set<std::string> ids;
    for (const json& rule : driver["rules"]) {
        EXPECT_TRUE(ids.insert(rule["id"]).second);
        EXPECT_FALSE(rule["shortDescription"]["text"].get<std::string>().empty());
    }
    EXPECT_EQ(ids.size(), base::all_codes.size());
    ASSERT_EQ(run["results"].size(), 3u);
    for (const json& r : run["results"]) {
        EXPECT_EQ(driver["rules"].at(r["ruleIndex"].get<std::size_t>())["id"], r["ruleId"]);
        EXPECT_TRUE(r["level"] == "error" || r["level"] == "warning" || r["level"] == "note");
        EXPECT_TRUE(r["message"]["text"].is_string());
        EXPECT_TRUE(r["locations"].is_array());
    }
}

TEST(Sarif, PlacesCountFromOneAndCallsLeadThere) {
    sample::Sample s = sample::make();
    s.result.findings[0].related = {{sample::span(s, 0, "N10"), "first move with it"}};
    const json j = json::parse(to_sarif(s.subject()));
    const json& r = j["runs"][0]["results"][0];
    const json& physical = r["locations"][0]["physicalLocation"];
    EXPECT_EQ(physical["artifactLocation"]["uri"], "with%20blank/SUB.SPF");
    EXPECT_EQ(physical["region"]["startLine"], 2);
    EXPECT_EQ(physical["region"]["startColumn"], 1);
    EXPECT_EQ(physical["region"]["endLine"], 2);
    EXPECT_EQ(physical["region"]["endColumn"], 14);
    const json& steps = r["codeFlows"][0]["threadFlows"][0]["locations"];
    ASSERT_EQ(steps.size(), 2u);
    EXPECT_EQ(steps[0]["location"]["physicalLocation"]["artifactLocation"]["uri"], "MAIN.MPF");
    EXPECT_EQ(steps[1]["location"]["physicalLocation"]["region"]["startLine"], 2);
    EXPECT_EQ(r["relatedLocations"][0]["message"]["text"], "first move with it");
    EXPECT_EQ(r["relatedLocations"][0]["physicalLocation"]["region"]["startLine"], 1);
    EXPECT_EQ(r["properties"]["depth_x_mm"], 1.25);
}

}  // namespace
}  // namespace obrys::report
