/// Feed, coolant, dwell, compensation.

#include <algorithm>

#include "read/apt/state.hpp"

namespace obrys::read::apt {

using program::Code;
using program::Modal;

namespace {

struct FeedWord {
    std::string_view name;
    Modal mode = Modal::feed_per_minute;
    double mm = 0;  ///< of its unit; 0: that of the text
};
constexpr std::array feed_words{
    FeedWord{"MMPM", Modal::feed_per_minute, 1},   FeedWord{"MMPR", Modal::feed_per_rev, 1},
    FeedWord{"IPM", Modal::feed_per_minute, 25.4}, FeedWord{"IPR", Modal::feed_per_rev, 25.4},
    FeedWord{"PERMIN", Modal::feed_per_minute, 0}, FeedWord{"PERREV", Modal::feed_per_rev, 0},
    FeedWord{"MMPMIN", Modal::feed_per_minute, 1}, FeedWord{"INVERS", Modal::feed_inverse_time, 0},
};

struct FeedWords {
    const FeedWord* unit = nullptr;
    const Token* value = nullptr;
};

/// The number and its unit; false: something else stands there, and was said.
bool take_feed_words(State& s, const Arguments& a, FeedWords& w) {
    for (const Token& t : a) {
        if (t.kind == TokenKind::comma) continue;
        if (t.kind == TokenKind::number && w.value == nullptr) {
            w.value = &t;
            continue;
        }
        const std::string word = t.kind == TokenKind::word ? upper_of(t) : "";
        const FeedWord* unit = nullptr;
        for (const FeedWord& known : feed_words)
            if (known.name == word) unit = &known;
        const bool second = unit != nullptr && w.unit != nullptr;
        if (unit == nullptr || second) {
            fail(s, &t, second ? "this is a second unit of one feed" : "this is no unit of a feed",
                 "write one of MMPM, MMPR, IPM, IPR, PERMIN and PERREV");
            return false;
        }
        w.unit = unit;
    }
    if (w.value == nullptr) fail(s, nullptr, "FEDRAT wants a number");
    if (w.value != nullptr && w.value->number.value < 0) fail(s, w.value, "the feed is negative");
    return w.value != nullptr && !(w.value->number.value < 0);
}

/// A number alone keeps the unit before it, as SURFCAM's SPost and STEP Tools' reader take it; per minute at first.
void keep_unit(State& s, const Feed& f) {
    if (f.mode != Modal::feed_per_minute)
        assume(s, f.begin, f.end, "FEDRAT without a unit keeps the one before it, which is not per minute",
               "let the CAM system write the unit with every FEDRAT");
    else if (f.factor != 1)
        assume(s, f.begin, f.end, "FEDRAT without a unit keeps the one before it, which is not that of the points",
               "let the CAM system write the unit with every FEDRAT");
    else if (!s.feed)
        assume(s, f.begin, f.end, "FEDRAT without a unit is taken per minute, in the unit of the points",
               "let the CAM system write the unit with every FEDRAT");
}

}  // namespace

void read_feed(State& s, const Arguments& a) {
    FeedWords w;
    if (!take_feed_words(s, a, w)) return;
    if (s.rapid)
        assume(s, s.line.begin, s.line.end,
               "FEDRAT between RAPID and its point: the point is taken at rapid, the feed for those behind it",
               "let the CAM system write RAPID right before its point");
    Feed f;
    f.begin = w.value->begin;
    f.end = w.value->end;
    if (w.unit == nullptr) {
        if (s.feed) f.mode = s.feed->mode, f.factor = s.feed->factor;
        keep_unit(s, f);
    } else {
        f.mode = w.unit->mode;
        if (w.unit->mm > 0 && !s.unit_told) set_unit(s, w.unit->mm);
        if (w.unit->mm > 0) f.factor = w.unit->mm / (s.inch > 0 ? s.inch : 1);
    }
    f.value = w.value->number.value * f.factor;
    if (!(s.feed && *s.feed == f)) s.feed_told = false;
    s.feed = f;
}

void read_coolant(State& s, const Arguments& a) {
    const std::string word = a.begin() != a.end() ? upper_of(*a.begin()) : "ON";
    int m = 0;
    if (word == "ON" || word == "FLOOD") m = 8;
    if (word == "MIST") m = 7;
    if (word == "OFF") m = 9;
    if (m == 0 || (a.begin() != a.end() && a.begin() + 1 != a.end()))
        return refuse(s, "flood, mist and off are what is known of coolant here");
    // On controls M7 and M8 add up, while one word of this names the kind.
    const bool changes = m != 9 && s.coolant != 9 && m != s.coolant;
    if (changes)
        assume(s, s.line.begin, s.line.end, "another kind of coolant behind the first is taken to stand in its place",
               "let the CAM system write COOLNT/OFF between them");
    s.coolant = m;
    const auto block_of = [&](int function) {  // two of one block have an order of their own
        begin_block(s);
        s.build.literal(Code::m, function, s.line.begin, s.line.end);
        end_block(s);
    };
    if (changes) block_of(9);
    block_of(m);
}

void read_delay(State& s, const Arguments& a) {
    if (a.begin() == a.end() || a.begin()->kind != TokenKind::number) return fail(s, a.begin(), "DELAY wants a number");
    const Token* more = a.begin() + 1;
    const bool turns = more + 1 < a.end() && upper_of(more[1]) == "REV";
    if (more != a.end() && (!turns || more + 2 != a.end()))
        return fail(s, more, "DELAY wants seconds, or a number of turns with REV");
    begin_block(s);
    s.build.modal(Modal::dwell, s.line.begin, s.line.end);
    s.build.literal(turns ? Code::spindle : Code::p, a.begin()->number, false, a.begin()->begin, a.begin()->end);
    end_block(s);
}

namespace {

/// Words behind CUTCOM/LEFT that say the plane, or which register posts write.
bool is_compensation_word(const Token& t) {
    constexpr std::array<std::string_view, 6> words{"XYPLAN", "YZPLAN", "ZXPLAN", "OSETNO", "LEFT", "RIGHT"};
    return t.kind != TokenKind::word || std::find(words.begin(), words.end(), upper_of(t)) != words.end();
}

}  // namespace

void read_compensation(State& s, const Arguments& a) {
    const std::string word = a.begin() != a.end() ? upper_of(*a.begin()) : "";
    if (word != "LEFT" && word != "RIGHT" && word != "ON" && word != "OFF")
        return refuse(s, "only LEFT, RIGHT and OFF are known");
    const Token* const foreign = std::find_if_not(a.begin() + 1, a.end(), is_compensation_word);
    if (foreign != a.end()) return refuse(s, "what " + std::string(foreign->chars) + " says of it is not known");
    if (word == "OFF") return s.build.ignored("CUTCOM/OFF", s.line.begin, s.line.end);
    assume(s, s.line.begin, s.line.end,
           "points with CUTCOM on are taken as those of the tool's centre: what the control compensates is the tool's "
           "wear, 0 here",
           "if the points lie on the contour, let the CAM system write those of the centre");
    s.build.ignored("CUTCOM", s.line.begin, s.line.end);
}

}  // namespace obrys::read::apt
