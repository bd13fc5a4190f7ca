#include <algorithm>
#include <array>
#include <utility>

#include "dialect/sinumerik/tables.hpp"

namespace obrys::dialect::sinumerik {

namespace {

using program::Function;
using program::SystemVariable;

template <class T>
using Row = std::pair<std::string_view, T>;

template <class T, std::size_t n>
constexpr bool sorted(const std::array<Row<T>, n>& rows) {
    return std::is_sorted(rows.begin(), rows.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
}

template <class T, std::size_t n>
std::optional<T> find(const std::array<Row<T>, n>& rows, std::string_view name) {
    const auto found =
        std::lower_bound(rows.begin(), rows.end(), name, [](const auto& r, std::string_view s) { return r.first < s; });
    if (found == rows.end() || found->first != name) return std::nullopt;
    return found->second;
}

// clang-format off
constexpr std::array<Row<Function>, 43> functions{{
    {"ABS", Function::abs}, {"ACOS", Function::acos}, {"ASIN", Function::asin}, {"ATAN2", Function::atan2},
    {"AXNAME", Function::axis_name}, {"AXSTRING", Function::axis_string}, {"BOUND", Function::bound},
    {"CFINE", Function::frame_fine}, {"CMIRROR", Function::frame_mirror}, {"COS", Function::cos},
    {"CROT", Function::frame_rotation}, {"CRPL", Function::frame_plane_rotation}, {"CSCALE", Function::frame_scale},
    {"CTRANS", Function::frame_shift}, {"EXP", Function::exp}, {"INDEX", Function::index},
    {"INVFRAME", Function::frame_inverse}, {"ISAXIS", Function::is_axis}, {"ISFILE", Function::file_exists},
    {"ISNUMBER", Function::is_number}, {"ISVAR", Function::is_variable}, {"LN", Function::ln},
    {"MATCH", Function::index}, {"MAXVAL", Function::max}, {"MINDEX", Function::mindex},
    {"MINVAL", Function::min}, {"MODAXVAL", Function::modulo_axis}, {"NUMBER", Function::number}, {"POT", Function::square},
    {"REP", Function::repeat_list}, {"RINDEX", Function::rindex}, {"ROUND", Function::round}, {"ROUNDUP", Function::round_up},
    {"SET", Function::set_list}, {"SIN", Function::sin}, {"SPRINT", Function::format_text}, {"SQRT", Function::sqrt}, {"STRLEN", Function::string_length},
    {"SUBSTR", Function::substring}, {"TAN", Function::tan}, {"TOLOWER", Function::to_lower}, {"TOUPPER", Function::to_upper},
    {"TRUNC", Function::trunc},
}};

constexpr std::array<Row<SystemVariable>, 46> variables{{
    {"$AA_IM", SystemVariable::machine_position}, {"$AA_IW", SystemVariable::work_position},
    {"$AA_S", SystemVariable::spindle_speed}, {"$AC_F", SystemVariable::feed}, {"$AC_MARKER", SystemVariable::marker},
    {"$AC_PARAM", SystemVariable::parameter}, {"$AC_SDIR", SystemVariable::spindle_direction},
    {"$AC_TIME", SystemVariable::timer}, {"$AC_TIMER", SystemVariable::timer}, {"$A_DAY", SystemVariable::clock},
    {"$A_HOUR", SystemVariable::clock}, {"$A_MINUTE", SystemVariable::clock}, {"$A_MONTH", SystemVariable::clock},
    {"$A_MSECOND", SystemVariable::clock}, {"$A_OUT", SystemVariable::digital_output},
    {"$A_OUTA", SystemVariable::analog_output}, {"$A_SECOND", SystemVariable::clock}, {"$A_YEAR", SystemVariable::clock},
    {"$PI", SystemVariable::pi},
    {"$P_ACTFRAME", SystemVariable::active_frame}, {"$P_AXN1", SystemVariable::channel_axis_name},
    {"$P_AXN2", SystemVariable::channel_axis_name}, {"$P_AXN3", SystemVariable::channel_axis_name},
    {"$P_BFRAME", SystemVariable::base_frame}, {"$P_DRYRUN", SystemVariable::is_dry_run},
    {"$P_EP", SystemVariable::programmed_position}, {"$P_F", SystemVariable::feed}, {"$P_GG", SystemVariable::active_g},
    {"$P_IFRAME", SystemVariable::settable_frame}, {"$P_ISTEST", SystemVariable::is_test},
    {"$P_PFRAME", SystemVariable::programmed_frame}, {"$P_PROG", SystemVariable::program_name},
    {"$P_S", SystemVariable::spindle_speed}, {"$P_SDIR", SystemVariable::spindle_direction},
    {"$P_SEARCH", SystemVariable::is_search}, {"$P_SIM", SystemVariable::is_simulation},
    {"$P_STACK", SystemVariable::stack_depth}, {"$P_SUBPAR", SystemVariable::argument_given},
    {"$P_TOOL", SystemVariable::tool_edge}, {"$P_TOOLEXIST", SystemVariable::tool_exists},
    {"$P_TOOLL", SystemVariable::tool_length}, {"$P_TOOLNO", SystemVariable::tool_number},
    {"$P_TOOLR", SystemVariable::tool_radius}, {"$P_UIFR", SystemVariable::datum_frame},
    {"$R", SystemVariable::numbered_parameter}, {"$TC_TP2", SystemVariable::tool_name},
}};

// clang-format on
static_assert(sorted(functions) && sorted(variables));

bool is_tool_parameter(std::string_view name) {
    constexpr std::string_view stem = "$TC_DP";
    if (!name.starts_with(stem) || name.size() == stem.size()) return false;
    return name.find_first_not_of("0123456789", stem.size()) == std::string_view::npos;
}

}  // namespace

std::optional<Function> find_function(std::string_view name) { return find(functions, name); }

std::optional<program::Reference> find_reference(std::string_view name) {
    using program::Reference;
    if (name == "IC") return Reference::incremental;
    if (name == "AC") return Reference::absolute;
    if (name == "DC") return Reference::shortest;
    if (name == "ACP") return Reference::positive;
    if (name == "ACN") return Reference::negative;
    if (name == "DAC") return Reference::diameter_absolute;
    if (name == "DIC") return Reference::diameter_incremental;
    if (name == "RAC") return Reference::radius_absolute;
    if (name == "RIC") return Reference::radius_incremental;
    return std::nullopt;
}

SystemVariable find_system_variable(std::string_view name) {
    if (const auto found = find(variables, name)) return *found;
    if (is_tool_parameter(name)) return SystemVariable::tool_parameter;
    if (name.starts_with("$MC_") || name.starts_with("$MN_") || name.starts_with("$MA_"))
        return SystemVariable::machine_data;
    return SystemVariable::unknown;
}

std::optional<program::Type> find_type(std::string_view name) {
    using program::Type;
    if (name == "REAL") return Type::real;
    if (name == "INT") return Type::integer;
    if (name == "BOOL") return Type::boolean;
    if (name == "CHAR") return Type::character;
    if (name == "STRING") return Type::string;
    if (name == "AXIS") return Type::axis;
    if (name == "FRAME") return Type::frame;
    return std::nullopt;
}

}  // namespace obrys::dialect::sinumerik
