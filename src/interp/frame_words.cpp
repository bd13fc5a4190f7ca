/// Programmable frames: TRANS, ROT, SCALE, MIRROR and their additive forms.
/// Offsets of a transverse axis are radii whatever the diameter mode (SINUMERIK, Function Manual P1 Transverse axes).

#include <cmath>
#include <optional>

#include "base/codes.hpp"
#include "interp/motion.hpp"
#include "interp/run.hpp"

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

/// Where a datum lies in the machine, with its basic rotation about Z.
struct DatumPlace {
    geom::Vec3 origin;
    double rotation = 0;
};
std::optional<DatumPlace> datum_place(const Reckoning& run, std::uint32_t n) {
    const shop::Machine& machine = run.env.machine;
    if (const auto found = machine.datums.find(n); found != machine.datums.end()) {
        const auto turned = machine.datum_rotations.find(n);
        geom::Vec3 origin = found->second;
        for (int k = 0; k < 3 && n == run.modal.datum; ++k)
            if (std::isnan(coordinate(origin, k))) coordinate(origin, k) = coordinate(run.modal.datum_before, k);
        return DatumPlace{origin, turned == machine.datum_rotations.end() ? 0 : turned->second};
    }
    if (n == program::no_datum && run.traits->datum.none_is_machine_zero) return DatumPlace{};
    return std::nullopt;
}

/// Way between the active datum and the one the stream's coordinates are in; nothing where it is not known.
std::optional<geom::Frame> datum_shift(const Reckoning& run) {
    if (run.modal.datum == run.reference_datum) return geom::Frame{};
    const auto active = datum_place(run, run.modal.datum), reference = datum_place(run, run.reference_datum);
    if (!active || !reference || !geom::is_finite(active->origin - reference->origin)) return std::nullopt;
    if (active->rotation == 0 && reference->rotation == 0)
        return geom::Frame::shift(active->origin - reference->origin);
    const auto frame = [](const DatumPlace& p) {
        return geom::Frame::shift(p.origin) * geom::Frame::rotation(2, p.rotation);
    };
    return geom::inverse(frame(*reference)) * frame(*active);
}

bool has_unknown(const BlockWords& b) {
    bool unknown = b.has(Code::plane_rotation) && std::isnan(b.peek(Code::plane_rotation));
    for (int k = 0; k < 3; ++k) unknown = unknown || (b.has(axis_code(k)) && std::isnan(b.peek(axis_code(k))));
    return unknown;
}

}  // namespace

geom::Vec3 datum_origin(const Reckoning& run) {
    const auto place = datum_place(run, run.modal.datum);
    return place ? place->origin : geom::Vec3{NAN, NAN, NAN};
}

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
    tell_frame(run);
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
    for (const Transform& t : run.modal.transforms) add(kind_of(t.kind), t.frame);
    if (run.modal.transforms.empty()) add(cl::FrameKind::programmed, run.modal.programmed);
    return parts;
}

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
        run.modal.programmed = {};  // TRANS alone deletes every programmed frame, ATRANS alone too
    else if (call.additive)
        run.modal.programmed = run.modal.programmed * part_of(run, call.op);
    else
        run.modal.programmed = part_of(run, call.op);
    report_unused(run);
    update_frame(run);
}

}  // namespace obrys::interp
