/// TRANS, ROT, SCALE, MIRROR and their additive forms.

#include <cmath>

#include "base/codes.hpp"
#include "interp/calls/calls.hpp"

namespace obrys::interp {

namespace codes = base::codes;
using program::FrameOp;

namespace {

/// Rotations of one block act in the order Z, Y', X'' (RPY, MD10600 as delivered).
geom::Frame rotation(Moving& run) {
    const BlockWords& b = run.block;
    if (b.has(Code::plane_rotation))
        return geom::Frame::rotation(plane_axes(run.modal.plane).w, geom::radians(b.get(Code::plane_rotation)));
    geom::Frame f;
    for (int k = 2; k >= 0; --k)
        if (b.has(axis_code(k))) f = f * geom::Frame::rotation(k, geom::radians(b.get(axis_code(k))));
    return f;
}

geom::Frame part_of(Moving& run, FrameOp op) {
    const BlockWords& b = run.block;
    if (op == FrameOp::rotate) return rotation(run);
    const double unit = length_unit(run.modal);
    geom::Vec3 shift, factors{1, 1, 1};
    for (int k = 0; k < 3; ++k) {
        if (!b.has(axis_code(k))) continue;
        const double v = b.get(axis_code(k));
        if (op == FrameOp::shift) coordinate(shift, k) = v * unit;
        if (op == FrameOp::scale) coordinate(factors, k) = v;
        if (op == FrameOp::mirror) coordinate(factors, k) = -1;
    }
    return op == FrameOp::shift ? geom::Frame::shift(shift) : geom::Frame::scaling(factors);
}

bool has_unknown(const BlockWords& b) {
    bool unknown = b.has(Code::plane_rotation) && std::isnan(b.peek(Code::plane_rotation));
    for (int k = 0; k < 3; ++k) unknown = unknown || (b.has(axis_code(k)) && std::isnan(b.peek(axis_code(k))));
    return unknown;
}

}  // namespace

void frame_statement(Calling& run, const program::Statement& s, std::uint32_t index) {
    const Unit& unit = run.unit();
    const program::FrameCall call = unit.frames[static_cast<std::size_t>(unit.words[s.first].payload)];
    run.block.clear();
    run.complained = false;
    if (call.beside_words)
        return alarm(run, codes::repeated_word, run.here(),
                     "TRANS, ROT, SCALE, MIRROR and their additive forms stand in a block of their own: other words "
                     "stand before this one",
                     "write two blocks");
    const std::uint32_t end = unit.words_end(index);
    for (std::uint32_t i = s.first + 1; i < end && !run.stopped; ++i) gather(run, s, unit.words[i]);
    if (run.block.twice != 0) repeated_words(run);
    if (run.stopped) return;
    if (!run.block.m.empty() || !run.block.h.empty())
        unchecked(run, codes::unknown_word, run.here(), "M and H functions beside a frame are not run",
                  "write them in a block of their own");
    for (int k = 3; k < 9; ++k)
        if (run.block.has(axis_code(k)))
            unchecked(run, codes::unsupported, run.here(),
                      "the frame of axis " + axis_name(static_cast<std::size_t>(k)) + " is not followed");
    const bool empty = run.block.present == 0;
    if (call.op != FrameOp::shift && has_unknown(run.block)) {
        unchecked(run, codes::unknown_value, run.here(),
                  "this frame depends on a value that is not known: it is left out");
        return;
    }
    if (empty)
        run.modal.programmed = active_plane(run);  // TRANS alone deletes every programmed frame, ATRANS alone too
    else if (call.additive)
        run.modal.programmed = run.modal.programmed * part_of(run, call.op);
    else
        run.modal.programmed = active_plane(run) * part_of(run, call.op);
    report_unused(run);
    update_frame(run);
}

}  // namespace obrys::interp
