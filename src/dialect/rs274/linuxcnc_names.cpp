#include "dialect/rs274/linuxcnc.hpp"

namespace obrys::dialect::rs274 {

namespace {

using program::Function;
using program::Operator;
using program::StateQuery;

/// Levels as in the interpreter: power, multiplication, addition, comparison, logic.
constexpr std::array operators{
    OperatorName{"**", Operator::power, 5},        OperatorName{"*", Operator::multiply, 4},
    OperatorName{"/", Operator::divide, 4},        OperatorName{"MOD", Operator::modulo, 4},
    OperatorName{"+", Operator::add, 3},           OperatorName{"-", Operator::subtract, 3},
    OperatorName{"EQ", Operator::equal, 2},        OperatorName{"NE", Operator::not_equal, 2},
    OperatorName{"GT", Operator::greater, 2},      OperatorName{"GE", Operator::greater_equal, 2},
    OperatorName{"LT", Operator::less, 2},         OperatorName{"LE", Operator::less_equal, 2},
    OperatorName{"AND", Operator::logical_and, 1}, OperatorName{"OR", Operator::logical_or, 1},
    OperatorName{"XOR", Operator::logical_xor, 1},
};

constexpr std::array functions{
    FunctionName{"ABS", Function::abs},          FunctionName{"ACOS", Function::acos},
    FunctionName{"ASIN", Function::asin},        FunctionName{"ATAN", Function::atan2, Argument::ratio},
    FunctionName{"COS", Function::cos},          FunctionName{"EXISTS", Function::is_variable, Argument::parameter},
    FunctionName{"EXP", Function::exp},          FunctionName{"FIX", Function::round_down},
    FunctionName{"FUP", Function::round_up},     FunctionName{"LN", Function::ln},
    FunctionName{"ROUND", Function::round_away}, FunctionName{"SIN", Function::sin},
    FunctionName{"SQRT", Function::sqrt},        FunctionName{"TAN", Function::tan},
};

/// Names that LinuxCNC itself keeps up to date: manual "G-code overview", predefined named parameters.
constexpr std::array predefined{
    PredefinedName{"_VMAJOR", StateQuery::version_major},
    PredefinedName{"_VMINOR", StateQuery::version_minor},
    PredefinedName{"_LINE", StateQuery::line},
    PredefinedName{"_MOTION_MODE", StateQuery::motion_mode},
    PredefinedName{"_PLANE", StateQuery::plane},
    PredefinedName{"_CCOMP", StateQuery::compensation},
    PredefinedName{"_METRIC", StateQuery::metric},
    PredefinedName{"_IMPERIAL", StateQuery::imperial},
    PredefinedName{"_ABSOLUTE", StateQuery::absolute},
    PredefinedName{"_INCREMENTAL", StateQuery::incremental},
    PredefinedName{"_INVERSE_TIME", StateQuery::inverse_time},
    PredefinedName{"_UNITS_PER_MINUTE", StateQuery::feed_per_minute},
    PredefinedName{"_UNITS_PER_REV", StateQuery::feed_per_rev},
    PredefinedName{"_COORD_SYSTEM", StateQuery::coordinate_system},
    PredefinedName{"_TOOL_OFFSET", StateQuery::tool_offset},
    PredefinedName{"_RETRACT_R_PLANE", StateQuery::retract_clearance},
    PredefinedName{"_RETRACT_OLD_Z", StateQuery::retract_initial},
    PredefinedName{"_SPINDLE_RPM_MODE", StateQuery::spindle_rpm_mode},
    PredefinedName{"_SPINDLE_CSS_MODE", StateQuery::spindle_surface_mode},
    PredefinedName{"_IJK_ABSOLUTE_MODE", StateQuery::arc_centre_absolute},
    PredefinedName{"_LATHE_DIAMETER_MODE", StateQuery::diameter_mode},
    PredefinedName{"_LATHE_RADIUS_MODE", StateQuery::radius_mode},
    PredefinedName{"_SPINDLE_ON", StateQuery::spindle_on},
    PredefinedName{"_SPINDLE_CW", StateQuery::spindle_clockwise},
    PredefinedName{"_MIST", StateQuery::mist},
    PredefinedName{"_FLOOD", StateQuery::flood},
    PredefinedName{"_SPEED_OVERRIDE", StateQuery::speed_override},
    PredefinedName{"_FEED_OVERRIDE", StateQuery::feed_override},
    PredefinedName{"_ADAPTIVE_FEED", StateQuery::adaptive_feed},
    PredefinedName{"_FEED_HOLD", StateQuery::feed_hold},
    PredefinedName{"_FEED", StateQuery::feed},
    PredefinedName{"_RPM", StateQuery::speed},
    PredefinedName{"_X", StateQuery::x},
    PredefinedName{"_Y", StateQuery::y},
    PredefinedName{"_Z", StateQuery::z},
    PredefinedName{"_A", StateQuery::a},
    PredefinedName{"_B", StateQuery::b},
    PredefinedName{"_C", StateQuery::c},
    PredefinedName{"_U", StateQuery::u},
    PredefinedName{"_V", StateQuery::v},
    PredefinedName{"_W", StateQuery::w},
    PredefinedName{"_ABS_X", StateQuery::machine_x},
    PredefinedName{"_ABS_Y", StateQuery::machine_y},
    PredefinedName{"_ABS_Z", StateQuery::machine_z},
    PredefinedName{"_ABS_A", StateQuery::machine_a},
    PredefinedName{"_ABS_B", StateQuery::machine_b},
    PredefinedName{"_ABS_C", StateQuery::machine_c},
    PredefinedName{"_ABS_U", StateQuery::machine_u},
    PredefinedName{"_ABS_V", StateQuery::machine_v},
    PredefinedName{"_ABS_W", StateQuery::machine_w},
    PredefinedName{"_CURRENT_TOOL", StateQuery::current_tool},
    PredefinedName{"_CURRENT_POCKET", StateQuery::current_pocket},
    PredefinedName{"_SELECTED_TOOL", StateQuery::selected_tool},
    PredefinedName{"_SELECTED_POCKET", StateQuery::selected_pocket},
    PredefinedName{"_TASK", StateQuery::is_task},
    PredefinedName{"_CALL_LEVEL", StateQuery::call_level},
    PredefinedName{"_REMAP_LEVEL", StateQuery::remap_level},
};

/// Tool data and position; `rs274` refuses to assign them.
constexpr std::array read_only{NumberRange{5400, 5413}, NumberRange{5420, 5428}};

}  // namespace

const std::span<const OperatorName> linuxcnc_operators = operators;
const std::span<const FunctionName> linuxcnc_functions = functions;
const std::span<const PredefinedName> linuxcnc_predefined = predefined;
const std::span<const NumberRange> linuxcnc_read_only = read_only;

}  // namespace obrys::dialect::rs274
