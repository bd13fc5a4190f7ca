/// Tools, their speed and coolant.

#include <cmath>

#include "base/whole.hpp"
#include "dialect/fusion/words.hpp"
#include "read/fusion/state.hpp"

namespace obrys::read::fusion {

using dialect::fusion::Coolant;
using program::Code;
using program::Modal;

namespace {

void tell_function(State& s, const Place& where, int m) {
    begin_block(s, where);
    s.build.literal(Code::m, m, where.begin, where.end);
    end_block(s, where);
}

void tell_coolant(State& s, const Place& where) {
    const Coolant* c = dialect::fusion::find_coolant(parameter(s, "operation:tool_coolant"));
    if (const auto number = s.tool->coolant) {
        if (const auto n = base::whole<std::size_t>(*number, 0U, dialect::fusion::coolants.size() - 1))
            c = &dialect::fusion::coolants[*n];
        else
            return refuse(s, s.tool->coolant_where, "nothing is known of this coolant");
    }
    if (c == nullptr || c == s.coolant) return;
    if (!c->beyond.empty())
        refuse(s, s.tool->coolant_where,
               "it wants " + std::string(c->beyond) + ", for which each machine has functions of its own");
    const bool was_on = s.coolant != nullptr && s.coolant != &dialect::fusion::coolants[0];
    s.coolant = c;
    if (was_on || !(c->flood || c->mist)) tell_function(s, where, 9);
    if (c->mist) tell_function(s, where, 7);
    if (c->flood) tell_function(s, where, 8);
}

void tell_change(State& s, const Place& where) {
    const Tool& t = *s.tool;
    if (!t.turns) {
        begin_block(s, where);
        s.build.unit().tool_definitions.push_back(static_cast<std::uint32_t>(s.build.unit().statements.size() - 1));
        s.build.bare(Code::tool_definition, where.begin, where.end);
        s.build.literal(Code::tool, t.number, where.begin, where.end);
        s.build.literal(Code::tool_radius, t.diameter / 2, where.begin, where.end);
        end_block(s, where);
    }
    begin_block(s, where);
    s.build.literal(Code::tool, t.number, where.begin, where.end);
    s.build.bare(Code::tool_change, where.begin, where.end);
    end_block(s, where);
    s.in_spindle = t.number;
    s.tool_changed = true;
    s.speed = -1;
    s.side = Side::none;
}

/// Constant cutting speed, with the highest speed of the tool.
void tell_surface_speed(State& s, const Place& where, double mm_per_minute) {
    begin_block(s, where);
    s.build.modal(Modal::surface_speed_on, where.begin, where.end, 96);
    s.build.literal(Code::spindle, mm_per_minute / 1000, where.begin, where.end);
    if (const auto most = number_of(s, "operation:tool_maximumSpindleSpeed"); most && *most > 0)
        s.build.literal(Code::speed_limit, *most, where.begin, where.end);
    s.build.literal(Code::m, s.tool->clockwise ? 3 : 4, where.begin, where.end);
    end_block(s, where);
    s.speed = -1;
    s.speed_is_surface = true;
}

/// The tool comes into the spindle; what it does there waits for the section (tell_technology).
void take_tool(State& s, const Tool& tool) {
    s.tool = tool;
    s.tool->where = place_of(s.line);
    s.tool->coolant_where = place_of(s.line, "coolant");
    if (!s.in_spindle || *s.in_spindle != tool.number) tell_change(s, s.tool->where);
}

/// What both kinds of tools say; false after a complaint.
bool read_common(State& s, Tool& t) {
    const auto number = s.line.number("number"), speed = s.line.number("speed"), clockwise = s.line.number("clockwise"),
               pitch = s.line.number("pitch");
    constexpr std::uint32_t most = 99'999'999;
    if (!number || !base::whole<std::uint32_t>(*number, 0U, most)) {
        fail(s, "this is no tool number: a whole number is due");
        return false;
    }
    if (!speed || !clockwise || !pitch || *speed < 0) {
        fail(s, "speed, sense or pitch of this tool is no number that a spindle can have");
        return false;
    }
    t.number = *number;
    t.speed = *speed;
    t.clockwise = *clockwise != 0;
    t.pitch = *pitch;
    return true;
}

}  // namespace

void tell_spindle(State& s, const Place& where, double speed, bool clockwise) {
    const int direction = speed > 0 ? (clockwise ? 1 : -1) : 0;
    if (s.speed == speed && s.direction == direction && !s.speed_is_surface) return;
    begin_block(s, where);
    if (s.speed_is_surface) s.build.modal(Modal::surface_speed_off, where.begin, where.end, 97);
    if (speed > 0) s.build.literal(Code::spindle, speed, where.begin, where.end);
    s.build.literal(Code::m, direction == 0 ? 5 : direction > 0 ? 3 : 4, where.begin, where.end);
    end_block(s, where);
    s.speed_is_surface = false;
    s.speed = speed;
    s.direction = direction;
}

void tell_technology(State& s) {
    const Place where = s.tool->where;
    const auto surface = number_of(s, "operation:tool_surfaceSpeed");
    if (parameter(s, "operation:tool_useConstantSurfaceSpeed") == "1" && surface && *surface > 0)
        tell_surface_speed(s, where, *surface);
    else
        tell_spindle(s, where, s.tool->speed, s.tool->clockwise);
    tell_coolant(s, where);
}

void read_tool(State& s) {
    Tool t;
    if (!read_common(s, t)) return;
    const auto diameter = s.line.number("diameter"), coolant = s.line.number("coolant"),
               offset = s.line.number("diameter-offset");
    if (!diameter || !coolant || !offset || *diameter < 0)
        return fail(s, "diameter, coolant or offset of this tool is no number that a tool can have");
    t.diameter = *diameter;
    t.coolant = *coolant;
    t.offset = *offset;
    take_tool(s, t);
}

void read_turning_tool(State& s) {
    Tool t;
    if (!read_common(s, t)) return;
    t.turns = true;
    t.offset = s.line.number("offset").value_or(t.number);
    s.turns = true;
    take_tool(s, t);
}

}  // namespace obrys::read::fusion
