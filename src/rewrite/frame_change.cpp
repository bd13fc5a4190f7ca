/// What a statement makes of the frame, told in the control's own way: together (TRANS, then AROT) or each part for
/// itself (cycles 7 and 10; G52 and G68).

#include <algorithm>

#include "rewrite/block_words.hpp"
#include "rewrite/contour_text.hpp"
#include "rewrite/frames.hpp"

namespace obrys::rewrite {

using program::Code;
using program::CycleDefinition;
using program::FrameOp;
using program::Modal;

namespace {

/// One statement that changes the frame.
class FrameChange {
public:
    explicit FrameChange(Writing& w) : w_(w), sums_(w) {}

    /// False after a complaint.
    bool begin() {
        for (std::size_t i = 0; i < frame_modes.size(); ++i)
            before_[i] = now_[i] = w_.frame_part(frame_modes[i]).value_or(unknown());
        if (w_.held()[Mode::plane] == 17) return true;
        w_.refuse(w_.here, "frames outside the plane of X and Y are not translated by structure");
        return false;
    }

    void cycle(const CycleDefinition& d) {
        for (const program::CycleSetting& s : d.settings) {
            const auto axis = axis_of_role(s.role);
            const bool shift = d.kind == cl::CycleKind::datum_shift && axis;
            if (d.kind == cl::CycleKind::mirror && axis) continue;
            const bool whole = shift || (d.kind == cl::CycleKind::rotation && s.role == cl::CycleRole::angle) ||
                               (d.kind == cl::CycleKind::scaling && s.role == cl::CycleRole::factor);
            if (!whole || s.as_modal || s.parameter != program::no_target)
                return w_.refuse(s.where, d.name + ": " + w_.source(s.where) + " is not translated by structure");
            const Mode part = shift ? shift_modes[*axis] : d.kind == cl::CycleKind::rotation ? Mode::turn : Mode::scale;
            const Text v = w_.value(s.value);
            if (s.incremental && !known(part)) return;
            set(part, s.incremental ? sums_.plus(at(part), v) : v);
        }
        if (d.kind == cl::CycleKind::mirror) mirror(d);
        if (!overtakes(d.kind == cl::CycleKind::datum_shift)) finish();
    }

    void frame(const program::FrameCall& call) {
        if (call.beside_words) return w_.refuse(w_.here, "a frame beside other words is not translated by structure");
        if (!call.additive) now_ = nothing();
        const Unit& unit = *w_.unit;
        for (std::uint32_t i = unit.statements[w_.at].first + 1; i < unit.words_end(w_.at); ++i)
            if (!word(call, unit.words[i])) return;
        if (call.additive && call.op == FrameOp::shift && behind_turn())
            return w_.refuse(w_.here, "a shift in turned or scaled axes has no counterpart there",
                             "write the shift before the rotation");
        finish();
    }

    /// G52, G68, G69.
    void block(Modal m) {
        const Unit& unit = *w_.unit;
        if (m == Modal::rotation_off) set(Mode::turn, w_.number_text(0));
        for (std::uint32_t i = unit.statements[w_.at].first; i < unit.words_end(w_.at); ++i) {
            const program::Word& word = unit.words[i];
            const Code code = program::code_of(word);
            if (code == Code::modal || code == Code::act || code == Code::comment) continue;
            const auto v = value_of(word);
            const bool axis = code <= Code::z;
            if (v && m == Modal::local_shift && axis)
                set(shift_modes[static_cast<std::size_t>(code)], *v);
            else if (v && m == Modal::rotation_on && code == Code::plane_rotation)
                set(Mode::turn, *v);
            else if (!(v && m == Modal::rotation_on && axis && v->number == 0.0))
                return w_.refuse(
                    unit.span(unit.statements[w_.at], word),
                    w_.source(w_.here) + ": this frame is not translated by structure",
                    m == Modal::rotation_on ? "shift the zero to the centre (G52), and turn about X0 Y0" : "");
        }
        finish();
    }

private:
    using Parts = std::array<Text, frame_modes.size()>;

    [[nodiscard]] static std::size_t index(Mode m) {
        return static_cast<std::size_t>(m) - static_cast<std::size_t>(Mode::shift_x);
    }
    /// What depends on the way that the run has come.
    [[nodiscard]] static Text unknown() { return {"?", Level::atom, std::nullopt}; }
    /// False after a complaint.
    bool known(Mode m) {
        if (at(m).text != unknown().text) return true;
        w_.refuse(w_.here,
                  "which frame is in force here depends on the way that the run has come, or on another program",
                  "end the frame before, or write the whole frame here");
        return false;
    }
    [[nodiscard]] bool changes_shift() const {
        return std::any_of(shift_modes.begin(), shift_modes.end(), [&](Mode m) { return changed(m); });
    }
    [[nodiscard]] const Text& at(Mode m) const { return now_[index(m)]; }
    void set(Mode m, const Text& v) { now_[index(m)] = v; }
    [[nodiscard]] Parts nothing() const {
        Parts out;
        for (std::size_t i = 0; i < out.size(); ++i) out[i] = w_.nothing_of(frame_modes[i]);
        return out;
    }
    [[nodiscard]] bool acts(const Parts& parts, Mode m) const { return parts[index(m)].text != w_.nothing_of(m).text; }
    [[nodiscard]] bool shifts_in(const Parts& parts) const {
        return std::any_of(shift_modes.begin(), shift_modes.end(), [&](Mode m) { return acts(parts, m); });
    }
    [[nodiscard]] bool behind_turn() const {
        return acts(now_, Mode::turn) || acts(now_, Mode::mirror) || acts(now_, Mode::scale);
    }

    void mirror(const CycleDefinition& d) {
        std::string axes;
        for (const program::CycleSetting& s : d.settings)
            if (const auto axis = axis_of_role(s.role)) axes += "XYZ"[*axis];
        set(Mode::mirror, {axes, Level::atom, std::nullopt});
    }

    std::optional<Text> value_of(const program::Word& word) {
        if (program::is_literal(word)) return w_.number_text(w_.unit->literal(word));
        if (program::form_of(word) != program::Form::expression) return std::nullopt;
        return w_.value(static_cast<ExprId>(word.payload));
    }

    bool word(const program::FrameCall& call, const program::Word& word) {
        const Code code = program::code_of(word);
        const auto v = value_of(word);
        const bool axis = code <= Code::z;
        if (v && call.op == FrameOp::shift && axis) {
            const Mode part = shift_modes[static_cast<std::size_t>(code)];
            if (call.additive && !known(part)) return false;
            return set(part, call.additive ? sums_.plus(at(part), *v) : *v), true;
        }
        if (call.additive && call.op != FrameOp::shift &&
            !known(call.op == FrameOp::rotate ? Mode::turn : Mode::mirror))
            return false;
        if (v && call.op == FrameOp::rotate && (code == Code::plane_rotation || code == Code::z))
            return set(Mode::turn, call.additive ? sums_.plus(at(Mode::turn), *v) : *v), true;
        if (call.op == FrameOp::mirror && axis) {
            std::string axes = at(Mode::mirror).text;
            const char letter = "XYZ"[static_cast<std::size_t>(code)];
            if (const std::size_t there = axes.find(letter); there != std::string::npos)
                axes.erase(there, 1);  // twice is not at all
            else
                axes += letter;
            return set(Mode::mirror, {axes, Level::atom, std::nullopt}), true;
        }
        w_.refuse(w_.unit->span(w_.unit->statements[w_.at], word),
                  w_.source(w_.here) + ": this frame is not translated by structure",
                  call.op == FrameOp::scale ? "" : "write TRANS X Y Z, ROT RPL=, MIRROR X0");
        return false;
    }

    /// What begins to act stands behind what acts already: a shift in turned axes, a mirror image of a turned part.
    bool overtakes(bool shift) {
        const bool late = shift && !shifts_in(before_) && shifts_in(now_) && behind_turn();
        const bool both = acts(now_, Mode::turn) && acts(now_, Mode::mirror);
        if (late || both)
            w_.refuse(w_.here,
                      late ? "a shift behind a rotation, mirror image or scaling has no counterpart there"
                           : "a rotation together with a mirror image is not translated by structure",
                      late ? "write the shift before the rotation" : "");
        return late || both;
    }

    void finish() {
        const bool whole = w_.language.frames_together || (w_.language.shift_before_turn && changes_shift());
        for (const Mode m : frame_modes)
            if (whole && (w_.language.frames_together || m == Mode::turn) && !known(m)) return;
        for (std::size_t i = 0; i < now_.size(); ++i) hold(i);
        w_.keep_frame(now_);
        if (w_.language.frames_together)
            together();
        else
            one_by_one();
    }

    /// In a place of its own where it will be said again, and may have changed by then.
    void hold(std::size_t i) {
        const bool varies = w_.frame_varies(frame_modes[i]);
        if (now_[i].text == before_[i].text || frame_modes[i] == Mode::mirror) return;
        if (!varies && (now_[i].number || !w_.says_frames_again())) return;
        const auto to = w_.frame_keeper(frame_modes[i]);
        if (!to) return w_.refuse(w_.here, "there is no parameter left for this frame");
        w_.assign(*to, now_[i]);
        before_[i] = unknown();  // the place is the same, what it holds is not
        if (!now_[i].number) now_[i] = *to;
    }

    std::string axis_word(Mode m) { return BlockWords(w_).spelt(std::string(1, "XYZ"[index(m)]), at(m), true); }

    void together() {
        const bool any = shifts_in(now_) || behind_turn();
        if (!any) return static_cast<void>(w_.say("frames.off", {}, "the end of a frame"));
        std::string axes;
        for (const Mode m : shift_modes)
            if (acts(now_, m)) axes += (axes.empty() ? "" : " ") + axis_word(m);
        if (axes.empty())
            w_.say("frames.off", {}, "the end of a frame");
        else
            w_.say("frames.shift", {{"axes", axes}}, "a shift");
        for (const Mode m : {Mode::turn, Mode::mirror, Mode::scale})
            if (acts(now_, m)) say(m);
    }

    void say(Mode m) {
        if (m == Mode::turn) return static_cast<void>(w_.say("frames.turn", values(m), "a rotation"));
        if (m == Mode::scale) return static_cast<void>(w_.say("frames.scale", values(m), "a scaling"));
        std::string axes;
        for (const char letter : at(m).text) axes += (axes.empty() ? "" : " ") + std::string(1, letter);
        w_.say("frames.mirror", {{"axes", axes}, {"zeros", zeros_of(at(m).text)}}, "a mirror image");
    }

    Places values(Mode m) {
        Text v = at(m);
        if (!w_.language.computes && !v.number) v = w_.atom(v, program::no_expr);
        const bool bare = v.number || v.level == Level::atom;
        return {{"value", v.text},
                {"signed", w_.language.sign && v.text[0] != '-' ? "+" + v.text : v.text},
                {"bracketed", bare ? v.text : w_.language.open + v.text + w_.language.close}};
    }

    [[nodiscard]] bool changed(Mode m) const { return now_[index(m)].text != before_[index(m)].text; }

    void one_by_one() {
        const bool shift = changes_shift();
        // Not every control lets the shift be changed while its axes are turned.
        const bool lift = shift && w_.language.shift_before_turn && acts(before_, Mode::turn);
        for (const Mode m : {Mode::turn, Mode::mirror, Mode::scale})
            if ((changed(m) && acts(before_, m) && !acts(now_, m)) || (m == Mode::turn && lift)) end(m);
        if (shift) say_shift();
        for (const Mode m : {Mode::turn, Mode::mirror, Mode::scale})
            if (acts(now_, m) && (changed(m) || (m == Mode::turn && lift))) say(m);
    }

    /// Of what the control has; that it lacks what ends here is said where it begins.
    void end(Mode m) {
        constexpr std::array begin{"frames.turn", "frames.mirror", "frames.scale"};
        const std::string key = begin[static_cast<std::size_t>(m) - static_cast<std::size_t>(Mode::turn)];
        if (w_.language.has(key)) w_.say(key + "-off", {{"zeros", zeros_of("XYZ")}}, "the end of a frame");
    }

    [[nodiscard]] std::string zeros_of(std::string_view axes) {
        std::string out;
        for (const char letter : axes)
            out += (out.empty() ? "" : " ") + BlockWords(w_).spelt(std::string(1, letter), w_.number_text(0), true);
        return out;
    }

    void say_shift() {
        std::string axes;
        for (const Mode m : shift_modes)
            if (changed(m)) axes += (axes.empty() ? "" : " ") + axis_word(m);
        w_.say("frames.shift", {{"axes", axes}}, "a shift");
        int n = 0;
        for (const Mode m : shift_modes)
            if (changed(m) && w_.language.has("frames.shift-axis"))
                w_.say("frames.shift-axis", {{"n", std::to_string(++n)}, {"axis", axis_word(m)}}, "a shift");
    }

    Writing& w_;
    Sums sums_;
    Parts before_, now_;
};

}  // namespace

void Writing::frame_cycle(const CycleDefinition& d) {
    FrameChange change(*this);
    if (change.begin()) change.cycle(d);
}

void Writing::frame(const program::FrameCall& call) {
    FrameChange change(*this);
    if (change.begin()) change.frame(call);
}

void Writing::frame_block(Modal m) {
    FrameChange change(*this);
    if (change.begin()) change.block(m);
}

}  // namespace obrys::rewrite
