/// Blocks: what their words say, gathered.

#include <algorithm>
#include <cmath>

#include "base/whole.hpp"
#include "rewrite/block_words.hpp"

namespace obrys::rewrite {

using program::Code;
using program::Modal;

namespace {

/// The word of a block that changes the frame.
std::optional<Modal> frame_of(const Unit& unit, std::uint32_t statement) {
    for (std::uint32_t w = unit.statements[statement].first; w < unit.words_end(statement); ++w) {
        if (program::code_of(unit.words[w]) != Code::modal) continue;
        const Modal m = program::modal_of(unit.words[w]);
        if (m == Modal::local_shift || m == Modal::rotation_on || m == Modal::rotation_off) return m;
    }
    return std::nullopt;
}

bool has_later_assign(const Unit& unit, std::uint32_t w, std::uint32_t end) {
    for (++w; w < end; ++w)
        if (program::code_of(unit.words[w]) == Code::assign) return true;
    return false;
}

}  // namespace

Text BlockWords::across(const Text& v, bool source_across) {
    if (source_across == w_.language.across) return v;
    const double factor = source_across ? 0.5 : 2;
    if (v.number) return w_.number_text(*v.number * factor);
    return source_across ? w_.joined("operators.divide", v, w_.number_text(2), Level::product)
                         : w_.joined("operators.multiply", w_.number_text(2), v, Level::product);
}

void BlockWords::axis(char letter, ExprId id, const Text& given) {
    const Expr* e = id == program::no_expr ? nullptr : &w_.unit->exprs[id];
    Axis axis{letter, given, false};
    int distance = w_.held()[Mode::distance];
    if (distance_) distance = *distance_ == Modal::incremental ? 1 : 0;
    bool known = distance != several;
    axis.incremental = distance == 1;
    int source_across = w_.held()[Mode::across];
    if (e != nullptr && e->kind == ExprKind::qualified) {
        const auto r = static_cast<program::Reference>(e->op);
        known = r == program::Reference::absolute || r == program::Reference::incremental;
        axis.incremental = r == program::Reference::incremental;
        if (!known)
            return w_.refuse(
                w_.here, w_.source(w_.span(id)) + ": this way of giving a coordinate is not translated by structure");
    }
    if (!known)
        return w_.refuse(w_.here, "whether coordinates are absolute here depends on the way that the run has come",
                         "write G90 or G91 in this block");
    if (letter == 'X' && source_across == several)
        return w_.refuse(w_.here, "whether X is a diameter here depends on the way that the run has come",
                         "write DIAMON or DIAMOF in this block");
    if (letter == 'X') axis.value = across(axis.value, source_across == 1);
    axes_.push_back(axis);
}

void BlockWords::modal(const program::Word& word) {
    const Modal m = program::modal_of(word);
    switch (m) {
        case Modal::rapid:
        case Modal::linear:
        case Modal::arc_cw:
        case Modal::arc_ccw: motion_ = m; return;
        case Modal::arc_same_sense: same_sense_ = true; return;
        case Modal::pole_given: is_pole_ = true; return;
        case Modal::paraxial: {
            const int said = program::modal_number(word);
            const bool rapid = (said & program::paraxial_rapid) != 0;
            if ((said & (program::paraxial_rapid | program::paraxial_feed)) == 0) return;  // by another word
            motion_ = rapid ? Modal::rapid : Modal::linear;
            return;
        }
        case Modal::dwell: dwell_ = true; return;
        case Modal::plane_xy:
        case Modal::plane_zx:
        case Modal::plane_yz: plane_ = m; return;
        case Modal::absolute:
        case Modal::incremental: distance_ = m; return;
        case Modal::feed_per_minute:
        case Modal::feed_per_rev: feed_mode_ = m; return;
        case Modal::surface_speed_on:
        case Modal::surface_speed_off: surface_ = m; return;
        case Modal::compensation_left:
        case Modal::compensation_right:
        case Modal::compensation_off: compensation_ = m; return;
        case Modal::datum: datum_ = program::modal_number(word); return;
        case Modal::tool_length: length_ = true; return;
        case Modal::tool_length_off: length_off_ = true; return;
        case Modal::suppress_all:
            // Elsewhere the tip goes there (SUPA): G53 of the others leads what holds the tool.
            if (program::modal_number(word) == program::position_ignored || !holder_goes() ||
                !w_.language.has("words.machine-rapid"))
                break;
            machine_ = true;
            return;
        case Modal::program_stop: m_.push_back(stop_alone); return;
        case Modal::diameter_on:
        case Modal::diameter_off:
        case Modal::metric_geometry:
        case Modal::metric_all:
        case Modal::canned_off:
        case Modal::position_reset:
        case Modal::arc_centre_incremental:
        case Modal::retract_initial: return;
        case Modal::path_exact: return joining("path.exact");
        case Modal::exact_stop:
        case Modal::path_stop: return joining("path.exact-stop");
        case Modal::path_blend: return joining("path.free");
        case Modal::continuous: return joining(program::modal_number(word) == 64 ? "path.free" : "");
        case Modal::exact_stop_block:
            return w_.tell(word_, w_.source(word_) + ": that the control stops exactly behind this block is left out");
        case Modal::corner_arc:
        case Modal::approach_normal:
            return w_.tell(word_, w_.source(word_) + ": how moves are joined is as the control has it");
        default: break;
    }
    w_.refuse(word_, w_.source(word_) + " is not translated by structure",
              "translate without --keep: its moves are written then");
}

/// How moves are joined, for a control that says both that and that they are not.
void BlockWords::joining(std::string_view key) {
    if (w_.language.has("path.exact") && w_.language.has(key))
        static_cast<void>(w_.say(key, {}, "how moves are joined"));
    else
        w_.tell(word_, w_.source(word_) + ": how moves are joined is as the control has it");
}

void BlockWords::gather() {
    const Unit& unit = *w_.unit;
    const std::uint32_t end = unit.words_end(w_.at);
    if (const auto frame = frame_of(unit, w_.at)) {
        frame_ = frame;
        return;
    }
    // It holds for all coordinates of its block, wherever it stands in it.
    for (std::uint32_t i = unit.statements[w_.at].first; i < end && !distance_; ++i)
        if (program::code_of(unit.words[i]) == Code::modal) {
            const Modal m = program::modal_of(unit.words[i]);
            if (m == Modal::absolute || m == Modal::incremental) distance_ = m;
        }
    std::vector<std::pair<Text, Text>> together;
    for (std::uint32_t i = unit.statements[w_.at].first; i < end; ++i) {
        const program::Word& word = unit.words[i];
        const Code code = program::code_of(word);
        word_ = unit.span(unit.statements[w_.at], word);
        if (code == Code::modal) {
            modal(word);
            continue;
        }
        if (code == Code::assign) {
            const program::Assign& a = unit.assigns[static_cast<std::size_t>(word.payload)];
            const auto to = w_.target_of(a.target);
            const Text from = w_.of_type(a.target, w_.value(a.value), a.value);
            const bool later = unit.traits->assigns_together && end - unit.statements[w_.at].first > 1;
            if (to && later) {
                const Text held = from.number ? from : w_.place_for(a.value);
                if (!from.number) w_.assign(held, from);
                together.emplace_back(*to, held);
            } else if (to) {
                w_.assign(*to, from);
            }
            continue;
        }
        if (code == Code::act || code == Code::comment) continue;
        const bool literal = program::is_literal(word), bare = program::form_of(word) == program::Form::bare;
        const ExprId id =
            program::form_of(word) == program::Form::expression ? static_cast<ExprId>(word.payload) : program::no_expr;
        Text v = literal ? w_.number_text(unit.literal(word)) : id != program::no_expr ? w_.value(id) : Text{};
        if (!literal && !bare && id == program::no_expr) {
            w_.refuse(word_, w_.source(word_) + " is not translated by structure");
            continue;
        }
        if (!v.number && id != program::no_expr && has_later_assign(unit, i, end) && !unit.traits->assigns_together) {
            const Text held = w_.place_for(id);  // as it is before this block's assignments
            w_.assign(held, v);
            v = held;
        }
        take(code, id, v);
    }
    for (const auto& [to, from] : together) w_.assign(to, from);
}

void BlockWords::take(Code code, ExprId id, const Text& v) {
    constexpr std::string_view letters = "XYZABCUVW";
    switch (code) {
        case Code::i:
        case Code::j:
        case Code::k:
            if (id != program::no_expr && w_.unit->exprs[id].kind == ExprKind::qualified) {
                const auto reference = static_cast<program::Reference>(w_.unit->exprs[id].op);
                if (reference != program::Reference::absolute) break;
                centre_counts_on_ = false;
            }
            centre_.emplace_back(static_cast<std::size_t>(code) - static_cast<std::size_t>(Code::i), v);
            return;
        case Code::radius: radius_ = v; return;
        case Code::centre_at_pole: about_pole_ = true; return;
        case Code::round: corner_ = {"words.round", v}; return;
        case Code::chamfer_leg: corner_ = {"words.chamfer-leg", v}; return;
        case Code::chamfer_length: corner_ = {"words.chamfer", v}; return;
        case Code::feed: feed_ = v; return;
        case Code::spindle: speed_ = v; return;
        case Code::speed_limit: limit_ = v; return;
        case Code::tool: tool_ = v; return;
        case Code::tool_definition: prepares_ = true; return;
        case Code::edge: edge_ = v; return;
        case Code::tool_change:
            change_ = true;
            if (v.number) tool_ = v, joined_offset_ = true;
            return;
        case Code::cycle_call: call_cycle_ = true; return;
        case Code::p: dwell_time_ = v; return;
        case Code::offset_h: offset_ = v; return;
        case Code::offset_d: radius_offset_ = v; return;
        case Code::m:
            if (const auto n = v.number ? base::whole<int>(*v.number, 0, 999) : std::nullopt) return m_.push_back(*n);
            break;
        default:
            if (code <= Code::w) return axis(letters[static_cast<std::size_t>(code)], id, v);
            break;
    }
    w_.refuse(word_, w_.source(word_) + " is not translated by structure",
              "translate without --keep: its moves are written then");
}

}  // namespace obrys::rewrite
