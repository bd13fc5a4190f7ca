#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "shop/files/fusion/tools.hpp"
#include "shop/files/json_document.hpp"
#include "shop/reading_testing.hpp"

namespace obrys::shop {
namespace {

const char* const library = R"({
 "data": [
  { "type": "flat end mill", "unit": "millimeters", "description": "6 mm", "guid": "a", "vendor": "X",
    "geometry": { "CSP": false, "DC": 6, "HAND": true, "LB": 30, "LCF": 13, "NOF": 3, "OAL": 57, "SFDM": 6,
                  "shoulder-diameter": 5.8, "shoulder-length": 18, "assemblyGaugeLength": 80.5 },
    "holder": { "description": "ER16", "gaugeLength": 50.5, "segments": [
       { "height": 10, "lower-diameter": 28, "upper-diameter": 30 }, { "height": 40.5, "lower-diameter": 50, "upper-diameter": 50 } ] },
    "post-process": { "number": 4, "length-offset": 4 } },
  { "type": "ball end mill", "unit": "inches", "description": "1/4 ball",
    "geometry": { "DC": 0.25, "LB": 1.5, "LCF": 0.75, "OAL": 2.5, "SFDM": 0.375, "NOF": 2 },
    "shaft": { "type": "shaft", "segments": [ { "height": 0.25, "lower-diameter": 0.25, "upper-diameter": 0.375 } ] },
    "post-process": { "number": 1 } },
  { "type": "chamfer mill", "unit": "millimeters", "geometry": { "DC": 10, "TA": 45, "tip-diameter": 2, "LCF": 5, "LB": 40, "SFDM": 10 },
    "post-process": { "number": 2 } },
  { "type": "drill", "geometry": { "DC": "8.5", "SIG": 140, "LCF": 60, "LB": 70, "SFDM": 8 }, "post-process": { "number": 3 } },
  { "type": "tap right hand", "unit": "millimeters", "geometry": { "DC": 8, "TP": 1.25, "LCF": 20, "LB": 60, "SFDM": 8 }, "post-process": { "number": 5 } },
  { "type": "slot mill", "unit": "millimeters", "geometry": { "DC": 25, "LCF": 6, "RE": 0.2, "shoulder-diameter": 12, "shoulder-length": 30, "LB": 50, "SFDM": 16 }, "post-process": { "number": 6 } },
  { "type": "tapered mill", "unit": "millimeters", "geometry": { "DC": 4, "TA": 5, "RE": 1, "LCF": 20, "LB": 40, "SFDM": 8 }, "post-process": { "number": 7 } },
  { "type": "lollipop mill", "unit": "millimeters", "geometry": { "DC": 10, "LCF": 9, "shoulder-diameter": 6, "shoulder-length": 30, "LB": 45, "SFDM": 10 }, "post-process": { "number": 8 } },
  { "type": "probe", "unit": "millimeters", "geometry": { "DC": 6 }, "post-process": { "number": 9 } },
  { "type": "turning general", "post-process": { "number": 20 } },
  { "type": "holder", "segments": [] }
 ],
 "version": 14
})";

struct Fusion : Reading {
    std::vector<Tool> tools;
    explicit Fusion(const std::string& text) { tools = read_fusion_tools(add(text, "lib.json"), sources, diagnostics); }
};

TEST(FusionTools, TheCommonKinds) {
    const Fusion f(library);
    ASSERT_EQ(f.tools.size(), 9U);
    const Tool& ball = f.tools[0];
    EXPECT_EQ(ball.number, 1U);
    EXPECT_EQ(ball.name, "1/4 ball");
    EXPECT_EQ(ball.kind, ToolKind::ball);
    EXPECT_DOUBLE_EQ(ball.radius, 3.175);
    EXPECT_EQ(ball.corner_radius, ball.radius);
    EXPECT_DOUBLE_EQ(*ball.cutting_length, 19.05);
    EXPECT_DOUBLE_EQ(ball.length, 38.1);
    ASSERT_EQ(ball.shank.size(), 2U);  // the cone of 1/4 inch, then 3/8 inch up to 1.5 inch
    EXPECT_DOUBLE_EQ(ball.shank[0].length, 6.35);
    EXPECT_DOUBLE_EQ(ball.shank[0].upper_diameter, 9.525);
    EXPECT_NEAR(ball.shank[1].length, 38.1 - 19.05 - 6.35, 1e-12);
    EXPECT_EQ(f.tools[1].kind, ToolKind::chamfer);
    EXPECT_EQ(f.tools[1].point_angle, 90);
    EXPECT_EQ(f.tools[1].tip_diameter, 2);
    EXPECT_EQ(f.tools[2].kind, ToolKind::drill);
    EXPECT_EQ(f.tools[2].radius, 4.25);
    EXPECT_EQ(f.tools[2].point_angle, 140);
    EXPECT_EQ(f.tools[2].assumed, "tool 3: lengths in mm");
    const Tool& flat = f.tools[3];
    EXPECT_EQ(flat.kind, ToolKind::end_mill);
    EXPECT_EQ(flat.teeth, 3);
    EXPECT_EQ(flat.length, 80.5);
    EXPECT_EQ(flat.type, "flat end mill");
    ASSERT_EQ(flat.shank.size(), 2U);  // neck of 5.8 from 13 to 18, shank from 18 to 30
    EXPECT_EQ(flat.shank[0].lower_diameter, 5.8);
    EXPECT_EQ(flat.shank[0].length, 5);
    EXPECT_EQ(flat.shank[1].length, 12);
    ASSERT_EQ(flat.holder.size(), 2U);
    EXPECT_EQ(flat.holder[0].lower_diameter, 28);
    EXPECT_EQ(flat.holder[1].length, 40.5);
    EXPECT_EQ(f.tools[4].kind, ToolKind::tap);
    EXPECT_EQ(f.tools[4].pitch, 1.25);
    EXPECT_EQ(f.tools[8].kind, ToolKind::other);
}

TEST(FusionTools, KindsThatBecomeProfiles) {
    const Fusion f(library);
    ASSERT_EQ(f.tools.size(), 9U);
    const Tool& slot = f.tools[5];
    EXPECT_EQ(slot.kind, ToolKind::t_slot);
    EXPECT_EQ(slot.width, 6);
    EXPECT_EQ(slot.neck_diameter, 12);
    EXPECT_EQ(slot.corner_radius, 0.2);
    EXPECT_EQ(cutting_height(slot), 6);
    const Tool& taper = f.tools[6];
    EXPECT_EQ(taper.kind, ToolKind::form);
    ASSERT_EQ(taper.profile.size(), 4U);
    EXPECT_NEAR(taper.profile[3].p.x, 2 + 20 * std::tan(geom::radians(5)), 1e-12);
    EXPECT_EQ(taper.profile[3].p.y, 20);
    // the round corner of 1 mm touches the bottom and the flank: its centre is 1 above the bottom and 1 from the flank
    const geom::Vec2 centre{taper.profile[1].p.x, 1}, flank{std::sin(geom::radians(5)), std::cos(geom::radians(5))};
    EXPECT_NEAR(std::abs(geom::cross(flank, centre - geom::Vec2{2, 0})), 1, 1e-12);
    EXPECT_NEAR(geom::distance(centre, taper.profile[2].p), 1, 1e-12);
    EXPECT_NEAR(taper.profile[1].bulge, std::tan(geom::radians(85) / 4), 1e-12);
    const Tool& lollipop = f.tools[7];
    EXPECT_EQ(lollipop.kind, ToolKind::form);
    ASSERT_EQ(lollipop.profile.size(), 3U);
    EXPECT_EQ(lollipop.profile[1].p, (geom::Vec2{5, 5}));
    EXPECT_NEAR(lollipop.profile[2].p.y, 9, 1e-12);  // 5 + sqrt(25 - 9)
    EXPECT_EQ(lollipop.radius, 5);
    EXPECT_EQ(lollipop.shank[0].lower_diameter, 6);
    for (const Tool& t : f.tools) EXPECT_TRUE(dimension_fault(t).ok()) << t.number;
}

TEST(FusionTools, WhatIsNotTakenIsSaidOnce) {
    const Fusion f(library);
    EXPECT_EQ(f.complaints(),
              "lib.json:3:76: note: not taken from this file: geometry.CSP (1), geometry.OAL (2), "
              "guid (1), "
              "holder.description (1), post-process.length-offset (1), tools of type \"holder\" (1), tools of type "
              "\"turning general\" (1), "
              "vendor (1) [no-effect]\n"
              "    { \"type\": \"flat end mill\", \"unit\": \"millimeters\", \"description\": \"6 mm\", \"guid\": "
              "\"a\", \"vendor\": \"X\",\n"
              "                                                                             ^~~~~~\n");
}

TEST(FusionTools, MistakesArePlacedAndTheRestIsRead) {
    const Fusion f(R"({"data": [
 { "type": "flat end mill", "unit": "millimeters", "geometry": { "DC": 0 }, "post-process": { "number": 1 } },
 { "type": "flat end mill", "unit": "millimeters", "geometry": { "DC": 4 } },
 { "type": "bull nose end mill", "unit": "millimeters", "geometry": { "DC": 4, "RE": 3 }, "post-process": { "number": 2 } },
 { "type": "drill", "post-process": { "number": 3 } },
 { "type": "drill", "unit": "millimeters", "geometry": { "DC": 4 }, "post-process": { "number": 5 } },
 { "type": "drill", "unit": "millimeters", "geometry": { "DC": 5 }, "post-process": { "number": 5 } },
 7
]})");
    std::string places;
    for (const base::Diagnostic& d : f.diagnostics.all()) {
        const base::Position p = f.sources.position(d.where);
        places += std::to_string(p.line) + ":" + std::to_string(p.column) + ": " + d.text + "\n";
    }
    EXPECT_EQ(places,
              "2:64: tool 1 is left out: the diameter must be greater than 0\n"
              "3:2: a tool without a number (post-process, number) is left out: \n"
              "4:69: tool 2 is left out: the corner radius (3 mm) is greater than the tool's radius (2 mm)\n"
              "5:2: tool 3 has no 'geometry': left out\n"
              "7:2: tool 5 is there already: this one is left out\n"
              "8:2: a tool must be an object, not a whole number\n");
    ASSERT_EQ(f.tools.size(), 1U);
    EXPECT_EQ(f.tools[0].radius, 2);
    EXPECT_EQ(f.tools[0].assumed, "tool 5: point angle 118 degrees");
    EXPECT_FALSE(f.diagnostics.has_errors());
}

TEST(FusionTools, TextsThatAreNoLibrary) {
    EXPECT_EQ(Fusion("{}").complaints(),
              "lib.json:1:1: error: this is no Fusion tool library: it has no array 'data' [job-file]\n  {}\n  ^\n");
    EXPECT_EQ(Fusion("3").complaints(),
              "lib.json:1:1: error: this is no Fusion tool library: it has no array 'data' [job-file]\n  3\n  ^\n");
    for (const std::string text :
         {"", "{", "{\"data\": [1,}", "{\"data\": \"\xFF\"}", "[1] 2", "{\"a\": nul}", "\xEF\xBB\xBF{\"data\": [}"}) {
        const Fusion f(text);
        ASSERT_EQ(f.diagnostics.all().size(), 1U) << text;
        EXPECT_LE(f.diagnostics.all()[0].where.end, text.size()) << text;
        EXPECT_NE(f.complaints().find("not valid JSON"), std::string::npos) << f.complaints();
    }
    const std::string deep = std::string(100'000, '[') + std::string(100'000, ']');
    EXPECT_NE(Fusion(deep).diagnostics.all().at(0).text.find("nested too deep"), std::string::npos);
    EXPECT_TRUE(Fusion("\xEF\xBB\xBF{\"data\": []}").complaints().empty());
}

TEST(JsonDocument, EveryValueHasItsPlace) {
    Reading r;
    const std::string text =
        "{ \"a\" : 12 , \"b\":[1.5e1,-3,true, \"x\\\"y\" ,null],\n\"c\" : {\"d\":0} , \"n\": null, \"e\":9}";
    const auto file = r.add(text, "j.json");
    const auto v = parse_json(file, r.sources, r.diagnostics);
    ASSERT_TRUE(v) << r.complaints();
    const auto at = [&](const Value& x) { return std::string(r.sources.text(x.where)); };
    EXPECT_EQ(at(*v), text);
    ASSERT_EQ(v->entries.size(), 4U);
    EXPECT_EQ(std::string(r.sources.text(v->entries[0].where)), "\"a\"");
    EXPECT_EQ(at(v->entries[0].value), "12");
    const Value& list = v->entries[1].value;
    EXPECT_EQ(at(list), "[1.5e1,-3,true, \"x\\\"y\" ,null]");
    ASSERT_EQ(list.items.size(), 4U);
    EXPECT_EQ(at(list.items[0]), "1.5e1");
    EXPECT_EQ(at(list.items[1]), "-3");
    EXPECT_EQ(at(list.items[2]), "true");
    EXPECT_EQ(at(list.items[3]), "\"x\\\"y\"");
    EXPECT_EQ(list.items[3].text, "x\"y");
    EXPECT_EQ(at(v->entries[2].value), "{\"d\":0}");
    EXPECT_EQ(at(v->entries[2].value.entries[0].value), "0");
    EXPECT_EQ(at(v->entries[3].value), "9");
}

RC_GTEST_PROP(FusionProperty, ADamagedLibraryNeverBreaksTheReader, ()) {
    std::string text = library;
    const std::string letters = "[]{}\":,.-+019eE \n\\\xC5";
    const int edits = *rc::gen::inRange(1, 6);
    for (int i = 0; i < edits; ++i) {
        const std::size_t at = *rc::gen::inRange<std::size_t>(0, text.size());
        text.replace(at, *rc::gen::inRange<std::size_t>(0, 4),
                     std::string(1, letters[*rc::gen::inRange<std::size_t>(0, letters.size())]));
    }
    const Fusion f(text);
    for (const base::Diagnostic& d : f.diagnostics.all()) {
        RC_ASSERT(d.where.begin <= d.where.end);
        RC_ASSERT(d.where.end <= text.size());
    }
    for (const Tool& t : f.tools) RC_ASSERT(dimension_fault(t).ok());
}

}  // namespace
}  // namespace obrys::shop
