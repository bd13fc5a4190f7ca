/// Rotation, scaling and mirror image about a centre (G68, G51, G51.1), each in force until its own end. They act in
/// the order mirror image, scaling, rotation, whatever the order in which they were switched on. Sources: FANUC series
/// 16i/18i-M operator's manual, functions to simplify programming; Haas Mill Operator's Manual 96-8000, page 176: an
/// axis of the centre that has no word is where the tool stands.

#include <algorithm>
#include <cmath>

#include "base/codes.hpp"
#include "interp/setup/setup.hpp"

namespace obrys::interp {

namespace codes = base::codes;

namespace {

int rank(TransformKind k) { return k == TransformKind::mirror ? 0 : k == TransformKind::rotation ? 2 : 1; }

void act_together(Telling& run) {
    auto& all = run.modal.transforms;
    std::stable_sort(all.begin(), all.end(), [](const auto& a, const auto& b) { return rank(a.kind) < rank(b.kind); });
    run.modal.programmed = {};
    for (const Transform& t : all) run.modal.programmed = run.modal.programmed * t.frame;
    update_frame(run);
}

/// The tool's place stands in for axes that the block does not name.
geom::Vec3 centre_of(Moving& run, const std::vector<int>& axes, const char* name) {
    const BlockWords& b = run.block;
    geom::Vec3 c;
    bool named = false, left_out = false;
    for (const int k : axes) {
        const bool has = b.has(axis_code(k));
        coordinate(c, k) = has ? b.get(axis_code(k)) * length_unit(run.modal) : coordinate(run.programmed_position, k);
        (has ? named : left_out) = true;
    }
    if (named && left_out && run.traits->assumes_rest_of_centre)
        assume(run, run.here(),
               std::string("the centre of ") + name +
                   " has not a word for every axis: along the others it is taken to be where the tool stands",
               "write all of its coordinates");
    return c;
}

bool can_be_made(Saying& run, const geom::Frame& op, const geom::Vec3& centre, const char* name) {
    const bool known = geom::is_finite(centre) &&
                       std::all_of(op.linear.begin(), op.linear.end(), [](double v) { return std::isfinite(v); });
    if (!known)
        unchecked(run, codes::unknown_value, run.here(),
                  std::string(name) + " depends on a value or a position that is not known: it is left out");
    return known;
}

void add(Telling& run, TransformKind kind, int axis, const geom::Frame& op, const geom::Vec3& centre) {
    auto& all = run.modal.transforms;
    std::erase_if(all, [&](const Transform& t) { return t.kind == kind && t.axis == axis; });
    all.push_back({kind, geom::Frame::shift(centre) * op * geom::Frame::shift(geom::Vec3{} - centre), axis});
    act_together(run);
}

void rotate_about(Moving& run) {
    const PlaneAxes a = plane_axes(run.modal.plane);
    const geom::Frame op = geom::Frame::rotation(a.w, geom::radians(run.block.get(Code::plane_rotation)));
    const geom::Vec3 centre = centre_of(run, {a.u, a.v}, "the rotation");
    run.block.use(axis_code(a.w));  // the rotation leaves it as it is
    if (can_be_made(run, op, centre, "the rotation")) add(run, TransformKind::rotation, -1, op, centre);
}

void scale_about(Moving& run) {
    const BlockWords& b = run.block;
    geom::Vec3 f{1, 1, 1};
    constexpr Code factors[3] = {Code::i, Code::j, Code::k};
    for (int k = 0; k < 3; ++k)
        if (b.has(Code::p))
            coordinate(f, k) = b.get(Code::p);
        else if (b.has(factors[k]))
            coordinate(f, k) = b.get(factors[k]);
    const geom::Frame op = geom::Frame::scaling(f);
    std::vector<int> scaled;
    for (int k = 0; k < 3; ++k) {
        b.use(axis_code(k));
        if (coordinate(f, k) != 1) scaled.push_back(k);
    }
    const geom::Vec3 centre = centre_of(run, scaled, "the scaling");
    if (can_be_made(run, op, centre, "the scaling")) add(run, TransformKind::scaling, -1, op, centre);
}

void mirror_about(Moving& run) {
    for (int k = 0; k < 3 && !run.stopped; ++k) {
        if (!run.block.has(axis_code(k))) continue;
        geom::Vec3 centre, f{1, 1, 1};
        coordinate(centre, k) = run.block.get(axis_code(k)) * length_unit(run.modal);
        coordinate(f, k) = -1;
        if (can_be_made(run, {}, centre, "the mirror image"))
            add(run, TransformKind::mirror, k, geom::Frame::scaling(f), centre);
    }
}

/// Without an axis every one.
void end_mirror(Moving& run) {
    bool any = false;
    for (int k = 0; k < 3; ++k) any = any || run.block.has(axis_code(k));
    std::erase_if(run.modal.transforms, [&](const Transform& t) {
        return t.kind == TransformKind::mirror && (!any || run.block.has(axis_code(t.axis)));
    });
    for (int k = 0; k < 3; ++k) run.block.use(axis_code(k));
}

}  // namespace

void transform_about_centre(Moving& run, Modal m) {
    const auto end = [&](TransformKind kind) {
        std::erase_if(run.modal.transforms, [&](const Transform& t) { return t.kind == kind; });
    };
    switch (m) {
        case Modal::rotation_on: return rotate_about(run);
        case Modal::scaling_on: return scale_about(run);
        case Modal::mirror_on: return mirror_about(run);
        case Modal::rotation_off: end(TransformKind::rotation); break;
        case Modal::scaling_off: end(TransformKind::scaling); break;
        default: end_mirror(run); break;
    }
    act_together(run);
}

}  // namespace obrys::interp
