#include "compare/compare.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "cl/text.hpp"
#include "compare/near.hpp"

namespace obrys::compare {

namespace {

constexpr std::array<std::string_view, aspect_count> names{
    "motion", "feed", "spindle", "coolant", "tool", "events", "datum", "frame", "tolerance", "cycles", "compensation"};

/// What lies in the plane of `normal`; a coordinate that nobody knows is taken to lie along the normal.
geom::Vec3 in_plane(const geom::Vec3& v, const geom::Vec3& normal) {
    const geom::Vec3 known{std::isnan(v.x) ? 0 : v.x, std::isnan(v.y) ? 0 : v.y, std::isnan(v.z) ? 0 : v.z};
    return known - geom::dot(known, normal) * normal;
}

/// Compares values by what they are.
class Likeness {
public:
    explicit Likeness(const Tolerance& t) : t_(t) {}

    [[nodiscard]] bool share(double a, double b) const { return near(a, b, t_.share * std::max(1.0, std::abs(a))); }
    [[nodiscard]] bool place(const geom::Vec3& a, const geom::Vec3& b) const { return near(a, b, t_.length); }
    [[nodiscard]] bool direction(const geom::Vec3& a, const geom::Vec3& b) const { return near(a, b, 1e-6); }

    /// Turned by the same about the same side: a sweep about the other side of the axis is the same with its sign.
    [[nodiscard]] bool turn(const geom::Vec3& n, double s, const geom::Vec3& m, double r, double radius) const {
        const double allowed = t_.length / std::max(radius, t_.length) + 1e-9;
        return near(s * n, r * m, allowed);
    }

    [[nodiscard]] bool operator()(const cl::Linear& a, const cl::Linear& b) const {
        return place(a.to, b.to) && a.rapid == b.rapid && direction(a.axis, b.axis) && a.seek == b.seek;
    }
    [[nodiscard]] bool operator()(const cl::Arc& a, const cl::Arc& b) const {
        const double radius = geom::length(in_plane(a.to - a.centre, a.normal));
        return place(a.to, b.to) && a.rapid == b.rapid && turn(a.normal, a.sweep, b.normal, b.sweep, radius) &&
               middles(a, b);
    }
    /// Ways between the same ends: places on them. Where an arc is short, its ends do not hold its centre.
    [[nodiscard]] bool middles(const cl::Arc& a, const cl::Arc& b) const {
        return place(on(a, 0.25), on(b, 0.25)) && place(on(a, 0.5), on(b, 0.5)) && place(on(a, 0.75), on(b, 0.75));
    }
    /// A place of an arc in its plane, seen back from its end.
    [[nodiscard]] static geom::Vec3 on(const cl::Arc& a, double share) {
        const geom::Vec3 r = in_plane(a.to - a.centre, a.normal);
        const double angle = -share * a.sweep;
        return in_plane(a.centre, a.normal) + std::cos(angle) * r + std::sin(angle) * geom::cross(a.normal, r);
    }
    [[nodiscard]] bool operator()(const cl::Spline& a, const cl::Spline& b) const {
        return place(a.to, b.to) && place(a.k1, b.k1) && place(a.k2, b.k2) && place(a.k3, b.k3);
    }
    [[nodiscard]] bool operator()(const cl::Thread& a, const cl::Thread& b) const {
        return place(a.to, b.to) && near(a.pitch, b.pitch, t_.length) && a.rigid_tap == b.rigid_tap &&
               near(a.start, b.start, t_.angle) && near(a.change, b.change, t_.length);
    }
    [[nodiscard]] bool operator()(const cl::Axis& a, const cl::Axis& b) const {
        return a.name == b.name && near(a.to, b.to, a.rotary ? t_.angle : t_.length);
    }
    [[nodiscard]] bool operator()(const cl::Feed& a, const cl::Feed& b) const {
        return a.mode == b.mode && share(a.value, b.value);
    }
    [[nodiscard]] bool operator()(const cl::Spindle& a, const cl::Spindle& b) const {
        const bool stands = a.direction == 0 && b.direction == 0;
        return a.direction == b.direction && (stands || (share(a.speed, b.speed) && a.mode == b.mode)) &&
               (stands || share(a.limit, b.limit)) && a.held.has_value() == b.held.has_value() &&
               near(a.held.value_or(0), b.held.value_or(0), t_.angle);
    }
    [[nodiscard]] bool operator()(const cl::ToolChange& a, const cl::ToolChange& b) const {
        return a.number == b.number && a.edge == b.edge && a.name == b.name && near(a.raised, b.raised, t_.length) &&
               near(a.wider, b.wider, t_.length);
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
               near(a.radius, b.radius, t_.length) && near(a.angle, b.angle, 1e-6) && a.rapid == b.rapid;
    }
    [[nodiscard]] bool operator()(const cl::MachinePlace& a, const cl::MachinePlace& b) const {
        return a.kind == b.kind && a.number == b.number && a.axes == b.axes && place(a.to, b.to);
    }
    [[nodiscard]] bool operator()(const cl::Datum& a, const cl::Datum& b) const {
        return a.number == b.number && place(a.origin, b.origin);
    }
    [[nodiscard]] bool operator()(const cl::Frame& a, const cl::Frame& b) const {
        return std::equal(a.parts.begin(), a.parts.end(), b.parts.begin(), b.parts.end(),
                          [&](const cl::FramePart& p, const cl::FramePart& q) {
                              return p.kind == q.kind && place(p.frame.origin, q.frame.origin) &&
                                     std::equal(p.frame.linear.begin(), p.frame.linear.end(), q.frame.linear.begin(),
                                                [](double x, double y) { return near(x, y, 1e-6); });
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
        return a.cycle->kind == b.cycle->kind && place(a.place, b.place) && v.size() == w.size() &&
               std::all_of(v.begin(), v.end(), [&](const cl::CycleValue& x) {
                   return std::any_of(w.begin(), w.end(), [&](const cl::CycleValue& y) {
                       return x.role == y.role && near(x.value, y.value, t_.length);
                   });
               });
    }
    [[nodiscard]] bool operator()(const cl::CompensationBegin& a, const cl::CompensationBegin& b) const {
        return a.side == b.side && near(a.radius, b.radius, t_.length) && a.approach == b.approach &&
               a.sharp == b.sharp && direction(a.normal, b.normal);
    }
    [[nodiscard]] bool operator()(const cl::Programmed& a, const cl::Programmed& b) const {
        const double radius = a.sweep == 0 ? 1 : geom::distance(a.from, a.centre);
        return place(a.from, b.from) && place(a.to, b.to) && (a.sweep == 0 || place(a.centre, b.centre)) &&
               turn(a.normal, a.sweep, b.normal, b.sweep, radius) && a.corner == b.corner &&
               near(a.size, b.size, t_.length) && share(a.corner_feed, b.corner_feed);
    }
    template <class T>
    [[nodiscard]] bool operator()(const T& a, const T& b) const {
        return a == b;
    }

    [[nodiscard]] bool steps(const cl::Step& a, const cl::Step& b) const {
        return std::visit(
            [&]<class T, class U>(const T& x, const U& y) {
                if constexpr (std::is_same_v<T, U>)
                    return (*this)(x, y);
                else
                    return false;
            },
            a, b);
    }

private:
    Tolerance t_;
};

/// A record in the words of the stream's text form, without its place.
std::string words(const cl::Step& step) {
    std::string out = cl::to_text({step, {}, 0});
    return out.substr(0, out.rfind(" @"));
}

/// A length matters once the tool goes to a height, not where it goes over at rapid before.
bool goes_to_height(const std::vector<Move>& moves, std::size_t i) {
    const auto* line = std::get_if<cl::Linear>(&moves[i].step);
    if (line == nullptr || !line->rapid) return true;
    const auto* before = i > 0 ? std::get_if<cl::Linear>(&moves[i - 1].step) : nullptr;
    return !std::isnan(line->to.z) && (before == nullptr || before->to.z != line->to.z);
}

std::string with_axes(const Move& m) {
    std::string out = words(m.step);
    for (const cl::Axis& axis : m.axes) out += ", " + words(axis);
    return out;
}

class Comparison {
public:
    Comparison(const Path& a, const Path& b, const Tolerance& t) : a_(a), b_(b), like_(t) {}

    Result run() {
        compare_moves();
        compare_items(Aspect::events, a_.events, b_.events);
        compare_items(Aspect::cycles, a_.cycles, b_.cycles);
        compare_items(Aspect::compensation, a_.contours, b_.contours);
        result_.moves_a = a_.moves.size();
        result_.moves_b = b_.moves.size();
        return std::move(result_);
    }

private:
    template <class T>
    void add(Aspect aspect, const T* a, const T* b, std::size_t move, std::string what) {
        if (result_.of(aspect) != nullptr) return;
        Difference d{aspect, std::move(what), move, {}, {}, 0, 0};
        if (a != nullptr) d.in_a = a->from, d.stack_a = a->stack;
        if (b != nullptr) d.in_b = b->from, d.stack_b = b->stack;
        result_.first.push_back(std::move(d));
    }

    void compare_moves() {
        const std::size_t both = std::min(a_.moves.size(), b_.moves.size());
        for (std::size_t i = 0; i < both; ++i) {
            const Move &a = a_.moves[i], &b = b_.moves[i];
            const bool axes = std::is_permutation(a.axes.begin(), a.axes.end(), b.axes.begin(), b.axes.end(), like_);
            if (!like_.steps(a.step, b.step) || !axes) {
                add(Aspect::motion, &a, &b, i, with_axes(a) + "; in the other " + with_axes(b));
                // Where there is a move more or less, those behind it no longer stand side by side.
                if (a_.moves.size() != b_.moves.size()) return static_cast<void>(result_.looked_to = i);
            }
            if (a.holding != last_a_ || b.holding != last_b_) compare_holding(a, b, i);
        }
        if (a_.moves.size() == b_.moves.size()) return;
        result_.looked_to = both;
        const Move* a = both < a_.moves.size() ? &a_.moves[both] : nullptr;
        const Move* b = both < b_.moves.size() ? &b_.moves[both] : nullptr;
        add(Aspect::motion, a, b, both,
            a != nullptr ? words(a->step) + ", which the other does not have"
                         : "the other has " + words(b->step) + ", too");
    }

    void compare_holding(const Move& a, const Move& b, std::size_t i) {
        const Holding &h = *a.holding, &k = *b.holding;
        const auto held = [&](Aspect aspect, const auto& x, const auto& y) {
            if (!like_(x, y)) add(aspect, &a, &b, i, words(x) + "; in the other " + words(y));
        };
        const bool feeds = !cl::is_rapid(a.step) && !std::holds_alternative<cl::Thread>(a.step);
        if (feeds) held(Aspect::feed, h.feed, k.feed);
        held(Aspect::spindle, h.spindle, k.spindle);
        held(Aspect::coolant, h.coolant, k.coolant);
        held(Aspect::tool, h.tool, k.tool);
        // A program that compensates no length at all counts from other zeros.
        const Aspect length = a_.compensates_length && b_.compensates_length ? Aspect::tool : Aspect::datum;
        const bool as_long =
            h.length == k.length && like_.place(h.length_by.value_or(geom::Vec3{}), k.length_by.value_or(geom::Vec3{}));
        const bool counts = goes_to_height(a_.moves, i) && goes_to_height(b_.moves, i);
        if (!as_long && counts)
            add(length, &a, &b, i, "compensation of the tool's length; in the other another one, or none");
        held(Aspect::datum, h.datum, k.datum);
        if (geom::is_finite(h.datum.origin) && geom::is_finite(k.datum.origin) &&
            !like_.place(h.datum.origin, k.datum.origin))
            add(Aspect::motion, &a, &b, i, words(h.datum) + "; in the other " + words(k.datum));
        held(Aspect::frame, h.frame, k.frame);
        held(Aspect::tolerance, h.tolerance, k.tolerance);
        if (h.path && k.path) held(Aspect::tolerance, *h.path, *k.path);
        if (h.path.has_value() != k.path.has_value())
            add(Aspect::tolerance, &a, &b, i,
                h.path ? words(*h.path) + ", which the other does not say" : "the other says " + words(*k.path));
        const bool all_looked_at = (feeds || like_(h.feed, k.feed)) && (as_long || counts);
        if (all_looked_at) last_a_ = a.holding, last_b_ = b.holding;
    }

    /// Spindle and coolant while the tool stands: dwells and stops; the end of a program stops both.
    void compare_state(const Item& a, const Item& b) {
        const auto* stop = std::get_if<cl::Stop>(&a.step);
        const bool waits =
            std::holds_alternative<cl::Dwell>(a.step) || (stop != nullptr && stop->kind != cl::StopKind::end);
        if (!waits || !a.holding || !b.holding) return;
        const Holding &h = *a.holding, &k = *b.holding;
        if (!like_(h.spindle, k.spindle))
            add(Aspect::spindle, &a, &b, a.moves, words(h.spindle) + "; in the other " + words(k.spindle));
        if (!like_(h.coolant, k.coolant))
            add(Aspect::coolant, &a, &b, a.moves, words(h.coolant) + "; in the other " + words(k.coolant));
    }

    void compare_items(Aspect aspect, const std::vector<Item>& a, const std::vector<Item>& b) {
        const std::size_t both = std::min(a.size(), b.size());
        for (std::size_t i = 0; i < both; ++i) {
            if (!like_.steps(a[i].step, b[i].step))
                return add(aspect, &a[i], &b[i], a[i].moves, words(a[i].step) + "; in the other " + words(b[i].step));
            if (aspect == Aspect::events) compare_state(a[i], b[i]);
            if (aspect == Aspect::events && a[i].moves != b[i].moves)
                return add(aspect, &a[i], &b[i], a[i].moves,
                           words(a[i].step) + " before move " + std::to_string(a[i].moves) + "; in the other before " +
                               std::to_string(b[i].moves));
        }
        if (a.size() > both)
            add<Item>(aspect, &a[both], nullptr, a[both].moves,
                      words(a[both].step) + ", which the other does not have");
        if (b.size() > both)
            add<Item>(aspect, nullptr, &b[both], b[both].moves, "the other has " + words(b[both].step) + ", too");
    }

    const Path &a_, &b_;
    Likeness like_;
    Result result_;
    std::shared_ptr<const Holding> last_a_, last_b_;
};

}  // namespace

std::string_view name_of(Aspect a) { return names[static_cast<std::size_t>(a)]; }

const Difference* Result::of(Aspect a) const {
    const auto found = std::find_if(first.begin(), first.end(), [&](const Difference& d) { return d.aspect == a; });
    return found == first.end() ? nullptr : &*found;
}

bool Result::is_equal(Aspect a) const { return of(a) == nullptr && !(looked_to && holds(a)); }

Result compare(const Path& a, const Path& b, const Tolerance& tolerance) { return Comparison(a, b, tolerance).run(); }

}  // namespace obrys::compare
