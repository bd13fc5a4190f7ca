#include "driver/check_program.hpp"

#include "base/work_time.hpp"
#include "driver/contours.hpp"
#include "driver/hints.hpp"
#include "driver/program_tools.hpp"
#include "driver/wording.hpp"

namespace obrys::driver {

namespace {

check::RapidRule rule_of(const program::Rapids& rapids) {
    switch (rapids.way) {
        case program::RapidWay::straight: return {};
        case program::RapidWay::each_axis: return {shop::RapidPath::dog_leg, std::string(rapids.setting)};
        case program::RapidWay::by_setting: break;
    }
    return {shop::RapidPath::either, std::string(rapids.setting)};
}

}  // namespace

check::Setup setup_of(Session& session, const MillingRequest& milling) {
    check::Setup setup;
    setup.tools_given = !session.job.tools.empty();
    for (shop::Tool& own : program_tools(*session.main, session.job.tools, session.diagnostics))
        session.job.tools.push_back(std::move(own));
    setup.machine = session.job.machine;
    setup.rapids = rule_of(session.main->traits->rapids);
    setup.tools = session.job.tools;
    if (session.job.stock) setup.stock = session.job.stock->region;
    setup.part = session.part;
    setup.right_face = session.right_face;
    setup.turned_clamps = turned_clamps(session);
    setup.allowance = session.allowance;
    setup.tolerances = session.job.tolerances;
    setup.scope = session.job.scope;
    if (setup.scope == shop::Scope::motion)
        setup.stock.reset();  // nothing is removed
    else
        setup.milling = milling_setup(session, milling);
    if (setup.milling) setup.milling->most_simulated = session.job.budgets.simulated_moves;
    return setup;
}

Checked check_against(Session& session, check::Setup setup) {
    // Program tree -> CL stream -> removal and findings, record by record (interp, check, sim/turning).
    const base::WorkTime time;
    if (session.job.budgets.bounds_check)
        setup.out_of_time = [time, seconds = session.job.budgets.seconds] { return time.by_clock() > seconds; };
    std::function<void(std::uint64_t)> running;  // reading is fast: where something is removed, that takes the time
    if (!setup.milling) running.swap(setup.progress);
    check::Check check(setup, session.stacks);
    std::uint64_t moves = 0;
    const auto sink = [&](const cl::Record& record) {
        check.take(record);
        if (running && cl::is_move(record.step) && (++moves & 0x3F) == 0) running(moves);
    };
    const interp::Outcome outcome = interpret(session, sink);

    // Rest material and figures; what reader and interpreter complained about joins the findings (check).
    check::Result result = check.finish(outcome.ending == interp::Ending::regular);
    result.stats.blocks_executed = outcome.blocks_executed;
    check::merge(result, session.diagnostics);
    if (outcome.ending == interp::Ending::regular) check::require_cuts(result, session.program);
    ask_for_points(session.programs->units(), session.sources, result);
    name_carried_compensation(outcome, result);
    check::restrict_to(result, setup.scope);
    reword(result, session.control, session.main->traits->edge_is_offset_number);
    return {std::move(setup), std::move(result)};
}

Checked check_program(Session& session, std::size_t keep_moves, const MillingRequest& milling,
                      const std::function<void(std::uint64_t)>& progress) {
    check::Setup setup = setup_of(session, milling);
    setup.keep_moves = keep_moves;
    setup.progress = progress;
    return check_against(session, std::move(setup));
}

}  // namespace obrys::driver
