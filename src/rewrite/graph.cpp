#include "rewrite/graph.hpp"

#include <algorithm>

#include "base/number.hpp"
#include "base/text.hpp"

namespace obrys::rewrite {

using program::Jump;
using program::JumpDirection;
using program::StatementKind;
using program::Unit;

std::size_t entry_of(const Unit& unit, std::uint32_t statement) {
    const std::uint32_t first = unit.statements[statement].first;
    return first < unit.words_end(statement) ? static_cast<std::size_t>(unit.words[first].payload) : 0;
}

Ends ends_of(const Unit& unit, std::uint32_t statement) {
    if (unit.statements[statement].kind != StatementKind::block) return Ends::no;
    for (std::uint32_t w = unit.statements[statement].first; w < unit.words_end(statement); ++w) {
        const program::Word& word = unit.words[w];
        if (program::code_of(word) != program::Code::m || !program::is_literal(word)) continue;
        const double m = unit.literal(word);
        if (m == 2 || m == 30) return Ends::program;
        if (m == 17) return Ends::call;
    }
    return Ends::no;
}

std::optional<std::uint32_t> labelled(const Unit& unit, std::uint32_t from, program::NameId name,
                                      JumpDirection direction) {
    const auto found = unit.labels.find(name);
    if (found == unit.labels.end() || found->second.empty()) return std::nullopt;
    const std::vector<std::uint32_t>& at = found->second;
    const auto after = std::upper_bound(at.begin(), at.end(), from);
    if (direction != JumpDirection::backward && after != at.end()) return *after;
    if (direction == JumpDirection::forward || (direction == JumpDirection::backward && after == at.begin()))
        return std::nullopt;
    return direction == JumpDirection::backward ? *std::prev(after) : at.front();
}

namespace {

/// Of a jump to a block number that no table holds: the first behind `from`, else the first of all.
std::optional<std::uint32_t> numbered(const Unit& unit, std::uint32_t from, std::int64_t number,
                                      JumpDirection direction, const base::Sources& sources) {
    std::optional<std::uint32_t> before, first;
    for (std::uint32_t i = 0; i < unit.statements.size(); ++i) {
        if ((unit.statements[i].flags & program::line_start) == 0) continue;
        if (sources.block_number(unit.file, unit.statements[i].begin) != number) continue;
        if (i > from && direction != JumpDirection::backward) return i;
        if (!first) first = i;
        if (i <= from) before = i;
    }
    return direction == JumpDirection::forward ? std::nullopt : direction == JumpDirection::backward ? before : first;
}

std::string text_of(const Unit& unit, program::ExprId e) {
    if (e == program::no_expr) return {};
    const program::Expr& x = unit.exprs[e];
    if (x.kind == program::ExprKind::text) return unit.texts[x.a];
    return x.kind == program::ExprKind::number ? "N" + base::shortest(unit.numbers[x.a]) : "";
}

}  // namespace

std::optional<std::uint32_t> destination(const Unit& unit, std::uint32_t from, const Jump& jump,
                                         const program::Names& names, const base::Sources& sources) {
    if (jump.direction == JumpDirection::start) return std::nullopt;
    if (jump.target != program::no_target) return jump.target;
    const std::string name = base::to_upper(text_of(unit, jump.destination));
    if (name.empty()) return std::nullopt;
    if (const auto id = names.find(name))
        if (const auto at = labelled(unit, from, *id, jump.direction)) return at;
    const auto n = name[0] == 'N' ? base::parse_integer(std::string_view(name).substr(1)) : std::nullopt;
    if (!n || !unit.traits->jump_to_block_number) return std::nullopt;
    return numbered(unit, from, *n, jump.direction, sources);
}

std::optional<Range> called_range(const Unit& unit, const program::LabelCall& call) {
    if (call.target == program::no_target || call.repeats != program::no_expr) return std::nullopt;
    for (std::uint32_t i = call.target; i < unit.statements.size(); ++i)
        if (unit.statements[i].kind == StatementKind::label_end) return Range{call.target, i};
    return std::nullopt;
}

std::optional<Range> repeated_range(const Unit& unit, std::uint32_t statement, const program::Section& s) {
    const auto place = [&](program::NameId label) {
        const auto back = labelled(unit, statement, label, JumpDirection::backward);
        return back ? back : labelled(unit, statement, label, JumpDirection::forward);
    };
    const auto first = place(s.first);
    std::optional<std::uint32_t> last = first;
    if (s.to_here) last = statement - 1;
    if (!s.to_here && !s.one_block) last = place(s.last);
    if (!first || !last || *last < *first) return std::nullopt;
    while (!s.to_here && *last + 1 < unit.statements.size() &&
           (unit.statements[*last + 1].flags & program::line_start) == 0)
        ++*last;
    return Range{*first, *last};
}

namespace {

void branches(const Unit& unit, std::uint32_t i, std::vector<std::uint32_t>& next) {
    const std::uint32_t target = unit.branches[entry_of(unit, i)].target;
    const auto to = std::min(target, static_cast<std::uint32_t>(unit.statements.size()));
    switch (unit.statements[i].kind) {
        case StatementKind::if_:
        case StatementKind::while_:
        case StatementKind::until:
        case StatementKind::repeat_count: next = {i + 1, to}; break;
        case StatementKind::end_repeat_count: next = {i + 1, to + 1}; break;
        case StatementKind::else_:
        case StatementKind::endwhile:
        case StatementKind::endloop: next = {to}; break;
        default: break;
    }
}

void loops(const Unit& unit, std::uint32_t i, std::vector<std::uint32_t>& next) {
    const std::uint32_t target = unit.fors[entry_of(unit, i)].target;
    if (target != program::no_target) next = {i + 1, target + 1};
}

}  // namespace

Graph graph_of(const Unit& unit, const program::Names& names, const base::Sources& sources) {
    Graph g;
    const auto n = static_cast<std::uint32_t>(unit.statements.size());
    g.next.resize(n);
    std::vector<std::uint32_t> behind_calls;
    for (std::uint32_t i = 0; i < n; ++i)
        if (unit.statements[i].kind == StatementKind::label_call) behind_calls.push_back(i + 1);
    const auto jump_from = [&](std::uint32_t i, const Jump& jump) {
        if (const auto to = destination(unit, i, jump, names, sources)) {
            g.next[i].push_back(*to);
            g.jumped_to.insert(*to);
        }
    };
    for (std::uint32_t i = 0; i < n; ++i) {
        std::vector<std::uint32_t>& next = g.next[i];
        next = {i + 1};
        const std::size_t entry = entry_of(unit, i);
        switch (unit.statements[i].kind) {
            case StatementKind::block:
                if (ends_of(unit, i) != Ends::no) next = {n};
                break;
            case StatementKind::jump:
                if (unit.jumps[entry].condition == program::no_expr) next.clear();
                jump_from(i, unit.jumps[entry]);
                break;
            case StatementKind::case_:
                for (const program::CaseArm& arm : unit.cases[entry].arms) jump_from(i, arm.jump);
                break;
            case StatementKind::for_:
            case StatementKind::endfor: loops(unit, i, next); break;
            case StatementKind::return_: next = {n}; break;
            case StatementKind::label_call:
                if (unit.label_calls[entry].target != program::no_target)
                    next.push_back(unit.label_calls[entry].target);
                break;
            case StatementKind::label_end: next.insert(next.end(), behind_calls.begin(), behind_calls.end()); break;
            case StatementKind::repeat_section:
                if (const auto r = repeated_range(unit, i, unit.sections[entry])) {
                    next.push_back(r->first);
                    if (r->last < i) g.next[r->last].push_back(i + 1);
                }
                break;
            case StatementKind::if_:
            case StatementKind::else_:
            case StatementKind::while_:
            case StatementKind::endwhile:
            case StatementKind::until:
            case StatementKind::endloop:
            case StatementKind::repeat_count:
            case StatementKind::end_repeat_count: branches(unit, i, next); break;
            default: break;
        }
    }
    return g;
}

}  // namespace obrys::rewrite
