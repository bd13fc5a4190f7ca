/// TOOL CALL and TOOL DEF.

#include "read/heidenhain/state.hpp"

namespace obrys::read::heidenhain {

void read_tool(State& s) {
    s.in.skip_blanks();
    const std::uint32_t begin = s.in.at();
    if (s.in.peek() == '"' || (stands_parameter(s) && base::upper(s.in.peek(1)) == 'S')) {
        const ExprId name = read_text(s);
        if (!s.failed) s.build.expression(Code::tool, name, begin, s.in.at());
    } else if (base::is_digit(s.in.peek()) || stands_parameter(s)) {
        value_word(s, Code::tool, begin);
    }
}

void preselect_tool(State& s, std::uint32_t begin) { s.build.bare(Code::tool_definition, begin, s.in.at()); }

void read_oversize(State& s, std::uint32_t begin) {
    s.in.step();
    const char c = base::upper(s.in.peek());
    s.in.step();
    if (c == 'L') return value_word(s, Code::delta_length, begin);
    if (c == 'R' && s.in.peek() == '2') {
        s.in.step();
        s.in.take(':');
        return value_word(s, Code::delta_corner, begin);
    }
    if (c == 'R') return value_word(s, Code::delta_radius, begin);
    s.in.go_to(begin);
    fail_here(s, "DL, DR or DR2 is due here, found " + here(s));
}

namespace {

void plane_of(State& s, std::uint32_t begin) {
    const char axis = base::upper(s.in.peek());
    s.in.step();
    s.build.modal(axis == 'Z' ? Modal::plane_xy : axis == 'Y' ? Modal::plane_zx : Modal::plane_yz, begin, s.in.at());
}

void feed_of_tool(State& s, std::uint32_t begin) {
    s.in.step();
    if (s.in.take_word("MAX") || s.in.take_word("AUTO"))
        return s.build.problem(Code::unsupported, begin, s.in.at(), "TOOL CALL has a feed in numbers");
    const char kind = base::upper(s.in.peek());
    if (kind == 'U' || kind == 'Z') {
        s.in.step();
        return value_word(s, kind == 'U' ? Code::feed_per_rev : Code::feed_per_tooth, begin);
    }
    value_word(s, Code::feed, begin);
}

void read_tool_call(State& s, std::uint32_t begin) {
    read_tool(s);
    s.build.bare(Code::tool_change, begin, s.in.at());
    while (!s.failed && !s.in.at_end()) {
        const std::uint32_t word = s.in.at();
        const char c = base::upper(s.in.peek());
        if (c == 'X' || c == 'Y' || c == 'Z') {
            plane_of(s, word);
        } else if (c == 'S') {
            s.in.step();
            value_word(s, Code::spindle, word);
        } else if (c == 'F') {
            feed_of_tool(s, word);
        } else if (c == 'D') {
            read_oversize(s, word);
        } else if (c == 'M') {
            s.in.step();
            read_m(s, word);
        } else {
            fail_here(s, "this is no word of TOOL CALL: " + here(s), "tool axis, S, F, DL, DR, DR2");
        }
    }
}

void read_tool_definition(State& s, std::uint32_t begin) {
    read_tool(s);
    if (s.in.at_end()) return preselect_tool(s, begin);
    s.build.bare(Code::tool_definition, begin, s.in.at());
    s.build.unit().tool_definitions.push_back(static_cast<std::uint32_t>(s.build.unit().statements.size() - 1));
    while (!s.failed && !s.in.at_end()) {
        const std::uint32_t word = s.in.at();
        const char c = base::upper(s.in.peek());
        s.in.step();
        if (c == 'L' || c == 'R') {
            value_word(s, c == 'L' ? Code::tool_length : Code::tool_radius, word);
        } else {
            s.in.go_to(word);
            fail_here(s, "L and R of the tool are due here, found " + here(s));
        }
    }
}

}  // namespace

void read_tool_block(State& s, std::uint32_t begin) {
    s.build.statement(StatementKind::block, s.block);
    if (s.in.take_word("CALL")) return read_tool_call(s, begin);
    if (s.in.take_word("DEF")) return read_tool_definition(s, begin);
    fail_here(s, "CALL or DEF is due behind TOOL, found " + here(s));
}

}  // namespace obrys::read::heidenhain
