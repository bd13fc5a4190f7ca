#include "check/limits/feed_mode.hpp"

#include <algorithm>

#include "base/codes.hpp"
#include "base/number.hpp"
#include "check/words.hpp"

namespace obrys::check {

namespace {

constexpr double most_a_turn = 10, most_a_turn_of_any = 50;           ///< mm a revolution
constexpr double most_turned = 5, least_drilled = 1, drilled = 0.25;  ///< the last as a part of the diameter
constexpr double least_per_minute = 1;                                ///< mm

Finding implausible(std::string text) {
    Finding f;
    f.code = base::codes::feed_implausible;
    f.severity = base::Severity::warning;
    f.text = std::move(text);
    f.remedy = "see whether the feed counts per minute or per revolution here, and where its decimal point stands";
    return f;
}

}  // namespace

double widest_feed(const shop::Tool* tool, shop::MachineKind machine) {
    if (tool == nullptr) return machine == shop::MachineKind::lathe ? most_a_turn : most_a_turn_of_any;
    if (tool->kind == shop::ToolKind::drill || tool->kind == shop::ToolKind::centre_drill)
        return std::max(least_drilled, drilled * 2 * tool->radius);
    if (tool->kind == shop::ToolKind::turning || tool->kind == shop::ToolKind::groove) return most_turned;
    return shop::is_milling(shop::assumed_kind(*tool)) ? std::max(most_a_turn, 2 * tool->radius) : most_a_turn;
}

std::optional<Finding> too_fast(double feed_per_rev, double widest) {
    if (!(feed_per_rev > widest)) return std::nullopt;
    Finding f = implausible("the feed is " + plain(feed_per_rev) + " mm a revolution: no tool cuts so fast");
    f.amounts = {{"feed_mm_per_rev", feed_per_rev}, {"limit_mm_per_rev", widest}};
    return f;
}

std::optional<Finding> too_fine(double feed_per_rev, const shop::Tool* tool) {
    constexpr double finest = 0.005, part_of_diameter = 0.01;
    if (tool == nullptr) return std::nullopt;
    const shop::ToolKind kind = shop::assumed_kind(*tool);
    const bool turns = kind == shop::ToolKind::turning || kind == shop::ToolKind::groove;
    if (!turns && !(shop::is_milling(kind) && tool->radius > 0)) return std::nullopt;
    const double least = turns ? finest : std::min(finest, part_of_diameter * 2 * tool->radius);
    if (!(feed_per_rev > 0 && feed_per_rev < least)) return std::nullopt;
    Finding f = implausible("the feed is " + base::shortest(feed_per_rev) + " mm a revolution: no tool cuts so finely");
    f.amounts = {{"feed_mm_per_rev", feed_per_rev}, {"limit_mm_per_rev", least}};
    return f;
}

std::optional<Finding> too_slow(double feed_per_minute, double feed_per_rev, double finest) {
    if (!(feed_per_minute > 0 && feed_per_minute < least_per_minute && feed_per_rev < finest)) return std::nullopt;
    Finding f = implausible("the feed of " + plain(feed_per_minute) + " mm counts per minute: no tool cuts so slowly");
    f.amounts = {{"feed_mm_per_min", feed_per_minute}, {"feed_mm_per_rev", feed_per_rev}};
    return f;
}

}  // namespace obrys::check
