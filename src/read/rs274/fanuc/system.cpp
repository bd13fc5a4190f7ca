/// System variables: #3000 stops with an alarm, #5041 is where the tool stands.

#include "read/rs274/fanuc/state.hpp"

namespace obrys::read::rs274 {

using dialect::rs274::FanucGroup;
using dialect::rs274::FanucSystem;
using program::Operator;
using program::StateQuery;
using program::SystemVariable;

namespace {

struct SystemWriter {
    State& s;
    std::uint32_t number = 0, begin = 0, end = 0;

    [[nodiscard]] ExprId constant(double x) const { return s.build().number(x, true, begin, end); }
    [[nodiscard]] ExprId system(SystemVariable v, const std::vector<ExprId>& children) const {
        program::Expr e;
        e.kind = program::ExprKind::system;
        e.op = static_cast<std::uint8_t>(v);
        e.a = s.build().name("#" + std::to_string(number));
        s.build().adopt(e, children);
        return s.build().add(e, begin, end);
    }
    [[nodiscard]] ExprId query(StateQuery q) const {
        return system(SystemVariable::state, {constant(static_cast<double>(q))});
    }
    /// `no`, or `yes` where the state is so; without both the number of the code itself.
    [[nodiscard]] ExprId code(StateQuery q, int yes = 0, int no = 0) const {
        return system(SystemVariable::code_in_force, {constant(static_cast<double>(q)), constant(yes), constant(no)});
    }
};

ExprId group(const SystemWriter& w, FanucGroup g, bool minutes_98) {
    switch (g) {
        case FanucGroup::motion: return w.code(StateQuery::motion_mode);
        case FanucGroup::plane: return w.code(StateQuery::plane);
        case FanucGroup::compensation: return w.code(StateQuery::compensation);
        case FanucGroup::datum: return w.code(StateQuery::coordinate_system);
        case FanucGroup::distance: return w.code(StateQuery::absolute, 90, 91);
        case FanucGroup::units: return w.code(StateQuery::imperial, 20, 21);
        case FanucGroup::surface_speed: return w.code(StateQuery::spindle_surface_mode, 96, 97);
        case FanucGroup::feed_mode:
            return minutes_98 ? w.code(StateQuery::feed_per_rev, 99, 98) : w.code(StateQuery::feed_per_rev, 95, 94);
    }
    return no_expr;
}

/// What the operator is told: the number, and the comment behind it.
ExprId message(FanucState& s, ExprId number, int first, std::uint32_t begin) {
    program::Builder& b = s.build();
    const std::string text = take_comment(s);
    const std::uint32_t end = s.line.behind();
    const ExprId tail = b.text(text.empty() ? "" : " " + text, begin, end);
    if (number == no_expr) return b.text(text, begin, end);
    const ExprId shown = b.binary(Operator::add, number, b.number(first, true, begin, end), begin, end);
    const ExprId places = b.number(0, true, begin, end);
    return b.binary(Operator::concat, b.function(program::Function::to_text, {shown, places}, begin, end), tail, begin,
                    end);
}

void add_procedure(FanucState& s, program::Procedure p, ExprId text) {
    program::ProcedureCall call;
    call.procedure = p;
    call.arguments = {text};
    call.where = s.build().span(s.line.begin(), s.line.end());
    s.unit().procedures.push_back(std::move(call));
    add_control(s, StatementKind::procedure, s.unit().procedures.size() - 1);
}

}  // namespace

ExprId system_parameter(State& state, std::uint32_t number, std::uint32_t begin) {
    auto& s = static_cast<FanucState&>(state);
    const auto v = dialect::rs274::system_variable(number, s.control);
    const SystemWriter w{s, number, begin, s.line.behind()};
    const bool minutes_98 = s.control.is_lathe() && s.control.system == dialect::rs274::GSystem::a;
    switch (v.system) {
        case FanucSystem::storage: return no_expr;
        case FanucSystem::unknown:
            if (number < 4000 || number >= 5000) return no_expr;  // Traits::kept
            return w.system(SystemVariable::unknown, {});
        case FanucSystem::option: return w.system(SystemVariable::unknown, {});  // what the machine makes of it
        case FanucSystem::timer: return w.system(SystemVariable::timer, {});
        case FanucSystem::position: return w.system(SystemVariable::coordinate, {w.constant(v.index)});
        case FanucSystem::machine: return w.system(SystemVariable::machine_coordinate, {w.constant(v.index)});
        case FanucSystem::probed: return w.system(SystemVariable::probed_coordinate, {w.constant(v.index)});
        case FanucSystem::group: return group(w, static_cast<FanucGroup>(v.index), minutes_98);
        case FanucSystem::feed: return w.query(StateQuery::feed);
        case FanucSystem::speed: return w.query(StateQuery::speed);
        case FanucSystem::tool: return w.query(StateQuery::selected_tool);
        default: return w.system(SystemVariable::unknown, {});
    }
}

bool assign_system(FanucState& s, std::uint32_t number) {
    const auto v = dialect::rs274::system_variable(number, s.control);
    const bool acts = v.system == FanucSystem::alarm || v.system == FanucSystem::stop;
    if (!acts && v.system != FanucSystem::option && v.system != FanucSystem::timer) return false;
    const std::uint32_t begin = s.line.here();
    s.line.step(std::to_string(number).size() + 2);
    const ExprId value = read_expression(s);
    if (s.failed || value == no_expr) return true;
    if (!acts) {
        s.build().ignored("#" + std::to_string(number), begin, s.line.behind());
        while (s.line.peek() == '(') static_cast<void>(take_comment(s));
    } else if (v.system == FanucSystem::alarm) {
        // #3000=7 is alarm 3007 on FANUC, 1007 on Haas controls.
        add_procedure(s, program::Procedure::abort, message(s, value, s.control.haas ? 1000 : 3000, begin));
    } else {
        add_procedure(s, program::Procedure::message, message(s, no_expr, 0, begin));
        program::Builder& b = s.build();
        b.statement(StatementKind::block, s.line.begin());
        b.literal(Code::m, 0.0, begin, s.line.behind());
        b.end_statement(s.line.end());
    }
    if (!s.line.at_end()) fail_here(s, here(s) + " cannot stand behind an assignment");
    return true;
}

}  // namespace obrys::read::rs274
