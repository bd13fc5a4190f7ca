/// Programmable frames: TRANS, ROT, SCALE, MIRROR and their additive forms.
/// Offsets of a transverse axis are radii whatever the diameter mode (SINUMERIK, Function Manual P1 Transverse axes).

#include <optional>

#include "base/codes.hpp"
#include "interp/stream/stream.hpp"

namespace obrys::interp {

namespace codes = base::codes;

void update_frame(Telling& run) {
    flush_path(run);
    run.told.current = false;
    const std::optional<geom::Frame> shift = keeps_offsets(run) ? std::optional(offset_frame(run)) : datum_shift(run);
    if (!keeps_offsets(run)) run.datum_known = shift.has_value();
    run.frame = shift.value_or(geom::Frame{}) * run.modal.programmed;
    if (run.modal.datum_offset != geom::Vec3{})
        run.frame = shift.value_or(geom::Frame{}) * geom::Frame::shift(run.modal.datum_offset) * run.modal.programmed;
    run.frame_is_identity = run.frame == geom::Frame{};
    if (!geom::is_invertible(run.frame)) {
        alarm(run, codes::value_range, run.here(), "a scale factor of 0 leaves no coordinate system");
        return;
    }
    run.programmed_position =
        run.frame_is_identity ? run.position : geom::apply(geom::inverse(run.frame), run.position);
    if (run.statement != nullptr) hear(run, heard::Counting{run.frame, run.offsets.total});
}

namespace {

cl::FrameKind kind_of(TransformKind kind) {
    switch (kind) {
        case TransformKind::mirror: return cl::FrameKind::mirror;
        case TransformKind::rotation: return cl::FrameKind::rotation;
        case TransformKind::scaling:
        case TransformKind::axis_scaling: return cl::FrameKind::scaling;
        case TransformKind::plane: return cl::FrameKind::plane;
        case TransformKind::shift:
        case TransformKind::call_place: break;
    }
    return cl::FrameKind::shift;
}

}  // namespace

std::vector<cl::FramePart> frame_parts(const Telling& run) {
    std::vector<cl::FramePart> parts;
    const auto add = [&](cl::FrameKind kind, const geom::Frame& frame) {
        if (!(frame == geom::Frame{})) parts.push_back({kind, frame});
    };
    geom::Frame datum = keeps_offsets(run) ? datum_frame(run) : datum_shift(run).value_or(geom::Frame{});
    datum.origin = datum.origin - cl::way(run.told.first, run.told.datum);
    add(cl::FrameKind::datum, datum);
    const Axes& shift = run.offsets.shift;
    if (keeps_offsets(run)) add(cl::FrameKind::shift, geom::Frame::shift({shift[0], shift[1], shift[2]}));
    add(cl::FrameKind::shift, geom::Frame::shift(run.modal.datum_offset));
    for (const Transform& t : run.modal.transforms) {
        const std::size_t before = parts.size();
        add(kind_of(t.kind), t.frame);
        if (parts.size() > before) parts.back().turn = t.turn;
    }
    geom::Frame all;
    for (const Transform& t : run.modal.transforms) all = all * t.frame;
    if (!(all == run.modal.programmed)) add(cl::FrameKind::programmed, geom::inverse(all) * run.modal.programmed);
    return parts;
}

}  // namespace obrys::interp
