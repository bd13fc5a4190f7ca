#pragma once
/// Records held against each other, kind by kind, within tolerances. What a kind does not name here is compared
/// exactly.

#include <algorithm>
#include <cmath>

#include "cl/record.hpp"
#include "compare/compare.hpp"
#include "compare/near.hpp"

namespace obrys::compare {

/// What lies in the plane of `normal`; a coordinate that nobody knows is taken to lie along the normal.
inline geom::Vec3 in_plane(const geom::Vec3& v, const geom::Vec3& normal) {
    const geom::Vec3 known{std::isnan(v.x) ? 0 : v.x, std::isnan(v.y) ? 0 : v.y, std::isnan(v.z) ? 0 : v.z};
    return known - geom::dot(known, normal) * normal;
}

/// Compares values by what they are.
class Likeness {
public:
    /// mm: a pitch adds up with every turn, and is no place that may lie beside another.
    static constexpr double pitch_words = 1e-4;
    explicit Likeness(const Tolerance& t) : t_(t) { t_.on_arcs = std::max(t.on_arcs, t.length); }

    [[nodiscard]] bool share(double a, double b) const { return near(a, b, t_.share * std::max(1.0, std::abs(a))); }
    [[nodiscard]] bool speed(double a, double b) const {
        constexpr double most = 0.05;  // of slow ones: 0.4 1/min is not 0
        return share(a, b) || std::abs(a - b) <= std::min(t_.speed_step, most * std::abs(a));
    }
    [[nodiscard]] bool place(const geom::Vec3& a, const geom::Vec3& b) const { return near(a, b, t_.length); }
    [[nodiscard]] bool direction(const geom::Vec3& a, const geom::Vec3& b) const {
        return near(a, b, std::max(1e-6, t_.turn));
    }

    /// Turned by the same about the same side: a sweep about the other side of the axis is the same with its sign.
    [[nodiscard]] bool turn(const geom::Vec3& n, double s, const geom::Vec3& m, double r, double radius) const {
        constexpr double ends = 2;  // each of them may lie so far beside
        const double room = std::max(ends * t_.length, t_.on_arcs);
        const double allowed = room / std::max(radius, t_.length) + 1e-9;
        return near(s * n, r * m, allowed);
    }

    [[nodiscard]] bool operator()(const cl::Linear& a, const cl::Linear& b) const {
        return place(a.to, b.to) && a.rapid == b.rapid && direction(a.axis, b.axis) && a.seek == b.seek;
    }
    [[nodiscard]] bool operator()(const cl::Arc& a, const cl::Arc& b) const {
        const double radius = geom::length(in_plane(a.to - a.centre, a.normal));
        return place(a.to, b.to) && a.rapid == b.rapid && turn(a.normal, a.sweep, b.normal, b.sweep, radius) &&
               direction(a.axis, b.axis) && middles(a, b) && as_known(a.centre, b.centre, a.normal);
    }
    /// Coordinates of a centre that nobody knows: the same ones, but for those along the axis.
    [[nodiscard]] static bool as_known(const geom::Vec3& a, const geom::Vec3& b, const geom::Vec3& normal) {
        const auto one = [](double x, double y, double n) {
            return std::isnan(x) == std::isnan(y) || std::abs(n) > 1 - 1e-9;
        };
        return one(a.x, b.x, normal.x) && one(a.y, b.y, normal.y) && one(a.z, b.z, normal.z);
    }
    /// Ways between the same ends: places on them. Where an arc is short, its ends do not hold its centre.
    [[nodiscard]] bool middles(const cl::Arc& a, const cl::Arc& b) const {
        const auto one = [&](double share) { return near(on(a, share), on(b, share), t_.on_arcs); };
        return one(0.25) && one(0.5) && one(0.75);
    }
    /// A place of an arc in its plane, seen back from its end.
    [[nodiscard]] static geom::Vec3 on(const cl::Arc& a, double share) {
        const geom::Vec3 r = in_plane(a.to - a.centre, a.normal);
        const double angle = -share * a.sweep;
        return in_plane(a.centre, a.normal) + std::cos(angle) * r + std::sin(angle) * geom::cross(a.normal, r);
    }
    [[nodiscard]] bool operator()(const cl::Spline& a, const cl::Spline& b) const {
        return place(a.to, b.to) && place(a.k1, b.k1) && place(a.k2, b.k2) && place(a.k3, b.k3) &&
               direction(a.axis, b.axis) &&
               std::is_permutation(a.axes.begin(), a.axes.end(), b.axes.begin(), b.axes.end(), *this);
    }
    [[nodiscard]] bool operator()(const cl::SplineAxis& a, const cl::SplineAxis& b) const {
        const double t = a.rotary ? t_.angle : t_.length;
        return a.name == b.name && a.rotary == b.rotary && near(a.to, b.to, t) && near(a.k1, b.k1, t) &&
               near(a.k2, b.k2, t) && near(a.k3, b.k3, t);
    }
    [[nodiscard]] bool operator()(const cl::Thread& a, const cl::Thread& b) const {
        return place(a.to, b.to) && near(a.pitch, b.pitch, std::min(t_.length, pitch_words)) &&
               direction(a.axis, b.axis) && a.rigid_tap == b.rigid_tap && near(a.start, b.start, t_.angle) &&
               near(a.change, b.change, t_.length);
    }
    [[nodiscard]] bool operator()(const cl::AxisEnd& a, const cl::AxisEnd& b) const {
        return a.name == b.name && near(a.to, b.to, a.rotary ? t_.angle : t_.length) && a.rotary == b.rotary &&
               a.counted == b.counted;
    }
    [[nodiscard]] bool operator()(const cl::Feed& a, const cl::Feed& b) const {
        constexpr double most = 1e-3;
        const double step = std::min(t_.feed_step, most * std::abs(a.value));
        return a.mode == b.mode && (share(a.value, b.value) || std::abs(a.value - b.value) <= step);
    }
    [[nodiscard]] bool operator()(const cl::Spindle& a, const cl::Spindle& b) const {
        const bool stands = a.direction == 0 && b.direction == 0;
        return a.direction == b.direction && (stands || (speed(a.speed, b.speed) && a.mode == b.mode)) &&
               (stands || share(a.limit, b.limit)) && a.held.has_value() == b.held.has_value() &&
               near(a.held.value_or(0), b.held.value_or(0), t_.angle);
    }
    [[nodiscard]] bool operator()(const cl::OtherSpindle& a, const cl::OtherSpindle& b) const {
        const auto same = [](const auto& x, const auto& y, auto alike) {
            return x.has_value() == y.has_value() && (!x || alike(*x, *y));
        };
        const auto speeds = [&](double x, double y) { return speed(x, y); };
        const auto angles = [&](double x, double y) { return near(x, y, t_.angle); };
        return a.number == b.number && same(a.speed, b.speed, speeds) && a.direction == b.direction &&
               same(a.held, b.held, angles) && same(a.limit, b.limit, speeds) && a.function == b.function;
    }
    /// What a program is given is in its moves; two programs of one control that are written by hand say it, too.
    [[nodiscard]] bool operator()(const cl::PartBegin& a, const cl::PartBegin& b) const {
        const auto alike = [&](const cl::PartArgument& x, const cl::PartArgument& y) {
            return x.name == y.name && near(x.value, y.value, t_.length) && x.text == y.text;
        };
        const bool counts = same_control() && !is_written_from_a();
        return a.kind == b.kind && a.name == b.name && a.pass == b.pass && a.passes == b.passes &&
               (!counts ||
                std::equal(a.arguments.begin(), a.arguments.end(), b.arguments.begin(), b.arguments.end(), alike));
    }
    /// What the end of a program does besides ending it is told apart by ItemPairs.
    [[nodiscard]] bool operator()(const cl::Stop& a, const cl::Stop& b) const {
        return a.kind == b.kind && (a.kind == cl::StopKind::end || a.pallets == b.pallets);
    }
    [[nodiscard]] bool operator()(const cl::ToolChange& a, const cl::ToolChange& b) const {
        return a.number == b.number && a.edge == b.edge && a.offset == b.offset && a.name == b.name &&
               near(a.raised, b.raised, t_.length) && near(a.wider, b.wider, t_.length);
    }
    [[nodiscard]] bool operator()(const cl::ToolLength& a, const cl::ToolLength& b) const {
        return a.sense == b.sense && a.offset == b.offset && a.by.has_value() == b.by.has_value() &&
               place(a.by.value_or(geom::Vec3{}), b.by.value_or(geom::Vec3{}));
    }
    [[nodiscard]] bool operator()(const cl::ToolData& a, const cl::ToolData& b) const {
        return a.number == b.number && a.edge == b.edge && a.length.has_value() == b.length.has_value() &&
               a.radius.has_value() == b.radius.has_value() &&
               near(a.length.value_or(0), b.length.value_or(0), t_.length) &&
               near(a.radius.value_or(0), b.radius.value_or(0), t_.length);
    }
    [[nodiscard]] bool operator()(const cl::DatumData& a, const cl::DatumData& b) const {
        return a.number == b.number && place(a.origin, b.origin) && a.added == b.added &&
               a.turn.has_value() == b.turn.has_value() && near(a.turn.value_or(0), b.turn.value_or(0), 1e-6);
    }
    [[nodiscard]] bool operator()(const cl::LeadBegin& a, const cl::LeadBegin& b) const {
        return a.kind == b.kind && a.onto == b.onto && place(a.at, b.at) && near(a.length, b.length, t_.length) &&
               near(a.radius, b.radius, t_.length) && near(a.angle, b.angle, 1e-6) && a.rapid == b.rapid &&
               share(a.feed, b.feed);
    }
    [[nodiscard]] bool operator()(const cl::MachinePlace& a, const cl::MachinePlace& b) const {
        const bool alike = a.kind == b.kind ? a.number == b.number : is_place_of_home(a, b) || is_place_of_home(b, a);
        return alike && a.axes == b.axes && place(a.to, b.to) && a.tip == b.tip;
    }
    /// A reference point whose coordinates are known is the place that the other leads to by them (G28, M91).
    [[nodiscard]] static bool is_place_of_home(const cl::MachinePlace& home, const cl::MachinePlace& said) {
        const auto known = [](bool named, double v) { return !named || std::isfinite(v); };
        return home.kind == cl::PlaceKind::home && said.kind == cl::PlaceKind::coordinates &&
               known(home.axes[0], home.to.x) && known(home.axes[1], home.to.y) && known(home.axes[2], home.to.z);
    }
    [[nodiscard]] bool operator()(const cl::Datum& a, const cl::Datum& b) const {
        return a.number == b.number && a.selected == b.selected && place(a.origin, b.origin);
    }
    [[nodiscard]] bool affine(const geom::Frame& a, const geom::Frame& b) const {
        return place(a.origin, b.origin) &&
               std::equal(a.linear.begin(), a.linear.end(), b.linear.begin(),
                          [&](double x, double y) { return near(x, y, std::max(1e-6, t_.turn)); });
    }
    [[nodiscard]] bool operator()(const cl::Frame& a, const cl::Frame& b) const {
        return std::equal(a.parts.begin(), a.parts.end(), b.parts.begin(), b.parts.end(),
                          [&](const cl::FramePart& p, const cl::FramePart& q) {
                              return p.kind == q.kind && p.turn == q.turn && affine(p.frame, q.frame);
                          });
    }
    [[nodiscard]] bool operator()(const cl::Tolerance& a, const cl::Tolerance& b) const {
        return near(a.contour, b.contour, t_.length) && near(a.rotary, b.rotary, t_.angle) && a.filter == b.filter;
    }
    [[nodiscard]] bool operator()(const cl::PathMode& a, const cl::PathMode& b) const {
        return a.kind == b.kind && near(a.tolerance, b.tolerance, t_.length) && near(a.merge, b.merge, t_.length) &&
               a.way == b.way;
    }
    [[nodiscard]] bool operator()(const cl::Dwell& a, const cl::Dwell& b) const {
        return share(a.seconds, b.seconds) && share(a.revolutions, b.revolutions);
    }
    [[nodiscard]] bool operator()(const cl::CycleBegin& a, const cl::CycleBegin& b) const {
        const std::vector<cl::CycleValue>&v = a.cycle->values, &w = b.cycle->values;
        return a.cycle->kind == b.cycle->kind && place(a.place, b.place) && affine(a.cycle->plane, b.cycle->plane) &&
               a.call == b.call && a.pass == b.pass && a.passes == b.passes && v.size() == w.size() &&
               std::all_of(v.begin(), v.end(), [&](const cl::CycleValue& x) {
                   return std::any_of(w.begin(), w.end(), [&](const cl::CycleValue& y) {
                       return x.role == y.role && near(x.value, y.value, t_.length);
                   });
               });
    }
    [[nodiscard]] bool operator()(const cl::CompensationBegin& a, const cl::CompensationBegin& b) const {
        return a.side == b.side && near(a.radius, b.radius, t_.length) && a.approach == b.approach &&
               a.sharp == b.sharp && direction(a.normal, b.normal) && a.given == b.given &&
               (!a.given || a.nose == b.nose) && !are_of_unknown_offsets(a, b);
    }
    /// Radii that nobody knows, of offsets with other numbers (D11, D12). The number does not count where the radius is
    /// known, nor 0, by which some controls call what others number as the tool.
    [[nodiscard]] static bool are_of_unknown_offsets(const cl::CompensationBegin& a, const cl::CompensationBegin& b) {
        const auto unknown = [](const cl::CompensationBegin& c) {
            return !c.given && c.offset != 0 && !(std::abs(c.radius) > 0);
        };
        return unknown(a) && unknown(b) && a.offset != b.offset;
    }
    [[nodiscard]] bool operator()(const cl::Programmed& a, const cl::Programmed& b) const {
        const double radius = a.sweep == 0 ? 1 : geom::distance(a.from, a.centre);
        return place(a.from, b.from) && place(a.to, b.to) && (a.sweep == 0 || place(a.centre, b.centre)) &&
               turn(a.normal, a.sweep, b.normal, b.sweep, radius) && a.corner == b.corner && a.rapid == b.rapid &&
               near(a.size, b.size, t_.length) && share(a.corner_feed, b.corner_feed);
    }
    template <class T>
    [[nodiscard]] bool operator()(const T& a, const T& b) const {
        return a == b;
    }

    [[nodiscard]] bool steps(const cl::Step& a, const cl::Step& b) const {
        return a.index() == b.index() &&
               std::visit([&]<class T>(const T& x) { return (*this)(x, *std::get_if<T>(&b)); }, a);
    }
    [[nodiscard]] double length() const { return t_.length; }
    [[nodiscard]] double increment() const { return t_.increment; }
    [[nodiscard]] bool same_control() const { return t_.same_control; }
    [[nodiscard]] bool is_written_from_a() const { return t_.is_written_from_a; }

private:
    Tolerance t_;
};

}  // namespace obrys::compare
