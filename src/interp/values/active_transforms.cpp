/// The transformations in force, one by one.

#include "interp/values/values.hpp"

namespace obrys::interp {

geom::Frame active_transform(const Reckoning& run, TransformKind kind) {
    geom::Frame found;
    for (const Transform& t : run.modal.transforms) {
        if (t.kind == TransformKind::plane && kind != TransformKind::plane) found = {};
        if (t.kind == kind) found = t.frame;
    }
    return found;
}

geom::Frame active_plane(const Reckoning& run) { return active_transform(run, TransformKind::plane); }

geom::Vec3 active_shift(const Reckoning& run) { return active_transform(run, TransformKind::shift).origin; }

}  // namespace obrys::interp
