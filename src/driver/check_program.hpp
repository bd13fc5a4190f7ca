#pragma once
/// The main job, from files to the verdict. Read this first: the stages stand in check_program.cpp in their order.

#include <functional>

#include "check/stream/check.hpp"
#include "driver/milling_job.hpp"
#include "driver/session.hpp"

namespace obrys::driver {

struct Checked {
    check::Setup setup;
    check::Result result;
};

/// What the session's program is held to: machine, tools, stock, part and clamps, with every file read. What is asked
/// of the check besides (Setup::keep_moves, progress, out_of_time) is left open.
[[nodiscard]] check::Setup setup_of(Session& session, const MillingRequest& milling = {});

/// Runs the session's program and holds it to `setup`, which `setup_of` made of this session or of the one it shares
/// with.
[[nodiscard]] Checked check_against(Session& session, check::Setup setup);

/// Both: runs the session's program and checks it. `keep_moves`: how many moves pictures and pages may show.
/// `progress` is told the number of moves from time to time; may be empty.
[[nodiscard]] Checked check_program(Session& session, std::size_t keep_moves, const MillingRequest& milling = {},
                                    const std::function<void(std::uint64_t)>& progress = {});

}  // namespace obrys::driver
