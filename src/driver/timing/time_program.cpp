#include "driver/timing/time_program.hpp"

#include "driver/program_tools.hpp"
#include "program/traits.hpp"

namespace obrys::driver {
namespace {

shop::RapidPath path_of(program::RapidWay way) {
    switch (way) {
        case program::RapidWay::straight: return shop::RapidPath::straight;
        case program::RapidWay::each_axis: return shop::RapidPath::dog_leg;
        case program::RapidWay::by_setting: break;
    }
    return shop::RapidPath::either;
}

}  // namespace

sim::time::Dynamics dynamics_of(const Session& session) {
    return sim::time::dynamics_of(session.job.machine, path_of(session.main->traits->rapids.way));
}

std::vector<Timed> time_program(Session& session, std::span<const Timing> timings) {
    for (shop::Tool& tool : program_tools(*session.main, session.job.tools, session.diagnostics))
        session.job.tools.push_back(std::move(tool));
    std::vector<sim::time::Timer> timers;
    timers.reserve(timings.size());
    for (const Timing& t : timings) timers.emplace_back(session.job.tools, t.dynamics, t.options);
    static_cast<void>(interpret(session, [&](const cl::Record& record) {
        for (sim::time::Timer& t : timers) t.take(record);
    }));
    std::vector<Timed> timed;
    for (sim::time::Timer& t : timers) {
        sim::time::Times times = t.finish();
        timed.push_back({std::move(times), t.curve(), t.tolerances()});
    }
    return timed;
}

std::string not_whole(int code) {
    if (code == 1) return "the control would stop with an alarm";
    if (code == 3) return "something was not understood or not run";
    return {};
}

}  // namespace obrys::driver
