/// Transformations set, changed and ended; the tilted plane.

#include <algorithm>

#include "base/codes.hpp"
#include "interp/setup/setup.hpp"
#include "interp/setup/tilted_axes.hpp"

namespace obrys::interp {

namespace codes = base::codes;

namespace {

/// Transformations act in the order in which they were programmed: what stands behind a tilted plane moves within it,
/// what stood before it stays as it is. Source: iTNC 530 User's Manual Cycle Programming, "Combining coordinate
/// transformation cycles" of cycle 19; TNC 620 User's Manual, "Workpiece coordinate system".
std::vector<Transform>::iterator find_transform(Reckoning& run, TransformKind kind) {
    auto& all = run.modal.transforms;
    auto from = all.begin();
    if (kind != TransformKind::plane)
        for (auto t = all.begin(); t != all.end(); ++t)
            if (t->kind == TransformKind::plane) from = t;
    return std::find_if(from, all.end(), [&](const auto& t) { return t.kind == kind; });
}

void update_programmed(Telling& run) {
    const geom::Vec3 normal = geom::apply_direction(active_plane(run), {0, 0, 1});
    run.tool_axis = (1 / geom::length(normal)) * normal;
    run.modal.programmed = {};
    for (const Transform& t : run.modal.transforms) run.modal.programmed = run.modal.programmed * t.frame;
    update_frame(run);
}

}  // namespace

void place_transform(Telling& run, TransformKind kind, const geom::Frame& frame) {
    auto& all = run.modal.transforms;
    const auto at = find_transform(run, kind);
    if (frame == geom::Frame{}) {
        if (at != all.end()) all.erase(at);
    } else if (at != all.end()) {
        at->frame = frame;
    } else {
        all.push_back({kind, frame});
    }
    update_programmed(run);
}

namespace {

std::int8_t sign_of(double v) { return v > 0 ? std::int8_t{1} : v < 0 ? std::int8_t{-1} : std::int8_t{0}; }

}  // namespace

void tilt(Telling& run, const geom::Frame& plane, const TiltChoice& choice, const base::Span& where) {
    leave_compensation(run, "the working plane is tilted");
    if (run.stopped) return;
    flush_path(run);
    const Rotary before = rotary(run);
    const bool was_tilted = tilted(run);
    const auto plane_before = find_transform(run, TransformKind::plane);
    const bool turned_by_control =
        plane_before != run.modal.transforms.end() && plane_before->turn.by_control && !choice.by_control;
    place_transform(run, TransformKind::plane, plane);
    // Behind a tilted plane that the control has turned the axes to, a level one is such a plane, too.
    if (choice.by_control && was_tilted && !tilted(run)) run.modal.transforms.push_back({TransformKind::plane, plane});
    if (const auto at = find_transform(run, TransformKind::plane); at != run.modal.transforms.end())
        at->turn = {sign_of(choice.side), choice.table_turns, choice.by_control};
    if (choice.later)
        run.aimed_at.clear();
    else
        aim(run, choice, where);
    recount(run, before);
    // What the linear axes count with another plane depends on where the control has turned the rotary ones.
    if (turned_by_control) stand_at(run, {unknown_number, unknown_number, unknown_number});
    const geom::Vec3 normal = geom::apply_direction(run.modal.programmed, {0, 0, 1});
    if (!tilted(run) || geom::distance((1 / geom::length(normal)) * normal, run.tool_axis) < 1e-9) return;
    unchecked(run, codes::unsupported, where,
              "a rotation or mirror image stands before this tilted plane and turns its normal: the tool's axis is not "
              "followed",
              "let the plane come first, or give its angles as they are turned");
}

void mark_turned_by_control(Reckoning& run) {
    if (const auto at = find_transform(run, TransformKind::plane); at != run.modal.transforms.end())
        at->turn.by_control = true;
}

void set_shift(Telling& run, const geom::Vec3& by) {
    place_transform(run, TransformKind::shift, geom::Frame::shift(by));
}

void keep_plane_alone(Telling& run) {
    std::erase_if(run.modal.transforms, [](const Transform& t) { return t.kind != TransformKind::plane; });
    update_programmed(run);
}

void shift_for_call(Telling& run, const geom::Vec3& by) {
    place_transform(run, TransformKind::call_place,
                    geom::Frame::shift(active_transform(run, TransformKind::call_place).origin + by));
}

}  // namespace obrys::interp
