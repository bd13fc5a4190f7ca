/// Rotation (G68), scaling (G51) and mirror image (G51.1) as programmed frames about their centres, and polar
/// coordinates (G16). They act in the order mirror image, scaling, rotation, whatever their order in the text. Source:
/// FANUC series 16i/18i-M operator's manual, functions to simplify programming.

#include <algorithm>

#include "read/rs274/fanuc_state.hpp"

namespace obrys::read::rs274 {

using program::FrameOp;
using program::Operator;

namespace {

constexpr std::string_view frame_axes = "XYZ";

struct FrameWriter {
    FanucState& s;
    std::uint32_t begin = 0, end = 0;

    [[nodiscard]] ExprId number(double x) const { return s.build().number(x, false, begin, end); }
    [[nodiscard]] ExprId variable(char axis) const {
        program::Expr e;
        e.kind = program::ExprKind::variable;
        e.a = s.build().name(std::string("_CENTRE_") + axis);
        return s.build().add(e, begin, end);
    }
    [[nodiscard]] ExprId coordinate(std::size_t axis) const {
        program::Expr e;
        e.kind = program::ExprKind::system;
        e.op = static_cast<std::uint8_t>(program::SystemVariable::coordinate);
        e.a = s.build().name("#500" + std::to_string(axis + 1));
        s.build().adopt(e, {number(static_cast<double>(axis + 1))});
        return s.build().add(e, begin, end);
    }
    void frame(FrameOp op, bool additive, const std::vector<std::pair<Code, ExprId>>& words) const {
        program::Builder& b = s.build();
        s.unit().frames.push_back({op, additive});
        b.statement(StatementKind::frame, s.line.begin());
        b.word(Code::control, program::Form::index, static_cast<std::int32_t>(s.unit().frames.size() - 1),
               s.line.begin(), s.line.end());
        for (const auto& [code, e] : words) b.expression(code, e, begin, end);
        b.end_statement(s.line.end());
    }
};

/// All transformations anew.
void emit_frames(const FrameWriter& w) {
    FanucState& s = w.s;
    const bool foreign = std::any_of(s.frames.begin(), s.frames.end(), [&](const auto& f) { return f.part != s.part; });
    if (foreign) {
        s.frames.clear();
        return add_problem(s, Code::unsupported, w.begin, w.end,
                           "rotation, scaling and mirror image of different programs at a time");
    }
    std::stable_sort(s.frames.begin(), s.frames.end(), [](const auto& a, const auto& b) { return a.kind < b.kind; });
    w.frame(FrameOp::shift, false, {});  // deletes all of them
    for (const Transformation& t : s.frames) {
        std::vector<std::pair<Code, ExprId>> there, back;
        for (std::size_t k = 0; k < 3; ++k) {
            if (t.centre[k] == no_expr) continue;
            const Code code = dialect::rs274::letter_code(frame_axes[k]);
            there.emplace_back(code, t.centre[k]);
            back.emplace_back(code, s.build().unary(Operator::negate, t.centre[k], w.begin, w.end));
        }
        if (!there.empty()) w.frame(FrameOp::shift, true, there);
        std::vector<std::pair<Code, ExprId>> words;
        for (std::size_t k = 0; k < 3; ++k)
            if (t.values[k] != no_expr)
                words.emplace_back(t.kind == TransformationKind::rotation ? Code::plane_rotation
                                                                          : dialect::rs274::letter_code(frame_axes[k]),
                                   t.values[k]);
        w.frame(t.kind == TransformationKind::rotation  ? FrameOp::rotate
                : t.kind == TransformationKind::scaling ? FrameOp::scale
                                                        : FrameOp::mirror,
                true, words);
        if (!there.empty()) w.frame(FrameOp::shift, true, back);
    }
}

/// The centre that the block's axis words name; where there is none, the place where the tool stands.
void take_centre(const FrameWriter& w, Transformation& t, int axis_count) {
    bool any = false;
    for (std::size_t k = 0; k < 3; ++k)
        if (Address* a = find_address(w.s, frame_axes[k])) {
            a->used = true;
            any = true;
            t.centre[k] = as_expr(w.s, scaled(w.s, a->value, Quantity::length));
        }
    if (any) return;
    program::Builder& b = w.s.build();
    b.statement(StatementKind::block, w.s.line.begin());
    for (std::size_t k = 0; k < static_cast<std::size_t>(axis_count); ++k) {
        const ExprId target = w.variable(frame_axes[k]);
        b.assign(target, w.coordinate(k), w.begin, w.end);
        t.centre[k] = w.variable(frame_axes[k]);
    }
    b.end_statement(w.s.line.end());
}

void forget(FanucState& s, TransformationKind kind) {
    std::erase_if(s.frames, [&](const Transformation& t) { return t.kind == kind; });
}

void rotation(const FrameWriter& w) {
    FanucState& s = w.s;
    Address* r = find_address(s, 'R');
    if (r == nullptr) return fail(s, w.begin, w.end, "the angle of the rotation is missing", "write it as R");
    r->used = true;
    Transformation t;
    t.kind = TransformationKind::rotation;
    t.values[0] = as_expr(s, scaled(s, r->value, Quantity::angle));
    take_centre(w, t, s.plane == 17 ? 2 : 3);
    t.part = s.part;
    forget(s, t.kind);
    s.frames.push_back(t);
    emit_frames(w);
}

void scaling(const FrameWriter& w) {
    FanucState& s = w.s;
    Transformation t;
    t.kind = TransformationKind::scaling;
    const auto factor = [&](char letter) -> ExprId {
        Address* a = find_address(s, letter);
        if (a == nullptr) return no_expr;
        a->used = true;
        return as_expr(s, scaled(s, a->value, Quantity::thousandths));
    };
    if (const ExprId all = factor('P'); all != no_expr) {
        t.values = {all, all, all};
    } else {
        for (std::size_t k = 0; k < 3; ++k) t.values[k] = factor("IJK"[k]);
    }
    if (t.values[0] == no_expr && t.values[1] == no_expr && t.values[2] == no_expr)
        return fail(s, w.begin, w.end, "the scale factor is missing", "write it as P, or as I, J and K");
    take_centre(w, t, 3);
    t.part = s.part;
    forget(s, t.kind);
    s.frames.push_back(t);
    emit_frames(w);
}

/// G51.1 X10.: about X = 10. One entry an axis.
void mirror(const FrameWriter& w, bool on) {
    FanucState& s = w.s;
    bool any = false;
    for (std::size_t k = 0; k < 3; ++k) {
        Address* a = find_address(s, frame_axes[k]);
        if (a == nullptr) continue;
        a->used = any = true;
        std::erase_if(s.frames, [&](const Transformation& t) {
            return t.kind == TransformationKind::mirror && t.values[k] != no_expr;
        });
        if (!on) continue;
        Transformation t;
        t.kind = TransformationKind::mirror;
        t.centre[k] = as_expr(s, scaled(s, a->value, Quantity::length));
        t.values[k] = w.number(0);
        t.part = s.part;
        s.frames.push_back(t);
    }
    if (!any && on) return fail(s, w.begin, w.end, "the axis of the mirror image is missing");
    if (!any) forget(s, TransformationKind::mirror);
    emit_frames(w);
}

void cancel(const FrameWriter& w, TransformationKind kind) {
    const std::size_t before = w.s.frames.size();
    forget(w.s, kind);
    // Where nothing of it was seen in this text a caller may have begun it.
    if (before != w.s.frames.size() || w.s.frames.empty()) emit_frames(w);
}

/// Polar coordinates about the zero of the workpiece coordinates.
void begin_polar(const FrameWriter& w) {
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

void frame_special(FanucState& s, const FanucG& g, const Address& a) {
    const FrameWriter w{s, a.begin, a.end};
    emit_base(s);
    switch (g.special) {
        case FanucSpecial::rotation: return rotation(w);
        case FanucSpecial::rotation_off: return cancel(w, TransformationKind::rotation);
        case FanucSpecial::scaling: return scaling(w);
        case FanucSpecial::scaling_off: return cancel(w, TransformationKind::scaling);
        case FanucSpecial::mirror: return mirror(w, true);
        case FanucSpecial::mirror_off: return mirror(w, false);
        case FanucSpecial::polar: return begin_polar(w);
        case FanucSpecial::polar_off: s.polar = false; return;
        default: return;
    }
}

std::optional<Code> polar_code(const FanucState& s, char letter) {
    const std::string_view plane = s.plane == 17 ? "XY" : s.plane == 18 ? "ZX" : "YZ";
    const bool otherwise = std::any_of(s.special.begin(), s.special.end(), [](const Special& x) {
        return x.g->special != FanucSpecial::polar && x.g->special != FanucSpecial::polar_off &&
               x.g->special != FanucSpecial::canned;
    });
    if (!s.polar || otherwise) return std::nullopt;
    if (letter == plane[0]) return Code::polar_radius;
    if (letter == plane[1]) return Code::polar_angle;
    return std::nullopt;
}

}  // namespace obrys::read::rs274
