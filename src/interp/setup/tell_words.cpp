/// F, S, T and M of the block in the order in which they act, for who wants to know.

#include <algorithm>

#include "base/whole.hpp"
#include "interp/setup/setup.hpp"

namespace obrys::interp {

void hear_inverse_feed(Moving& run, double length) {
    if (!run.listener || run.modal.feed_mode != cl::FeedMode::inverse_time) return;
    hear(run, heard::FeedNumber{std::max(0.1, length / length_unit(run.modal) * run.block.peek(Code::feed))});
}

namespace {

/// A number as a whole one; 0 where it is none that fits.
int whole(double v) { return base::cut<int>(v, -1'000'000'000, 1'000'000'000).value_or(0); }

/// Place in the tool list, 1 the first; 0 where it is not there.
int place_of(const Reckoning& run, std::uint32_t number) {
    for (std::size_t i = 0; i < run.tools.size(); ++i)
        if (run.tools[i].number == number) return static_cast<int>(i) + 1;
    return 0;
}

void tell_tool(Moving& run) {
    const BlockWords& b = run.block;
    if (b.has(Code::tool)) hear(run, heard::ToolWord{whole(b.peek(Code::tool))});
    const int numbers = run.traits->tool_number_function;
    if (numbers != 0 && run.block.has_m(numbers) && b.has(Code::q) && b.peek(Code::q) >= 0)
        hear(run, heard::ToolNumbered{place_of(run, static_cast<std::uint32_t>(std::max(0, whole(b.peek(Code::q)))))});
    if (run.block.has_m(6)) hear(run, heard::ToolChanged{});
}

/// M62 … M68 of controls that have them; of others they are functions of the machine.
void outputs(Moving& run) {
    const BlockWords& b = run.block;
    const auto number_of = [&](Code c) { return b.has(c) ? base::clipped<std::uint32_t>(b.peek(c), 0, 1'000'000) : 0; };
    for (const int m : b.m) {
        if (m == 66) forget_live(run, program::SystemVariable::input_value);
        if (!is_own_function(run, m)) continue;
        if (m >= 62 && m <= 65) emit(run, cl::Output{number_of(Code::p), false, m % 2 == 0 ? 1.0 : 0.0, m <= 63});
        if (m == 67 || m == 68)
            emit(run, cl::Output{number_of(Code::e), true, b.has(Code::q) ? b.peek(Code::q) : 0, m == 67});
    }
}

void tell_spindle(Moving& run) {
    for (const int m : run.block.m) {
        if (m >= 3 && m <= 5) hear(run, heard::SpindleTurn{m == 3 ? 1 : m == 4 ? -1 : 0});
        if (m == 19)
            hear(run, heard::SpindleOrient{run.block.has(Code::radius) ? run.block.peek(Code::radius) : 0,
                                           run.block.has(Code::p) ? whole(run.block.peek(Code::p)) : 0,
                                           run.block.has(Code::q) ? run.block.peek(Code::q) : 0});
    }
}

void set_overrides(Moving& run) {
    const BlockWords& b = run.block;
    const bool on = !b.has(Code::p) || b.peek(Code::p) != 0;
    for (const int m : b.m) {
        if (m == 60) hear(run, heard::PalletChange{});
        if (m >= 7 && m <= 9) hear(run, heard::CoolantWord{m});
        if (!is_own_function(run, m)) continue;
        if (m == 48 || m == 50 || m == 49) switch_override(run, cl::OverrideKind::feed, m == 48 || (m == 50 && on));
        if (m == 48 || m == 51 || m == 49) switch_override(run, cl::OverrideKind::spindle, m == 48 || (m == 51 && on));
        if (m == 52) switch_override(run, cl::OverrideKind::adaptive_feed, on);
        if (m == 53) switch_override(run, cl::OverrideKind::feed_hold, on);
    }
}

}  // namespace

void tell_technology(Moving& run) {
    const BlockWords& b = run.block;
    if (b.surface_word != 0)
        hear(run, heard::SpeedKind{b.surface_word == 97       ? 0
                                   : b.has(Code::speed_limit) ? b.peek(Code::speed_limit)
                                                              : 1e30});
    if (b.has(Code::feed) && run.modal.feed_mode != cl::FeedMode::inverse_time)
        hear(run, heard::FeedNumber{b.peek(Code::feed)});
    if (b.has(Code::spindle)) hear(run, heard::SpeedNumber{b.peek(Code::spindle)});
    if (b.m.empty() && !b.has(Code::tool)) return;
    outputs(run);
    tell_tool(run);
    tell_spindle(run);
    set_overrides(run);
}

}  // namespace obrys::interp
