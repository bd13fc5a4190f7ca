/// Words of tool length compensation.

#include <cmath>

#include "base/codes.hpp"
#include "base/whole.hpp"
#include "cl/unknown_tool.hpp"
#include "interp/setup/setup.hpp"

namespace obrys::interp {

namespace codes = base::codes;

namespace {

/// The number of no tool: an H that no tool list can have.
constexpr std::uint32_t no_listed_tool = 0xFFFFFFFF;

const shop::Tool* listed_tool(const Reckoning& run, double number) {
    for (const shop::Tool& t : run.tools)
        if (t.number == number) return &t;
    return nullptr;
}

/// What G43 means: the axes of tool H, of the one in the spindle, or nothing where it is not known.
std::optional<Axes> length_of_block(Moving& run) {
    const std::optional<double> h = length_number(run);
    if (h && *h == 0) return Axes{};
    if (h && std::isnan(*h)) {
        unchecked(run, codes::unknown_value, run.here(),
                  "which tool length offset H is meant depends on a value that is not known");
        return std::nullopt;
    }
    const shop::Tool* t = h ? listed_tool(run, *h) : run.tool.data;
    if (t != nullptr) return axes_of(*t);
    if (!h && run.tool.number == cl::unknown_tool) return std::nullopt;
    if (!h && run.tool.number == 0) return Axes{};
    if (run.tools.empty()) {
        assume(run, run.here(),
               "no tools are given: the tool length offset is taken as that of the tool in the spindle",
               "give the tool table of the control to have offset numbers and lengths checked");
        return std::nullopt;
    }
    const std::string which = h ? "H" + printed(Value::real(*h)) : "T" + std::to_string(run.tool.number);
    alarm(run, codes::tool_missing, run.here(), "tool length offset: " + which + " is not in the tool table");
    return std::nullopt;
}

/// Whose compensation is in force from here on.
void take_length(Moving& run, Modal m) {
    using Length = Offsets::Length;
    Offsets& o = run.offsets;
    const BlockWords& b = run.block;
    const bool kept = run.traits->offset_numbers_stay && !std::isnan(o.number);
    const bool numbered = b.has(Code::offset_h) || (kept && m != Modal::tool_length_off);
    judge_anew(o);
    o.subtracts = m == Modal::tool_length_negative;
    const double offset = b.has(Code::offset_h) ? b.get(Code::offset_h) : o.number;
    if (b.has(Code::offset_h) || !numbered) o.said_for = run.tool.number;
    o.length_tool = numbered ? base::cut<std::uint32_t>(offset).value_or(no_listed_tool) : run.tool.number;
    const bool ends = m == Modal::tool_length_off || (numbered && o.length_tool == 0);
    const bool of_tool = m == Modal::tool_length;
    o.length = ends ? Length::none : of_tool ? Length::of_tool : Length::by_values;
    o.compensates = o.compensates || !ends;
}

/// Without Z the control may move the tool by the length there and then; on the way to a place of the machine no length
/// counts. In a cut that is another part, above it the next Z sets it right.
void say_length_may_move(Moving& run, Modal m) {
    const BlockWords& b = run.block;
    const bool to_machine = b.suppress != Modal::linear || b.special == Modal::home;
    const bool ends = m == Modal::tool_length_off, held = run.offsets.length != Offsets::Length::none;
    if (run.traits->length_word_setting.empty() || b.has(Code::z) || to_machine || (ends && !held) ||
        std::isnan(run.position.z))
        return;
    const std::string text = std::string(ends ? "the end of the tool's length" : "a length of the tool") +
                             " without Z: whether the tool moves by it at once depends on " +
                             std::string(run.traits->length_word_setting) + "; it is taken to stay where it is";
    constexpr const char* remedy = "write Z in the same block";
    if (held && run.modal.motion != Modal::rapid) return unchecked(run, codes::unknown_value, run.here(), text, remedy);
    assume(run, run.here(), text, remedy);
}

/// A length that nobody has given is compensated all the same.
void tell_length_word(Moving& run, Modal m) {
    if (m != Modal::tool_length && m != Modal::tool_length_negative) return;
    take_length(run, m);
    const cl::ToolLength length{
        static_cast<std::int8_t>(m == Modal::tool_length ? 1 : -1), run.offsets.length_tool, {}};
    if (length == run.told.length) return;
    run.told.length = length;
    emit(run, length);
}

}  // namespace

void tool_length_words(Moving& run, Modal m) {
    say_length_may_move(run, m);
    const cl::ToolLength before = run.told.length;
    const bool was_given = !run.offsets.is_not_given;
    std::optional<Axes> by;
    if (m == Modal::tool_length_off) by = Axes{};
    const bool adds_axes = m == Modal::tool_length_added && run.block.special == Modal::tool_length_by_axes;
    if (adds_axes)
        by = Axes{};
    else if (m == Modal::tool_length || m == Modal::tool_length_negative || m == Modal::tool_length_added)
        by = length_of_block(run);
    if (run.stopped) return;
    if (m == Modal::tool_length_by_axes || adds_axes) {
        if (!adds_axes) by = run.offsets.tool;
        for (std::size_t k = 0; k < 9; ++k)
            if (const auto v = axis_word(run, k)) (*by)[k] = *v;
    }
    if (by) {
        if (m == Modal::tool_length_negative)
            for (double& v : *by) v = -v;
        if (m == Modal::tool_length_added)
            for (std::size_t k = 0; k < 9; ++k) (*by)[k] += run.offsets.tool[k];
        take_length(run, m);
        tell_length(run, *by);
        set_tool_offset(run, *by);
        take_tip(run);
    } else {
        tell_length_word(run, m);
        hear(run, heard::ToolOffset{run.offsets.tool});
    }
    run.offsets.is_not_given = !by;
    // By how much the tip's place along Z has changed is not known: what was said of it is said no longer.
    if (!(run.told.length == before) && (!was_given || !by)) run.unsaid_since_change[2] = true;
}

}  // namespace obrys::interp
