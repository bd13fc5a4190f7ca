// Radius compensation by the offset of another tool.
#include <algorithm>
#include <cmath>

#include "base/codes.hpp"
#include "check/limits/limits.hpp"
#include "check/words.hpp"

namespace obrys::check {

/// The offset's number is that of another tool, and its radius is the other tool's: no allowance of this one.
void Limits::check_compensation(const Move& move) {
    constexpr double same_radius = 1e-6;  // mm
    if (!state_.compensation) return void(judged_compensation_.reset());
    if (judged_compensation_ == state_.compensation) return;
    judged_compensation_ = state_.compensation;
    const cl::CompensationBegin& c = *state_.compensation;
    const shop::Tool* tool = state_.tool;
    if (c.given || c.offset == 0 || std::abs(c.radius) < same_radius || tool == nullptr ||
        !shop::is_milling(tool->kind) || tool->number == c.offset || !(tool->radius > 0))
        return;
    const double radius = std::abs(c.radius);
    const auto is_other = [&](const shop::Tool& t) {
        return t.number == c.offset && std::abs(t.radius - radius) < same_radius;
    };
    const auto is_own = [&](const shop::Tool& t) {
        return t.number == tool->number && std::abs(t.radius - radius) < same_radius;
    };
    if (std::none_of(tools_.begin(), tools_.end(), is_other) || std::any_of(tools_.begin(), tools_.end(), is_own))
        return;
    Finding f;
    f.code = base::codes::tool_radius;
    f.text = "T" + std::to_string(tool->number) + " moves with the radius compensation of D" +
             std::to_string(c.offset) + ": the contour is offset by " + mm(radius) + ", and the tool's radius is " +
             mm(tool->radius);
    f.remedy = "program the D of T" + std::to_string(tool->number) + " with the compensation";
    f.amounts = {{"radius_mm", radius}, {"tool_radius_mm", tool->radius}};
    out_.finding(move, std::move(f));
}

}  // namespace obrys::check
