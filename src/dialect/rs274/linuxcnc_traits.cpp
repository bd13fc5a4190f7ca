#include "dialect/rs274/linuxcnc.hpp"

namespace obrys::dialect::rs274 {

namespace {

using program::LiveParameters;
using program::SystemVariable;

/// Manual "G-code overview", numbered parameters.
constexpr std::array live{
    LiveParameters{5061, 9, SystemVariable::probed_coordinate},
    LiveParameters{5070, 1, SystemVariable::probe_success},
    LiveParameters{5399, 1, SystemVariable::input_value},
    LiveParameters{5400, 14, SystemVariable::tool_table_column},
    LiveParameters{5420, 9, SystemVariable::coordinate},
};

}  // namespace

/// Comparisons hold within 0.0001 (interpreter: TOLERANCE_EQUAL). The last parameter is #5601.
constexpr program::Traits traits{
    .equality = {0, 1e-4},
    .banks = {program::ParameterBank{"#", 5602}, {}, {}},
    .jump_to_block_number = false,
    .end_stops_all = true,
    .datum = {.prefix = "G", .key = "G", .none = "G54", .none_key = "G54", .none_is_machine_zero = false},
    .assigns_together = true,
    .variables_by_assignment = true,
    .argument_parameters = 30,
    .parameters_begin_at_zero = true,
    .live = live,
};
const program::Traits linuxcnc_traits = traits;

const Dialect linuxcnc{
    .control = "LinuxCNC",
    .traits = &linuxcnc_traits,
    .g = linuxcnc_g,
    .g_index = &linuxcnc_g_index,
    .m = linuxcnc_m,
    .operators = linuxcnc_operators,
    .functions = linuxcnc_functions,
    .predefined = linuxcnc_predefined,
    .read_only = linuxcnc_read_only,
    .letters = linuxcnc_letters,
};

}  // namespace obrys::dialect::rs274
