/// The modal cycle at places in a row or on a circle: HOLES1, HOLES2. Source: docs/dialects/sinumerik.md, "Cycles of
/// one hole".

#include <array>
#include <cmath>

#include "base/codes.hpp"
#include "base/whole.hpp"
#include "interp/calls/calls.hpp"
#include "interp/moves/cycle_steps.hpp"

namespace obrys::interp {

namespace codes = base::codes;

namespace {

constexpr std::uint64_t most_holes = 100'000;
constexpr std::size_t most_arguments = 6;
using Numbers = std::array<double, most_arguments>;

/// 0 where one is left out; nothing where one is no number that is known.
std::optional<Numbers> numbers_of(Calling& run, const program::Call& call) {
    Numbers out{};
    for (std::size_t i = 0; i < call.arguments.size(); ++i) {
        const auto v = plain(run, call, i);
        if (!v || (i >= out.size() && *v != 0)) return std::nullopt;
        if (i < out.size()) out[i] = *v;
    }
    return out;
}

geom::Vec2 direction(double degrees) {
    const double a = geom::radians(degrees);
    return {std::cos(a), std::sin(a)};
}

/// HOLES1(SPCA, SPCO, STA1, FDIS, DBH, NUM): from the end of the row that the tool is nearer to.
std::vector<geom::Vec2> row(const Numbers& n, double unit, std::uint64_t count, geom::Vec2 tool) {
    const geom::Vec2 origin = unit * geom::Vec2{n[0], n[1]}, along = direction(n[2]);
    const auto at = [&](std::uint64_t i) { return origin + (n[3] + static_cast<double>(i) * n[4]) * unit * along; };
    const bool from_end = geom::distance(tool, at(count - 1)) < geom::distance(tool, at(0));
    std::vector<geom::Vec2> out;
    for (std::uint64_t i = 0; i < count; ++i) out.push_back(at(from_end ? count - 1 - i : i));
    return out;
}

/// HOLES2(CPA, CPO, RAD, STA1, INDA, NUM): counter-clockwise; INDA 0 divides the whole circle.
std::vector<geom::Vec2> circle(const Numbers& n, double unit, std::uint64_t count) {
    const geom::Vec2 centre = unit * geom::Vec2{n[0], n[1]};
    const double step = n[4] != 0 ? n[4] : 360.0 / static_cast<double>(count);
    std::vector<geom::Vec2> out;
    for (std::uint64_t i = 0; i < count; ++i)
        out.push_back(centre + n[2] * unit * direction(n[3] + static_cast<double>(i) * step));
    return out;
}

}  // namespace

void call_hole_pattern(Calling& run, const program::Call& call) {
    const HoleCall& hole = run.modal_call.hole;
    if (run.modal_call.unit != nullptr) return say_not_run(run, call, "a program is called at its places");
    if (hole.cycle == nullptr)
        return alarm(run, codes::value_range, call.where, "no drilling cycle is modal" + of_alarm("62100"),
                     "make the cycle modal before the pattern");
    if (run.modal.diameter != DiameterMode::off && run.modal.plane == 18)
        return say_not_run(run, call, "its places lie in a plane with diameters");
    const auto numbers = numbers_of(run, call);
    if (run.stopped) return;
    if (!numbers) return say_not_run(run, call, "one of its values is not known");
    const auto count = base::whole<std::uint64_t>((*numbers)[5], 1, most_holes);
    if (!count) {
        alarm(run, codes::value_range, call.where,
              "the number of holes (NUM) must be a whole number above 0" + of_alarm("61103"),
              "write how many holes the pattern has");
        return;
    }
    const PlaneAxes a = plane_axes(run.modal.plane);
    const geom::Vec3 tool = into_plane(run.programmed_position, a);
    const double unit = length_unit(run.modal);
    const std::vector<geom::Vec2> places = call.control_cycle == program::ControlCycle::hole_row
                                               ? row(*numbers, unit, *count, {tool.x, tool.y})
                                               : circle(*numbers, unit, *count);
    flush_path(run);
    std::uint64_t pass = 0;
    for (const geom::Vec2& p : places) {
        if (run.stopped || over_budget(run, false)) return;
        begin_motion(run);
        emit_step(run, cl::Linear{{p.x, p.y, into_plane(run.programmed_position, a).z}, {0, 0, 1}, true});
        call_hole(run, hole, {cl::CycleCall::pattern, ++pass, *count});
    }
}

}  // namespace obrys::interp
