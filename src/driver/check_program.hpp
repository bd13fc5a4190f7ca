#pragma once
/// The main job, from files to the verdict. Read this first: the stages stand in check_program.cpp in their order.

#include <functional>

#include "check/check.hpp"
#include "driver/milling_job.hpp"
#include "driver/session.hpp"

namespace obrys::driver {

struct Checked {
    check::Setup setup;
    check::Result result;
};

/// Runs the session's program and checks it. `keep_moves`: how many moves pictures and pages may show.
/// `progress` is told the number of moves from time to time; may be empty.
[[nodiscard]] Checked check_program(Session& session, std::size_t keep_moves, const MillingRequest& milling = {},
                                    const std::function<void(std::uint64_t)>& progress = {});

}  // namespace obrys::driver
