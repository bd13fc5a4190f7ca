/// A corner comes out when the element behind it is known, and by then the words of that block have been told. Whatever
/// feeds stand there, each element is run with its own, and a corner's holds for the corner alone: contours of random
/// feeds against a model that knows one feed an element.

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "base/number.hpp"
#include "driver/bare_run_testing.hpp"
#include "read/heidenhain/read.hpp"
#include "read/sinumerik/read.hpp"

namespace obrys::driver {
namespace {

constexpr double any_feed = -1;  ///< a corner without a feed of its own, where it is not what is tested here

struct FeedElement {
    int feed = 0;         ///< F; 0: not written
    int alone = 0;        ///< FB
    bool corner = false;  ///< behind it
    bool chamfer = false;
    int own = 0;         ///< FRC, or F of RND
    int modal = -1;      ///< FRCM; -1: not written
    bool sinks = false;  ///< a block along the axis of the tool stands behind it, where no corner is
    int sinks_at = 0;    ///< its F
};

struct FeedContour {
    bool compensated = false;
    std::vector<FeedElement> elements;  ///< to the right and upwards by turns
};

int seldom_feed() { return *rc::gen::weightedOneOf<int>({{1, rc::gen::just(0)}, {1, rc::gen::inRange(1, 9)}}) * 100; }

/// The first and the last element have no corner: there compensation begins and ends.
FeedContour any_feed_contour(bool words_of_sinumerik) {
    FeedContour c;
    c.compensated = *rc::gen::arbitrary<bool>();
    const int count = *rc::gen::inRange(3, 9);
    for (int i = 0; i < count; ++i) {
        FeedElement e;
        e.feed = i == 0 ? 50 : seldom_feed();
        // Under compensation a corner that is left sharp would bring an arc of its own.
        e.corner = i > 0 && i + 2 < count && (c.compensated || *rc::gen::inRange(0, 4) != 0);
        e.chamfer = !c.compensated && *rc::gen::arbitrary<bool>();
        if (e.corner && *rc::gen::inRange(0, 3) != 0) e.own = *rc::gen::inRange(1, 9) * 10;
        if (words_of_sinumerik) e.alone = *rc::gen::inRange(0, 3) == 0 ? seldom_feed() / 10 : 0;
        if (words_of_sinumerik && *rc::gen::inRange(0, 5) == 0) e.modal = *rc::gen::inRange(0, 4) * 7;
        e.sinks = !e.corner && !c.compensated && words_of_sinumerik && *rc::gen::inRange(0, 5) == 0;
        if (e.sinks) e.sinks_at = seldom_feed();
        c.elements.push_back(e);
    }
    return c;
}

std::string feed_text(double v) { return base::shortest(v); }

std::string text_of_sinumerik(const FeedContour& c) {
    std::string text = "G17 G71 G90 G94 G450 G40\nT1 D1 M6\nS1000 M3\nG0 X-30 Y0 Z0\n";
    int x = 0, y = 0, z = 0;
    for (std::size_t i = 0; i < c.elements.size(); ++i) {
        const FeedElement& e = c.elements[i];
        text += i % 2 == 0 ? "G1 X" + std::to_string(x += 30) : "G1 Y" + std::to_string(y += 30);
        if (c.compensated && i == 0) text += " G41";
        if (c.compensated && i + 1 == c.elements.size()) text += " G40";
        if (e.feed > 0) text += " F" + std::to_string(e.feed);
        if (e.alone > 0) text += " FB=" + std::to_string(e.alone);
        if (e.corner) text += e.chamfer ? " CHR=3" : " RND=3";
        if (e.corner && e.own > 0) text += " FRC=" + std::to_string(e.own);
        if (e.modal >= 0) text += " FRCM=" + std::to_string(e.modal);
        if (e.sinks) text += "\nZ" + std::to_string(--z) + (e.sinks_at > 0 ? " F" + std::to_string(e.sinks_at) : "");
        text += "\n";
    }
    return text + "M30\n";
}

std::string text_of_klartext(const FeedContour& c) {
    std::string text = "0 BEGIN PGM A MM\n1 TOOL CALL 1 Z S1000\n2 L X-30 Y+0 Z+0 R0 FMAX M3\n";
    int x = 0, y = 0, n = 3;
    const auto block = [&](const std::string& words) { text += std::to_string(n++) + " " + words + "\n"; };
    for (std::size_t i = 0; i < c.elements.size(); ++i) {
        const FeedElement& e = c.elements[i];
        (i % 2 == 0 ? x : y) += 30;
        std::string line = "L X+" + std::to_string(x) + " Y+" + std::to_string(y);
        if (c.compensated && i == 0) line += " RL";
        if (c.compensated && i + 1 == c.elements.size()) line += " R0";
        if (e.feed > 0) line += " F" + std::to_string(e.feed);
        block(line);
        if (!e.corner) continue;
        block((e.chamfer ? std::string("CHF 3") : std::string("RND R3")) +
              (e.own > 0 ? " F" + std::to_string(e.own) : ""));
    }
    block("M30");
    return text + std::to_string(n) + " END PGM A MM\n";
}

/// The feed of every move. A corner of SINUMERIK without one of its own is run with that of the block behind it.
std::vector<double> feeds_by_model(const FeedContour& c, bool corner_as_next) {
    std::vector<double> feeds;
    double f = 0, frcm = 0;
    bool waits = false;
    for (std::size_t i = 0; i < c.elements.size(); ++i) {
        const FeedElement& e = c.elements[i];
        if (e.feed > 0) f = e.feed;
        const double here = e.alone > 0 ? e.alone : f;
        if (waits) feeds.push_back(corner_as_next ? here : any_feed);
        feeds.push_back(here);
        if (e.modal >= 0) frcm = e.modal;
        if (e.sinks && e.sinks_at > 0) f = e.sinks_at;
        if (e.sinks) feeds.push_back(f);
        const double own = e.own > 0 ? e.own : frcm;
        waits = e.corner && own == 0;
        if (e.corner && own > 0) feeds.push_back(own);
    }
    return feeds;
}

struct RunFeeds {
    std::vector<double> feeds;  ///< of every feed move
    std::string stream;
};

template <class Read>
RunFeeds run_feeds(const std::string& name, const std::string& text, base::BlockNumbers numbers, const Read& read) {
    testing::BareRun bare;
    shop::Tool tool;
    tool.number = 1;
    tool.radius = 2;
    bare.tools = {tool};
    const auto file = bare.sources.add(name, text, numbers);
    const program::Unit main = read(file, bare);
    RunFeeds out;
    double feed = 0;
    const auto take = [&](const cl::Record& r) {
        out.stream += testing::placeless(r);
        if (const auto* f = std::get_if<cl::Feed>(&r.step)) feed = f->value;
        const auto* line = std::get_if<cl::Linear>(&r.step);
        const auto* arc = std::get_if<cl::Arc>(&r.step);
        if ((line != nullptr && !line->rapid) || (arc != nullptr && !arc->rapid)) out.feeds.push_back(feed);
    };
    bare.run(main, take);
    out.stream += bare.messages();
    return out;
}

void hold_feeds(const RunFeeds& ran, const std::vector<double>& expected) {
    RC_LOG() << ran.stream;
    RC_ASSERT(ran.feeds.size() == expected.size());
    for (std::size_t i = 0; i < expected.size(); ++i)
        if (expected[i] != any_feed) RC_ASSERT(feed_text(ran.feeds[i]) == feed_text(expected[i]));
}

}  // namespace

RC_GTEST_PROP(CornerFeeds, of_sinumerik_hold_for_their_corner_alone, ()) {
    const FeedContour c = any_feed_contour(true);
    const std::string text = text_of_sinumerik(c);
    RC_LOG() << text;
    hold_feeds(run_feeds("TEST.MPF", text, base::BlockNumbers::n_word,
                         [](auto file, testing::BareRun& b) {
                             return std::move(read::sinumerik::read(file, b.sources, b.names, b.diagnostics).at(0));
                         }),
               feeds_by_model(c, true));
}

RC_GTEST_PROP(CornerFeeds, of_klartext_hold_for_their_corner_alone, ()) {
    const FeedContour c = any_feed_contour(false);
    const std::string text = text_of_klartext(c);
    RC_LOG() << text;
    hold_feeds(run_feeds("TEST.H", text, base::BlockNumbers::leading,
                         [](auto file, testing::BareRun& b) {
                             return read::heidenhain::read(file, b.sources, b.names, b.diagnostics);
                         }),
               feeds_by_model(c, false));
}

}  // namespace obrys::driver
