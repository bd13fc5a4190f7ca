/// Calls of programs and macros, and the way back. Sources: FANUC series 16i operator's manual B-63684EN, subprogram
/// and 16.7 macro call; Haas mill operator's manual 96-8000, M97, M98, M99, G65.

#include <algorithm>
#include <array>
#include <set>
#include <utility>

#include "read/rs274/fanuc/state.hpp"

namespace obrys::read::rs274 {

using program::Call;
using program::CallKind;

namespace {

constexpr std::int32_t most_number = 9999;  ///< of a program where P holds the repeats, too

/// G65, G66, G67: nothing else may be named so early.
Address* find_macro_g(FanucState& s, int& tenths) {
    for (Address& a : s.addresses) {
        const auto n = g_tenths(a);
        if (n != 650 && n != 660 && n != 670) continue;
        tenths = *n;
        return &a;
    }
    return nullptr;
}

ExprId whole_number(FanucState& s, std::int32_t n, const Address& a) {
    return s.build().number(n, true, a.begin, a.end);
}

/// `<NAME>` in the place of P.
bool takes_name(FanucState& s, Call& call) {
    if (s.called.empty()) return false;
    call.where = s.build().span(s.called_begin, s.called_end);
    call.name = s.build().name(s.called);
    return true;
}

/// The program that P names. `counts`: digits above the fourth are the number of repeats.
bool name_program(FanucState& s, Call& call, const Address& p, bool counts) {
    call.where = s.build().span(p.begin, p.end);
    const auto n = as_integer(p.value);
    if (!p.value.is_literal()) {
        call.kind = call.kind == CallKind::modal ? call.kind : CallKind::indirect;
        call.target = p.value.expr;
        return true;
    }
    if (!n || *n < 0) {
        fail(s, p.begin, p.end, "P is the number of a program");
        return false;
    }
    const bool both = counts && *n > most_number;
    if (both) call.passes = whole_number(s, *n / (most_number + 1), p);
    call.name = s.build().name("O" + std::to_string(both ? *n % (most_number + 1) : *n));
    return true;
}

void add_call(FanucState& s, Call call) {
    s.unit().calls.push_back(std::move(call));
    add_control(s, StatementKind::call, s.unit().calls.size() - 1);
}

/// Argument specification I and II: I, J, K count up in sets of three whose letters come in this order.
struct Arguments {
    std::vector<ExprId> values;
    std::set<char> letters;
    int set = 0, last = 3;

    int parameter(char letter) {
        if (letter < 'I' || letter > 'K') return dialect::rs274::argument_parameter(letter);
        const int rank = letter - 'I';
        if (rank <= last) ++set;
        last = rank;
        return dialect::rs274::argument_parameter(letter, set);
    }
    void put(int parameter, ExprId e) {
        const auto at = static_cast<std::size_t>(parameter - 1);
        if (values.size() <= at) values.resize(at + 1, no_expr);
        values[at] = e;
    }
};

/// Arguments without point are increments of their address (B-63684EN page 278); feeds are not scaled on Haas.
Quantity argument_quantity(const FanucState& s, char letter) {
    if (std::string_view("DEFHMST").find(letter) == std::string_view::npos) {
        const Quantity q = quantity_of(s, letter);
        return letter == 'K' ? Quantity::length : q;
    }
    return (letter == 'E' || letter == 'F') && !s.control.haas ? Quantity::feed : Quantity::plain;
}

void say_twice(FanucState& s, const Address& a) {
    base::Diagnostic d;
    d.severity = base::Severity::warning;
    d.code = base::codes::repeated_word;
    d.where = s.build().span(a.begin, a.end);
    d.text = std::string("the argument ") + a.letter + " stands twice: the macro gets the last one";
    d.remedy = "leave one of them in the block";
    s.diagnostics.add(std::move(d));
}

bool read_arguments(FanucState& s, Call& call, const Address& from) {
    Arguments arguments;
    for (Address& a : s.addresses) {
        if (a.used || a.begin < from.begin) continue;
        const int n = a.comma ? 0 : arguments.parameter(a.letter);
        if (n == 0) {
            fail(s, a.begin, a.end, (a.comma ? "," : "") + std::string(1, a.letter) + " is no argument of a macro",
                 "G, L, N, O and P have a meaning of their own; I, J, K may stand ten times");
            return false;
        }
        a.used = true;
        if (!arguments.letters.insert(a.letter).second && (a.letter < 'I' || a.letter > 'K')) say_twice(s, a);
        arguments.put(n, as_expr(s, scaled(s, a.value, argument_quantity(s, a.letter))));
    }
    call.arguments = std::move(arguments.values);
    call.has_arguments = true;
    return true;
}

/// What stands in front of G65 acts before the call.
void emit_before(FanucState& s, std::uint32_t place) {
    std::vector<Address> all = std::move(s.addresses);
    s.addresses.clear();
    for (const Address& a : all)
        if (a.begin < place && !a.used) s.addresses.push_back(a);
    if (!s.addresses.empty()) emit_addresses(s);
    s.addresses = std::move(all);
}

bool macro_call(FanucState& s) {
    int tenths = 0;
    Address* g = find_macro_g(s, tenths);
    if (g == nullptr) return false;
    g->used = true;
    const Address here = *g;
    Call call;
    call.where = s.build().span(here.begin, here.end);
    if (tenths == 670) {
        call.kind = CallKind::modal_end;
        add_call(s, std::move(call));
        if (std::any_of(s.addresses.begin(), s.addresses.end(), [](const Address& a) { return !a.used; }))
            emit_addresses(s);
        return true;
    }
    if (tenths == 660) call.kind = CallKind::modal;
    Address* p = find_address(s, 'P');
    const bool named = takes_name(s, call);
    if (p == nullptr && !named) {
        fail(s, here.begin, here.end, "the number of the macro is missing", "write it as P");
        return true;
    }
    if (p != nullptr && !named) {
        p->used = true;
        if (!name_program(s, call, *p, false)) return true;
    }
    if (Address* l = find_address(s, 'L')) {
        l->used = true;
        call.passes = as_expr(s, l->value);
    }
    s.hole_apart = true;  // K and P are arguments here
    const bool good = read_arguments(s, call, here);
    s.hole_apart = false;
    if (!good) return true;
    emit_before(s, here.begin);
    if (!s.failed) judge_call_behind_corner(s, here);
    if (!s.failed) as_piece(s, [&] { add_call(s, std::move(call)); });
    return true;
}

Address* find_m(FanucState& s, int number) {
    for (Address& a : s.addresses)
        if (a.letter == 'M' && !a.used && as_integer(a.value) == number) return &a;
    return nullptr;
}

/// What stands beside a call or a return acts before it.
void emit_others(FanucState& s, const Address& here) {
    if (std::any_of(s.addresses.begin(), s.addresses.end(), [](const Address& a) { return !a.used; }))
        emit_addresses(s);
    if (!s.failed) judge_call_behind_corner(s, here);
}

/// M98 P L, behind the block's motion. Q: the block of that program with which it begins (parameter 6005, bit SQC = 1
/// [-]). M198 calls a program of another store by the same words.
void subprogram(FanucState& s, Address& m) {
    m.used = true;
    const Address here = m;
    Call call;
    call.shares_parameters = true;
    Address *p = find_address(s, 'P'), *l = find_address(s, 'L');
    Address* q = s.control.haas ? nullptr : find_address(s, 'Q');
    const bool named = takes_name(s, call);
    if (p == nullptr && !named)
        return fail(s, here.begin, here.end, "the number of the subprogram is missing", "write it as P");
    if (l != nullptr) l->used = true;
    // FANUC: M98 P31000 calls O1000 three times; Haas programs may have five digits.
    if (p != nullptr && !named) {
        p->used = true;
        if (!name_program(s, call, *p, l == nullptr && !s.control.haas)) return;
    }
    if (l != nullptr) call.passes = as_expr(s, l->value);
    if (q != nullptr) {
        q->used = true;
        call.first_block = as_expr(s, q->value);
    }
    emit_others(s, here);
    if (!s.failed) add_call(s, std::move(call));
}

/// Haas M97 P100 L2: the blocks from N100 to M99.
void local_subprogram(FanucState& s, Address& m) {
    m.used = true;
    const Address here = m;
    Address *p = find_address(s, 'P'), *l = find_address(s, 'L');
    const auto n = p != nullptr ? as_integer(p->value) : std::nullopt;
    if (!n || *n < 0) return fail(s, here.begin, here.end, "M97 needs the number of a block as P");
    p->used = true;
    const std::uint32_t begin = s.line.begin(), end = s.line.end();
    ExprId count = no_expr;
    if (l != nullptr) {
        l->used = true;
        count = as_expr(s, l->value);
    }
    emit_others(s, here);
    if (s.failed) return;
    program::Unit& unit = s.unit();
    const auto opener = static_cast<std::uint32_t>(unit.statements.size());
    if (count != no_expr) {
        unit.branches.push_back({count, opener + 3});
        add_control(s, StatementKind::repeat_count, unit.branches.size() - 1);
    }
    program::LabelCall call;
    call.label = s.build().text("N" + std::to_string(*n), begin, end);
    unit.label_calls.push_back(call);
    s.labels.push_back({unit.label_calls.size() - 1, static_cast<std::uint32_t>(*n)});
    add_control(s, StatementKind::label_call, unit.label_calls.size() - 1);
    if (count == no_expr) return;
    unit.branches.push_back({no_expr, opener});
    add_control(s, StatementKind::end_repeat_count, unit.branches.size() - 1);
}

/// The jump of M99 P; its index. On Haas it is one within the program at hand, which is not left (96-8000, M99).
std::size_t jump_of(FanucState& s, const Address& p, ExprId condition) {
    program::Jump jump;
    jump.condition = condition;
    jump.direction = condition == no_expr ? program::JumpDirection::again : program::JumpDirection::either;
    jump.destination = as_expr(s, p.value);
    s.unit().jumps.push_back(jump);
    if (const auto n = as_integer(p.value); n && *n >= 0 && s.control.haas)
        s.jumps.push_back({s.unit().jumps.size() - 1, static_cast<std::uint32_t>(*n)});
    return s.unit().jumps.size() - 1;
}

/// M99; with P the caller goes on at another block.
void go_back(FanucState& s, Address& m) {
    m.used = true;
    const Address here = m;
    Address *p = find_address(s, 'P'), *l = find_address(s, 'L');
    if (p != nullptr) p->used = true;
    if (l != nullptr) l->used = true;
    const std::optional<Address> to = p != nullptr ? std::optional(*p) : std::nullopt;
    const std::optional<Address> count = l != nullptr ? std::optional(*l) : std::nullopt;
    const ExprId condition = std::exchange(s.condition, no_expr);
    emit_others(s, here);
    if (s.failed) return;
    if (count) {
        s.build().statement(StatementKind::block, s.line.begin());
        s.build().problem(Code::unsupported, count->begin, count->end, "the number of repeats changes");
        s.build().end_statement(s.line.end());
    }
    if (to && s.control.haas) return add_control(s, StatementKind::jump, jump_of(s, *to, condition));
    if (s.control.haas) {  // ends a section that M97 called
        s.build().statement(StatementKind::label_end, s.line.begin());
        s.build().end_statement(s.line.end());
    }
    s.build().control(StatementKind::return_, to ? jump_of(s, *to, no_expr) + 1 : 0, here.begin, here.end);
}

}  // namespace

bool read_calls(FanucState& s) {
    if (macro_call(s)) return true;
    for (const int number : {98, 198})
        if (Address* m = find_m(s, number)) return subprogram(s, *m), true;
    if (Address* m = s.control.haas ? find_m(s, 97) : nullptr) return local_subprogram(s, *m), true;
    if (Address* m = find_m(s, 99)) return go_back(s, *m), true;
    return false;
}

}  // namespace obrys::read::rs274
