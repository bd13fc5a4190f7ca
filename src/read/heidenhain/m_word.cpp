/// M functions: those that change the path become words of the tree, the others stay numbers.

#include "read/heidenhain/state.hpp"

namespace obrys::read::heidenhain {

namespace {

/// Values that belong to an M function: M120 LA10, M140 MB MAX, M103 F20.
void skip_values(State& s) {
    for (;;) {
        const std::uint32_t before = s.in.at();
        const bool keyword =
            s.in.take_prefix("LA") || s.in.take_prefix("MB") || s.in.take_prefix("F") || s.in.take_prefix("P");
        if (!keyword) return;
        s.in.take_word("MAX");
        if (!read_value(s).found && s.in.at() == before) return;
    }
}

}  // namespace

void read_m(State& s, std::uint32_t begin) {
    if (base::is_blank(s.in.peek()) || s.in.at_end()) return;  // M alone: the key was pressed and nothing entered
    const Value v = read_value(s);
    if (!v.found || (v.is_literal() && !v.literal.integer)) {
        fail(s, begin, "M needs the whole number of a function");
        return;
    }
    if (!v.is_literal()) return s.build.expression(Code::m, v.expr, begin, v.end);
    const double m = v.number();
    if (m == 91) return s.build.modal(Modal::suppress_all, begin, v.end);
    if (m == 99) return s.build.bare(Code::cycle_call, begin, v.end);
    if (m == 89) return s.build.bare(Code::cycle_call_modal, begin, v.end);
    if (m == 13 || m == 14) {  // spindle and coolant at once
        s.build.literal(Code::m, m == 13 ? 3 : 4, begin, v.end);
        s.build.literal(Code::m, 8, begin, v.end);
        return;
    }
    s.build.literal(Code::m, v.literal, v.negative, begin, v.end);
    if (m == 103 || m == 120 || m == 140 || m == 128) {
        skip_values(s);
        s.build.problem(Code::unsupported, begin, s.in.at(), "");
    }
}

}  // namespace obrys::read::heidenhain
