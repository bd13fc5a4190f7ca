/// Feed, spindle, coolant, dwell, compensation.

#include <cmath>

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

}  // namespace

void read_feed(State& s, const Arguments& a) {
    Feed f;
    f.mode = s.feed ? s.feed->mode : Modal::feed_per_minute;
    const FeedWord* unit = nullptr;
    const Token* value = nullptr;
    for (const Token& t : a) {
        if (t.kind == TokenKind::comma) continue;
        if (t.kind == TokenKind::number && value == nullptr) {
            value = &t;
            continue;
        }
        const std::string word = t.kind == TokenKind::word ? upper_of(t) : "";
        for (const FeedWord& w : feed_words)
            if (w.name == word) unit = &w;
        if (unit == nullptr || unit->name != word)
            return fail(s, &t, "this is no unit of a feed", "write MMPM, MMPR, IPM, IPR, PERMIN or PERREV");
    }
    if (value == nullptr) return fail(s, nullptr, "FEDRAT wants a number");
    if (value->number.value < 0) return fail(s, value, "the feed is negative");
    if (unit != nullptr) f.mode = unit->mode;
    if (unit != nullptr && unit->mm > 0 && !s.unit_told) set_unit(s, unit->mm);
    const double factor = unit == nullptr || unit->mm == 0 ? 1 : unit->mm / (s.inch > 0 ? s.inch : 1);
    f.value = value->number.value * factor;
    f.begin = value->begin;
    f.end = value->end;
    if (!(s.feed && *s.feed == f)) s.feed_told = false;
    s.feed = f;
}

namespace {

struct SpindleWords {
    std::optional<double> speed, limit, angle;
    int m = 0;
    enum class Unit : std::uint8_t { none, turns, feet, metres } unit = Unit::none;
};

/// RANGE and MAXRPM have numbers of their own.
bool take_spindle_couplet(const Token*& t, const Token* end, const std::string& word, SpindleWords& w) {
    const bool couplet = t + 2 < end && t[1].kind == TokenKind::comma && t[2].kind == TokenKind::number;
    if (!couplet || (word != "RANGE" && word != "MAXRPM" && word != "ORIENT")) return false;
    if (word == "MAXRPM") w.limit = t[2].number.value;
    if (word == "ORIENT") w.angle = t[2].number.value, w.m = 19;
    t += 2;
    return true;
}

bool take_spindle_word(const std::string& word, SpindleWords& w, int before) {
    using Unit = SpindleWords::Unit;
    if (word == "RPM")
        w.unit = Unit::turns;
    else if (word == "SFM")
        w.unit = Unit::feet;
    else if (word == "SMM")
        w.unit = Unit::metres;
    else if (word == "CLW")
        w.m = 3;
    else if (word == "CCLW")
        w.m = 4;
    else if (word == "OFF" || word == "STOP")
        w.m = 5;
    else if (word == "ON")
        w.m = before;
    else if (word == "ORIENT")
        w.m = 19;
    else
        return word == "LOW" || word == "HIGH" || word == "MEDIUM";
    return true;
}

void tell_spindle(State& s, const SpindleWords& w) {
    using Unit = SpindleWords::Unit;
    begin_block(s);
    const bool surface = w.unit == Unit::feet || w.unit == Unit::metres || (w.unit == Unit::none && s.surface);
    if (w.speed && surface != s.surface) {
        s.build.modal(surface ? Modal::surface_speed_on : Modal::surface_speed_off, s.line.begin, s.line.end,
                      surface ? 96 : 97);
        s.surface = surface;
    }
    double speed = w.speed.value_or(0);
    const bool inches = s.inch > 1;  // the interpreter counts feet then
    if (w.unit == Unit::feet && !inches) speed *= 0.3048;
    if (w.unit == Unit::metres && inches) speed /= 0.3048;
    if (w.speed) s.speed = surface ? 0 : speed;
    if (w.speed) s.build.literal(Code::spindle, speed, s.line.begin, s.line.end);
    if (w.limit) s.build.literal(Code::speed_limit, *w.limit, s.line.begin, s.line.end);
    if (w.angle) s.build.literal(Code::radius, *w.angle, s.line.begin, s.line.end);
    if (w.m != 0) s.build.literal(Code::m, w.m, s.line.begin, s.line.end);
    end_block(s);
}

}  // namespace

void read_spindle(State& s, const Arguments& a) {
    SpindleWords w;
    for (const Token* t = a.begin(); t < a.end(); ++t) {
        if (t->kind == TokenKind::comma) continue;
        if (t->kind == TokenKind::number && !w.speed) {
            w.speed = t->number.value;
            continue;
        }
        const std::string word = t->kind == TokenKind::word ? upper_of(*t) : "";
        if (take_spindle_couplet(t, a.end(), word, w) || take_spindle_word(word, w, s.spindle)) continue;
        return fail(s, t, "what this says of the spindle is not known");
    }
    if (w.speed && *w.speed < 0) return fail(s, a.begin(), "the speed of the spindle is negative");
    if (w.speed && w.m == 0) w.m = s.spindle;
    if (w.m == 3 || w.m == 4) s.spindle = w.m;
    if (w.unit == SpindleWords::Unit::feet && s.inch == 1)
        assume(s, s.line.begin, s.line.end,
               "SFM in a metric text is taken as feet per minute, as the word says; metres are SMM",
               "let the CAM system write SMM if metres are meant");
    tell_spindle(s, w);
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

void read_compensation(State& s, const Arguments& a) {
    const std::string word = a.begin() != a.end() ? upper_of(*a.begin()) : "";
    if (word == "OFF") return s.build.ignored("CUTCOM/OFF", s.line.begin, s.line.end);
    if (word != "LEFT" && word != "RIGHT" && word != "ON") return refuse(s, "only LEFT, RIGHT and OFF are known");
    assume(s, s.line.begin, s.line.end,
           "points with CUTCOM on are taken as those of the tool's centre: what the control compensates is the tool's "
           "wear, 0 here",
           "if the points lie on the contour, let the CAM system write those of the centre");
    s.build.ignored("CUTCOM", s.line.begin, s.line.end);
}

}  // namespace obrys::read::apt
