/// Single components of a frame: $P_PFRAME[X,TR], F_1[Z,RT]. A frame is shift, rotation (Z, Y', X''), scale and mirror.

#include <array>
#include <cmath>
#include <optional>

#include "base/codes.hpp"
#include "interp/values/values.hpp"

namespace obrys::interp {

namespace codes = base::codes;
using geom::Frame;
using geom::Vec3;
using program::Expr;

namespace {

enum class Component : std::uint8_t { shift, fine, rotation, scale, mirror };

std::optional<Component> component_of(Saying& run, ExprId id) {
    const Expr& e = run.unit().exprs[id];
    if (e.kind != program::ExprKind::variable || e.count != 0) return std::nullopt;
    const std::string& name = run.env.names.text(e.a);
    if (name == "TR") return Component::shift;
    if (name == "FI") return Component::fine;
    if (name == "RT") return Component::rotation;
    if (name == "SC") return Component::scale;
    if (name == "MI") return Component::mirror;
    return std::nullopt;
}

/// What a frame is made of. NaN: it cannot be told from the whole.
struct FrameParts {
    std::array<double, 3> rotation{}, scale{1, 1, 1}, mirror{};  // rad, factors, 0 or 1
};

Vec3 column(const Frame& f, std::size_t k) { return {f.linear[k], f.linear[3 + k], f.linear[6 + k]}; }

/// Mirroring of a frame whose axes keep their directions; two mirrored axes might be half a turn as well.
void take_straight(const Frame& f, FrameParts& p) {
    int mirrored = 0;
    for (std::size_t k = 0; k < 3; ++k) mirrored += f.linear[4 * k] < 0 ? 1 : 0;
    for (std::size_t k = 0; k < 3; ++k) p.mirror[k] = mirrored >= 2 ? unknown_number : f.linear[4 * k] < 0 ? 1 : 0;
    if (mirrored >= 2) p.rotation = {unknown_number, unknown_number, unknown_number};
}

FrameParts parts_of(const Frame& f) {
    FrameParts p;
    const std::array<Vec3, 3> c{column(f, 0), column(f, 1), column(f, 2)};
    for (std::size_t k = 0; k < 3; ++k) p.scale[k] = geom::length(c[k]);
    bool straight = true;
    for (std::size_t i = 0; i < 9; ++i) straight = straight && (i % 4 == 0 || f.linear[i] == 0);
    if (straight) {
        take_straight(f, p);
        return p;
    }
    const auto square = [&](std::size_t a, std::size_t b) {
        return std::abs(geom::dot(c[a], c[b])) <= 1e-9 * p.scale[a] * p.scale[b];
    };
    if (!square(0, 1) || !square(0, 2) || !square(1, 2) || !(geom::determinant(f) > 0)) {
        p.rotation = p.mirror = {unknown_number, unknown_number, unknown_number};
        if (!square(0, 1) || !square(0, 2) || !square(1, 2)) p.scale = p.rotation;
        return p;
    }
    const Vec3 x = (1 / p.scale[0]) * c[0], y = (1 / p.scale[1]) * c[1], z = (1 / p.scale[2]) * c[2];
    p.rotation = {std::atan2(y.z, z.z), std::asin(std::fmax(-1, std::fmin(1, -x.z))), std::atan2(x.y, x.x)};
    return p;
}

Frame frame_of(const FrameParts& p, Vec3 shift) {
    const auto factor = [&](std::size_t k) { return p.mirror[k] == 0 ? p.scale[k] : -p.scale[k]; };
    return Frame::shift(shift) * Frame::rotation(2, p.rotation[2]) * Frame::rotation(1, p.rotation[1]) *
           Frame::rotation(0, p.rotation[0]) * Frame::scaling({factor(0), factor(1), factor(2)});
}

/// The place in a frame that the last two indices name; nothing after a complaint.
struct Place {
    int axis = 0;
    Component component = Component::shift;
};
std::optional<Place> place_of(Reckoning& run, const Expr& e) {
    const base::Span where{run.unit().file, e.begin, e.end};
    const std::uint32_t at = e.b + e.count - 2;
    const std::string axis = axis_of(run, run.unit().children[at]);
    const auto component = component_of(run, run.unit().children[at + 1]);
    if (run.stopped) return std::nullopt;
    const int k = axis == "X" ? 0 : axis == "Y" ? 1 : axis == "Z" ? 2 : -1;
    if (component && k >= 0 && *component != Component::fine) return Place{k, *component};
    unchecked(run, codes::unsupported, where,
              "this component of a frame is not followed: only TR, RT, SC and MI of X, Y and Z are");
    return std::nullopt;
}

double& part(FrameParts& p, const Place& place) {
    const auto k = static_cast<std::size_t>(place.axis);
    return place.component == Component::rotation ? p.rotation[k]
           : place.component == Component::scale  ? p.scale[k]
                                                  : p.mirror[k];
}

void not_told(Saying& run, const Expr& e) {
    unchecked(run, codes::unknown_value, {run.unit().file, e.begin, e.end},
              "rotation, scale and mirroring of this frame cannot be told apart here");
}

}  // namespace

bool is_component(const Saying& run, const Expr& e) {
    if (e.count < 2) return false;
    const Expr& last = run.unit().exprs[run.unit().children[e.b + e.count - 1]];
    if (last.kind != program::ExprKind::variable || last.count != 0) return false;
    const std::string& name = run.env.names.text(last.a);
    return name == "TR" || name == "FI" || name == "RT" || name == "SC" || name == "MI";
}

Value read_component(Reckoning& run, const Expr& e, const Frame& frame) {
    const auto place = place_of(run, e);
    if (!place) return Value::unknown();
    if (place->component == Component::shift)
        return Value::real(coordinate(frame.origin, place->axis) / length_unit(run.modal));
    FrameParts p = parts_of(frame);
    const double v = part(p, *place);
    if (std::isnan(v)) not_told(run, e);
    if (place->component == Component::mirror) return std::isnan(v) ? Value::unknown() : Value::boolean(v != 0);
    return Value::real(place->component == Component::rotation ? geom::degrees(v) : v);
}

void write_component(Reckoning& run, const Expr& e, Frame& frame, ExprId value) {
    const auto place = place_of(run, e);
    const double v = number(run, value);
    if (!place || run.stopped) return;
    const base::Span where{run.unit().file, e.begin, e.end};
    if (std::isnan(v))
        return unchecked(run, codes::unknown_value, where,
                         "this frame depends on a value that is not known: it stays as it was");
    if (place->component == Component::shift) {
        coordinate(frame.origin, place->axis) = v * length_unit(run.modal);
        return;
    }
    FrameParts p = parts_of(frame);
    part(p, *place) = place->component == Component::rotation ? geom::radians(v) : v;
    for (std::size_t k = 0; k < 3; ++k)
        if (std::isnan(p.rotation[k] + p.scale[k] + p.mirror[k])) return not_told(run, e);
    frame = frame_of(p, frame.origin);
}

}  // namespace obrys::interp
