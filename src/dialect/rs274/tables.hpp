#pragma once
/// What the tables of an RS-274 variant hold: G and M codes with their modal groups and their place in the order of
/// execution, operators, functions, predefined names. The reader knows none of them by itself.

#include <array>
#include <cstdint>
#include <span>
#include <string_view>

#include "program/traits.hpp"
#include "program/unit.hpp"

namespace obrys::dialect::rs274 {

/// Places in the order in which the words of a block act: LinuxCNC manual "G-code overview", order of execution.
/// Words of one place keep the order of the text.
enum class Order : std::uint8_t {
    comment,
    feed_mode,
    surface_speed,  ///< G96 D, G97: S behind it is meant in it
    technology,     ///< F S T
    m_output,       ///< M62 … M68
    m_tool,         ///< M6, M61
    m_spindle,
    m_coolant,
    m_override,
    m_user,
    m_stop,  ///< M0 M1 M2 M30 M60; the run keeps them for the block's end
    value,   ///< coordinates and all other letters
    assign,
    act,
    state,  ///< M70 … M73
    dwell,
    plane,
    units,
    diameter,
    compensation,
    tool_length,
    datum,
    path_control,
    distance,
    arc_centre,
    retract,
    special,  ///< G10 G28 G30 G52 G92 …
    suppress,
    motion,
};

enum class Use : std::uint8_t {
    modal,        ///< a modal word
    canned,       ///< Modal::canned with the index of the cycle in the traits
    m_word,       ///< Code::m
    ignored,      ///< known, without effect on the path
    unsupported,  ///< known, not run
    call,
    return_,  ///< M98, M99
};

/// Groups of which a block may hold one code each.
inline constexpr std::uint8_t no_group = 255;

/// What a block with this code does with coordinates.
enum class Axes : std::uint8_t {
    none,       ///< nothing
    allowed,    ///< a motion that may stand without them (G0 … G3)
    required,   ///< a motion that needs one at least
    forbidden,  ///< G80, G70 … G72: none may stand in the block
    own,        ///< a code of group 0 that takes them for itself (G10, G28)
    own_required,
};

struct GCode {
    std::uint16_t number = 0;  ///< G number * 10
    std::uint8_t group = no_group;
    Use use = Use::modal;
    Order order = Order::motion;
    program::Modal modal = program::Modal::rapid;
    std::uint16_t modal_number = 0;
    Axes axes = Axes::none;
    std::string_view reason = {};  ///< of what is not run: what it belongs to
};

struct MCode {
    std::uint16_t first = 0, last = 0;  ///< numbers, inclusive
    std::uint8_t group = no_group;
    Use use = Use::m_word;
    Order order = Order::m_user;
    std::string_view letters = {};  ///< words beside it that belong to it, upper case
    program::Modal modal = program::Modal::rapid;
    std::string_view reason = {};
};

/// Binding strength grows with `level`; operators of one level bind from left to right.
struct OperatorName {
    std::string_view text;
    program::Operator op;
    std::uint8_t level = 0;
};

enum class Argument : std::uint8_t {
    one,        ///< NAME[a]
    ratio,      ///< NAME[a]/[b]
    either,     ///< NAME[a] or NAME[a]/[b] or NAME[a,b]
    parameter,  ///< NAME[#…]: asks whether it exists
    refused,    ///< known, not run
};
struct FunctionName {
    std::string_view text;
    program::Function function;
    Argument argument = Argument::one;
};

struct PredefinedName {
    std::string_view text;  ///< upper case, with its underscore
    program::StateQuery query;
};

/// Numbers of parameters that can only be read.
struct NumberRange {
    std::uint32_t first = 0, last = 0;
};

/// A letter that only some codes use: a block in which none of them stands, and that moves by no code of its own, must
/// not have it.
struct LetterUse {
    char letter = 0;
    program::Code code = program::Code::p;
    std::span<const std::uint16_t> g;  ///< numbers times ten
    std::array<NumberRange, 3> m{};    ///< M numbers; {0, 0}: none
};

/// Places of G codes in the table by their number * 10; -1 where the control has none.
using GIndex = std::array<std::int16_t, 10000>;

struct Dialect {
    std::string_view control;  ///< for messages: "LinuxCNC"
    const program::Traits* traits = nullptr;
    std::span<const GCode> g;
    const GIndex* g_index = nullptr;
    std::span<const MCode> m;
    std::span<const OperatorName> operators;  ///< longer ones before their beginnings
    std::span<const FunctionName> functions;
    std::span<const PredefinedName> predefined;
    std::span<const NumberRange> read_only;
    std::span<const LetterUse> letters;  ///< empty: every letter may stand in every block
    bool named_parameters = true;        ///< #<name>
    bool null_parameter = false;         ///< #0 can be read: it has no value
    bool semicolon_comment = true;       ///< `;` begins a comment to the line's end; else it ends the block
    bool nested_comments = false;        ///< `( … ( … )` is a comment; else an error
    bool skip_levels = false;            ///< /2
    bool o_words = true;                 ///< o100 sub, o<name> if
    bool active_comments = true;         ///< (debug, …), (print, …)
    bool percent_needs_begin = true;     ///< `%` alone is an error where the text does not begin with one
    int longest_line = 0;                ///< bytes; 0: no limit
    bool whole_lists = true;   ///< the tables hold all codes of the control; else those that are known of it
    bool end_is_due = true;              ///< a program without M2, M30 or `%` at its end is an error
};

/// Nothing where the control has no such code; `tenths`: the number times ten.
[[nodiscard]] inline const GCode* find_g(const Dialect& d, std::int32_t tenths) {
    if (tenths < 0 || tenths >= static_cast<std::int32_t>(d.g_index->size())) return nullptr;
    const std::int16_t at = (*d.g_index)[static_cast<std::size_t>(tenths)];
    return at < 0 ? nullptr : &d.g[static_cast<std::size_t>(at)];
}
[[nodiscard]] const MCode* find_m(const Dialect& d, std::int32_t number);

/// Fills a GIndex from its table.
template <std::size_t n>
[[nodiscard]] constexpr GIndex make_g_index(const std::array<GCode, n>& table) {
    GIndex index{};
    index.fill(-1);
    for (std::size_t i = 0; i < n; ++i) index[table[i].number] = static_cast<std::int16_t>(i);
    return index;
}

/// Code of an address; Code::control where the letter is none.
[[nodiscard]] constexpr program::Code letter_code(char upper) {
    using enum program::Code;
    switch (upper) {
        case 'X': return x;
        case 'Y': return y;
        case 'Z': return z;
        case 'A': return a;
        case 'B': return b;
        case 'C': return c;
        case 'U': return u;
        case 'V': return v;
        case 'W': return w;
        case 'I': return i;
        case 'J': return j;
        case 'K': return k;
        case 'R': return radius;
        case 'P': return p;
        case 'Q': return q;
        case 'L': return l;
        case 'E': return e;
        case 'H': return offset_h;
        case 'D': return offset_d;
        case 'F': return feed;
        case 'S': return spindle;
        case 'T': return tool;
        case '@': return polar_radius;
        case '^': return polar_angle;
        default: return control;
    }
}

}  // namespace obrys::dialect::rs274
