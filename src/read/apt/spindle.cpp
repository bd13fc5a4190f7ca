/// SPINDL: speed, sense, stop, angle.

#include "read/apt/state.hpp"

namespace obrys::read::apt {

using program::Code;
using program::Modal;

namespace {

struct SpindleWords {
    enum class Unit : std::uint8_t { none, turns, feet, metres };
    enum class Turn : std::uint8_t { none, on, off, held };
    std::optional<double> speed, limit, angle;
    int sense = 0;  ///< M3, M4; 0: not said
    Turn turn = Turn::none;
    Unit unit = Unit::none;
};
using Unit = SpindleWords::Unit;
using Turn = SpindleWords::Turn;

/// The same word again says nothing new; another one in its place contradicts it.
template <class Value>
bool say_once(Value& slot, Value none, Value v) {
    const bool fits = slot == none || slot == v;
    slot = v;
    return fits;
}

enum class Taken : std::uint8_t { yes, unknown, contradicts };

Taken taken(bool fits) { return fits ? Taken::yes : Taken::contradicts; }

Taken take_spindle_word(const std::string& word, SpindleWords& w) {
    if (word == "RPM") return taken(say_once(w.unit, Unit::none, Unit::turns));
    if (word == "SFM") return taken(say_once(w.unit, Unit::none, Unit::feet));
    if (word == "SMM") return taken(say_once(w.unit, Unit::none, Unit::metres));
    if (word == "CLW") return taken(say_once(w.sense, 0, 3));
    if (word == "CCLW") return taken(say_once(w.sense, 0, 4));
    if (word == "OFF" || word == "STOP") return taken(say_once(w.turn, Turn::none, Turn::off));
    if (word == "ON") return taken(say_once(w.turn, Turn::none, Turn::on));
    if (word == "ORIENT") return taken(say_once(w.turn, Turn::none, Turn::held));
    return word == "LOW" || word == "HIGH" || word == "MEDIUM" ? Taken::yes : Taken::unknown;  // gears
}

/// RANGE, MAXRPM and ORIENT have numbers of their own.
bool take_spindle_couplet(const Token*& t, const Token* end, const std::string& word, SpindleWords& w) {
    if (word != "RANGE" && word != "MAXRPM" && word != "ORIENT") return false;
    const bool couplet = t + 2 < end && t[2].kind == TokenKind::number;
    if (!couplet) return word == "RANGE";  // LOW, HIGH and MEDIUM are words themselves
    if (word == "MAXRPM") w.limit = t[2].number.value;
    if (word == "ORIENT") w.angle = t[2].number.value, w.turn = Turn::held;
    t += 2;
    return true;
}

/// All words; false: one of them was complained about.
bool take_all(State& s, const Arguments& a, SpindleWords& w) {
    for (const Token* t = a.begin(); t < a.end(); t += 2) {
        if (t->kind == TokenKind::number && !w.speed) {
            w.speed = t->number.value;
            continue;
        }
        const std::string word = t->kind == TokenKind::word ? upper_of(*t) : "";
        if (take_spindle_couplet(t, a.end(), word, w)) continue;
        const Taken known = take_spindle_word(word, w);
        if (known == Taken::yes) continue;
        fail(s, t,
             known == Taken::unknown ? "what this says of the spindle is not known"
                                     : "this contradicts what SPINDL said before it");
        return false;
    }
    const bool stands = w.turn == Turn::off || w.turn == Turn::held;
    if (stands && w.sense != 0) fail(s, a.begin(), "SPINDL says a sense of a spindle that stands");
    return !stands || w.sense == 0;
}

int function_of(const State& s, const SpindleWords& w) {
    if (w.turn == Turn::off) return 5;
    if (w.turn == Turn::held) return 19;
    if (w.sense != 0) return w.sense;
    return w.turn == Turn::on || w.speed ? s.spindle : 0;
}

/// A speed without a unit has that of the one before it.
void keep_unit_of_speed(State& s, SpindleWords& w) {
    if (!w.speed || w.unit != Unit::none || !s.surface) return;
    w.unit = s.surface_in_feet ? Unit::feet : Unit::metres;
    assume(s, s.line.begin, s.line.end, "SPINDL without a unit keeps the one before it, which is a cutting speed",
           "let the CAM system write RPM, SFM or SMM with every speed");
}

void tell_spindle(State& s, const SpindleWords& w, int m) {
    begin_block(s);
    const bool surface = w.unit == Unit::feet || w.unit == Unit::metres;
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
    if (m != 0) s.build.literal(Code::m, m, s.line.begin, s.line.end);
    end_block(s);
}

}  // namespace

void read_spindle(State& s, const Arguments& a) {
    SpindleWords w;
    if (!take_all(s, a, w)) return;
    if (w.speed && *w.speed < 0) return fail(s, a.begin(), "the speed of the spindle is negative");
    keep_unit_of_speed(s, w);
    if (w.speed) s.surface_in_feet = w.unit == Unit::feet;
    const int m = function_of(s, w);
    if (m == 3 || m == 4) s.spindle = m;
    if (w.unit == Unit::feet && s.inch == 1)
        assume(s, s.line.begin, s.line.end,
               "SFM in a metric text is taken as feet per minute, as the word says; metres are SMM",
               "let the CAM system write SMM if metres are meant");
    tell_spindle(s, w, m);
}

}  // namespace obrys::read::apt
