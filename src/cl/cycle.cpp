#include "cl/cycle.hpp"

#include <algorithm>
#include <array>

namespace obrys::cl {

namespace {

// clang-format off
// In the order of the enumerators; a word too few leaves the last one empty, which cycle_test.cpp sees.
constexpr std::array<std::string_view, static_cast<std::size_t>(CycleKind::probe) + 1> kind_words{
    "peck", "drill", "ream", "bore", "universal-drill", "back-bore", "universal-peck", "bore-mill", "centre",
    "single-lip", "tap-floating-simple", "tap-floating", "tap-rigid-simple", "tap-rigid", "tap-chip-breaking",
    "thread-cut", "thread-mill", "thread-mill-countersink", "thread-mill-drill", "thread-mill-helix",
    "thread-mill-outside", "canned-drill", "canned-chip-break", "canned-peck", "canned-deep", "canned-tap-floating",
    "canned-tap-rigid", "canned-bore-feed", "canned-bore-stop", "canned-bore-orient", "canned-back-bore",
    "canned-bore-manual", "canned-circular-pocket", "lathe-finish-offset", "lathe-rough-along", "lathe-rough-across",
    "lathe-thread-degressive", "lathe-finish", "lathe-remove-along", "lathe-remove-across", "lathe-repeat-pattern",
    "lathe-peck-along", "lathe-peck-across", "lathe-thread-passes", "lathe-box-along", "lathe-box-thread",
    "lathe-box-across", "slot-simple", "rectangular-pocket-simple", "circular-pocket-simple", "slot-reciprocating",
    "round-slot-reciprocating", "rectangular-pocket-finish", "rectangular-stud-finish", "circular-pocket-finish",
    "circular-stud-finish", "rectangular-pocket", "circular-pocket", "slot", "round-slot", "rectangular-stud",
    "circular-stud", "pattern-circle", "pattern-lines", "contour-definition", "contour-data", "pilot-drill",
    "rough-out", "floor-finish", "side-finish", "contour-train", "contour-train-data", "pilot-drill-simple",
    "rough-out-simple", "contour-mill-simple", "cylinder-surface", "cylinder-slot", "cylinder-ridge",
    "cylinder-contour", "multipass", "ruled-surface", "face-mill", "point-data", "datum-shift", "mirror", "rotation",
    "scaling", "axis-scaling", "working-plane", "preset", "dwell", "program-call", "orientation", "tolerance",
    "global-values", "probe",
};

constexpr std::array<std::string_view, static_cast<std::size_t>(CycleRole::turned_axes) + 1> role_words{
    "surface", "clearance", "second-clearance", "clearance-height", "depth", "end-surface", "infeed", "min-infeed",
    "decrement", "chip-break-distance", "chip-break-depth", "breaks-before-retract", "stop-distance-first",
    "stop-distance-last", "deepened-start", "allowance-side", "allowance-floor", "allowance-left", "allowance-u",
    "finish-infeed", "hole-depth", "countersink-depth", "front-depth", "front-offset", "countersink-order",
    "dwell-depth", "counterbore-depth", "thickness", "off-centre", "edge-height", "depth-reference", "feed-plunge",
    "feed-mill", "feed-position", "feed-retract", "feed-countersink", "feed-finish", "feed-step", "feed-reciprocate",
    "feed-approach", "feed-factor", "feed-reference", "dwell-top", "dwell-bottom", "dwell", "spindle-direction",
    "spindle-speed-position", "spindle-speed", "rpm-factor", "coolant-on", "coolant-off", "pitch", "diameter", "radius",
    "first-radius", "predrilled-diameter", "blank-diameter", "centre-by-diameter", "infeed-per-turn",
    "threads-per-step", "length", "width", "blank-length", "blank-width", "corner-radius", "rounding-radius",
    "cylinder-radius", "slot-width", "side-clearance", "tolerance", "tolerance-angle", "tolerance-mode", "centre-u",
    "centre-v", "start-u", "start-v", "start-w", "second-u", "second-v", "second-w", "third-u", "third-v", "third-w",
    "fourth-u", "fourth-v", "fourth-w", "end-u", "end-v", "pitch-circle", "start-angle", "end-angle", "angle-step",
    "angle-length", "rotation", "spacing-u", "spacing-v", "columns", "rows", "count", "passes", "position",
    "approach-position", "direction", "retract-direction", "spindle-angle", "operation", "overlap", "plunge",
    "strategy", "move-at-clearance", "traverse", "approach", "compensation", "approach-radius", "approach-angle",
    "auxiliary-distance", "coarse-tool", "pilot-tool", "dimension-kind", "plunge-angle", "axis-x", "axis-y", "axis-z",
    "axis-a", "axis-b", "axis-c", "axis-u", "axis-v", "axis-w", "centre-x", "centre-y", "centre-z", "datum-number",
    "preset-number", "angle", "factor", "contour-label", "program-name", "setup-distance", "probe-input", "target-u",
    "target-v", "retract-plane", "bottom", "return-level", "rise-first", "shift-u", "shift-v", "counterbore-top",
    "feed-out", "length-unit", "retract-every", "starts-spindle", "manual-retract", "escape", "pockets", "offset-u",
    "offset-v", "allowance-first", "allowance-last", "allowance-v", "relief-u", "relief-v", "stepover", "relief",
    "crest-offset", "first-depth", "thread-depth", "degression", "infeed-angle", "spring-passes", "finish-passes",
    "finish-allowance", "taper-length", "taper-ends", "taper-u", "taper-v", "runout", "runout-leads", "infeed-method",
    "first-infeed", "second-infeed", "peck-to-surface", "chip-break-turns", "kept", "infeed-factor", "spindle-after", "stops-program",
    "shift-w", "turned-axes",
};

// clang-format on

template <class Enum, std::size_t N>
std::optional<Enum> find(const std::array<std::string_view, N>& words, std::string_view word) {
    const auto found = std::find(words.begin(), words.end(), word);
    if (found == words.end()) return std::nullopt;
    return static_cast<Enum>(found - words.begin());
}

}  // namespace

std::string_view spelling(CycleKind kind) { return kind_words[static_cast<std::size_t>(kind)]; }
std::string_view spelling(CycleRole role) { return role_words[static_cast<std::size_t>(role)]; }
std::optional<CycleKind> cycle_kind_spelt(std::string_view word) { return find<CycleKind>(kind_words, word); }
std::optional<CycleRole> cycle_role_spelt(std::string_view word) { return find<CycleRole>(role_words, word); }

}  // namespace obrys::cl
