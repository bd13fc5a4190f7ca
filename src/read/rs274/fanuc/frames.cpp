/// Rotation (G68), scaling (G51) and mirror image (G51.1) about their centres, and polar coordinates (G16). Which of
/// them are in force, and how they act together, is the run's to know (interp/centred.cpp). Source: FANUC series
/// 16i/18i-M operator's manual, functions to simplify programming.

#include <algorithm>

#include "read/rs274/fanuc/state.hpp"

namespace obrys::read::rs274 {

namespace {

constexpr std::string_view frame_axes = "XYZ";

struct Transformer {
    FanucState& s;
    std::uint32_t begin = 0, end = 0;

    /// A block of its own, with what its letters say.
    void open() const { s.build().statement(StatementKind::block, s.line.begin()); }
    void close(Modal m) const {
        s.build().modal(m, begin, end);
        s.build().end_statement(s.line.end());
    }
    void word(Code code, const Value& v, const Address& a) const {
        s.build().expression(code, as_expr(s, v), a.begin, a.end);
    }
    /// The centre, as far as the block names it.
    void centre(std::string_view axes = frame_axes) const {
        for (const char axis : axes)
            if (Address* a = find_address(s, axis)) {
                a->used = true;
                word(dialect::rs274::letter_code(axis), scaled(s, a->value, Quantity::length), *a);
            }
    }
};

void rotation(const Transformer& t) {
    FanucState& s = t.s;
    Address* r = find_address(s, 'R');
    if (r == nullptr) return fail(s, t.begin, t.end, "the angle of the rotation is missing", "write it as R");
    r->used = true;
    t.open();
    t.centre(s.plane == 17 ? "XY" : s.plane == 18 ? "ZX" : "YZ");
    t.word(Code::plane_rotation, scaled(s, r->value, Quantity::angle), *r);
    t.close(Modal::rotation_on);
    s.transformed = s.transformed | rotated;
    refuse_axes(s, "G68 takes the axes of its plane alone");
}

void scaling(const Transformer& t) {
    FanucState& s = t.s;
    const bool any = find_address(s, 'P') != nullptr || find_address(s, 'I') != nullptr ||
                     find_address(s, 'J') != nullptr || find_address(s, 'K') != nullptr;
    if (!any) return fail(s, t.begin, t.end, "the scale factor is missing", "write it as P, or as I, J and K");
    t.open();
    t.centre();
    const auto factor = [&](char letter, Code code) {
        Address* a = find_address(s, letter);
        if (a == nullptr) return false;
        a->used = true;
        t.word(code, scaled(s, a->value, Quantity::thousandths), *a);
        return true;
    };
    if (!factor('P', Code::p)) {
        static_cast<void>(factor('I', Code::i));
        static_cast<void>(factor('J', Code::j));
        static_cast<void>(factor('K', Code::k));
    }
    t.close(Modal::scaling_on);
    s.transformed = s.transformed | enlarged;
}

/// G51.1 X10.: about X = 10.
void mirror(const Transformer& t, bool on) {
    FanucState& s = t.s;
    int named = 0;
    for (std::size_t k = 0; k < frame_axes.size(); ++k)
        if (find_address(s, frame_axes[k]) != nullptr) named |= mirrored << k;
    if (named == 0 && on) return fail(s, t.begin, t.end, "the axis of the mirror image is missing");
    t.open();
    t.centre();
    t.close(on ? Modal::mirror_on : Modal::mirror_off);
    constexpr int all = mirrored | mirrored << 1 | mirrored << 2;
    s.transformed = on ? s.transformed | named : s.transformed & ~(named == 0 ? all : named);
}

void cancel(const Transformer& t, Modal m, Transformed bit) {
    t.open();
    t.close(m);
    t.s.transformed = t.s.transformed & ~bit;
}

/// Polar coordinates about the zero of the workpiece coordinates.
void begin_polar(const Transformer& w) {
    FanucState& s = w.s;
    if (s.incremental)
        return add_problem(s, Code::unsupported, w.begin, w.end, "polar coordinates about where the tool stands (G91)");
    s.polar = true;
    program::Builder& b = s.build();
    b.statement(StatementKind::block, s.line.begin());
    const std::string_view plane = s.plane == 17 ? "XY" : s.plane == 18 ? "ZX" : "YZ";
    for (const char axis : plane) b.literal(dialect::rs274::letter_code(axis), 0.0, w.begin, w.end);
    b.modal(Modal::pole_from_zero, w.begin, w.end);
    b.end_statement(s.line.end());
}

}  // namespace

namespace {

/// The plane, the unit and the zero offset that stand beside the G code ("G18 G68 X Z R") hold for it.
void emit_base(FanucState& s) {
    const auto first = std::stable_partition(s.words.begin(), s.words.end(), [](const BlockWord& w) {
        return w.code != Code::modal || (w.order != Order::plane && w.order != Order::units && w.order != Order::datum);
    });
    if (first == s.words.end()) return;
    const std::vector<BlockWord> beside(first, s.words.end());
    s.words.erase(first, s.words.end());
    emit_words(s, beside);
}

}  // namespace

namespace {

/// A cycle, an arc or a G code that acts once reads words of the same block that are the transformation's, too.
bool is_beside_others(const FanucState& s, const FanucG& g) {
    switch (g.special) {
        case FanucSpecial::rotation:
        case FanucSpecial::scaling:
        case FanucSpecial::mirror:
        case FanucSpecial::tilt:
        case FanucSpecial::tilt_spatial:
        case FanucSpecial::take_up_tilt: break;
        default: return false;
    }
    if (s.own_motion && s.motion != Modal::rapid && s.motion != Modal::linear) return true;
    return std::any_of(s.special.begin(), s.special.end(), [](const Special& x) {
        switch (x.g->special) {
            case FanucSpecial::dwell:
            case FanucSpecial::home:
            case FanucSpecial::probe:
            case FanucSpecial::set_data:
            case FanucSpecial::position:
            case FanucSpecial::canned:
            case FanucSpecial::thread:
            case FanucSpecial::local_pattern: return true;
            default: return false;
        }
    });
}

}  // namespace

void frame_special(FanucState& s, const FanucG& g, const Address& a) {
    const Transformer w{s, a.begin, a.end};
    if (is_beside_others(s, g)) {
        s.facts.refused = true;
        s.lost_motion = s.lost_motion || s.hole != 0;
        add_problem(s, Code::unsupported, a.begin, a.end,
                    "it stands in one block with another function that reads coordinates: write two blocks");
    }
    emit_base(s);
    if (tilt_special(s, g, a)) return;
    switch (g.special) {
        case FanucSpecial::rotation: return rotation(w);
        case FanucSpecial::rotation_off:
            if (!s.control.haas) end_tilt(s, a);
            return cancel(w, Modal::rotation_off, rotated);
        case FanucSpecial::scaling: return scaling(w);
        case FanucSpecial::scaling_off: return cancel(w, Modal::scaling_off, enlarged);
        case FanucSpecial::mirror: return mirror(w, true);
        case FanucSpecial::mirror_off: return mirror(w, false);
        case FanucSpecial::polar: return begin_polar(w);
        case FanucSpecial::polar_off: s.polar = false; return;
        default: return;
    }
}

std::optional<Code> polar_code(const FanucState& s, char letter) {
    if (frame_axes.find(letter) == std::string_view::npos) return std::nullopt;
    const bool otherwise = std::any_of(s.special.begin(), s.special.end(), [](const Special& x) {
        return x.g->special != FanucSpecial::polar && x.g->special != FanucSpecial::polar_off &&
               x.g->special != FanucSpecial::canned;
    });
    if (otherwise || !s.polar) return std::nullopt;
    const std::string_view plane = s.plane == 17 ? "XY" : s.plane == 18 ? "ZX" : "YZ";
    if (letter == plane[0]) return Code::polar_radius;
    if (letter == plane[1]) return Code::polar_angle;
    return std::nullopt;
}

}  // namespace obrys::read::rs274
