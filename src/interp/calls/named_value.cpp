/// Words with a value and a name of their own, and what machine axes are called.

#include <algorithm>
#include <cmath>
#include <string_view>

#include "base/codes.hpp"
#include "base/number.hpp"
#include "base/whole.hpp"
#include "interp/calls/calls.hpp"

namespace obrys::interp {

namespace codes = base::codes;
using program::NamedKind;

std::uint8_t reference_of(const program::Expr& e) {
    return e.kind == program::ExprKind::qualified ? static_cast<std::uint8_t>(e.op + 1) : std::uint8_t{0};
}

namespace {

/// POS[X]=, POSA[C]=: linear axes move on their own, others are additional axes as if they stood in the block.
void position(Moving& run, const program::Named& n) {
    const std::string written = axis_of(run, n.index);
    const std::string axis = machine_axis_name(run, written).value_or(written);
    if (run.stopped) return;
    if (axis.empty() || axis == "?")
        return unchecked(run, codes::unknown_value, run.here(),
                         "which axis is positioned here depends on a value that is not known");
    const double v = number(run, n.value);
    const std::uint8_t reference = reference_of(run.unit().exprs[n.value]);
    const auto k = axis.size() == 1 ? std::string_view("XYZABCUVW").find(axis[0]) : std::string_view::npos;
    if (k != std::string_view::npos && k < 3) {
        run.block.positioned.push_back({axis, v, reference, run.here()});
        run.block.goes_on = run.block.goes_on || n.kind == NamedKind::position_meanwhile;
    } else if (k != std::string_view::npos) {
        run.block.put(axis_code(static_cast<int>(k)), v, reference);
    } else {
        run.block.axes.push_back({axis, v, reference, run.here()});
    }
}

void axis_feed(Reckoning& run, const program::Named& n) {
    const std::string written = axis_of(run, n.index);
    const double feed = number(run, n.value);
    if (run.stopped) return;
    const std::string axis = machine_axis_name(run, written).value_or(written);
    if (feed < 0) return alarm(run, codes::value_range, run.here(), "the feed FA[" + axis + "] is negative");
    if (std::isnan(feed))
        unchecked(run, codes::unknown_value, run.here(),
                  "the feed FA[" + axis + "] depends on a value that is not known: it is not judged");
    run.axis_feeds[axis] = feed * (run.modal.inch_feed ? 25.4 : 1);
    if (axis != "X" && axis != "Y" && axis != "Z")
        assume(run, run.here(), "FA[" + axis + "]= is the feed of a single axis and is not followed");
}

/// The sum offset is among the tool's data: what it holds is known where the program wrote it alone.
void sum_offset(Reckoning& run, double number) {
    if (number == 0) return;
    unchecked_once(run, codes::unknown_value, run.here(),
                   "DL=" + printed(Value::real(number)) + ": the sum offset of T" + std::to_string(run.tool.number) +
                       " D" + std::to_string(run.tool.edge) +
                       " that it adds is not known: the tip is taken to stand where the program says",
                   "write DL=0, or put the offset into the tool's length and radius");
}

/// How other spindles are spoken of: T2=, SPOS[2]=.
std::string extended_name(const std::string& letters, double extension) {
    const std::string n = printed(Value::real(extension));
    return letters + (letters.size() == 1 ? n : "[" + n + "]") + "=";
}

/// Addresses whose extension is a spindle (NC programming 12/2019, extended address notation).
bool is_of_spindle(Code plain) {
    return plain == Code::spindle || plain == Code::m || plain == Code::tool || plain == Code::edge ||
           plain == Code::spindle_position || plain == Code::speed_limit;
}

/// A word of another spindle as the stream has it.
cl::OtherSpindle told_of(std::uint32_t number, Code word, double value) {
    constexpr int oriented = 19;
    cl::OtherSpindle told{.number = number};
    if (word == Code::spindle) told.speed = value;
    if (word == Code::speed_limit) told.limit = value;
    if (word == Code::spindle_position) told.held = value;
    if (word != Code::m) return told;
    const auto m = base::whole<int>(value, 0, 1'000'000'000);
    if (!m)
        told.direction = std::nullopt, told.function = -1;  // which one is not known, as is said
    else if (*m == 3 || *m == 4)
        told.direction = static_cast<std::int8_t>(*m == 3 ? 1 : -1);
    else if (*m == 5)
        told.direction = std::int8_t{0};
    else if (*m == oriented)
        told.held = std::nan("");
    else
        told.function = *m;
    return told;
}

/// A word of another spindle than the master. That of a mill may be the one with the tool in it, on lathes the master
/// turns what is cut.
void word_of_other_spindle(Telling& run, const program::Named& n, double extension) {
    const std::string name = extended_name(run.env.names.text(n.name), extension);
    if (n.plain == Code::tool || n.plain == Code::edge) {
        static_cast<void>(evaluate(run, n.value));
        return unchecked(run, codes::unsupported, run.here(),
                         name +
                             " is the tool of another spindle than the first: which tool cuts from here on is not "
                             "known",
                         "the first spindle's own is written without a number");
    }
    const double value = number(run, n.value);
    if (run.stopped) return;
    other_spindle(run, n.plain, extension, value);
    if (const auto k = base::whole<std::uint32_t>(extension, 1, 999)) emit(run, told_of(*k, n.plain, value));
    if (extension == 1) return;  // SETMS has been said
    const bool turns = n.plain == Code::spindle_position ||
                       (n.plain == Code::m &&
                        (std::isnan(value) || value == 3 || value == 4 || value == 5 || value == 19 || value == 70));
    if (turns && run.env.machine.kind != shop::MachineKind::lathe)
        return unchecked(run, codes::unsupported, run.here(),
                         name +
                             " is for another spindle than the first and is not followed: whether the tool turns is "
                             "not known if that spindle holds it");
    assume(run, run.here(), name + " is for another spindle than the first and is not followed");
}

/// S2=, M2=, T[1]=, H1=, F[X]=: extended addresses. The extension of the master spindle, and 0, act as none.
void extended_value(Calling& run, const program::Statement& s, const program::Word& w, const program::Named& n) {
    const std::string& letters = run.env.names.text(n.name);
    const Value index = n.index == program::no_expr ? Value::real(0) : evaluate(run, n.index);
    if (run.stopped) return;
    if (index.is_unknown())
        return unchecked(run, codes::unknown_value, run.here(),
                         "which spindle or axis " + letters + "[…]= is for depends on a value that is not known");
    if (index.is_text() && n.plain == Code::feed) {  // F[X]=: an axis that is positioned on its own
        static_cast<void>(number(run, n.value));
        return assume(run, run.here(),
                      letters + "[" + index.as_text() + "]= is the feed of a single axis and is not followed");
    }
    const bool known = is_of_spindle(n.plain) || n.plain == Code::h;
    if (index.is_text() || !known)
        return unchecked(run, codes::unknown_word, run.unit().span(s, w),
                         letters + "[…]= is not run: this address has no such extension");
    if (is_of_spindle(n.plain) && index.number != 0 && index.number != run.spindles.master)
        return word_of_other_spindle(run, n, index.number);
    const std::size_t told = run.block.h.size();
    gather(run, s,
           program::make_word(n.plain, static_cast<std::uint32_t>(program::Form::expression),
                              static_cast<std::int32_t>(n.value), w.offset, w.length));
    if (run.block.h.size() > told)
        run.block.h.back().extension = base::whole<std::uint32_t>(index.number, 0, 99'999'999).value_or(0);
}

/// X[2]=: the axis X2.
std::string numbered_axis(Reckoning& run, const program::Named& n) {
    const std::string& letter = run.env.names.text(n.name);
    const Value index = evaluate(run, n.index);
    const auto number = index.is_text() || index.is_unknown() ? std::nullopt : base::whole<int>(index.number, 0, 99);
    if (run.stopped || !number) return "?";
    return *number == 0 ? letter : letter + std::to_string(*number);
}

void special_value(Moving& run, const program::Named& n) {
    if (n.kind == NamedKind::position || n.kind == NamedKind::position_meanwhile) return position(run, n);
    if (n.kind == NamedKind::axis_feed) return axis_feed(run, n);
    const double v = number(run, n.value);
    if (run.stopped) return;
    ModalState& m = run.modal;
    const double unit = length_unit(m);
    switch (n.kind) {
        case NamedKind::rounding_distance:
            m.rounding_distance = std::max(v, 0.0) * unit;
            if (run.told.path) tell_joining(run, true);
            return;
        case NamedKind::rounding_distance_rapid: m.rounding_distance_rapid = std::max(v, 0.0) * unit; return;
        case NamedKind::thread_start: run.block.thread_start = v; return;
        case NamedKind::block_feed: run.block.feed_alone = v; return;
        case NamedKind::contour_tolerance: m.contour_tolerance = v < 0 ? std::nan("") : v * unit; return;
        case NamedKind::contour_allowance: m.contour_allowance = v * unit; return;
        case NamedKind::corner_overshoot:
            if (v < 0 || v > 100)
                return alarm(run, codes::value_range, run.here(),
                             "DISC=" + base::fixed(v, 0) + " is not within 0 and 100");
            m.corner_overshoot = v;
            return;
        default: return sum_offset(run, v);
    }
}

}  // namespace

void named_value(Calling& run, const program::Statement& s, const program::Word& w) {
    const program::Named& n = run.unit().named[static_cast<std::size_t>(w.payload)];
    return n.kind == NamedKind::extended ? extended_value(run, s, w, n) : special_value(run, n);
}

void named_axis(Moving& run, const program::Named& n, const base::Span& where) {
    const std::string& written = run.env.names.text(n.name);
    std::string axis = written;
    if (n.index != program::no_expr) axis = written == "AX" ? axis_of(run, n.index) : numbered_axis(run, n);
    if (run.stopped || n.value == program::no_expr) return;
    if (axis == "?") {
        unchecked(run, codes::unknown_value, where, "which axis this is depends on a value that is not known");
        return;
    }
    const double v = number(run, n.value);
    const std::uint8_t reference = reference_of(run.unit().exprs[n.value]);
    if (const auto machine = machine_axis_name(run, axis)) {
        run.block.machine_axis = run.block.machine_axis || axis.size() > 2;
        axis = *machine;
    }
    if (axis.size() == 1) {
        if (const auto k = std::string_view("XYZABCUVW").find(axis[0]); k != std::string_view::npos) {
            run.block.put(axis_code(static_cast<int>(k)), v, reference);
            return;
        }
    }
    run.block.axes.push_back({axis, v, reference, where});
}

}  // namespace obrys::interp
