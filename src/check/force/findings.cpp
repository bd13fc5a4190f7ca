#include "check/force/findings.hpp"

#include <algorithm>
#include <map>
#include <tuple>

#include "base/codes.hpp"
#include "base/number.hpp"

namespace obrys::check::force {

namespace codes = base::codes;

namespace {

/// Gathers what a line has of a code.
class Lines {
public:
    explicit Lines(const Milled& milled) : milled_(milled) {}

    /// `excess`: how bad it is, the larger the worse.
    void add(std::string_view code, const MoveForce& f, double value, double limit, const std::string& text) {
        const base::Span& at = milled_.moves[f.move].where;
        const double excess = std::max(value / limit, limit / value);
        const auto [found, is_new] = places_.try_emplace({code, at.file, at.begin}, Worst{all_.size(), excess});
        if (is_new) {
            all_.push_back({code, text, value, limit, f.move, 1});
            return;
        }
        ForceFinding& known = all_[found->second.index];
        ++known.moves;
        if (excess <= found->second.excess) return;
        found->second.excess = excess;
        known = {code, text, value, limit, f.move, known.moves};
    }
    [[nodiscard]] std::vector<ForceFinding> all() && { return std::move(all_); }

private:
    struct Worst {
        std::size_t index = 0;
        double excess = 0;
    };
    const Milled& milled_;
    std::map<std::tuple<std::string_view, std::uint32_t, std::uint32_t>, Worst> places_;
    std::vector<ForceFinding> all_;
};

std::string number(double v, int decimals) { return base::fixed(v, decimals); }

void hold_to_machine(Lines& lines, const MoveForce& f, const shop::MachineSpindle& spindle,
                     const std::optional<double>& torque) {
    constexpr double watts = 1000;
    if (spindle.power && f.power > watts * *spindle.power)
        lines.add(codes::spindle_power, f, f.power, watts * *spindle.power,
                  "takes " + number(f.power / watts, 2) + " kW, and the spindle has " + base::shortest(*spindle.power) +
                      " kW");
    if (torque && f.torque > *torque)
        lines.add(codes::spindle_torque, f, f.torque, *torque,
                  "takes " + number(f.torque, 1) + " Nm, and the spindle has " + base::shortest(*torque) + " Nm");
}

void hold_to_tool(Lines& lines, const MoveForce& f, const shop::ToolUseData& t) {
    constexpr double rounding = 0.01;  // of data in a list
    const std::string name = "tool " + std::to_string(t.number);
    if (t.feed_per_tooth && f.programmed_per_tooth < (*t.feed_per_tooth)[0] * (1 - rounding))
        lines.add(codes::chip_too_thin, f, f.programmed_per_tooth, (*t.feed_per_tooth)[0],
                  number(f.programmed_per_tooth, 4) + " mm a tooth, and " + name + " is to cut " +
                      base::shortest((*t.feed_per_tooth)[0]) + " mm at least: it rubs");
    if (t.feed_per_tooth && f.programmed_per_tooth > (*t.feed_per_tooth)[1] * (1 + rounding))
        lines.add(codes::chip_too_thick, f, f.programmed_per_tooth, (*t.feed_per_tooth)[1],
                  number(f.programmed_per_tooth, 4) + " mm a tooth, and " + name + " is to cut " +
                      base::shortest((*t.feed_per_tooth)[1]) + " mm at most");
    if (!t.cutting_speed) return;
    const auto [least, most] = *t.cutting_speed;
    // What touches with a small part of its edge is slower than it could be, which is no mistake of the speed.
    if (f.cutting_speed > most * (1 + rounding))
        lines.add(codes::feed_differs, f, f.cutting_speed, most,
                  "cuts at " + number(f.cutting_speed, 0) + " m/min, and " + name + " is for " + base::shortest(least) +
                      " to " + base::shortest(most) + " m/min");
}

/// A speed that is too low at the tool's whole radius.
void hold_to_least_speed(Lines& lines, const MoveForce& f, const shop::ToolUseData& t, double radius, double rpm) {
    if (!t.cutting_speed || !(rpm > 0)) return;
    constexpr double rounding = 0.01, metres = 1e-3;
    const double fastest = metres * 2 * geom::pi * radius * rpm, least = (*t.cutting_speed)[0];
    if (fastest < least * (1 - rounding))
        lines.add(codes::feed_differs, f, fastest, least,
                  number(fastest, 0) + " m/min at its whole diameter, and tool " + std::to_string(t.number) +
                      " is for " + base::shortest(least) + " to " + base::shortest((*t.cutting_speed)[1]) + " m/min");
}

}  // namespace

std::vector<ForceFinding> findings_of(const ForceResult& forces, const Result& result, const Setup& setup,
                                      const shop::CuttingJob& job) {
    Lines lines(*result.milled);
    for (const MoveForce& f : forces.moves) {
        if (f.gap != Gap::none) continue;
        const MilledMove& m = result.milled->moves[f.move];
        hold_to_machine(lines, f, setup.machine.spindle, job.spindle_torque);
        const ToolUse& tool = result.tools[m.tool - 1];
        const shop::ToolUseData* use = find_use(job, tool.number);
        if (use == nullptr || !tool.listed) continue;
        hold_to_tool(lines, f, *use);
        hold_to_least_speed(lines, f, *use, setup.tools[*tool.listed].radius, m.speed_rpm);
    }
    return std::move(lines).all();
}

}  // namespace obrys::check::force
