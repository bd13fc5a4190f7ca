#include "cl/text.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <set>

#include "base/codes.hpp"

namespace obrys::cl {
namespace {

std::vector<Record> read(std::string text, base::Diagnostics& diagnostics) {
    base::Sources sources;
    const std::uint32_t file = sources.add("test.cl", std::move(text));
    return read_text(sources, file, diagnostics);
}

/// Any double: small decimals, any bits, NaN, infinities, zero.
rc::Gen<double> any_number() {
    return rc::gen::oneOf(
        rc::gen::map(rc::gen::inRange(-1'000'000, 1'000'000), [](int i) { return i / 1000.0; }),
        rc::gen::arbitrary<double>(),
        rc::gen::element<double>(NAN, INFINITY, -INFINITY, 0.0, 5e-324, 1.7976931348623157e308, 1e15));
}
double number() { return *any_number(); }
geom::Vec3 vec() {
    const double x = number(), y = number(), z = number();
    return {x, y, z};
}
std::string text() { return *rc::gen::container<std::string>(rc::gen::arbitrary<char>()); }

std::array<char, 8> axis_name() {
    std::array<char, 8> out{};
    const std::string name = text();
    for (std::size_t i = 0; i < name.size() && i < out.size() && name[i] != 0; ++i) out[i] = name[i];
    return out;
}

geom::Frame any_affine() {
    geom::Frame f;
    f.origin = vec();
    if (*rc::gen::arbitrary<bool>())
        for (double& v : f.linear) v = number();
    return f;
}

template <class Enum>
Enum any_of(Enum last) {
    return static_cast<Enum>(*rc::gen::inRange(0, static_cast<int>(last) + 1));
}

Frame any_frame() {
    Frame s;
    for (int n = *rc::gen::inRange(0, 4); n > 0; --n) {
        const FrameKind kind = any_of(FrameKind::programmed);
        s.parts.push_back({kind, any_affine()});
    }
    return s;
}

CycleBegin any_cycle() {
    Cycle c;
    c.kind = any_of(CycleKind::probe);
    if (*rc::gen::arbitrary<bool>()) c.plane = any_affine();
    for (int i = *rc::gen::inRange(0, 4); i > 0; --i) c.values.push_back({any_of(CycleRole::turned_axes), number()});
    c.name = text();
    for (int i = *rc::gen::inRange(0, 4); i > 0; --i) c.written.push_back({text(), number()});
    CycleBegin s{c, vec(), any_of(CycleCall::pattern)};
    s.pass = *rc::gen::inRange(1, 3);
    s.passes = *rc::gen::inRange(1, 3);
    return s;
}

Programmed any_programmed() {
    Programmed p;
    p.from = vec(), p.to = vec();
    if (*rc::gen::arbitrary<bool>()) p.centre = vec(), p.normal = vec(), p.sweep = number();
    if (p.sweep == 0) p.centre = {}, p.normal = {0, 0, 1}, p.sweep = 0;
    p.rapid = *rc::gen::arbitrary<bool>();
    p.corner = any_of(Corner::rounding);
    if (p.corner != Corner::none) p.size = number(), p.corner_feed = number();
    return p;
}

MachinePlace any_place() {
    MachinePlace p;
    p.kind = any_of(PlaceKind::fixed);
    p.number = *rc::gen::inRange<std::uint8_t>(1, 4);
    p.axes = {*rc::gen::arbitrary<bool>(), *rc::gen::arbitrary<bool>(), *rc::gen::arbitrary<bool>()};
    if (p.axes[0]) p.to.x = number();
    if (p.axes[1]) p.to.y = number();
    if (p.axes[2]) p.to.z = number();
    return p;
}

ToolLength any_length() {
    ToolLength l{*rc::gen::element<std::int8_t>(-1, 0, 1), 0, {}};
    if (l.sense == 0) return l;
    l.offset = *rc::gen::arbitrary<std::uint32_t>();
    if (*rc::gen::arbitrary<bool>()) l.by = vec();
    return l;
}

LeadBegin any_lead() {
    return {any_of(LeadKind::arc_and_line),
            *rc::gen::arbitrary<bool>(),
            vec(),
            number(),
            number(),
            number(),
            *rc::gen::arbitrary<bool>(),
            number()};
}

std::optional<double> perhaps() { return *rc::gen::arbitrary<bool>() ? std::optional(number()) : std::nullopt; }

Step any_step(std::size_t kind) {
    switch (kind) {
        case 0: return Linear{vec(), vec(), *rc::gen::arbitrary<bool>(), any_of(Seek::release_or_end)};
        case 1: return Arc{vec(), vec(), vec(), number(), *rc::gen::arbitrary<bool>()};
        case 2: return Axis{axis_name(), number(), *rc::gen::arbitrary<bool>(), *rc::gen::arbitrary<bool>()};
        case 3: return Thread{vec(), number(), *rc::gen::arbitrary<bool>(), number(), number()};
        case 4: return Dwell{number(), number()};
        case 5:
            return Feed{number(), *rc::gen::element(FeedMode::per_minute, FeedMode::per_rev, FeedMode::inverse_time)};
        case 6:
            return Spindle{number(), *rc::gen::element(SpindleMode::rpm, SpindleMode::surface),
                           *rc::gen::element<std::int8_t>(-1, 0, 1), number(),
                           *rc::gen::arbitrary<bool>() ? std::optional(number()) : std::nullopt};
        case 7:
            return ToolChange{*rc::gen::arbitrary<std::uint32_t>(),
                              *rc::gen::arbitrary<std::uint32_t>(),
                              text(),
                              number(),
                              number(),
                              *rc::gen::arbitrary<bool>(),
                              *rc::gen::arbitrary<bool>(),
                              *rc::gen::arbitrary<std::uint32_t>()};
        case 8: return Coolant{*rc::gen::arbitrary<bool>(), *rc::gen::arbitrary<bool>()};
        case 9: return Stop{*rc::gen::element(StopKind::program, StopKind::optional, StopKind::end)};
        case 10: {
            const bool message = *rc::gen::arbitrary<bool>();
            return Comment{text(), message, message && *rc::gen::arbitrary<bool>()};
        }
        case 11: return Datum{*rc::gen::arbitrary<std::uint32_t>(), vec()};
        case 20: return any_frame();
        case 12: return Auxiliary{*rc::gen::arbitrary<char>(), *rc::gen::arbitrary<std::int64_t>()};
        case 18:
            return PartBegin{*rc::gen::element(PartKind::call, PartKind::label, PartKind::repetition), text(),
                             *rc::gen::arbitrary<std::uint64_t>(), *rc::gen::arbitrary<std::uint64_t>()};
        case 19: return PartEnd{};
        case 17: {
            Setting s{static_cast<SettingKind>(*rc::gen::inRange(0, static_cast<int>(SettingKind::pallet_change) + 1)),
                      *rc::gen::inRange(-1000, 1000),
                      *rc::gen::inRange(-1000, 1000),
                      {}};
            for (double& v : s.values) v = number();
            return s;
        }
        case 13: return any_cycle();
        case 14: {
            Spline s{vec(), vec(), vec(), vec(), vec(), {}};
            for (int i = *rc::gen::inRange(0, 3); i > 0; --i)
                s.axes.push_back({axis_name(), number(), number(), number(), number(), *rc::gen::arbitrary<bool>()});
            return s;
        }
        case 15:
            return Tolerance{number(), number(),
                             *rc::gen::element(Filter::none, Filter::finishing, Filter::semi_finishing,
                                               Filter::roughing, Filter::precision)};
        case 21:
            return CompensationBegin{any_of(CompensationSide::right),      number(),
                                     *rc::gen::arbitrary<std::uint32_t>(), any_of(Approach::smooth),
                                     *rc::gen::arbitrary<bool>(),          vec()};
        case 22: return CompensationEnd{};
        case 23: return any_programmed();
        case 24: return any_place();
        case 25: return any_length();
        case 26:
            return ToolData{*rc::gen::arbitrary<std::uint32_t>(), *rc::gen::arbitrary<std::uint32_t>(), perhaps(),
                            perhaps()};
        case 27: return any_lead();
        case 28: return LeadEnd{};
        case 30: return PathMode{any_of(PathKind::within), number(), number(), *rc::gen::arbitrary<std::uint16_t>()};
        case 29: return DatumData{*rc::gen::arbitrary<std::uint32_t>(), vec(), perhaps(), *rc::gen::arbitrary<bool>()};
        case 31: return ToolSelection{*rc::gen::arbitrary<std::uint32_t>(), text()};
        case 32:
            return Output{*rc::gen::arbitrary<std::uint32_t>(), *rc::gen::arbitrary<bool>(), number(),
                          *rc::gen::arbitrary<bool>()};
        case 33: return Override{any_of(OverrideKind::feed_hold), *rc::gen::arbitrary<bool>()};
        default: return CycleEnd{};
    }
}

Record any_record(std::size_t kind) {
    Record r;
    r.step = any_step(kind);
    r.from = {*rc::gen::arbitrary<std::uint32_t>(), *rc::gen::arbitrary<std::uint32_t>(),
              *rc::gen::arbitrary<std::uint32_t>()};
    r.stack = *rc::gen::arbitrary<StackId>();
    return r;
}

/// Puts a number in the place of NaN, which equals nothing, not even itself.
void mark(double& v) { v = std::isnan(v) ? -987654321.125 : v; }
void mark(geom::Vec3& v) { mark(v.x), mark(v.y), mark(v.z); }
void mark(geom::Frame& f) {
    mark(f.origin);
    for (double& v : f.linear) mark(v);
}
struct Mark {
    void operator()(Linear& s) const { mark(s.to), mark(s.axis); }
    void operator()(Arc& s) const { mark(s.to), mark(s.centre), mark(s.normal), mark(s.sweep); }
    void operator()(Spline& s) const {
        mark(s.to), mark(s.k1), mark(s.k2), mark(s.k3), mark(s.axis);
        for (SplineAxis& a : s.axes) mark(a.to), mark(a.k1), mark(a.k2), mark(a.k3);
    }
    void operator()(Tolerance& s) const { mark(s.contour), mark(s.rotary); }
    void operator()(Axis& s) const { mark(s.to); }
    void operator()(Thread& s) const { mark(s.to), mark(s.pitch), mark(s.start), mark(s.change); }
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
    void operator()(Setting& s) const {
        for (double& v : s.values) mark(v);
    }
    void operator()(CycleBegin& s) const {
        Cycle c = *s.cycle;
        for (CycleValue& v : c.values) mark(v.value);
        for (CycleParameter& p : c.written) mark(p.value);
        mark(c.plane);
        mark(s.place);
        s.cycle = c;
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
