/// What the program writes about a tool, held to what the job gives.

#include <algorithm>
#include <cmath>

#include "base/codes.hpp"
#include "base/number.hpp"
#include "interp/setup/setup.hpp"

namespace obrys::interp {

namespace codes = base::codes;

namespace {

/// Allowances are cut by a radius that the program writes: the job's is the tool's. Wear is none of it.
void compare_radius(Saying& run, const shop::Tool& t, const shop::Tool& job) {
    constexpr double same = 1e-6;  // mm
    const auto nominal = [](const shop::Tool& x) {
        constexpr int wear = 15;  // $TC_DP15
        const auto p = x.parameters.find(wear);
        return x.radius - (p == x.parameters.end() ? 0 : p->second);
    };
    const double radius = nominal(t), given = nominal(job);
    if (run.env.stand_alone || given == 0 || !(std::abs(radius - given) >= same)) return;
    assume(run, run.here(),
           "the program sets the radius of tool " + std::to_string(t.number) + " to " + base::fixed(radius, 3) +
               " mm, and the tool list gives " + base::fixed(given, 3) +
               " mm: the path is compensated by the program's, and the tool is taken to have the tool list's",
           "give the tool the radius that it has, or write the difference as wear");
}

}  // namespace

/// The job's length is what the tool has, and the program's is what the control compensates.
void compare_with_job(Saying& run, const shop::Tool& t) {
    constexpr double same = 1e-6;  // mm
    const auto job = std::find_if(run.env.tools.begin(), run.env.tools.end(),
                                  [&](const shop::Tool& x) { return x.number == t.number && x.edge == t.edge; });
    if (job != run.env.tools.end() && run.env.machine.kind == shop::MachineKind::mill) compare_radius(run, t, *job);
    const double length = t.length + t.delta_length;
    if (run.env.stand_alone || job == run.env.tools.end() || job->length == 0 ||
        std::abs(length - job->length - job->delta_length) < same)
        return;
    const std::string parts =
        t.delta_length == job->delta_length
            ? ""
            : " (" + base::fixed(t.length, 3) + " mm and wear of " + base::fixed(t.delta_length, 3) + " mm)";
    unchecked(run, codes::unknown_value, run.here(),
              "the program sets the length of tool " + std::to_string(t.number) + " to " + base::fixed(length, 3) +
                  " mm" + parts + ", and the tool list gives " + base::fixed(job->length + job->delta_length, 3) +
                  " mm: which of them the tool has is not known, the program's is taken",
              "give the tool the length that it has, or take that out of the program");
}

}  // namespace obrys::interp
