#include "interp/calls/endless.hpp"

#include <algorithm>
#include <set>
#include <vector>

#include "interp/calls/calls.hpp"

namespace obrys::interp {

using program::Code;
using program::Expr;
using program::ExprId;
using program::ExprKind;
using program::Statement;
using program::StatementKind;
using program::Unit;

namespace {

/// Numbered parameters and variables, by the kind and number of their expressions.
using Names = std::set<std::pair<ExprKind, std::uint32_t>>;

/// Adds what an expression asks for; false where that cannot be told from the text.
bool add_asked(const Unit& unit, ExprId id, Names& asked) {
    if (id == program::no_expr) return true;
    const Expr& e = unit.exprs[id];
    const auto children = [&] {
        for (std::uint32_t i = 0; i < e.count; ++i)
            if (!add_asked(unit, unit.children[e.b + i], asked)) return false;
        return true;
    };
    switch (e.kind) {
        case ExprKind::number:
        case ExprKind::boolean:
        case ExprKind::text: return true;
        case ExprKind::parameter: asked.insert({e.kind, e.a}); return !program::is_of_control(*unit.traits, e.a);
        case ExprKind::variable: asked.insert({e.kind, e.a}); return children();
        case ExprKind::unary: return add_asked(unit, e.a, asked);
        case ExprKind::binary: return add_asked(unit, e.a, asked) && add_asked(unit, e.b, asked);
        case ExprKind::function: return e.op != static_cast<std::uint8_t>(program::Function::file_exists) && children();
        default: return false;
    }
}

std::size_t table_of(const Unit& unit, const Statement& s) {
    return static_cast<std::size_t>(unit.words[s.first].payload);
}

/// What the statements of a loop do to its end.
class Body {
public:
    Body(const Unit& unit, const Loop& loop) : unit_(unit), loop_(loop) {}

    /// False where it holds something that may change anything.
    [[nodiscard]] bool read() {
        for (std::uint32_t i = loop_.first; i <= loop_.last; ++i)
            if (!statement(i)) return false;
        return true;
    }
    /// The statement that asks whether the loop goes on; the last one where nothing does.
    [[nodiscard]] std::uint32_t condition() const {
        return unit_.statements[loop_.last].kind == StatementKind::endwhile ? loop_.first : loop_.last;
    }
    /// What its end depends on; nothing where that cannot be told.
    [[nodiscard]] std::optional<Names> asked() const {
        Names names;
        const std::uint32_t own = condition();
        for (const auto& [at, expr] : conditions_)
            if ((leaves_ || at == own) && !add_asked(unit_, expr, names)) return std::nullopt;
        return names;
    }
    [[nodiscard]] bool changes(const Names& asked) const {
        const auto is_parameter = [](const auto& name) { return name.first == ExprKind::parameter; };
        if (changes_any_ && std::any_of(asked.begin(), asked.end(), is_parameter)) return true;
        return std::any_of(asked.begin(), asked.end(), [&](const auto& name) { return changed_.contains(name); });
    }

private:
    void change(ExprId target) {
        const Expr& e = unit_.exprs[target];
        changes_any_ = changes_any_ || e.kind == ExprKind::parameter_at;
        changed_.insert({e.kind, e.a});
    }
    bool statement(std::uint32_t i);
    bool block(std::uint32_t i);

    const Unit& unit_;
    const Loop loop_;
    std::vector<std::pair<std::uint32_t, ExprId>> conditions_;  ///< by their statements
    Names changed_;
    bool changes_any_ = false;  ///< a parameter by a computed number
    bool leaves_ = false;       ///< by a jump or a return in its midst
};

bool Body::block(std::uint32_t i) {
    for (std::uint32_t w = unit_.statements[i].first; w < unit_.words_end(i); ++w) {
        const program::Word& word = unit_.words[w];
        switch (program::code_of(word)) {
            case Code::assign: change(unit_.assigns[static_cast<std::size_t>(word.payload)].target); break;
            case Code::m: leaves_ = true; break;  // M30 may be among them
            case Code::unknown:
            case Code::unsupported: return false;
            default: break;
        }
    }
    return true;
}

bool Body::statement(std::uint32_t i) {
    const Statement& s = unit_.statements[i];
    switch (s.kind) {
        case StatementKind::block: return block(i);
        case StatementKind::if_:
        case StatementKind::while_:
        case StatementKind::until:
            conditions_.emplace_back(i, unit_.branches[table_of(unit_, s)].condition);
            return true;
        case StatementKind::else_:
        case StatementKind::endif:
        case StatementKind::endwhile:
        case StatementKind::repeat_:
        case StatementKind::loop_:
        case StatementKind::endloop:
        case StatementKind::frame: return true;
        case StatementKind::for_: change(unit_.fors[table_of(unit_, s)].variable); return true;
        case StatementKind::endfor:
        case StatementKind::repeat_count:
        case StatementKind::end_repeat_count: return i != loop_.last;
        case StatementKind::jump: {
            const program::Jump& j = unit_.jumps[table_of(unit_, s)];
            conditions_.emplace_back(i, j.condition);
            const bool within = j.target >= loop_.first && j.target <= loop_.last;
            leaves_ = leaves_ || (i != loop_.last && !within);
            return true;
        }
        default: return false;
    }
}

/// "R1, R2"
std::string list(const Unit& unit, const Names& asked, const program::Names& names) {
    std::string all;
    for (const auto& [kind, number] : asked)
        all +=
            (all.empty() ? "" : " or ") + (kind == ExprKind::parameter ? program::parameter_name(*unit.traits, number)
                                                                       : std::string(names.text(number)));
    return all;
}

}  // namespace

std::optional<Endless> why_endless(const Unit& unit, const Loop& loop, const program::Names& names) {
    Body body(unit, loop);
    if (loop.last >= unit.statements.size() || !body.read()) return std::nullopt;
    const auto asked = body.asked();
    if (!asked || body.changes(*asked)) return std::nullopt;
    if (asked->empty())
        return Endless{"nothing in it ends it", "see by what the program is to leave it", body.condition()};
    const std::string all = list(unit, *asked, names);
    return Endless{"nothing in it changes " + all, "see whether a block that changes " + all + " is missing",
                   body.condition()};
}

}  // namespace obrys::interp
