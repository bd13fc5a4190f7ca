/// Sources: Autodesk, "Drilling cycles reference" (Fusion help): what each cycle does; Autodesk's published posts for
/// HEIDENHAIN and FANUC controls: which word of the control each value goes to.

#include "dialect/fusion/cycles.hpp"

#include <algorithm>
#include <array>

namespace obrys::dialect::fusion {

namespace {

constexpr std::string_view made_elsewhere =
    "the file holds its sizes and not its path, which each postprocessor makes in its own way";

constexpr std::array cycles{
    CycleWord{"drilling", Hole::drill},
    CycleWord{"counter-boring", Hole::drill},
    CycleWord{"deep-drilling", Hole::peck},
    CycleWord{"chip-breaking", Hole::chip_break},
    CycleWord{"break-through-drilling", Hole::break_through},
    CycleWord{"gun-drilling", Hole::guided},
    CycleWord{"tapping", Hole::tap_rigid},
    CycleWord{"left-tapping", Hole::tap_rigid},
    CycleWord{"right-tapping", Hole::tap_rigid},
    CycleWord{"tapping-with-chip-breaking", Hole::tap_rigid},
    CycleWord{"left-tapping-with-chip-breaking", Hole::tap_rigid},
    CycleWord{"right-tapping-with-chip-breaking", Hole::tap_rigid},
    CycleWord{"reaming", Hole::bore_feed},
    CycleWord{"boring", Hole::bore_feed},
    CycleWord{"stop-boring", Hole::bore_stop},
    CycleWord{"fine-boring", Hole::bore_orient},
    CycleWord{"thread-turning", Hole::thread_turning},
    CycleWord{"back-boring", Hole::not_run,
              "how far below the part the tool goes in, and to which side, is each postprocessor's own"},
    CycleWord{"manual-boring", Hole::not_run, "the operator takes the tool out"},
    CycleWord{"bore-milling", Hole::not_run, made_elsewhere},
    CycleWord{"thread-milling", Hole::not_run, made_elsewhere},
    CycleWord{"circular-pocket-milling", Hole::not_run, made_elsewhere},
    CycleWord{"inspect", Hole::not_run, "it probes the surface, and what the program then does is not in the file"},
};

constexpr std::array<std::string_view, 24> values{
    "clearance",
    "retract",
    "stock",
    "depth",
    "feedrate",
    "retractFeedrate",
    "plungeFeedrate",
    "dwell",
    "incrementalDepth",
    "incrementalDepthReduction",
    "minimumIncrementalDepth",
    "accumulatedDepth",
    "chipBreakDistance",
    "shift",
    "shiftOrientation",
    "startingDepth",
    "dwellDepth",
    "stopSpindle",
    "breakThroughDistance",
    "breakThroughFeedrate",
    "breakThroughSpindleSpeed",
    "positioningFeedrate",
    "positioningSpindleSpeed",
    "kind",
};
constexpr std::array<std::string_view, 3> thread_values{"pitch", "incrementalX", "incrementalZ"};

constexpr CycleWord probing{"probing", Hole::not_run,
                            "it probes the part, and where the tool goes depends on what it touches"};

}  // namespace

const CycleWord* find_cycle(std::string_view name) {
    if (name.starts_with("probing-")) return &probing;
    const auto found = std::find_if(cycles.begin(), cycles.end(), [&](const CycleWord& c) { return c.name == name; });
    return found == cycles.end() ? nullptr : &*found;
}

bool is_known_value(std::string_view name) {
    return std::find(values.begin(), values.end(), name) != values.end() ||
           std::find(thread_values.begin(), thread_values.end(), name) != thread_values.end();
}

}  // namespace obrys::dialect::fusion
