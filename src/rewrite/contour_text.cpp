/// Contours in labels: read from their blocks, turned round, and what lies beside their ends.

#include "rewrite/contour_text.hpp"

#include <algorithm>
#include <cmath>

#include "rewrite/block_words.hpp"

namespace obrys::rewrite {

using program::Code;
using program::Modal;

Text Sums::plus(const Text& a, const Text& b) {
    if (a.number && b.number) return w_.number_text(*a.number + *b.number);
    if (a.number == 0.0) return b;
    if (b.number == 0.0) return a;
    if (b.number && *b.number < 0) return minus(a, w_.number_text(-*b.number));
    if (b.level == Level::sign && b.text[0] == '-') return minus(a, {b.text.substr(1), Level::atom, std::nullopt});
    return w_.joined("operators.add", a, b, Level::sum);
}

Text Sums::minus(const Text& a, const Text& b) {
    if (a.number && b.number) return w_.number_text(*a.number - *b.number);
    if (b.number == 0.0) return a;
    if (b.number && *b.number < 0) return plus(a, w_.number_text(-*b.number));
    return w_.joined("operators.subtract", a, b, Level::sum);
}

Text Sums::times(const Text& a, const Text& b) {
    if (a.number && b.number) return w_.number_text(*a.number * *b.number);
    if (a.number == 1.0 || b.number == 1.0) return a.number == 1.0 ? b : a;
    if (a.number == 0.0 || b.number == 0.0) return w_.number_text(0);
    if (b.number == -1.0) return minus(w_.number_text(0), a);
    return w_.joined("operators.multiply", a, b, Level::product);
}

Text Sums::through(const Text& a, const Text& b) {
    if (a.number && b.number && *b.number != 0) return w_.number_text(*a.number / *b.number);
    if (b.number == 1.0 || a.number == 0.0) return a;
    return w_.joined("operators.divide", a, b, Level::product);
}

Text Sums::root(const Text& a, const Text& b) {
    if (a.number && b.number) return w_.number_text(std::hypot(*a.number, *b.number));
    const std::string* root = w_.language.find("functions.sqrt");
    if (root == nullptr) {
        w_.refuse(w_.here, "the control has no square root");
        return w_.number_text(1);
    }
    return {filled(*root, {{"a", plus(times(a, a), times(b, b)).text}}), Level::atom, std::nullopt};
}

ContourText ContourText::reversed() const {
    ContourText out;
    out.from = parts.empty() ? from : parts.back().to;
    out.side = -side;
    for (std::size_t i = parts.size(); i-- > 0;) {
        ContourPart part = parts[i];
        part.to = start_of(i);
        part.clockwise = !part.clockwise;
        part.round = i > 0 ? parts[i - 1].round : std::nullopt;
        part.chamfer = i > 0 ? parts[i - 1].chamfer : std::nullopt;
        out.parts.push_back(std::move(part));
    }
    return out;
}

Place beside(Writing& w, const ContourText& contour, bool at_end, const Text& away) {
    Sums s(w);
    const std::size_t at = at_end ? contour.parts.size() - 1 : 0;
    const ContourPart& part = contour.parts[at];
    const Place& from = contour.start_of(at);
    const Place& here = at_end ? part.to : from;
    // To the left of the way, as long as `size`.
    Place left{s.minus(from.v, part.to.v), s.minus(part.to.u, from.u)};
    if (part.is_arc) left = {s.minus(part.centre.u, here.u), s.minus(part.centre.v, here.v)};
    const bool turned = (part.is_arc && part.clockwise) != (contour.side < 0);
    const Text size = s.root(left.u, left.v);
    const auto shifted = [&](const Text& coordinate, const Text& component) {
        const Text share = s.through(component, size);
        const bool back = turned != (share.number && *share.number < 0);
        const Text by = s.times(away, share.number ? w.number_text(std::abs(*share.number)) : share);
        return back ? s.minus(coordinate, by) : s.plus(coordinate, by);
    };
    return contour.side == 0 ? here : Place{shifted(here.u, left.u), shifted(here.v, left.v)};
}

namespace {

/// Reads the blocks of a contour one after the other.
class ContourReader {
public:
    ContourReader(Writing& w, ContourText& out) : w_(w), sums_(w), out_(out) {}

    /// False after a complaint.
    bool take(std::uint32_t statement) {
        block_ = {};
        const Unit& unit = *w_.unit;
        if (unit.statements[statement].kind != StatementKind::block) return refuse("stands in the contour");
        for (std::uint32_t i = unit.statements[statement].first; i < unit.words_end(statement); ++i)
            if (!word(unit.words[i])) return false;
        return finish();
    }

private:
    struct Block {
        std::optional<Place> pole{};
        std::optional<Text> u, v, radius, round, chamfer;
        bool u_counts_on = false, v_counts_on = false;
        bool is_pole = false, about_pole = false, is_arc = false;
        std::optional<bool> clockwise{};
    };

    bool refuse(const std::string& what) {
        w_.refuse(w_.here, w_.source(w_.here) + ": " + what + ": it is not translated by structure",
                  "write the contour with straight blocks, arcs about a pole, roundings and chamfers alone");
        return false;
    }

    bool modal(Modal m) {
        switch (m) {
            case Modal::compensation_left:
            case Modal::compensation_right:
                if (out_.side == 0) out_.side = m == Modal::compensation_left ? 1 : -1;
                return true;
            case Modal::compensation_off:
            case Modal::linear:
            case Modal::rapid:
            case Modal::absolute:
            case Modal::paraxial: return true;
            case Modal::arc_same_sense: return block_.is_arc = true;
            case Modal::arc_cw:
            case Modal::arc_ccw: block_.clockwise = m == Modal::arc_cw; return block_.is_arc = true;
            case Modal::pole_given: return block_.is_pole = true;
            default: return refuse("a word of the contour has no counterpart");
        }
    }

    bool word(const program::Word& word) {
        const Code code = program::code_of(word);
        if (code == Code::modal) return modal(program::modal_of(word));
        if (code == Code::comment || code == Code::act || code == Code::feed) return true;
        if (code == Code::centre_at_pole) return block_.about_pole = true;
        const bool computed = program::form_of(word) == program::Form::expression;
        if (!computed && !program::is_literal(word)) return refuse("a word of the contour has no counterpart");
        const ExprId id = computed ? static_cast<ExprId>(word.payload) : program::no_expr;
        if (computed && reads_own(id)) return refuse("the contour reads parameters that its program has for itself");
        const Text value = computed ? w_.value(id) : w_.number_text(w_.unit->literal(word));
        const bool counts_on = computed && w_.unit->exprs[id].kind == ExprKind::qualified;
        if (counts_on && static_cast<program::Reference>(w_.unit->exprs[id].op) != program::Reference::incremental)
            return refuse("this way of giving a coordinate");
        switch (code) {
            case Code::x: block_.u = value, block_.u_counts_on = counts_on; return true;
            case Code::y: block_.v = value, block_.v_counts_on = counts_on; return true;
            case Code::radius: block_.radius = value; return true;
            case Code::round: block_.round = value; return true;
            case Code::chamfer_leg: block_.chamfer = value; return true;
            default: return refuse("a word of the contour has no counterpart");
        }
    }

    /// Of its own program: not to be seen from the one that the contour is written into.
    bool reads_own(ExprId id) {
        const Expr& e = w_.unit->exprs[id];
        if (e.kind == ExprKind::parameter) return is_local(*w_.unit->traits, e.a);
        if (e.kind == ExprKind::unary || e.kind == ExprKind::qualified) return reads_own(e.a);
        if (e.kind == ExprKind::binary) return reads_own(e.a) || reads_own(e.b);
        if (e.kind != ExprKind::function) return e.kind == ExprKind::variable;
        for (std::size_t k = 0; k < e.count; ++k)
            if (reads_own(w_.unit->children[e.b + k])) return true;
        return false;
    }

    [[nodiscard]] bool has_place() const { return block_.u || block_.v; }
    [[nodiscard]] const Place& last() const { return out_.parts.empty() ? out_.from : out_.parts.back().to; }

    Place target() {
        Place to = last();
        if (block_.u) to.u = block_.u_counts_on ? sums_.plus(to.u, *block_.u) : *block_.u;
        if (block_.v) to.v = block_.v_counts_on ? sums_.plus(to.v, *block_.v) : *block_.v;
        return to;
    }

    bool finish() {
        if (block_.is_pole) return pole();
        if (!has_place()) return block_.round || block_.chamfer ? refuse("a corner without its element") : true;
        if (!begun_) return begin();
        ContourPart part;
        part.to = target();
        part.is_arc = block_.is_arc;
        part.round = block_.round, part.chamfer = block_.chamfer;
        if (part.is_arc && !arc(part)) return false;
        out_.parts.push_back(std::move(part));
        return true;
    }

    bool begin() {
        if (block_.is_arc || !block_.u || !block_.v || block_.u_counts_on || block_.v_counts_on)
            return refuse("a contour begins with a straight block that says both coordinates");
        if (block_.round || block_.chamfer) return refuse("a corner at the contour's first point");
        out_.from = {*block_.u, *block_.v};
        return begun_ = true;
    }

    bool pole() {
        if (!block_.u || !block_.v || block_.u_counts_on || block_.v_counts_on)
            return refuse("a pole that is not given by both coordinates");
        pole_ = Place{*block_.u, *block_.v};
        return true;
    }

    bool arc(ContourPart& part) {
        if (block_.clockwise) clockwise_ = block_.clockwise;
        if (!clockwise_) return refuse("an arc without its sense (DR)");
        part.clockwise = *clockwise_;
        if (block_.about_pole && pole_) {
            part.centre = *pole_;
            return true;
        }
        return block_.radius ? by_radius(part) : refuse("an arc without a centre");
    }

    /// The centre of an arc whose ends and radius are numbers.
    bool by_radius(ContourPart& part) {
        const Place& from = last();
        const bool known = from.u.number && from.v.number && part.to.u.number && part.to.v.number;
        if (!known || !block_.radius->number) return refuse("an arc by its radius whose ends are computed");
        const double du = *part.to.u.number - *from.u.number, dv = *part.to.v.number - *from.v.number;
        const double radius = *block_.radius->number, chord = std::hypot(du, dv);
        const double square = radius * radius - chord * chord / 4;
        if (chord == 0 || square < 0) return refuse("an arc that its radius does not reach");
        const double height = std::sqrt(square) * ((radius > 0) != part.clockwise ? 1 : -1);
        part.centre = {w_.number_text(*from.u.number + du / 2 - height * dv / chord),
                       w_.number_text(*from.v.number + dv / 2 + height * du / chord)};
        return true;
    }

    Writing& w_;
    Sums sums_;
    ContourText& out_;
    Block block_;
    std::optional<Place> pole_;
    std::optional<bool> clockwise_;
    bool begun_ = false;
};

}  // namespace

std::optional<ContourText> Writing::contour_text(const Unit& of, const Range& range) {
    const Unit* const was = unit;
    const std::uint32_t was_at = at;
    const base::Span was_here = here;
    unit = &of;
    ContourText out;
    ContourReader reader(*this, out);
    bool good = true;
    for (std::uint32_t i = range.first; good && i < range.last; ++i) {
        at = i, here = of.span(of.statements[i]);
        good = reader.take(i);
    }
    unit = was, at = was_at, here = was_here;
    if (good && out.parts.empty()) {
        refuse(here, "the contour has no element");
        good = false;
    }
    return good ? std::optional(out) : std::nullopt;
}

std::string Writing::contour_blocks(const ContourText& contour, const std::string& feed) {
    std::string out;
    BlockWords words(*this);
    for (const ContourPart& part : contour.parts) {
        const auto axis = [&](char letter, const Text& v) { return words.spelt(std::string(1, letter), v, true); };
        std::string corner;
        for (const auto& [key, value] :
             {std::pair("words.round", part.round), std::pair("words.chamfer-leg", part.chamfer)})
            if (value) corner = words.corner(key, *value);
        const std::string centre = part.is_arc ? words.absolute_centre(part.centre.u, part.centre.v) : "";
        const std::string_view key = !part.is_arc ? "words.linear" : part.clockwise ? "words.arc-cw" : "words.arc-ccw";
        out += filled(*language.find(key), {{"axes", axis('X', part.to.u) + " " + axis('Y', part.to.v)},
                                            {"centre", centre},
                                            {"corner", corner},
                                            {"feed", feed}}) +
               "\n";
    }
    return out;
}

}  // namespace obrys::rewrite
