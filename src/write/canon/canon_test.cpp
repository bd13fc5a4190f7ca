#include "write/canon/canon.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace obrys::write {
namespace {

namespace heard = interp::heard;

/// The calls alone, without counters and block numbers.
struct Printed {
    std::vector<std::string> calls;
    void operator()(std::string_view line) {
        const std::string text(line.substr(0, line.size() - 1));
        calls.push_back(text.size() > 13 ? text.substr(13) : text);
    }
    std::string from(std::size_t n) const {
        std::string out;
        for (std::size_t i = n; i < calls.size(); ++i) out += calls[i] + "\n";
        return out;
    }
};

struct Writing {
    Printed printed;
    std::function<std::string(const base::Span&)> no_number = [](const base::Span&) { return std::string(); };
    CanonWriter writer{printed, no_number};
    std::size_t begun = 0;

    Writing() {
        writer.hear(heard::Zero{54, {}, interp::Axes{}, 0.0}, {});
        begun = printed.calls.size();
    }
    void add(cl::Step step) { writer(cl::Record{std::move(step), {}, 0}); }
    std::string text() const { return printed.from(begun); }
};

cl::Step line_to(double x, double z, bool rapid = false) {
    cl::Linear l;
    l.to = {x, 0, z};
    l.rapid = rapid;
    return l;
}

cl::Step thread_to(double z, double pitch) {
    cl::Thread t;
    t.to = {0, 0, z};
    t.pitch = pitch;
    return t;
}

cl::Step cycle(cl::CycleKind kind) {
    cl::Cycle c;
    c.kind = kind;
    return cl::CycleBegin{c, {}, cl::CycleCall::single, 1, 1};
}

TEST(Canon, BeginsWithTheZero) {
    const Writing w;
    EXPECT_EQ(w.printed.from(0),
              "USE_LENGTH_UNITS(CANON_UNITS_MM)\n"
              "SET_G5X_OFFSET(1, 0.0000, 0.0000, 0.0000, 0.0000, 0.0000, 0.0000)\n"
              "SET_G92_OFFSET(0.0000, 0.0000, 0.0000, 0.0000, 0.0000, 0.0000)\n"
              "SET_XY_ROTATION(0.0000)\nSET_FEED_REFERENCE(CANON_XYZ)\nON_RESET()\n");
}

/// The point counts from the zero of the last Datum; the call has what the program says, in its unit.
TEST(Canon, CoordinatesAreThoseOfTheProgram) {
    Writing w;
    w.add(cl::Datum{54, {0, 0, 0}});
    w.writer.hear(heard::Unit{true}, {});
    w.writer.hear(heard::Counting{geom::Frame::shift({25.4, 0, 0}) * geom::Frame::rotation(2, geom::pi / 2), {}}, {});
    w.add(line_to(25.4, 50.8, true));
    w.add(cl::Linear{{25.4, 25.4, 0}});
    w.writer.hear(heard::Counting{geom::Frame::shift({25.4, 0, 0}), {}}, {});
    w.add(cl::Datum{55, {25.4, 0, 0}});
    w.add(cl::Linear{{25.4, 25.4, 0}});
    EXPECT_EQ(w.text(),
              "USE_LENGTH_UNITS(CANON_UNITS_INCHES)\n"
              "STRAIGHT_TRAVERSE(0.0000, 0.0000, 2.0000, 0.0000, 0.0000, 0.0000)\n"
              "STRAIGHT_FEED(1.0000, 0.0000, 0.0000, 0.0000, 0.0000, 0.0000)\n"
              "STRAIGHT_FEED(1.0000, 1.0000, 0.0000, 0.0000, 0.0000, 0.0000)\n");
}

TEST(Canon, AThreadOfOneBlockIsSynchronisedByItself) {
    Writing w;
    w.add(thread_to(-5, 1.5));
    w.add(thread_to(-9, -1.5));
    EXPECT_EQ(w.text(),
              "START_SPEED_FEED_SYNC(1.500000,0)\n"
              "STRAIGHT_FEED(0.0000, 0.0000, -5.0000, 0.0000, 0.0000, 0.0000)\nSTOP_SPEED_FEED_SYNCH()\n"
              "START_SPEED_FEED_SYNC(1.500000,0)\n"
              "STRAIGHT_FEED(0.0000, 0.0000, -9.0000, 0.0000, 0.0000, 0.0000)\nSTOP_SPEED_FEED_SYNCH()\n");
}

TEST(Canon, AThreadOfACycleGoesOnOverItsMoves) {
    Writing w;
    w.add(cycle(cl::CycleKind::lathe_thread_degressive));
    w.add(thread_to(-5, 1));
    w.add(thread_to(-6, 1));
    w.add(line_to(1, 0, true));
    w.add(cl::CycleEnd{});
    EXPECT_EQ(w.text(),
              "DISABLE_FEED_OVERRIDE()\nSTART_SPEED_FEED_SYNC(1.000000,0)\n"
              "STRAIGHT_FEED(0.0000, 0.0000, -5.0000, 0.0000, 0.0000, 0.0000)\n"
              "STRAIGHT_FEED(0.0000, 0.0000, -6.0000, 0.0000, 0.0000, 0.0000)\n"
              "STOP_SPEED_FEED_SYNCH()\nSTRAIGHT_TRAVERSE(1.0000, 0.0000, 0.0000, 0.0000, 0.0000, 0.0000)\n"
              "ENABLE_FEED_OVERRIDE()\n");
}

/// What the program has switched off stays off behind the tap.
TEST(Canon, ATapHoldsTheOverrides) {
    Writing w;
    w.add(cl::Override{cl::OverrideKind::spindle, false});
    w.add(cycle(cl::CycleKind::canned_tap_floating));
    w.add(line_to(0, -5));
    w.add(cl::Spindle{.speed = 100, .direction = -1});
    w.add(line_to(0, 1));
    w.add(cl::CycleEnd{});
    w.add(cl::Spindle{.speed = 100, .direction = 1});
    EXPECT_EQ(w.text(),
              "DISABLE_SPEED_OVERRIDE(0)\nDISABLE_FEED_OVERRIDE()\nDISABLE_SPEED_OVERRIDE(0)\n"
              "STRAIGHT_FEED(0.0000, 0.0000, -5.0000, 0.0000, 0.0000, 0.0000)\nSTART_SPINDLE_COUNTERCLOCKWISE(0)\n"
              "STRAIGHT_FEED(0.0000, 0.0000, 1.0000, 0.0000, 0.0000, 0.0000)\nENABLE_FEED_OVERRIDE()\n");
}

}  // namespace
}  // namespace obrys::write
