#pragma once
/// Acramatic 2100 (Cincinnati, Vickers, Siemens), mills: what is known of its words. Sources:
/// docs/dialects/acramatic.md.

#include <optional>
#include <span>
#include <string_view>

#include "dialect/rs274/tables.hpp"

namespace obrys::dialect::rs274 {

extern const program::Traits acramatic_traits;
extern const Dialect acramatic;

/// Hole cycles by what their J makes of them: places in Traits::canned.
enum class AcramaticCycle : std::uint8_t { drill, counterbore, chip_break, short_peck, peck, tap_floating, tap_rigid };
/// Which cycle a block with this G number * 10 and J calls; nothing for a J that is none of its ways. `j`: 0 where the
/// block has none.
[[nodiscard]] std::optional<AcramaticCycle> acramatic_cycle(int tenths, int j);

/// Values of the control's table of cycle parameters, `[$CYCLE_PARAMS(2)NAME]`, which programs write.
enum class AcramaticParameter : std::uint8_t {
    gage_height,
    dwell_82,
    finish_depth_82,
    feed_factor_82,
    retract_83,
    short_retract_83,
    relief_83,
    dwell_84,
    chip_break_84,
    count
};
struct AcramaticParameterName {
    AcramaticParameter parameter;
    std::string_view name;     ///< upper case
    std::string_view missing;  ///< what is not run without it; empty: the path does not need it
};
[[nodiscard]] std::span<const AcramaticParameterName> acramatic_parameters();

}  // namespace obrys::dialect::rs274
