/// Where the tip of the tool in the spindle is.

#include "interp/stream/stream.hpp"

namespace obrys::interp {

using Length = Offsets::Length;
using shop::ToolLengths;

const Offsets::TouchedOff* touched_off(const Reckoning& run) {
    const auto found = run.offsets.zeros.find(run.modal.datum);
    return found == run.offsets.zeros.end() ? nullptr : &found->second;
}

namespace {

/// What the zero counts from, seen from the gauge point: the tip of the tool it was set with, or that point itself;
/// nothing: not known, and the tip is taken to be where the program says.
std::optional<Axes> base_of(const Reckoning& run) {
    const Offsets& o = run.offsets;
    const bool taken_at_change = run.env.tool_lengths == ToolLengths::at_change;
    if (o.length == Length::none && taken_at_change) return std::nullopt;
    const Offsets::TouchedOff* zero = touched_off(run);
    if (zero != nullptr && zero->compensated) return Axes{};
    if (zero != nullptr && (zero->offset[2] == 0 || run.env.tool_lengths != ToolLengths::touched_off))
        return std::nullopt;
    if (zero != nullptr) return zero->offset;
    const bool open = run.env.tool_lengths == ToolLengths::touched_off && o.length == Length::none;
    if (open || !(o.compensates || run.env.tool_lengths == ToolLengths::gauge)) return std::nullopt;
    return Axes{};
}

}  // namespace

void while_standing(Telling& run, base::FunctionRef<void()> change) {
    flush_path(run);
    const Axes before = tip_in_use(run.offsets);
    change();
    const Axes after = tip_in_use(run.offsets);
    for (std::size_t k = 0; k < 3; ++k) coordinate(run.position, static_cast<int>(k)) += before[k] - after[k];
    update_frame(run);
}

Axes axes_of(const shop::Tool& t) {
    Axes a = t.table ? t.table->offset : Axes{};
    a[2] = t.length + t.delta_length;
    return a;
}

void take_tip(Telling& run) {
    if (!keeps_offsets(run)) return;
    const shop::Tool* t = run.tool.data;
    while_standing(run, [&] {
        Offsets& o = run.offsets;
        const std::optional<Axes> base = base_of(run);
        o.tip_known = base && t != nullptr && t->length != 0;
        o.tip = t != nullptr ? axes_of(*t) : Axes{};
        for (std::size_t k = 0; k < o.tip.size() && base; ++k) o.tip[k] -= (*base)[k];
    });
}

}  // namespace obrys::interp
