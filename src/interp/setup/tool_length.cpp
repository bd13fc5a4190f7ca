/// Where the tip is when the length of the tool is not compensated, or that of another tool is:
/// docs/adr/0016-tool-length.md.

#include <cmath>

#include "base/codes.hpp"
#include "base/number.hpp"
#include "cl/unknown_tool.hpp"
#include "interp/complaints.hpp"
#include "interp/setup/setup.hpp"

namespace obrys::interp {

namespace codes = base::codes;
using Length = Offsets::Length;
using shop::ToolLengths;

namespace {

constexpr double same_length = 1e-6;  ///< mm

double length_of(const shop::Tool& t) { return axes_of(t)[2]; }

std::string millimetres(double v) { return base::fixed(v, 3) + " mm"; }

std::string tool_text(std::uint32_t n) { return "T" + std::to_string(n); }

void finding(Reckoning& run, const shop::Tool& t, double low) {
    const Offsets& o = run.offsets;
    const Offsets::TouchedOff* zero = touched_off(run);
    const std::string where = "its tip is " + millimetres(std::abs(low)) + (low > 0 ? " lower" : " higher") +
                              " than programmed, and is simulated there";
    std::string text, remedy = "program G43 H" + std::to_string(t.number) + " behind the tool change";
    if (o.length == Length::of_tool && o.length_tool != t.number)
        text = tool_text(t.number) + " moves with the length compensation of H" + std::to_string(o.length_tool);
    else if (o.length != Length::none)
        text = tool_text(t.number) + " moves with a length compensation that is not its length";
    else if (zero != nullptr && !zero->compensated)
        text = tool_text(t.number) + " (" + millimetres(length_of(t)) +
               ") moves without length compensation by the zero that " + tool_text(zero->tool) + " (" +
               millimetres(zero->offset[2]) + ") was set with";
    else
        text = tool_text(t.number) + " moves without length compensation";
    base::Diagnostic d;
    d.severity = base::Severity::error;
    d.code = codes::tool_length;
    d.where = run.here();
    d.text = text + ": " + where;
    d.remedy = std::move(remedy);
    d.stack = run.stacks->sites(run.top().stack);
    raise(run, std::move(d));
}

/// Without compensation, and where the tip is then is not known; true where it was said.
bool judge_uncompensated(Reckoning& run, const shop::Tool& t) {
    const Offsets& o = run.offsets;
    const double length = length_of(t);
    const std::string tool = tool_text(t.number);
    const Offsets::TouchedOff* zero = touched_off(run);
    constexpr const char* keys =
        "program G43 H, or say in the job how lengths are taken: tool_length = \"touched-off\", \"at-change\" or "
        "\"gauge\" (docs/job-file.md)";
    if (run.env.tool_lengths == ToolLengths::gauge || (o.compensates && (zero == nullptr || zero->compensated))) {
        unchecked(run, codes::unknown_value, run.here(),
                  tool +
                      " moves without length compensation, and how long it is is not known: it is simulated as "
                      "though its tip were where the program says",
                  "program G43 H" + std::to_string(t.number) + ", or give its length in the job");
    } else if (zero != nullptr && zero->tool != t.number) {
        const auto with_length = [](std::uint32_t n, double mm) {
            return tool_text(n) + (mm != 0 ? " (" + millimetres(mm) + ")" : " (its length is not known)");
        };
        unchecked(run, codes::unknown_value, run.here(),
                  with_length(t.number, length) + " moves without length compensation by the zero of " +
                      with_length(zero->tool, zero->offset[2]) + ": where its tip is is not known",
                  keys);
    } else if (zero != nullptr) {
        return false;
    } else if (run.env.tool_lengths == ToolLengths::not_said && length != 0) {
        unchecked(run, codes::unknown_value, run.here(),
                  tool + " is " + millimetres(length) +
                      " long and moves without length compensation: whether the zero was set with it is not known",
                  keys);
    } else if (run.env.tool_lengths == ToolLengths::not_said) {
        assume(run, run.here(), "no tool length is compensated: the zero is taken to be set with " + tool,
               "say tool_length = \"touched-off\" in the job");
    }
    return true;
}

/// With a compensation that is not that of this tool as far as is known; true where it was said.
bool judge_compensated(Reckoning& run, const shop::Tool& t) {
    const Offsets& o = run.offsets;
    const Offsets::TouchedOff* zero = touched_off(run);
    const bool own = o.length != Length::of_tool || o.length_tool == t.number;
    if (own && (zero == nullptr || zero->compensated)) return false;
    unchecked(run, codes::unknown_value, run.here(),
              own ? tool_text(t.number) + " moves with length compensation by the zero that " + tool_text(zero->tool) +
                        " was set with uncompensated: where its tip is is not known"
                  : tool_text(t.number) + " moves with the length compensation of H" + std::to_string(o.length_tool) +
                        ": where its tip is is not known",
              "give the lengths of both tools, or program G43 H" + std::to_string(t.number));
    return true;
}

/// The block says a height of the workpiece; from home, whose place nobody knows, a step leads nowhere known.
bool names_height(const Moving& run) {
    const BlockWords& b = run.block;
    if (!b.has(Code::z) || std::isnan(b.peek(Code::z))) return false;
    return !is_incremental(run, b.ref(Code::z)) || !std::isnan(run.programmed_position.z);
}

/// No list says how long the tools are: that a length is another tool's shows in its number all the same. One that the
/// program says for this tool, and that is no other tool's of the program so far, may be a further offset of it.
void judge_unlisted(Moving& run) {
    Offsets& o = run.offsets;
    const std::uint32_t tool = run.tool.number;
    const bool of_other = o.length == Length::of_tool && o.length_tool != tool;
    const bool is_known = tool != cl::unknown_tool && o.length_tool != cl::unknown_tool;
    if (!of_other || tool == 0 || !is_known) return;
    if (run.modal.motion == Modal::rapid && !names_height(run)) return;
    o.length_judged = true;
    const std::string moves =
        tool_text(tool) + " moves with the length compensation of H" + std::to_string(o.length_tool);
    const std::string remedy = "program G43 H" + std::to_string(tool);
    if (o.said_for != tool || run.tools_called.contains(o.length_tool))
        return unchecked(run, codes::unknown_value, run.here(), moves + ": where its tip is is not known",
                         remedy + ", or give the tool table of the control");
    assume(run, run.here(), moves + ", which is taken as one of its own", remedy + " if it is not");
}

/// A rapid move to a height: where lengths are compensated in this program, or the zero is another tool's, nobody knows
/// where its tip comes to stand. A zero is not taken by it.
void judge_rapid(Moving& run, const shop::Tool& t) {
    Offsets& o = run.offsets;
    if (o.tip_known || o.length_said || !names_height(run)) return;
    if (o.length != Length::none)
        o.length_said = judge_compensated(run, t);
    else if (run.env.tool_lengths != ToolLengths::at_change && (o.compensates || touched_off(run) != nullptr))
        o.length_said = judge_uncompensated(run, t);
}

/// The first tool that cuts by a zero says how it is meant.
void take_zero(Telling& run, const shop::Tool& t) {
    Offsets& o = run.offsets;
    const bool gauge = o.length != Length::none || run.env.tool_lengths == ToolLengths::gauge ||
                       (o.compensates && run.env.tool_lengths == ToolLengths::not_said);
    o.zeros.try_emplace(run.modal.datum, Offsets::TouchedOff{t.number, axes_of(t), gauge});
    take_tip(run);
}

}  // namespace

void zero_set_here(Reckoning& run) {
    const shop::Tool* t = run.tool.data;
    if (t == nullptr || !keeps_offsets(run)) return;
    Offsets& o = run.offsets;
    o.zeros[run.modal.datum] = {t->number, axes_of(*t), o.length != Length::none};
    judge_anew(o);
}

void judge_length(Moving& run) {
    Offsets& o = run.offsets;
    const shop::Tool* t = run.tool.data;
    const Modal m = run.modal.motion;
    if (run.env.stand_alone) return;  // there is no workpiece
    const bool machine = run.block.suppress != Modal::linear || run.block.special == Modal::home;
    if (run.env.machine.kind != shop::MachineKind::mill || machine || run.capture != nullptr) return;
    if (m == Modal::canned_off || m == Modal::probe) return;  // a probe may be what finds the length
    if (t == nullptr) return judge_unlisted(run);
    if (m == Modal::rapid) return judge_rapid(run, *t);
    o.length_judged = true;
    const bool at_change = run.env.tool_lengths == ToolLengths::at_change;
    if (o.length == Length::none && at_change) return;
    const bool first = touched_off(run) == nullptr;
    if (first && o.length == Length::none && !o.tip_known && !o.length_said)
        static_cast<void>(judge_uncompensated(run, *t));
    if (first) take_zero(run, *t);
    const double low = o.tip_known ? o.tip[2] - o.tool[2] : 0;
    if (std::abs(low) > same_length && o.length != Length::by_values) return finding(run, *t, low);
    if (o.tip_known || o.length_said) return;
    if (o.length != Length::none)
        static_cast<void>(judge_compensated(run, *t));
    else if (!first)
        static_cast<void>(judge_uncompensated(run, *t));
}

}  // namespace obrys::interp
