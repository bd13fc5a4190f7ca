#include "report/ledger/ledger.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace obrys::report {
namespace {

Ledger sample() {
    Ledger l;
    l.program = "P.H";
    l.control = "heidenhain-itnc530";
    l.output = "P.nc";
    l.post = "FANUC, mill";
    l.proof = "differs";
    l.entries.push_back({"cycle 200 <drill>", base::Fate::mapped, LedgerPlace{"P.H", 2}, LedgerPlace{"P.nc", 1}, 3});
    l.entries.push_back({"a spline", base::Fate::lost, LedgerPlace{"P.H", 2}, {}, 1});
    l.sources.push_back({"P.H", "0 BEGIN\r\n1 CYCL <&>\n"});
    l.outputs.push_back({"P.nc", "G81\n"});
    return l;
}

TEST(Ledger, JsonHasTheShapeThatScriptsRelyOn) {
    const auto json = nlohmann::json::parse(ledger_json(sample()));
    ASSERT_EQ(json["entries"].size(), 2U);
    EXPECT_EQ(json["entries"][0]["fate"], "mapped");
    EXPECT_EQ(json["entries"][0]["from"]["file"], "P.H");
    EXPECT_EQ(json["entries"][0]["to"]["line"], 1);
    EXPECT_EQ(json["entries"][0]["times"], 3);
    EXPECT_TRUE(json["entries"][1]["to"].is_null());
    EXPECT_EQ(json["counts"]["lost"], 1);
}

TEST(Ledger, TextNamesBothLines) {
    const std::string text = ledger_text(sample());
    EXPECT_NE(text.find("mapped    P.H:2  P.nc:1  cycle 200 <drill> (3 times)\n"), std::string::npos) << text;
    EXPECT_NE(text.find("lost      P.H:2  -  a spline\n"), std::string::npos) << text;
    EXPECT_NE(text.find("differs, not written"), std::string::npos) << text;
}

TEST(Ledger, ThePageHoldsBothTextsAndALineShowsItsWorstEntry) {
    const std::string page = ledger_html(sample());
    EXPECT_NE(page.find("<div id=\"a0-2\" class=\"lost\" data-n=\"1\"><i>2</i>1 CYCL &lt;&amp;&gt;</div>"),
              std::string::npos)
        << page;
    EXPECT_NE(page.find("<div id=\"b0-1\" class=\"mapped\" data-n=\"0\"><i>1</i>G81</div>"), std::string::npos) << page;
    EXPECT_EQ(page.find("<drill>"), std::string::npos);
    EXPECT_EQ(page.find("http"), std::string::npos);
}

}  // namespace
}  // namespace obrys::report
