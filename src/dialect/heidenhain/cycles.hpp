#pragma once
/// The cycles of the HEIDENHAIN iTNC 530 as data: number, meaning, parameters of both written forms.
/// Source: iTNC 530 user's manual, cycle programming (HEIDENHAIN); the numbered form also: TNC 407/415 conversational.
///
/// Two forms are written:
///   named:    CYCL DEF 200 DRILLING ~ Q200=2 ;SET-UP CLEARANCE ~ Q201=-15 …   a parameter is its Q number
///   numbered: CYCL DEF 1.0 PECKING / CYCL DEF 1.1 SET UP 2 / CYCL DEF 1.2 DEPTH -15 …   line and keyword; the keyword
///             is in the control's language, so the order of the values in a line decides where the word is not known

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "cl/cycle.hpp"

namespace obrys::dialect::heidenhain {

/// How a value scales in a program in inches.
enum class CycleUnit : std::uint8_t { plain, length, feed };

struct CycleParameter {
    int q = -1;             ///< Q number of the named form; -1 in the numbered form
    std::string_view word;  ///< numbered form: spellings in upper case, separated by '|'
    cl::CycleRole role = cl::CycleRole::depth;
    CycleUnit unit = CycleUnit::length;
    std::uint8_t line = 0;  ///< numbered form: 2 of CYCL DEF 1.2

    [[nodiscard]] constexpr bool length() const { return unit == CycleUnit::length; }
};

struct Cycle {
    enum class Use : std::uint8_t {
        run,       ///< its effect is simulated
        accepted,  ///< no effect on the path; `text` says what it does
        refused,   ///< not simulated; `text` says why
    };
    int number = 0;
    cl::CycleKind kind = cl::CycleKind::drill;
    std::string_view name;     ///< English, as the control shows it
    bool call_active = false;  ///< runs on CYCL CALL, M99, M89; otherwise acts at its definition
    std::span<const CycleParameter> parameters;
    Use use = Use::run;
    std::string_view text = {};
};

[[nodiscard]] const Cycle* find_cycle(int number);
/// Sorted by number.
[[nodiscard]] std::span<const Cycle> all_cycles();

[[nodiscard]] const CycleParameter* find_parameter(const Cycle& cycle, int q);
/// Numbered form: by line and keyword (upper case); null where that line has no such word.
[[nodiscard]] const CycleParameter* find_parameter(const Cycle& cycle, int line, std::string_view word);
/// Numbered form: bit n stands for line n, which a definition cannot do without; 0 in the named form. Cycles that act at
/// their definition need their first line alone, which may be empty (a reset).
[[nodiscard]] std::uint32_t needed_lines(const Cycle& cycle);
/// Numbered form: the n-th (from 0) value of a line.
[[nodiscard]] const CycleParameter* find_parameter_at(const Cycle& cycle, int line, std::size_t n);

/// GLOBAL DEF of that number has the parameter; false for numbers that the control has not.
[[nodiscard]] bool is_global_value(int number, int q);
/// Its name as the control shows it; empty where there is none.
[[nodiscard]] std::string_view global_values_name(int number);

/// Cycle of a G code of the control's DIN/ISO language. Source: TNC 407 and iTNC 530 ISO programming, tables of G
/// codes.
struct IsoCycle {
    int number = 0;
    double direction = 0;  ///< where the G code says it (G75 to G78, G58, G59): +1 counter-clockwise, -1 clockwise
};
[[nodiscard]] std::optional<IsoCycle> find_iso_cycle(int g);
/// Numbered form in DIN/ISO: parameter P01 is the first value, and so on. Of a side (P05 X+80) the entry of its axis X;
/// its line and the axis written give the right one. The direction is none of them.
[[nodiscard]] const CycleParameter* find_iso_parameter(const Cycle& cycle, int p);
/// As above by the word, a letter or P and two digits: F of G04 and G72, S of G36, H of G73, T of G62, F and S of G80
/// (iTNC 530 User's Manual DIN/ISO Programming, list of addresses). Axes are in find_parameter.
[[nodiscard]] const CycleParameter* find_iso_parameter(const Cycle& cycle, std::string_view word);

}  // namespace obrys::dialect::heidenhain
