#include "compare/piece.hpp"

#include "geom/vec.hpp"

namespace obrys::compare {

namespace {

bool is_along_axis(const geom::Vec3& v) { return (v.x != 0) + (v.y != 0) + (v.z != 0) == 1; }

/// The piece of the line that is left keeps to that line, so that cuts beside it do not add up.
std::optional<Piece> behind_line(const Piece& whole, const cl::Linear& line, const Piece& part, const cl::Linear& head,
                                 const Likeness& like) {
    const bool one_way = line.rapid == head.rapid && line.seek == cl::Seek::nothing && head.seek == cl::Seek::nothing;
    const bool no_turn = like.direction(line.axis, head.axis) && like.direction(line.axis, whole.tool) &&
                         like.direction(head.axis, part.tool);
    if (!one_way || !no_turn) return std::nullopt;
    const geom::Vec3 way = line.to - whole.from, done = head.to - whole.from;
    if (line.rapid && !is_along_axis(way)) return std::nullopt;
    const double share = geom::dot(done, way) / geom::dot(way, way);
    if (!(share > 0) || !(share < 1)) return std::nullopt;
    const geom::Vec3 on_it = whole.from + share * way;
    if (!like.place(on_it, head.to)) return std::nullopt;
    return Piece{on_it, whole.tool, line};
}

/// The arc up to a share of its sweep, with its rise.
cl::Arc up_to(const cl::Arc& arc, const geom::Vec3& from, double share) {
    const geom::Vec3& n = arc.normal;
    const double height = geom::dot(from, n) + share * geom::dot(arc.to - from, n);
    cl::Arc out = arc;
    const geom::Vec3 flat = Likeness::on(arc, 1 - share);
    out.to = flat + (height - geom::dot(flat, n)) * n;
    out.sweep = share * arc.sweep;
    return out;
}

std::optional<Piece> behind_arc(const Piece& whole, const cl::Arc& arc, const cl::Arc& head, const Likeness& like) {
    if (arc.rapid != head.rapid || arc.sweep == 0) return std::nullopt;
    const auto flat = [&](const geom::Vec3& v) { return in_plane(v - arc.centre, arc.normal); };
    const geom::Vec3 end = flat(arc.to), there = flat(head.to);
    const bool round = std::abs(geom::length(flat(whole.from)) - geom::length(end)) <= 2 * like.length();
    if (!round) return std::nullopt;
    // How far it is from the end of the part to the end of the whole: so many turns that both sweeps agree.
    const double sense = arc.sweep > 0 ? 1 : -1, turn = geom::full_turn;
    const double angle = sense * std::atan2(geom::dot(arc.normal, geom::cross(there, end)), geom::dot(there, end));
    const double wanted = std::abs(arc.sweep) - std::abs(head.sweep);
    const double left = angle + turn * std::round((wanted - angle) / turn);
    const double share = 1 - left / std::abs(arc.sweep);
    if (!(share > 0) || !(share < 1)) return std::nullopt;
    const cl::Arc beginning = up_to(arc, whole.from, share);
    if (!like(beginning, head)) return std::nullopt;
    cl::Arc rest = arc;
    rest.sweep = (1 - share) * arc.sweep;
    return Piece{beginning.to, whole.tool, rest};
}

}  // namespace

std::optional<Piece> behind(const Piece& whole, const Piece& part, const Likeness& like) {
    if (whole.step.index() != part.step.index()) return std::nullopt;
    if (!(geom::distance(whole.from, part.from) <= 2 * like.length())) return std::nullopt;  // nor where not known
    if (const auto* line = std::get_if<cl::Linear>(&whole.step))
        return behind_line(whole, *line, part, std::get<cl::Linear>(part.step), like);
    if (const auto* arc = std::get_if<cl::Arc>(&whole.step))
        return behind_arc(whole, *arc, std::get<cl::Arc>(part.step), like);
    return std::nullopt;
}

}  // namespace obrys::compare
