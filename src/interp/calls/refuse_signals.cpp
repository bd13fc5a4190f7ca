/// Outputs, inputs and the orientation of the spindle whose words the control refuses.
/// Source: LinuxCNC 2.9, interp_convert.cc convert_m, interp_check.cc check_other_codes, interp_read.cc read_l.

#include <cmath>

#include "base/codes.hpp"
#include "interp/calls/calls.hpp"

namespace obrys::interp {

namespace codes = base::codes;

namespace {

/// Of LinuxCNC's motion module: num_dio and num_aio are at most 64.
constexpr double most_signals = 64;

base::Span letter_of(const Reckoning& run, Code code) {
    const Unit& unit = run.unit();
    const auto index = static_cast<std::uint32_t>(run.statement - unit.statements.data());
    for (std::uint32_t i = run.statement->first; i < unit.words_end(index); ++i)
        if (program::code_of(unit.words[i]) == code) return unit.span(*run.statement, unit.words[i]);
    return run.here();
}

void refuse_letter(Reckoning& run, Code code, std::string text, std::string remedy = {}) {
    alarm(run, codes::value_range, letter_of(run, code), std::move(text), std::move(remedy));
}

/// A number that is rounded; nothing where the block has none, or after a complaint.
void refuse_number(Moving& run, Code code, const std::string& m) {
    const double n = run.block.has(code) ? run.block.peek(code) : 0;
    if (std::isnan(n))
        return unchecked(run, codes::unknown_value, letter_of(run, code),
                         "which output or input " + m + " is for depends on a value that is not known");
    if (std::round(n) < 0)
        return refuse_letter(run, code,
                             m + " names number " + printed(Value::real(n)) + ": inputs and outputs count from 0");
    if (std::round(n) >= most_signals)
        refuse_letter(run, code,
                      m + " names number " + printed(Value::real(n)) + ": inputs and outputs go up to " +
                          printed(Value::real(most_signals - 1)));
}

void require_letter(Moving& run, Code code, const std::string& m, char letter) {
    if (!run.block.has(code) && !run.stopped)
        alarm(run, codes::value_range, run.here(), m + " needs " + letter + ", the number of the output",
              "write " + m + " " + letter + (letter == 'E' ? "0 Q1" : "0"));
}

/// What M66 waits for: 0 nothing, 1 a rise, 2 a fall, 3 high, 4 low.
void refuse_wait(Moving& run) {
    constexpr double whole_enough = 1e-4;
    const BlockWords& b = run.block;
    const double l = b.has(Code::l) ? b.peek(Code::l) : 0, q = b.has(Code::q) ? b.peek(Code::q) : -1;
    if (std::isnan(l) || std::isnan(q))
        return unchecked(run, codes::unknown_value, letter_of(run, std::isnan(l) ? Code::l : Code::q),
                         "what M66 waits for, or how long, depends on a value that is not known");
    if (!(std::abs(l - std::round(l)) <= whole_enough) || std::round(l) < 0 || std::round(l) > 4)
        return refuse_letter(run, Code::l, "M66 waits as L says: 0 not at all, 1 a rise, 2 a fall, 3 high, 4 low",
                             "write one of them");
    if (std::round(l) > 0 && q <= 0)
        return refuse_letter(run, b.has(Code::q) ? Code::q : Code::l,
                             "M66 waits for an input, but does not say how long", "write Q, seconds above 0, e.g. Q5");
    if (std::round(l) != 0 && b.has(Code::e))
        refuse_letter(run, Code::l, "M66 does not wait for an analog input (E)", "leave out L");
}

void refuse_input(Moving& run) {
    const BlockWords& b = run.block;
    if (b.has(Code::p) && b.has(Code::e))
        return refuse_letter(run, Code::e, "M66 names a digital input with P and an analog one with E",
                             "write one of them");
    if (!b.has(Code::p) && !b.has(Code::e))
        return alarm(run, codes::value_range, run.here(), "M66 says neither with P nor with E which input",
                     "write M66 P0");
    refuse_number(run, b.has(Code::p) ? Code::p : Code::e, "M66");
    if (!run.stopped) refuse_wait(run);
}

void refuse_orientation(Moving& run) {
    constexpr double whole_enough = 1e-3;
    const BlockWords& b = run.block;
    const double p = b.has(Code::p) ? b.peek(Code::p) : 0, q = b.has(Code::q) ? b.peek(Code::q) : 1;
    const double r = b.has(Code::radius) ? b.peek(Code::radius) : 0;
    if (std::isnan(p + q + r)) return;  // the angle is told as unknown
    if (std::abs(p - std::round(p)) > whole_enough || std::round(p) < 0 || std::round(p) > 2)
        return refuse_letter(run, Code::p, "P of M19 is 0, 1 or 2: the shorter way, clockwise, counterclockwise",
                             "write one of them");
    if (r < 0 || r > 360)
        return refuse_letter(run, Code::radius, "R of M19, the angle of the spindle, is from 0 to 360");
    if (!(q > 0))
        refuse_letter(run, Code::q, "Q of M19, the time to wait for the spindle, is above 0", "write seconds, e.g. Q5");
}

void refuse_signal(Moving& run, int m) {
    const std::string name = "M" + std::to_string(m);
    if (m == 19) return refuse_orientation(run);
    if (m == 66) return refuse_input(run);
    const bool digital = m >= 62 && m <= 65;
    if (!digital && m != 67 && m != 68) return;
    require_letter(run, digital ? Code::p : Code::e, name, digital ? 'P' : 'E');
    if (!run.stopped) refuse_number(run, digital ? Code::p : Code::e, name);
}

}  // namespace

void refuse_signals(Moving& run) {
    for (const int m : run.block.m)
        if (!run.stopped) refuse_signal(run, m);
}

}  // namespace obrys::interp
