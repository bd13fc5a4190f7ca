#include "cl/text.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <set>

#include "base/codes.hpp"
#include "cl/records_testing.hpp"

namespace obrys::cl {
namespace {

std::vector<Record> read(std::string text, base::Diagnostics& diagnostics) {
    base::Sources sources;
    const std::uint32_t file = sources.add("test.cl", std::move(text));
    return read_text(sources, file, diagnostics);
}

/// Puts a number in the place of NaN, which equals nothing, not even itself.
void mark(double& v) { v = std::isnan(v) ? -987654321.125 : v; }
void mark(geom::Vec3& v) { mark(v.x), mark(v.y), mark(v.z); }
void mark(geom::Frame& f) {
    mark(f.origin);
    for (double& v : f.linear) mark(v);
}
void mark(AxisEnds& ends) {
    for (AxisEnd& end : ends) mark(end.to);
}
struct Mark {
    void operator()(Linear& s) const { mark(s.to), mark(s.axis), mark(s.ends); }
    void operator()(Arc& s) const {
        mark(s.to), mark(s.centre), mark(s.normal), mark(s.sweep), mark(s.axis), mark(s.ends);
    }
    void operator()(Spline& s) const {
        mark(s.to), mark(s.k1), mark(s.k2), mark(s.k3), mark(s.axis), mark(s.ends);
        for (SplineAxis& a : s.axes) mark(a.to), mark(a.k1), mark(a.k2), mark(a.k3);
    }
    void operator()(Tolerance& s) const { mark(s.contour), mark(s.rotary); }
    void operator()(Thread& s) const {
        mark(s.to), mark(s.pitch), mark(s.start), mark(s.change), mark(s.axis), mark(s.ends);
    }
    void operator()(Output& s) const { mark(s.value); }
    void operator()(Dwell& s) const { mark(s.seconds), mark(s.revolutions); }
    void operator()(Feed& s) const { mark(s.value); }
    void operator()(Spindle& s) const {
        mark(s.speed), mark(s.limit);
        if (s.held) mark(*s.held);
    }
    void operator()(Datum& s) const { mark(s.origin); }
    void operator()(Frame& s) const {
        for (FramePart& p : s.parts) mark(p.frame);
    }
    void operator()(CompensationBegin& s) const { mark(s.radius), mark(s.normal); }
    void operator()(ToolChange& s) const { mark(s.raised), mark(s.wider); }
    void operator()(ToolData& s) const {
        if (s.length) mark(*s.length);
        if (s.radius) mark(*s.radius);
    }
    void operator()(PathMode& s) const { mark(s.tolerance), mark(s.merge); }
    void operator()(DatumData& s) const {
        mark(s.origin);
        if (s.turn) mark(*s.turn);
    }
    void operator()(ToolLength& s) const {
        if (s.by) mark(*s.by);
    }
    void operator()(MachinePlace& s) const { mark(s.to); }
    void operator()(LeadBegin& s) const { mark(s.at), mark(s.length), mark(s.radius), mark(s.angle), mark(s.feed); }
    void operator()(Programmed& s) const {
        mark(s.from), mark(s.to), mark(s.centre), mark(s.normal), mark(s.sweep), mark(s.size), mark(s.corner_feed);
    }
    void operator()(CycleBegin& s) const {
        Cycle c = *s.cycle;
        for (CycleValue& v : c.values) mark(v.value);
        for (CycleParameter& p : c.written) mark(p.value);
        mark(c.plane);
        mark(s.place);
        s.cycle = c;
    }
    void operator()(OtherSpindle& s) const {
        for (std::optional<double>* v : {&s.speed, &s.held, &s.limit})
            if (*v) mark(**v);
    }
    void operator()(PartBegin& s) const {
        for (PartArgument& a : s.arguments) mark(a.value);
    }
    template <class Other>
    void operator()(Other&) const {}
};

RC_GTEST_PROP(Text, ReadsBackToTheSameStream, ()) {
    std::vector<Record> written;
    for (std::size_t kind = 0; kind < std::variant_size_v<Step>; ++kind) written.push_back(any_record(kind));
    const std::string text_form = to_text(written);
    base::Diagnostics diagnostics;
    std::vector<Record> back = read(text_form, diagnostics);
    RC_ASSERT(diagnostics.all().empty());
    RC_ASSERT(back.size() == written.size());
    for (std::size_t i = 0; i < back.size(); ++i) {
        std::visit(Mark{}, back[i].step);
        std::visit(Mark{}, written[i].step);
        RC_ASSERT(back[i].step == written[i].step);
        RC_ASSERT(back[i].from == written[i].from);
        RC_ASSERT(back[i].stack == written[i].stack);
    }
}

TEST(Text, LooksAsDocumented) {
    EXPECT_EQ(to_text({Linear{{30.5, NAN, -1.25}, {0, 0, 1}, true}, {0, 12, 25}, 3}), "rapid 30.5 ? -1.25 @0:12-25 ^3");
    EXPECT_EQ(to_text({Linear{{1, 2, 3}, {1, 0, 0}, false}, {}, 0}), "linear 1 2 3 axis 1 0 0 @0:0-0");
    EXPECT_EQ(to_text({Spindle{300, SpindleMode::surface, 1, 3000}, {}, 0}), "spindle 300 m/min cw limit 3000 @0:0-0");
    EXPECT_EQ(to_text({ToolChange{5, 1, "Stechstahl \"3 mm\" für Nut"}, {}, 0}),
              "tool 5 edge 1 \"Stechstahl \\\"3 mm\\\" für Nut\" @0:0-0");
    EXPECT_EQ(to_text({Feed{0.2, FeedMode::per_rev}, {1, 2, 3}, 0}), "feed 0.2 mm/rev @1:2-3");
    EXPECT_EQ(to_text({Spline{{1, 2, 3}, {4, 5, 6}, {7, 8, 9}, {10, 11, 12}, {0, 0, 1}, {{{'A'}, 1, 2, 3, 4, true}}},
                       {1, 2, 3},
                       0}),
              "spline 1 2 3 k3 10 11 12 k2 7 8 9 k1 4 5 6 \"A\" 1 4 3 2 deg @1:2-3");
    EXPECT_EQ(to_text({MachinePlace{PlaceKind::home, 2, {true, false, true}, {0, NAN, NAN}}, {}, 0}),
              "machine home 2 x 0 z ? @0:0-0");
    EXPECT_EQ(to_text({ToolLength{1, 5, {}}, {}, 0}), "length added offset 5 @0:0-0");
    EXPECT_EQ(to_text({ToolData{3, 1, 0, 5}, {}, 0}), "tool-data 3 edge 1 length 0 radius 5 @0:0-0");
    EXPECT_EQ(to_text({LeadBegin{LeadKind::tangent_arc, false, {1, 2, 3}, 0, 5, 1.5}, {}, 0}),
              "lead off tangent-arc at 1 2 3 radius 5 angle 1.5 @0:0-0");
    EXPECT_EQ(to_text({Tolerance{0.05, 0.5, Filter::semi_finishing}, {}, 0}),
              "tolerance 0.05 rotary 0.5 semi-finishing @0:0-0");
}

TEST(Text, EveryKindIsAmongTheRandomOnes) {
    EXPECT_TRUE(rc::check("kinds", [] {
        std::set<std::size_t> kinds;
        for (std::size_t i = 0; i < std::variant_size_v<Step>; ++i) kinds.insert(any_step(i).index());
        RC_ASSERT(kinds.size() == std::variant_size_v<Step>);
    }));
}

TEST(Text, TheWriterStreamsTheSameText) {
    const std::vector<Record> records{{Feed{100, FeedMode::per_minute}, {0, 0, 4}, 0}, {CycleEnd{}, {0, 5, 9}, 2}};
    std::string out;
    const auto take = [&out](std::string_view s) { out += s; };
    TextWriter writer{take};
    for (const Record& r : records) writer(r);
    EXPECT_EQ(out, to_text(records));
}

TEST(Text, BlankLinesAndNotesAreSkipped) {
    base::Diagnostics diagnostics;
    const auto records = read("; a note\r\n\r\nobrys-cl 2\r\n; more\r\ncycle-end @0:1-2\r\n", diagnostics);
    EXPECT_TRUE(diagnostics.all().empty());
    ASSERT_EQ(records.size(), 1u);
    EXPECT_EQ(records[0].from, (base::Span{0, 1, 2}));
}

/// The complaint about the only wrong line, and the text under its caret.
void expect_wrong(const std::string& line, const std::string& under, const std::string& part_of_message) {
    const std::string text = "obrys-cl 2\ncycle-end @0:0-0\n" + line + "\ncycle-end @0:0-0\n";
    base::Diagnostics diagnostics;
    EXPECT_EQ(read(text, diagnostics).size(), 2u) << line;
    ASSERT_EQ(diagnostics.all().size(), 1u) << line;
    const base::Diagnostic& d = diagnostics.all()[0];
    EXPECT_EQ(d.code, base::codes::syntax);
    EXPECT_EQ(text.substr(d.where.begin, d.where.end - d.where.begin), under) << line;
    EXPECT_NE(d.text.find(part_of_message), std::string::npos) << d.text;
}

TEST(Text, WrongWordsAreMarked) {
    expect_wrong("linaer 1 2 3 @0:0-0", "linaer", "unknown record kind");
    expect_wrong("linear 1 2x 3 @0:0-0", "2x", "expected a number");
    expect_wrong("linear 1 2", "", "expected a number");
    expect_wrong("arc 1 2 3 center 1 2 3 normal 0 1 0 sweep 1 @0:0-0", "center", "centre");
    expect_wrong("spline 1 2 3 k3 1 2 3 k1 1 2 3 k2 1 2 3 @0:0-0", "k1", "k2");
    expect_wrong("spline 1 2 3 k3 1 2 3 k2 1 2 3 k1 1 2 3 \"A\" 1 2 3 deg @0:0-0", "deg", "expected a number");
    expect_wrong("tolerance 0.1 rotary 0 smooth @0:0-0", "smooth", "none, finishing, semi-finishing, roughing");
    expect_wrong("feed 1 mm/mn @0:0-0", "mm/mn", "mm/min, mm/rev, 1/min");
    expect_wrong("tool -5 edge 1 \"\" @0:0-0", "-5", "whole number");
    expect_wrong("comment abc @0:0-0", "abc", "quotes");
    expect_wrong("comment \"abc @0:0-0", "\"abc @0:0-0", "closing quote");
    expect_wrong("comment \"a\\qb\" @0:0-0", "\"a\\q", "escape");
    expect_wrong("axis \"LONGERTHAN8\" 1 mm @0:0-0", "\"LONGERTHAN8\"", "8 characters");
    expect_wrong("cycle-end 0:0-0", "0:0-0", "@file:begin-end");
    expect_wrong("cycle-end @0:0-0 ^1 more", "more", "nothing may follow");
    expect_wrong("cycle-end @0:0-0 7", "7", "call stack");
}

TEST(Text, WithoutItsHeaderNothingIsRead) {
    base::Diagnostics diagnostics;
    EXPECT_TRUE(read("cycle-end @0:0-0\n", diagnostics).empty());
    ASSERT_EQ(diagnostics.all().size(), 1u);
    EXPECT_EQ(diagnostics.all()[0].code, base::codes::syntax);
}

}  // namespace
}  // namespace obrys::cl
