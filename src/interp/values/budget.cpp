/// How long a run may go on.

#include "base/codes.hpp"
#include "base/number.hpp"
#include "interp/interp.hpp"
#include "interp/values/values.hpp"

namespace obrys::interp {

namespace codes = base::codes;

bool over_budget(Reckoning& run, bool check_clock) {
    const shop::Budgets& b = run.env.budgets;
    const auto seconds = [&] { return b.bounds_check ? run.time.by_clock() : run.time.by_processor(); };
    run.out_of_time = run.out_of_time || (check_clock && seconds() > b.seconds);
    if (run.blocks <= b.blocks && !run.out_of_time) return false;
    const std::string limit = run.blocks > b.blocks
                                  ? std::to_string(b.blocks) + " blocks"
                                  : base::shortest(b.seconds) + (b.bounds_check ? " s" : " s of work");
    const std::string loop = loop_being_run(run);
    unchecked(run, codes::budget, run.here(),
              "the run was ended here after " + limit + (loop.empty() ? "" : "; " + loop),
              std::string(loop.empty() ? "" : "see whether that loop ends; ") +
                  "raise the limit in [budget] of the job if the program really needs more");
    run.ending = Ending::budget;
    run.stopped = true;
    return true;
}

}  // namespace obrys::interp
