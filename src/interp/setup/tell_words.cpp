/// F, S, T and M of the block in the order in which they act, for who wants to know.

#include <algorithm>

#include "base/whole.hpp"
#include "interp/setup/setup.hpp"

namespace obrys::interp {

using cl::SettingKind;

void tell_inverse_feed(Moving& run, double length) {
    if (!run.env.tell_settings || run.modal.feed_mode != cl::FeedMode::inverse_time) return;
    tell(run, SettingKind::feed_rate, 0, {std::max(0.1, length / length_unit(run.modal) * run.block.peek(Code::feed))});
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
    const bool changes = run.block.has_m(6);
    if (b.has(Code::tool)) tell(run, SettingKind::tool_selected, whole(b.peek(Code::tool)));
    const int numbers = run.traits->tool_number_function;
    if (numbers != 0 && run.block.has_m(numbers) && b.has(Code::q) && b.peek(Code::q) >= 0)
        tell(run, SettingKind::tool_numbered,
             place_of(run, static_cast<std::uint32_t>(std::max(0, whole(b.peek(Code::q))))));
    if (changes)
        tell(run, SettingKind::tool_changed,
             place_of(run, b.has(Code::tool) ? static_cast<std::uint32_t>(std::max(0, whole(b.peek(Code::tool))))
                                             : run.tool.prepared));
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
        if (m >= 3 && m <= 5) tell(run, SettingKind::spindle_turn, m == 3 ? 1 : m == 4 ? -1 : 0);
        if (m == 19)
            tell(run, SettingKind::spindle_orient, run.block.has(Code::p) ? whole(run.block.peek(Code::p)) : 0,
                 {run.block.has(Code::radius) ? run.block.peek(Code::radius) : 0,
                  run.block.has(Code::q) ? run.block.peek(Code::q) : 0});
    }
}

void set_overrides(Moving& run) {
    const BlockWords& b = run.block;
    const bool on = !b.has(Code::p) || b.peek(Code::p) != 0;
    for (const int m : b.m) {
        if (m == 60) tell(run, SettingKind::pallet_change);
        if (m >= 7 && m <= 9) tell(run, SettingKind::coolant, m);
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
        tell(run, SettingKind::surface_speed, b.surface_word,
             {b.surface_word == 97       ? 0
              : b.has(Code::speed_limit) ? b.peek(Code::speed_limit)
                                         : 1e30});
    if (b.has(Code::feed) && run.modal.feed_mode != cl::FeedMode::inverse_time)
        tell(run, SettingKind::feed_rate, 0, {b.peek(Code::feed)});
    if (b.has(Code::spindle)) tell(run, SettingKind::spindle_speed, 0, {b.peek(Code::spindle)});
    if (b.m.empty() && !b.has(Code::tool)) return;
    outputs(run);
    tell_tool(run);
    tell_spindle(run);
    set_overrides(run);
}

}  // namespace obrys::interp
