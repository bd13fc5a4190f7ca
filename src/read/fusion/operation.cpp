/// What stands around the moves of an operation: parameters, context, section, commands.

#include <algorithm>
#include <array>
#include <cmath>

#include "base/text.hpp"
#include "base/whole.hpp"
#include "dialect/fusion/words.hpp"
#include "read/fusion/state.hpp"

namespace obrys::read::fusion {

using geom::Frame;
using geom::Vec3;
using program::Code;
using program::Modal;

namespace {

/// Parameters that are looked at.
constexpr std::array<std::string_view, 8> wanted{
    "operation:tool_coolant",
    "operation:compensationType",
    "operation:threadPitch",
    "operation:tool_surfaceSpeed",
    "operation:tool_maximumSpindleSpeed",
    "operation:tool_useConstantSurfaceSpeed",
    "operation:tool_useFeedPerRevolution",
    "operation:tool_feedPerRevolution",
};

/// The comment of an operation goes into the program.
void tell_comment(State& s, std::string_view chars) {
    std::string text = base::as_utf8(unquoted(chars));
    std::replace(text.begin(), text.end(), '\n', ' ');
    if (base::trim(text).empty()) return;
    const Place where = place_of(s.line);
    begin_block(s, where);
    s.build.unit().texts.push_back(std::move(text));
    s.build.word(Code::comment, program::Form::index, static_cast<std::int32_t>(s.build.unit().texts.size() - 1),
                 where.begin, where.end);
    end_block(s, where);
}

constexpr double nearly = 1e-6;  ///< single precision of direction cosines

/// Directions as the columns of a matrix written row by row, made square to each other again: their numbers are
/// singles. Nothing where they are no such directions.
std::optional<Frame> frame_of(const std::vector<double>& m, const Vec3& origin) {
    Vec3 x{m[0], m[3], m[6]}, z{m[2], m[5], m[8]};
    const Vec3 y{m[1], m[4], m[7]};
    const double lx = geom::length(x), lz = geom::length(z);
    constexpr double rough = 1e-4;
    if (!(std::abs(lx - 1) < rough && std::abs(lz - 1) < rough)) return std::nullopt;
    z = (1 / lz) * z;
    x = x - geom::dot(x, z) * z;
    if (!(geom::length(x) > 0.5)) return std::nullopt;
    x = (1 / geom::length(x)) * x;
    const Vec3 across = geom::cross(z, x);
    if (!(geom::distance(across, y) < rough)) return std::nullopt;
    Frame f;
    f.linear = {x.x, across.x, z.x, x.y, across.y, z.y, x.z, across.z, z.z};
    f.origin = origin;
    return f;
}

/// What differs from nothing by less than a single holds is nothing.
Frame without_noise(Frame f) {
    for (double& v : f.linear)
        if (std::abs(v - std::round(v)) < nearly) v = std::round(v);
    for (double* v : {&f.origin.x, &f.origin.y, &f.origin.z})
        if (std::abs(*v) < nearly) *v = 0;
    return f;
}

Vec3 vector_of(const std::vector<double>& n) { return {n[0], n[1], n[2]}; }

}  // namespace

void read_parameter(State& s) {
    const Line& line = s.line;
    if (line.tokens.size() < 2 || line.tokens[0].kind != TokenKind::text)
        return fail(s, "a parameter has a name and a value");
    const std::string_view name = line.tokens[0].chars;
    if (s.cycle) return read_cycle_value(s, name);
    if (std::find(wanted.begin(), wanted.end(), name) != wanted.end())
        s.parameters[std::string(name)] = std::string(line.tokens[1].chars);
    if (name.ends_with("/parameter/operation-comment")) return tell_comment(s, line.tokens[1].chars);
    if (!dialect::fusion::describes(name))
        refuse(s, place_of(line), "nothing is known of this parameter, which stands outside of a cycle");
}

void read_context(State& s) {
    const Line& line = s.line;
    const auto origin = line.numbers("origin", 3), axes = line.numbers("axes", 9),
               setup_origin = line.numbers("setup-origin", 3), setup_axes = line.numbers("setup-axes", 9);
    const auto offset = line.number("work-offset"), kind = line.number("turning"), spindle = line.number("spindle");
    if (!origin || !axes || !setup_origin || !setup_axes || !offset || !kind || !spindle)
        return fail(s, "this context is not complete, or a number of it is none");
    const auto operation = frame_of(*axes, vector_of(*origin)), setup = frame_of(*setup_axes, vector_of(*setup_origin));
    if (!operation || !setup) return fail(s, "the axes of this context are not square to each other");
    s.context = {*offset, *kind == 1, *spindle != 0, without_noise(geom::inverse(*setup) * *operation), place_of(line)};
    s.has_context = true;
    s.tool.reset();
    if (*kind > 1) refuse(s, place_of(line, "turning"), "operations of jets and of additive machines are not run");
    if (*spindle != 0)
        refuse(s, place_of(line, "spindle"),
               "the operation is on the second spindle, and how the part comes into it is not in the file");
    if (s.context.turning) s.turns = true;
}

namespace {

void add_datum(State& s, program::Special& special, program::Datum datum, double value, const Place& where) {
    program::DatumValue v;
    v.datum = datum;
    v.value = s.build.number(value, false, where.begin, where.end);
    v.where = s.build.span(where.begin, where.end);
    special.data.push_back(v);
}

/// The tilted plane of the operation; none: that of the setup.
void tell_plane(State& s, const Frame& f, const Place& where) {
    using program::Datum;
    program::Special special;
    special.kind = program::SpecialKind::plane_vector;
    special.where = s.build.span(where.begin, where.end);
    const std::array<std::pair<Datum, double>, 6> values{{{Datum::vector_x, f.linear[0]},
                                                          {Datum::vector_y, f.linear[3]},
                                                          {Datum::vector_z, f.linear[6]},
                                                          {Datum::normal_x, f.linear[2]},
                                                          {Datum::normal_y, f.linear[5]},
                                                          {Datum::normal_z, f.linear[8]}}};
    for (const auto& [datum, value] : values) add_datum(s, special, datum, value, where);
    constexpr double stands_on_it = 4;
    add_datum(s, special, Datum::positioning, stands_on_it, where);
    s.build.begin_block();
    s.build.control(program::StatementKind::special, s.build.unit().specials.size(), where.begin, where.end);
    s.build.unit().specials.push_back(std::move(special));
    s.told_axis = {0, 0, 1};
    s.at.reset();
}

void tell_offset(State& s, const Place& where) {
    if (!s.uses_offsets || s.offset_told == s.context.work_offset) return;
    s.offset_told = s.context.work_offset;
    constexpr double most = 99;
    const auto n = base::whole<int>(s.context.work_offset, 0, static_cast<int>(most));
    if (!n) return refuse(s, where, "there are 99 work offsets");
    constexpr int before_first = 53;
    begin_block(s, where);
    s.build.modal(Modal::datum, where.begin, where.end, before_first + std::max(*n, 1));
    end_block(s, where);
    s.at.reset();
}

/// The operation's moves say the tool's direction point by point.
bool has_axis_vectors(const State& s) {
    const std::string_view rest = s.text.substr(s.line.end);
    const std::size_t end = std::min(rest.find(" section"), rest.size());
    return rest.substr(0, end).find("-5axis ") != std::string_view::npos;
}

}  // namespace

void begin_section(State& s) {
    const Place where = place_of(s.line);
    if (s.in_section) fail(s, "a section begins in a section");
    if (!s.has_context) fail(s, "no context says in which coordinates this section counts");
    s.in_section = true;
    if (!s.tool) fail(s, "no tool stands before this section");
    tell_offset(s, where);
    Frame plane = s.context.into_setup;
    plane.origin = {};
    s.direct = has_axis_vectors(s);
    if (s.direct) plane = Frame{};
    if (s.has_run && (s.tool_changed || !(plane == s.told_frame)))
        assume(s, where,
               "between operations the tool is taken to go straight at rapid from the last point to the next: how a "
               "machine goes there is its postprocessor's");
    s.has_run = true;
    s.tool_changed = false;
    if (!(plane == s.told_frame)) tell_plane(s, plane, where);
    s.told_frame = plane;
    s.shift = geom::apply_direction(geom::inverse(plane), s.context.into_setup.origin);
    if (s.context.turning && !(plane == Frame{}))
        refuse(s, where, "the operation turns in a plane that does not hold the axis of the setup");
    if (s.tool) tell_technology(s);
    s.feed_per_turn = parameter(s, "operation:tool_useFeedPerRevolution") == "1";
}

void end_section(State& s) {
    if (!s.in_section) return fail(s, "a section ends that has not begun");
    if (s.cycle) fail(s, "a section ends within a cycle");
    s.cycle.reset();
    s.in_section = false;
    s.has_context = false;
    s.tool.reset();
    s.thread_pitch.reset();
    s.parameters.clear();
}

void read_command(State& s) {
    const Place where = place_of(s.line);
    const auto number = s.line.numbers(0, 1);
    const auto known = number ? base::whole<std::uint32_t>(number->front(), 0U, 1'000'000U) : std::nullopt;
    if (!known) return fail(s, "a command is a whole number");
    constexpr std::uint32_t stop = 1, optional_stop = 2, couples = 12, uncouples = 13;
    if (*known == couples || *known == uncouples) return couple_feed(s, *known == couples);
    if (*known == stop || *known == optional_stop) {
        begin_block(s, where);
        s.build.literal(Code::m, *known == stop ? 0 : 1, where.begin, where.end);
        return end_block(s, where);
    }
    const std::string_view name = dialect::fusion::command_name(*known);
    refuse(s, where, name.empty() ? "nothing is known of this command" : "it says: " + std::string(name));
}

}  // namespace obrys::read::fusion
