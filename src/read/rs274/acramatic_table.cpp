/// Lines that write the control's table of cycle parameters.

#include <algorithm>

#include "read/rs274/acramatic_state.hpp"

namespace obrys::read::rs274 {

namespace {

constexpr std::string_view form = "write [$CYCLE_PARAMS(2)GAGE_HT_MM] = 5.0";

/// `CYCLE_PARAMS(2)`: true where the set is the metric one, whose names are known.
bool read_set(State& s) {
    if (!s.line.take("[")) return false;
    const std::uint32_t begin = s.line.here();
    if (!s.line.take("$CYCLE_PARAMS")) return fail_here(s, "a variable that is not known", std::string(form)), false;
    if (s.line.take("(2)")) return true;
    const std::size_t close = s.line.rest().find(')');
    s.line.step(close == std::string_view::npos ? 0 : close + 1);
    fail(s, begin, s.line.behind(), "of the sets of cycle parameters only (2), that in mm, is known",
         std::string(form));
    return false;
}

std::optional<AcramaticParameter> read_parameter_name(State& s) {
    const std::uint32_t begin = s.line.here();
    const std::size_t end = std::min(s.line.rest().find(']'), s.line.rest().size());
    const std::string name(s.line.rest().substr(0, end));
    s.line.step(end);
    for (const auto& known : dialect::rs274::acramatic_parameters())
        if (known.name == name) return known.parameter;
    const std::uint32_t behind = std::max(begin, s.line.behind());
    fail(s, begin, behind, "'" + base::as_utf8(name) + "' is not among the cycle parameters that are known",
         "GAGE_HT_MM, G82_DWELL, G82_FIN_DPTH, G82_FEED_FAC, G83_RET_DIST, G83_SHRT_RET, G83_RELIEF, G84_DWELL, "
         "G84_CHIP_BRK are");
    return std::nullopt;
}

}  // namespace

void read_table_line(AcramaticState& s) {
    if (!read_set(s)) return;
    const auto parameter = read_parameter_name(s);
    if (!parameter) return;
    if (!s.line.take(']')) return fail_here(s, "expected ] behind the name, found " + here(s), std::string(form));
    if (!s.line.take('=')) return fail_here(s, "expected = behind the parameter, found " + here(s), std::string(form));
    const std::uint32_t begin = s.line.here();
    Value v;
    v.negative = s.line.take('-');
    if (!v.negative) (void)s.line.take('+');
    v.literal = s.line.scan_number();
    if (v.literal.length == 0) return fail_here(s, "expected a number, found " + here(s), std::string(form));
    s.line.step(v.literal.length);
    v.found = true;
    if (v.negative && v.literal.value > 0)
        return fail(s, begin, s.line.behind(), "a cycle parameter cannot be negative");
    if (!s.line.at_end() && s.line.peek() != ';')
        return fail_here(s, "behind the value stands " + here(s), "write one parameter in a line");
    v.negative = false;
    TableValue& entry = s.entry(*parameter);
    entry.value = v;
    entry.fresh = true;
}

}  // namespace obrys::read::rs274
