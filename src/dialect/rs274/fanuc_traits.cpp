#include "dialect/rs274/fanuc.hpp"

#include <array>

namespace obrys::dialect::rs274 {

namespace {

using program::Function;
using program::KeptParameters;
using program::LiveParameters;
using program::Operator;
using program::SystemVariable;

/// Parameters that computed numbers (#[…]) may reach; those written as #4003 are read as what they mean. Work offsets
/// are ordinary parameters.
constexpr std::array live{
    LiveParameters{3001, 2, SystemVariable::timer},
    LiveParameters{3003, 3, SystemVariable::timer},  // what the machine's settings make of it
    LiveParameters{3008, 3, SystemVariable::timer},
    LiveParameters{3011, 2, SystemVariable::unknown},  // date and time: can only be read (B-63684EN, 16.2)
    LiveParameters{3013, 16, SystemVariable::timer},
    LiveParameters{3030, 4, SystemVariable::timer},
    LiveParameters{4000, 1000, SystemVariable::unknown},
    LiveParameters{5001, 9, SystemVariable::coordinate},
    LiveParameters{5021, 9, SystemVariable::machine_coordinate},
    LiveParameters{5041, 9, SystemVariable::coordinate},
    LiveParameters{5061, 9, SystemVariable::probed_coordinate},
};
/// Lathes count X, Z, C: only what is written as a number is known.
constexpr std::array lathe_live{
    LiveParameters{3001, 2, SystemVariable::timer},
    LiveParameters{3003, 3, SystemVariable::timer},  // what the machine's settings make of it
    LiveParameters{3008, 3, SystemVariable::timer},
    LiveParameters{3011, 2, SystemVariable::unknown},
    LiveParameters{3013, 16, SystemVariable::timer},
    LiveParameters{3030, 4, SystemVariable::timer},
    LiveParameters{4000, 1150, SystemVariable::unknown},
};

/// What holds something from before the program. Common variables: FANUC B-63684EN, 16.1 (#500 … keep their values
/// without power, #100 … do not); #98000 … of series 30i [-]; Haas 96-8000, page 93 (all of them are kept), #10000 …
/// are those of newer Haas controls.
constexpr KeptParameters retained{500, 999}, signals{1000, 1199, {}, true}, tool_offsets{2000, 2999, {}, true},
    mirror{3007, 3007, {}, true}, kept_3200{3201, 3399, {}, true}, parts{3901, 3902, {}, true},
    in_force{5081, 5149, {}, true}, datums{5201, 5328}, more_datums{7001, 7960}, tool_data{8000, 97999, {}, true},
    extended{98000, 98499};
/// Between them: not there on every control, and what writing them does is not known.
constexpr KeptParameters after_signals{1200, 1999, {}, true}, before_3200{3034, 3200, {}, true},
    after_3200{3400, 3900, {}, true}, after_parts{3903, 3999, {}, true}, after_block_end{5010, 5020, {}, true},
    after_machine{5030, 5040, {}, true}, after_place{5050, 5060, {}, true}, after_skip{5070, 5080, {}, true},
    before_datums{5150, 5200, {}, true}, after_datums{5329, 7000, {}, true}, before_tools{7961, 7999, {}, true};
constexpr std::array fanuc_kept{KeptParameters{100, 199, "bit CCV of parameter 6001 = 0"},
                                retained,
                                signals,
                                tool_offsets,
                                mirror,
                                kept_3200,
                                parts,
                                in_force,
                                datums,
                                more_datums,
                                tool_data,
                                extended,
                                after_signals,
                                before_3200,
                                after_3200,
                                after_parts,
                                after_block_end,
                                after_machine,
                                after_place,
                                after_skip,
                                before_datums,
                                after_datums,
                                before_tools};
constexpr std::array haas_kept{KeptParameters{100, 199},
                               retained,
                               signals,
                               tool_offsets,
                               mirror,
                               kept_3200,
                               parts,
                               in_force,
                               datums,
                               more_datums,
                               KeptParameters{8000, 9999, {}, true},
                               KeptParameters{10000, 10999},
                               KeptParameters{11000, 98499, {}, true},
                               after_signals,
                               before_3200,
                               after_3200,
                               after_parts,
                               after_block_end,
                               after_machine,
                               after_place,
                               after_skip,
                               before_datums,
                               after_datums,
                               before_tools};

/// Angle of M19 by P or R; builders' M functions take P and Q at most [-].
constexpr std::array function_letters{program::FunctionLetters{19, 19, "RP"}};

/// Haas Mill Operator's Manual 96-8000, M00: it stops axes and spindle and switches the coolant off; M01 does the same
/// where the operator has switched it on.
constexpr std::array haas_stops{program::SpindleStop{0, false, true, true}, program::SpindleStop{1, false, false}};
/// B-63684EN, M00 and M01: automatic operation stops. What spindle and coolant do is the machine builder's.
constexpr std::array fanuc_stops{program::SpindleStop{0, false, false}, program::SpindleStop{1, false, false}};

constexpr program::Traits common{
    // Parameter 3403#6 (AD2): alarm 5074, or the last address counts (series 30i/31i/32i parameter manual B-64310EN).
    .repeated_words = program::Repeated::last_or_stop,
    // "If G codes of one group are specified in a block, the last one is valid" (operator's manual, G codes).
    .repeated_groups = program::Repeated::last_counts,
    .equality = {0, 1e-7},
    .banks = {program::ParameterBank{"#", 98500}, {}, {}},
    .named_variables = program::NamedVariables::none,
    .jump_to_block_number = true,
    .end_stops_all = true,
    .may_end_anywhere = true,
    .label_depth = 9,
    .datum = {.prefix = "G",
              .key = "G",
              .none = "G54",
              .none_key = "G54",
              .more_by_decimals = true,
              .none_is_machine_zero = false},
    .variables_by_assignment = true,
    .argument_parameters = 33,
    .parameters_begin_at_one = true,  // #0 is always empty
    .programs_by_number = true,
    .modal_calls_nest = true,
    .repeats_program = "M99",
    .parameters_begin_at_zero = true,
    .empty_parameters = true,
    .kept = fanuc_kept,
    .absent_first = 34,  // B-63684EN, 16.1: #1 … #33, #100 …; the control: alarm 115; Haas 96-8000, page 93
    .absent_last = 99,
    .live = live,
    .offsets = {.datum_first = 5221,
                .datum_step = 20,
                .datum_count = 6,
                .external_first = 5201,
                .extended_first = 7001,
                .extended_count = 48},
    .dwell_in_feed_words = false,
    .feed_mode_ends_surface_speed = false,
    // Bit 5 of parameter 3404: M02 goes back to the beginning, or stays; Haas 96-8000: M30 alone goes back.
    .end_that_stays = 2,
    .function_letters = function_letters,
    .builders_letters = "PQ",
    .compensation_holds_plane = "37",
    .rapid_at_start = true,  // parameter 3402, bit G01 = 0
    .radius_makes_arc = false,
    .canned_words_stay = true,
    // Haas Mill Operator's Manual 96-8000, "Looping canned cycles" (G81 in G90, then G91 X1.0 L9: one depth).
    .canned_positions_stay = true,
};

/// With the hole cycles of mills, or for a lathe.
program::Traits traits_of(std::span<const program::CannedCycle> cycles, bool haas, bool lathe) {
    program::Traits t = common;
    t.canned = cycles;
    t.own_functions = t.passed_functions = accepted_fanuc_m(haas);
    t.pitch_along = program::PitchAlong::farthest_axis;
    t.thread_begins_at_q = lathe;
    if (haas) t.kept = haas_kept;
    // FANUC B-63944EN, 4.1 "Positioning (G00)"; Haas: setting 335, linear rapid mode (docs/dialects/fanuc.md).
    if (haas) t.rapids = {program::RapidWay::each_axis, "setting 335 = NONE"};
    if (!haas) t.rapids = {program::RapidWay::by_setting, "bit LRP of parameter 1401 = 0"};
    t.spindle_stops = fanuc_stops;
    if (haas) t.spindle_stops = haas_stops;
    if (!haas) t.line_without_centre = "bit CIR of parameter 3403 = 0";  // operator's manual, circular interpolation
    if (!haas) t.angles_from_zero = "bit NAT of parameter 6004 = 0";     // operator's manual, custom macro, arithmetic
    if (!haas) t.alarms.circle_compensates = "34";
    // B-63684EN, cutter compensation C, "block without tool movement". Haas looks 80 blocks ahead (96-8000).
    if (!haas)
        t.compensation_idle_blocks = {1, "the older series and parameter 19625 as delivered",
                                      "the tool goes square to the element before, and into the corner"};
    if (!haas) t.outer_corner_setting = "bit CCC of parameter 19607 = 1";  // memory: parameter manual of the 30i
    // Connection manual of the 30i, B-63943EN-1/02, 12.5.2: bit 6 of parameter 5006 shifts coordinates alone.
    if (!haas && !lathe) t.length_word_setting = "bit TOS of parameter 5006";
    // cnc.wiki, "G94 and G95: feed rate modes": F stays, and its number is taken in the new unit.
    if (!haas) t.feed_in_other_unit = "the control takes the number of the last F in the new unit";
    t.radius_to_start_stays = !haas;  // the same, circular interpolation: no move where start and end are one point
    // Haas Mill Operator's Manual 96-8000, G49: H0, G28, M30 and reset end tool length compensation, too.
    t.home_cancels_length = haas && !lathe;
    t.position_adds_in_increments = !haas;
    t.position_reset_names_axes = true;
    if (!haas) t.common_call_levels = 4;  // four to ten by series (cnc.wiki, "Writing and calling subprograms")
    t.unit_before_motion = true;
    t.first_rotary_axis_decides = !lathe;
    // IS-B; the custom macro's variables are rounded so, too (operator's manuals; Haas: "Address Substitution").
    t.counts_increments = true;
    t.increments_per_mm = 1000;
    t.speed_is_whole = true;  // S takes whole numbers, of variables rounded ones (cncarea.com, docs/dialects/fanuc.md)
    t.begins_as_lathe = lathe;
    t.assumes_rest_of_centre = !haas;
    t.guessed_machine = lathe ? program::GuessedMachine::lathe : program::GuessedMachine::mill;
    if (lathe) t.live = lathe_live;
    t.edge_is_offset_number = lathe;
    t.tool_change_stops_spindle = !lathe;  // M6 orients it, whichever tool comes
    t.offset_numbers_stay = !lathe;        // on lathes T says the offset
    t.radius_before_centre = true;
    return t;
}

const program::Traits mill_traits = traits_of(fanuc_mill_cycles(), false, false);
const program::Traits haas_traits = traits_of(haas_mill_cycles(), true, false);
const program::Traits lathe_traits = traits_of({}, false, true), haas_lathe_traits = traits_of({}, true, true);

/// Functions first; then * / AND MOD, then + - OR XOR, then comparisons (series 16i operator's manual B-63684EN, 16.3
/// priority of operations). AND, OR and XOR work bit by bit.
constexpr std::array operators{
    OperatorName{"EQ", Operator::equal, 1},    OperatorName{"NE", Operator::not_equal, 1},
    OperatorName{"GT", Operator::greater, 1},  OperatorName{"GE", Operator::greater_equal, 1},
    OperatorName{"LT", Operator::less, 1},     OperatorName{"LE", Operator::less_equal, 1},
    OperatorName{"XOR", Operator::bit_xor, 2}, OperatorName{"OR", Operator::bit_or, 2},
    OperatorName{"+", Operator::add, 2},       OperatorName{"-", Operator::subtract, 2},
    OperatorName{"AND", Operator::bit_and, 3}, OperatorName{"MOD", Operator::modulo, 3},
    OperatorName{"*", Operator::multiply, 3},  OperatorName{"/", Operator::divide, 3},
};
/// FIX cuts off, FUP goes away from zero (B-63684EN, 16.3).
constexpr std::array functions{
    FunctionName{"SIN", Function::sin, Argument::one},
    FunctionName{"COS", Function::cos, Argument::one},
    FunctionName{"TAN", Function::tan, Argument::one},
    FunctionName{"ASIN", Function::asin, Argument::one},
    FunctionName{"ACOS", Function::acos, Argument::one},
    FunctionName{"ATAN", Function::atan2, Argument::either},
    FunctionName{"SQRT", Function::sqrt, Argument::one},
    FunctionName{"SQR", Function::sqrt, Argument::one},
    FunctionName{"ABS", Function::abs, Argument::one},
    FunctionName{"ROUND", Function::round_away, Argument::one},
    FunctionName{"FIX", Function::trunc, Argument::one},
    FunctionName{"FUP", Function::round_outwards, Argument::one},
    FunctionName{"LN", Function::ln, Argument::one},
    FunctionName{"EXP", Function::exp, Argument::one},
    FunctionName{"BIN", Function::sign, Argument::refused},
    FunctionName{"BCD", Function::sign, Argument::refused},
    FunctionName{"ADP", Function::sign, Argument::refused},
    FunctionName{"POW", Function::sign, Argument::refused},
};

constexpr GIndex no_g = [] {
    GIndex index{};
    index.fill(-1);
    return index;
}();

Dialect dialect_of(std::string_view name, const program::Traits& traits) {
    Dialect d;
    d.control = name;
    d.traits = &traits;
    d.g_index = &no_g;  // fanuc.hpp has G and M codes
    d.operators = operators;
    d.functions = functions;
    d.null_parameter = d.skip_levels = true;
    d.named_parameters = d.semicolon_comment = d.o_words = d.active_comments = false;
    d.percent_needs_begin = d.end_is_due = false;
    return d;
}

}  // namespace

const FanucG* find_fanuc_g(int code, const FanucControl& control) {
    const auto find = [code](std::span<const FanucG> table) -> const FanucG* {
        for (const FanucG& g : table)
            if (g.code == code) return &g;
        return nullptr;
    };
    if (control.is_lathe()) {
        if (control.haas)
            if (const FanucG* g = find(haas_lathe_g_table())) return g;
        for (const LatheG& g : lathe_g_table())
            if ((control.system == GSystem::a ? g.a : control.system == GSystem::b ? g.b : g.c) == code)
                return &g.meaning;
        return nullptr;
    }
    if (control.haas)
        if (const FanucG* g = find(haas_mill_g_table())) return g;
    return find(mill_g_table());
}

const program::Traits& fanuc_traits(const FanucControl& control) {
    if (control.haas) return control.is_lathe() ? haas_lathe_traits : haas_traits;
    return control.is_lathe() ? lathe_traits : mill_traits;
}

const Dialect& fanuc_dialect(const FanucControl& control) {
    static const Dialect mill = dialect_of("FANUC", mill_traits), lathe = dialect_of("FANUC", lathe_traits);
    static const Dialect haas_mill = dialect_of("Haas", haas_traits),
                         haas_lathe = dialect_of("Haas", haas_lathe_traits);
    if (control.haas) return control.is_lathe() ? haas_lathe : haas_mill;
    return control.is_lathe() ? lathe : mill;
}

}  // namespace obrys::dialect::rs274
