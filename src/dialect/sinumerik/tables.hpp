#pragma once
/// The SINUMERIK 840D vocabulary as data: which word means what. Shared by its reader and (later) its writer.
/// Sources are named in docs/dialects/sinumerik.md. All names are upper case; lookups are by binary search.

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

#include "dialect/sinumerik/holes.hpp"
#include "program/traits.hpp"
#include "program/unit.hpp"

namespace obrys::dialect::sinumerik {

/// What a reader does with a word.
enum class Use : std::uint8_t {
    modal,              ///< value = program::Modal, number = its number
    address,            ///< value = program::Code; written NAME=value
    named_value,        ///< value = program::NamedKind; NAME[index]=value or NAME=value (FA[X]=)
    ignored,            ///< known, without effect on the path; a value, index or arguments may follow
    unsupported,        ///< known, not run; a value, index or arguments may follow
    unsupported_block,  ///< as unsupported, and the rest of the block belongs to it
    procedure,          ///< value = program::Procedure
    control_cycle,      ///< value = program::ControlCycle; a program of the user with that name counts before it
    statement,          ///< value = Keyword
    frame,              ///< value = program::FrameOp, number = 1 where additive
};

enum class Keyword : std::uint8_t {
    if_,
    else_,
    endif,
    while_,
    endwhile,
    repeat,
    repeatb,
    until,
    loop,
    endloop,
    for_,
    endfor,
    case_,
    goto_,
    gotof,
    gotob,
    gotoc,
    gotos,
    def,
    redef,
    proc,
    extern_,
    define,
    call,
    mcall,
    pcall,
    extcall,
    ret,
};

struct Entry {
    std::string_view name;
    Use use = Use::ignored;
    std::uint16_t value = 0;
    std::uint16_t number = 0;
    std::string_view reason = {};  ///< for unsupported words: what they belong to
};

struct GCode {
    std::uint16_t code;
    Use use;
    program::Modal modal = program::Modal::rapid;
    std::string_view reason = {};
};

/// The entry of a word of two letters or more; nothing for names the control does not know.
[[nodiscard]] const Entry* find_word(std::string_view upper);
/// Meaning of G<number>; G505 … G599 included.
[[nodiscard]] std::optional<GCode> find_g(int number);
/// Meaning of a one-letter address with a value; Code::unknown where it has none of its own.
[[nodiscard]] program::Code address_code(char upper_letter);
[[nodiscard]] std::optional<program::Function> find_function(std::string_view upper);
/// IC, AC, DC, ACP, ACN.
[[nodiscard]] std::optional<program::Reference> find_reference(std::string_view upper);
/// By the whole name with its `$`; `unknown` for names the tables do not hold.
[[nodiscard]] program::SystemVariable find_system_variable(std::string_view upper);
[[nodiscard]] std::optional<program::Type> find_type(std::string_view upper);

/// R parameters outlive power off: what nobody has set is not known.
inline constexpr std::array kept_parameters{program::KeptParameters{0, 999, {}, false}};

/// M70 makes the spindle an axis: it stands under position control until M3, M4 or M5.
inline constexpr std::array<std::int16_t, 7> own_functions{40, 41, 42, 43, 44, 45, 70};
inline constexpr std::span gears(own_functions.data(), 6);
inline constexpr std::array spindle_stops{program::SpindleStop{70, true}};

/// Comparisons of REAL values hold within a relative 1e-12 (Job Planning manual, comparison operations).
inline constexpr program::Traits traits{
    .guessed_machine = program::GuessedMachine::by_words,
    .equality = {1e-12, 0},
    .text_may_end = true,
    .kept = kept_parameters,
    .own_functions = own_functions,
    .passed_functions = gears,
    .tooth_feed_stays = true,
    .spindle_stops = spindle_stops,
    .modal_call_without_motion = true,
    .corner_may_be_tangential = true,
    .compensation_idle_blocks = {3, "MD20250 CUTCOM_MAXNUM_DUMMY_BLOCKS as delivered", "it stops with alarm 10762"},
    .compensates_in_fixed_plane = true,
    .compensation_holds_plane = "10757",
    .exponent_is_ex = true,
    .has_diameter_words = true,
    .radius_makes_arc = false,
    .length_axis_setting = "SD42940 TOOL_LENGTH_CONST = 17",
    .counts_increments = true,  // MD10200 INT_INCR_PER_MM, where the machine file says it
    // 840D sl, Function Manual Feeds (V1) 08/2005, 2.1: F is deleted when G93, G94 or G95 changes; alarm 10860.
    .feed_in_other_unit = "the control deletes F with the change, and stops with alarm 10860",
    .called_holes = called_holes,
    .alarms = {.late_definition = "14500"},
};

}  // namespace obrys::dialect::sinumerik
