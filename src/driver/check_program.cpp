#include "driver/check_program.hpp"

#include "base/work_time.hpp"
#include "driver/contours.hpp"
#include "driver/hints.hpp"
#include "driver/program_tools.hpp"
#include "driver/wording.hpp"

namespace obrys::driver {

Checked check_program(Session& session, std::size_t keep_moves, const MillingRequest& milling,
                      const std::function<void(std::uint64_t)>& progress) {
    // 1. What the program is held to: machine, tools, stock, part, allowance (shop; resolved when the session was
    // opened).
    const bool tools_given = !session.job.tools.empty();
    for (shop::Tool& own : program_tools(*session.main, session.job.tools, session.diagnostics))
        session.job.tools.push_back(std::move(own));
    check::Setup setup;
    setup.machine = session.job.machine;
    setup.tools = session.job.tools;
    setup.tools_given = tools_given;
    if (session.job.stock) setup.stock = session.job.stock->region;
    setup.part = session.part;
    setup.right_face = session.right_face;
    setup.turned_clamps = turned_clamps(session);
    setup.allowance = session.allowance;
    setup.tolerances = session.job.tolerances;
    setup.scope = session.job.scope;
    setup.keep_moves = keep_moves;
    if (setup.scope == shop::Scope::motion)
        setup.stock.reset();  // nothing is removed
    else
        setup.milling = milling_setup(session, milling);
    if (setup.milling) setup.milling->most_simulated = session.job.budgets.simulated_moves;
    if (setup.milling) setup.progress = progress;  // reading is fast, removing is what takes time
    const base::WorkTime time;
    if (session.job.budgets.bounds_check)
        setup.out_of_time = [time, seconds = session.job.budgets.seconds] { return time.by_clock() > seconds; };

    // 2. Program tree -> CL stream -> removal and findings, record by record (interp, check, sim/turning).
    check::Check check(setup, session.stacks);
    std::uint64_t moves = 0;
    const auto sink = [&](const cl::Record& record) {
        check.take(record);
        if (progress && !setup.progress && cl::is_move(record.step) && (++moves & 0x3F) == 0) progress(moves);
    };
    const interp::Outcome outcome = interpret(session, sink);

    // 3. Rest material and figures; what reader and interpreter complained about joins the findings (check).
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

}  // namespace obrys::driver
