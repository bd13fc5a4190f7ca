#include "check/open_way.hpp"

#include <algorithm>

namespace obrys::check {

namespace {

constexpr double end_step = 1e-3;  ///< mm before an end that stand for it: a move needs a length

using Coordinates = std::array<double, 3>;

Coordinates array_of(geom::Vec3 v) { return {v.x, v.y, v.z}; }
geom::Vec3 vector_of(const Coordinates& c) { return {c[0], c[1], c[2]}; }

}  // namespace

OpenWay open_way(geom::Vec3 from, geom::Vec3 to, geom::Vec3 away) {
    Coordinates f = array_of(from), t = array_of(to);
    const Coordinates level = array_of(away);
    for (std::size_t k = 0; k < 3; ++k)
        if (f[k] >= level[k] && t[k] >= level[k]) return {OpenWay::Kind::beside, from, to};
    for (std::size_t k = 0; k < 3; ++k)
        if (!std::isnan(level[k]) && !(f[k] < level[k]) && !(t[k] < level[k])) return {OpenWay::Kind::clear, from, to};
    std::size_t moved = 0, axis = 0;
    for (std::size_t k = 0; k < 3; ++k)
        if (!(f[k] == t[k])) ++moved, axis = k;
    if (moved == 1 && !std::isnan(level[axis]) && std::isnan(f[axis]) != std::isnan(t[axis])) {
        const double known = std::isnan(f[axis]) ? t[axis] : f[axis];
        (std::isnan(f[axis]) ? f : t)[axis] = std::max(level[axis], known) + 1;
        return {OpenWay::Kind::swept, vector_of(f), vector_of(t)};
    }
    if (!geom::is_finite(to)) return {};
    f = t;
    const std::size_t back = !std::isnan(level[2]) ? 2 : 0;
    f[back] += end_step;
    return {OpenWay::Kind::end, vector_of(f), to};
}

void Whereabouts::known(geom::Vec3 to) {
    const bool finite = geom::is_finite(to);
    began_ = began_ || finite;
    if (finite) lost_ = false;
}

OpenMove Whereabouts::open(geom::Vec3 from, geom::Vec3 to, bool rapid, geom::Vec3 away) {
    using Kind = OpenWay::Kind;
    OpenMove m{open_way(from, to, away)};
    const bool begun = began_, lost = lost_;
    if (m.way.kind == Kind::lost && rapid && geom::is_finite(from)) lost_ = true;
    // A feed at a height that is not known may well cut.
    if (!rapid && m.way.kind == Kind::clear) m.way.kind = Kind::lost;
    const bool told = m.way.kind == Kind::beside || m.way.kind == Kind::swept ||
                      (rapid && (m.way.kind != Kind::lost || !geom::is_finite(from)));
    m.left_out = lost || lost_ || !told;
    m.start = rapid && !begun && m.way.kind != Kind::swept;
    m.assumed = !m.left_out && begun && m.way.kind != Kind::beside;
    known(to);
    return m;
}

}  // namespace obrys::check
