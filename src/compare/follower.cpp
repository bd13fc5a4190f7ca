#include "cl/totals.hpp"
#include "compare/walk.hpp"

namespace obrys::compare {

namespace {

/// The numbers of both are counted from the same zero, with the same length of the same tool.
bool same_ground(const Holding& a, const Holding& b) {
    return a.datum.number == b.datum.number && near(a.datum.origin, b.datum.origin, 0) && a.length == b.length &&
           near(a.length_by.value_or(geom::Vec3{}), b.length_by.value_or(geom::Vec3{}), 0) &&
           a.tool.number == b.tool.number && a.tool.edge == b.tool.edge && a.tool.name == b.tool.name &&
           near(a.tool.raised, b.tool.raised, 0);
}

}  // namespace

Piece Follower::piece() const {
    if (rest_) return *rest_;
    const Move& m = move();
    const bool known = ground_ == m.holding || (ground_ && same_ground(*ground_, *m.holding));
    return {known ? from_ : geom::Vec3{NAN, NAN, NAN}, tool_, m.step};
}

bool Follower::goes_to_height() const {
    const auto* line = std::get_if<cl::Linear>(&move().step);
    if (line == nullptr || !line->rapid) return true;
    return !std::isnan(line->to.z) && (!line_z_ || *line_z_ != line->to.z);
}

void Follower::pass() {
    const Move& m = move();
    from_ = cl::position_after(from_, m.step);
    const auto* line = std::get_if<cl::Linear>(&m.step);
    const auto* curve = std::get_if<cl::Spline>(&m.step);
    if (line != nullptr) tool_ = line->axis;
    if (curve != nullptr) tool_ = curve->axis;
    line_z_ = line != nullptr ? std::optional(line->to.z) : std::nullopt;
    if (ground_ != m.holding) ground_ = m.holding;
    rest_.reset();
    ++next_;
}

void Follower::pass_to(Piece behind) { rest_ = std::move(behind); }

}  // namespace obrys::compare
