#pragma once
/// Any records, of every kind and with any numbers, for properties of all that takes a stream.

#include <rapidcheck.h>

#include "cl/record.hpp"

namespace obrys::cl {

/// Any double: small decimals, any bits, NaN, infinities, zero.
inline rc::Gen<double> any_number() {
    return rc::gen::oneOf(
        rc::gen::map(rc::gen::inRange(-1'000'000, 1'000'000), [](int i) { return i / 1000.0; }),
        rc::gen::arbitrary<double>(),
        rc::gen::element<double>(NAN, INFINITY, -INFINITY, 0.0, 5e-324, 1.7976931348623157e308, 1e15));
}
double number() { return *any_number(); }
inline geom::Vec3 vec() {
    const double x = number(), y = number(), z = number();
    return {x, y, z};
}
std::string text() { return *rc::gen::container<std::string>(rc::gen::arbitrary<char>()); }

inline std::array<char, 8> axis_name() {
    std::array<char, 8> out{};
    const std::string name = text();
    for (std::size_t i = 0; i < name.size() && i < out.size() && name[i] != 0; ++i) out[i] = name[i];
    return out;
}

inline geom::Frame any_affine() {
    geom::Frame f;
    f.origin = vec();
    if (*rc::gen::arbitrary<bool>())
        for (double& v : f.linear) v = number();
    return f;
}

template <class Enum>
inline Enum any_of(Enum last) {
    return static_cast<Enum>(*rc::gen::inRange(0, static_cast<int>(last) + 1));
}

inline Frame any_frame() {
    Frame s;
    for (int n = *rc::gen::inRange(0, 4); n > 0; --n) {
        const FrameKind kind = any_of(FrameKind::programmed);
        s.parts.push_back({kind, any_affine()});
    }
    return s;
}

inline CycleBegin any_cycle() {
    Cycle c;
    c.kind = any_of(CycleKind::probe);
    if (*rc::gen::arbitrary<bool>()) c.plane = any_affine();
    for (int i = *rc::gen::inRange(0, 4); i > 0; --i) c.values.push_back({any_of(CycleRole::turned_axes), number()});
    c.name = text();
    for (int i = *rc::gen::inRange(0, 4); i > 0; --i) c.written.push_back({text(), number()});
    CycleBegin s{c, vec(), any_of(CycleCall::pattern)};
    s.pass = *rc::gen::inRange(1, 3);
    s.passes = *rc::gen::inRange(1, 3);
    return s;
}

inline Programmed any_programmed() {
    Programmed p;
    p.from = vec(), p.to = vec();
    if (*rc::gen::arbitrary<bool>()) p.centre = vec(), p.normal = vec(), p.sweep = number();
    if (p.sweep == 0) p.centre = {}, p.normal = {0, 0, 1}, p.sweep = 0;
    p.rapid = *rc::gen::arbitrary<bool>();
    p.corner = any_of(Corner::rounding);
    if (p.corner != Corner::none) p.size = number(), p.corner_feed = number();
    return p;
}

inline MachinePlace any_place() {
    MachinePlace p;
    p.kind = any_of(PlaceKind::frame);
    p.number = *rc::gen::inRange<std::uint8_t>(1, 4);
    p.axes = {*rc::gen::arbitrary<bool>(), *rc::gen::arbitrary<bool>(), *rc::gen::arbitrary<bool>()};
    if (p.axes[0]) p.to.x = number();
    if (p.axes[1]) p.to.y = number();
    if (p.axes[2]) p.to.z = number();
    p.tip = *rc::gen::arbitrary<bool>();
    return p;
}

inline ToolLength any_length() {
    ToolLength l{*rc::gen::element<std::int8_t>(-1, 0, 1), 0, {}};
    if (l.sense == 0) return l;
    l.offset = *rc::gen::arbitrary<std::uint32_t>();
    if (*rc::gen::arbitrary<bool>()) l.by = vec();
    return l;
}

inline LeadBegin any_lead() {
    return {any_of(LeadKind::arc_and_line),
            *rc::gen::arbitrary<bool>(),
            vec(),
            number(),
            number(),
            number(),
            *rc::gen::arbitrary<bool>(),
            number()};
}

std::optional<double> perhaps() { return *rc::gen::arbitrary<bool>() ? std::optional(number()) : std::nullopt; }

inline AxisEnds ends() {
    AxisEnds out(*rc::gen::inRange<std::size_t>(0, 3));
    for (AxisEnd& end : out) end = {axis_name(), number(), *rc::gen::arbitrary<bool>(), *rc::gen::arbitrary<bool>()};
    return out;
}

inline Step any_other_spindle() {
    return OtherSpindle{
        *rc::gen::arbitrary<std::uint32_t>(),
        perhaps(),
        *rc::gen::arbitrary<bool>() ? std::optional(*rc::gen::element<std::int8_t>(-1, 0, 1)) : std::nullopt,
        perhaps(),
        perhaps(),
        *rc::gen::arbitrary<std::int64_t>()};
}

inline Step any_step(std::size_t kind) {
    switch (kind) {
        case 0: return Linear{vec(), vec(), *rc::gen::arbitrary<bool>(), any_of(Seek::release_or_end), ends()};
        case 1: return Arc{vec(), vec(), vec(), number(), *rc::gen::arbitrary<bool>(), vec(), ends()};
        case 3: return Thread{vec(), number(), *rc::gen::arbitrary<bool>(), number(), number(), vec(), ends()};
        case 4: return Dwell{number(), number()};
        case 5:
            return Feed{number(), *rc::gen::element(FeedMode::per_minute, FeedMode::per_rev, FeedMode::inverse_time)};
        case 6:
            return Spindle{number(), *rc::gen::element(SpindleMode::rpm, SpindleMode::surface),
                           *rc::gen::element<std::int8_t>(-1, 0, 1), number(),
                           *rc::gen::arbitrary<bool>() ? std::optional(number()) : std::nullopt};
        case 7:
            return ToolChange{*rc::gen::arbitrary<std::uint32_t>(),
                              *rc::gen::arbitrary<std::uint32_t>(),
                              text(),
                              number(),
                              number(),
                              *rc::gen::arbitrary<bool>(),
                              *rc::gen::arbitrary<bool>(),
                              *rc::gen::arbitrary<std::uint32_t>()};
        case 8: return Coolant{*rc::gen::arbitrary<bool>(), *rc::gen::arbitrary<bool>()};
        case 9:
            return Stop{*rc::gen::element(StopKind::program, StopKind::optional, StopKind::end),
                        *rc::gen::arbitrary<bool>(), *rc::gen::arbitrary<bool>()};
        case 32: return any_other_spindle();
        case 10: {
            const bool message = *rc::gen::arbitrary<bool>();
            return Comment{text(), message, message && *rc::gen::arbitrary<bool>()};
        }
        case 11: return Datum{*rc::gen::arbitrary<std::uint32_t>(), vec()};
        case 20: return any_frame();
        case 12:
            return Auxiliary{*rc::gen::arbitrary<char>(), *rc::gen::arbitrary<std::int64_t>(),
                             *rc::gen::arbitrary<std::uint32_t>()};
        case 18:
            return PartBegin{*rc::gen::element(PartKind::call, PartKind::label, PartKind::repetition), text(),
                             *rc::gen::arbitrary<std::uint64_t>(), *rc::gen::arbitrary<std::uint64_t>(),
                             *rc::gen::arbitrary<bool>()
                                 ? std::vector<PartArgument>{{text(), number(), {}}, {text(), NAN, text()}}
                                 : std::vector<PartArgument>{}};
        case 19: return PartEnd{};
        case 13: return any_cycle();
        case 14: {
            Spline s{vec(), vec(), vec(), vec(), vec(), {}};
            for (int i = *rc::gen::inRange(0, 3); i > 0; --i)
                s.axes.push_back({axis_name(), number(), number(), number(), number(), *rc::gen::arbitrary<bool>()});
            return s;
        }
        case 15:
            return Tolerance{number(), number(),
                             *rc::gen::element(Filter::none, Filter::finishing, Filter::semi_finishing,
                                               Filter::roughing, Filter::precision)};
        case 21:
            return CompensationBegin{any_of(CompensationSide::right),      number(),
                                     *rc::gen::arbitrary<std::uint32_t>(), any_of(Approach::smooth),
                                     *rc::gen::arbitrary<bool>(),          vec()};
        case 22: return CompensationEnd{};
        case 23: return any_programmed();
        case 24: return any_place();
        case 25: return any_length();
        case 26:
            return ToolData{*rc::gen::arbitrary<std::uint32_t>(), *rc::gen::arbitrary<std::uint32_t>(), perhaps(),
                            perhaps()};
        case 27: return any_lead();
        case 28: return LeadEnd{};
        case 30: return PathMode{any_of(PathKind::within), number(), number(), *rc::gen::arbitrary<std::uint16_t>()};
        case 29: return DatumData{*rc::gen::arbitrary<std::uint32_t>(), vec(), perhaps(), *rc::gen::arbitrary<bool>()};
        case 31: return ToolSelection{*rc::gen::arbitrary<std::uint32_t>(), text()};
        case 17:
            return Output{*rc::gen::arbitrary<std::uint32_t>(), *rc::gen::arbitrary<bool>(), number(),
                          *rc::gen::arbitrary<bool>()};
        case 2: return Override{any_of(OverrideKind::feed_hold), *rc::gen::arbitrary<bool>()};
        default: return CycleEnd{};
    }
}

inline Record any_record(std::size_t kind) {
    Record r;
    r.step = any_step(kind);
    r.from = {*rc::gen::arbitrary<std::uint32_t>(), *rc::gen::arbitrary<std::uint32_t>(),
              *rc::gen::arbitrary<std::uint32_t>()};
    r.stack = *rc::gen::arbitrary<StackId>();
    return r;
}

}  // namespace obrys::cl
