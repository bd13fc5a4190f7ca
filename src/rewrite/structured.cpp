#include "rewrite/structured.hpp"

#include <algorithm>

#include "rewrite/graph.hpp"

namespace obrys::rewrite {

using program::StatementKind;
using program::Unit;
using Region = Structured::Region;

bool is_always(const Unit& unit, const program::Jump& jump) {
    if (jump.condition == program::no_expr) return true;
    const program::Expr& e = unit.exprs[jump.condition];
    if (e.kind != program::ExprKind::binary || static_cast<program::Operator>(e.op) != program::Operator::equal)
        return false;
    const auto number = [&](program::ExprId id) -> std::optional<double> {
        while (unit.exprs[id].kind == program::ExprKind::unary &&
               static_cast<program::Operator>(unit.exprs[id].op) == program::Operator::plus)
            id = unit.exprs[id].a;
        return unit.exprs[id].kind == program::ExprKind::number ? std::optional(unit.numbers[unit.exprs[id].a])
                                                                : std::nullopt;
    };
    const auto a = number(e.a), b = number(e.b);
    return a && a == b;  // FN 9: IF +0 EQU +0
}

namespace {

struct Found {
    std::uint32_t at = 0, to = 0;
    bool always = false, repeats = false;
};

bool opens(StatementKind k) {
    return k == StatementKind::if_ || k == StatementKind::while_ || k == StatementKind::loop_ ||
           k == StatementKind::repeat_ || k == StatementKind::for_ || k == StatementKind::repeat_count;
}
bool closes(StatementKind k) {
    return k == StatementKind::endif || k == StatementKind::endwhile || k == StatementKind::endloop ||
           k == StatementKind::until || k == StatementKind::endfor || k == StatementKind::end_repeat_count;
}

/// The program's own structures, which stay what they are; nothing where one of them has no end.
std::optional<std::vector<Region>> own_structures(const Unit& unit) {
    std::vector<Region> out;
    std::vector<std::size_t> open;
    for (std::uint32_t i = 0; i < unit.statements.size(); ++i) {
        const StatementKind k = unit.statements[i].kind;
        if (opens(k)) {
            open.push_back(out.size());
            out.push_back({i, i, k != StatementKind::if_, false, i, std::nullopt, false, true});
        } else if (open.empty() && (closes(k) || k == StatementKind::else_)) {
            return std::nullopt;
        } else if (k == StatementKind::else_) {
            out[open.back()].other = i;
        } else if (closes(k)) {
            out[open.back()].end = i + 1;
            open.pop_back();
        }
    }
    return open.empty() ? std::optional(std::move(out)) : std::nullopt;
}

/// Nothing where the program jumps in another way too.
std::optional<std::vector<Found>> jumps_of(const Unit& unit, const std::vector<Held>& held, const program::Names& names,
                                           const base::Sources& sources) {
    std::vector<Found> out;
    for (std::uint32_t i = 0; i < unit.statements.size(); ++i) {
        const StatementKind kind = unit.statements[i].kind;
        if (held[i][Mode::plane] == never_there) continue;
        const bool repeats =
            kind == StatementKind::label_call && unit.label_calls[entry_of(unit, i)].repeats != program::no_expr;
        if (repeats) {
            const std::uint32_t to = unit.label_calls[entry_of(unit, i)].target;
            if (to == program::no_target || to >= i) return std::nullopt;
            out.push_back({i, to, false, true});
        }
        if (kind == StatementKind::case_ || kind == StatementKind::repeat_section) return std::nullopt;
        if (kind != StatementKind::jump) continue;
        const program::Jump& jump = unit.jumps[entry_of(unit, i)];
        const auto to = destination(unit, i, jump, names, sources);
        if (!to) return std::nullopt;
        out.push_back({i, *to, is_always(unit, jump)});
    }
    return out;
}

/// The last of a few statements from `first` on that end the program, whatever holds; nothing where they do not.
std::optional<std::uint32_t> tail_from(const Unit& unit, std::uint32_t first) {
    constexpr std::uint32_t most = 12;
    for (std::uint32_t i = first; i < unit.statements.size() && i < first + most; ++i) {
        const StatementKind kind = unit.statements[i].kind;
        if (kind == StatementKind::return_) return entry_of(unit, i) == 0 ? std::optional(i) : std::nullopt;
        if (kind != StatementKind::block && kind != StatementKind::procedure) return std::nullopt;
        if (kind == StatementKind::block && ends_of(unit, i) != Ends::no) return i;
    }
    return std::nullopt;
}

/// Nothing is done behind it.
bool ends_way(const Unit& unit, std::uint32_t i) {
    return unit.statements[i].kind == StatementKind::return_ ||
           (unit.statements[i].kind == StatementKind::block && ends_of(unit, i) != Ends::no);
}

/// Takes the jumps to the program's ends out of the list.
Structured take_tails(const Unit& unit, std::vector<Found>& jumps) {
    Structured out;
    for (const Found& j : jumps)
        if (const auto last = j.repeats ? std::nullopt : tail_from(unit, j.to)) {
            out.tails[j.to] = *last;
            out.tails_of_jumps[j.at] = j.to;
            out.jumps[j.at] = {JumpRole::tail, 0};
        }
    std::erase_if(jumps, [&](const Found& j) { return out.jumps.contains(j.at); });
    for (const auto& [first, last] : out.tails)
        if (first > 0 && ends_way(unit, first - 1))
            for (std::uint32_t i = first; i <= last; ++i) out.only_jumped_to.insert(i);
    return out;
}

class Structuring {
public:
    explicit Structuring(std::vector<Region> own) { out_.regions = std::move(own); }

    std::optional<Structured> run(const std::vector<Found>& jumps) {
        for (const Found& j : jumps)
            if (j.to <= j.at) loop(j);
        for (const Found& j : jumps)
            if (j.to > j.at + 1 && !j.always && !leave(j)) branch(j);
        for (const Found& j : jumps)
            if (j.to > j.at + 1 && j.always && !leave(j) && !other(j)) return std::nullopt;
        for (const Found& j : jumps)
            if (j.to == j.at + 1) out_.jumps[j.at] = {JumpRole::none, 0};
        if (!lie_within_each_other()) return std::nullopt;
        return std::move(out_);
    }

private:
    void loop(const Found& j) {
        const JumpRole role = j.repeats ? JumpRole::repeat : j.always ? JumpRole::end_loop : JumpRole::again;
        out_.jumps[j.at] = {role, out_.regions.size()};
        out_.regions.push_back({j.to, j.at + 1, true, j.always || j.repeats, j.at, std::nullopt, j.repeats});
    }
    void branch(const Found& j) {
        out_.jumps[j.at] = {JumpRole::branch, out_.regions.size()};
        out_.regions.push_back({j.at + 1, j.to, false, false, j.at});
    }
    /// Out of the innermost loop around it, to behind it.
    bool leave(const Found& j) {
        std::optional<std::size_t> innermost;
        for (std::size_t r = 0; r < out_.regions.size(); ++r) {
            const Region& region = out_.regions[r];
            if (!region.loop || j.at < region.begin || j.at >= region.end) continue;
            if (!innermost || region.end - region.begin < out_.regions[*innermost].end - out_.regions[*innermost].begin)
                innermost = r;
        }
        if (!innermost || out_.regions[*innermost].end != j.to) return false;
        out_.jumps[j.at] = {JumpRole::leave, *innermost};
        return true;
    }
    /// The last statement of a branch passes by what is done where its condition does not hold.
    bool other(const Found& j) {
        for (std::size_t r = 0; r < out_.regions.size(); ++r) {
            Region& region = out_.regions[r];
            if (region.own || region.loop || region.other || region.end != j.at + 1 || region.begin > j.at) continue;
            region.other = j.at;
            region.end = j.to;
            out_.jumps[j.at] = {JumpRole::other, r};
            return true;
        }
        return false;
    }
    [[nodiscard]] bool lie_within_each_other() const {
        for (const Region& a : out_.regions)
            for (const Region& b : out_.regions) {
                const bool apart = a.end <= b.begin || b.end <= a.begin;
                const bool inside = a.begin >= b.begin && a.end <= b.end, around = b.begin >= a.begin && b.end <= a.end;
                if (!apart && !inside && !around) return false;
                // Within a branch with an ELSE, on one side of it.
                if (&a != &b && inside && b.other && a.begin <= *b.other && a.end > *b.other) return false;
                // A jump into a loop.
                if (a.loop && !b.loop && b.jump < a.begin && b.end > a.begin && b.end < a.end) return false;
                // A branch that goes on behind its loop begins outside of it.
                if (&a != &b && a.loop && !b.loop && b.jump >= a.begin && b.jump < a.end && b.end >= a.end)
                    return false;
            }
        return true;
    }

    Structured out_;
};

}  // namespace

std::optional<Structured> structured(const Unit& unit, const std::vector<Held>& held, const program::Names& names,
                                     const base::Sources& sources) {
    const auto jumps = jumps_of(unit, held, names, sources);
    constexpr std::size_t most = 2000;
    if (!jumps || jumps->size() > most) return std::nullopt;
    auto own = own_structures(unit);
    if (!own || (own->size() > 0 && (jumps->empty() || own->size() + jumps->size() > most))) return std::nullopt;
    if (auto whole = Structuring(*own).run(*jumps)) return whole;
    std::vector<Found> others = *jumps;
    Structured tails = take_tails(unit, others);
    auto out = tails.jumps.empty() ? std::nullopt : Structuring(std::move(*own)).run(others);
    if (!out) return std::nullopt;
    out->jumps.merge(tails.jumps);
    out->tails = std::move(tails.tails);
    out->tails_of_jumps = std::move(tails.tails_of_jumps);
    out->only_jumped_to = std::move(tails.only_jumped_to);
    return out;
}

}  // namespace obrys::rewrite
