/// What a program sets besides its moves, in the order in which it acts: how moves are joined and overrides for
/// everybody, the rest for those who listen.

#include <utility>

#include "base/whole.hpp"
#include "interp/stream/path_stage.hpp"
#include "interp/stream/stream.hpp"

namespace obrys::interp {

void pass_on(Telling& run, Heard what) {
    if (run.capture != nullptr) return;
    const base::Span& from = run.along != nullptr ? run.along->where : run.here();
    if (run.path->holds())
        run.path->hold(std::move(what), from);
    else
        (*run.listener)(what, from);
}

namespace {

cl::PathMode path_mode_of(const ModalState& m, bool smoothing_words) {
    cl::PathMode p;
    constexpr int free_way = 64, by_distance = 641;
    if (smoothing_words) {
        p.kind = m.smoothing == 0          ? cl::PathKind::exact_stop
                 : m.smoothing == free_way ? cl::PathKind::free
                                           : cl::PathKind::within;
        if (m.smoothing == by_distance) p.tolerance = m.rounding_distance;
        if (m.smoothing > by_distance) p.way = base::clipped<std::uint16_t>(m.smoothing, 0, 999);
        return p;
    }
    p.kind = m.path_mode == Modal::path_exact  ? cl::PathKind::exact
             : m.path_mode == Modal::path_stop ? cl::PathKind::exact_stop
             : m.blend > 0                     ? cl::PathKind::within
                                               : cl::PathKind::free;
    p.tolerance = m.blend;
    if (m.merge != m.blend) p.merge = m.merge;
    return p;
}

}  // namespace

void tell_joining(Telling& run, bool smoothing_words) {
    const cl::PathMode now = path_mode_of(run.modal, smoothing_words);
    if (run.told.path && *run.told.path == now) return;
    run.told.path = now;
    emit(run, now);
}

heard::Joining joining_in_force(const Reckoning& run) {
    const ModalState& m = run.modal;
    const cl::PathKind kind = m.path_mode == Modal::path_exact  ? cl::PathKind::exact
                              : m.path_mode == Modal::path_stop ? cl::PathKind::exact_stop
                                                                : cl::PathKind::within;
    return {kind, m.blend, m.merge};
}

void switch_override(Telling& run, cl::OverrideKind kind, bool on) {
    if (kind == cl::OverrideKind::feed) run.overrides.feed = on;
    if (kind == cl::OverrideKind::spindle) run.overrides.speed = on;
    if (kind == cl::OverrideKind::feed_hold) run.overrides.hold = on;
    emit(run, cl::Override{kind, on});
}

heard::Zero zero_in_force(const Reckoning& run) {
    return {run.modal.datum, run.offsets.datum, run.offsets.shift, run.offsets.rotation};
}

void hear_beginning(Telling& run) {
    if (!run.listener || !keeps_offsets(run) || run.statement == nullptr) return;
    hear(run, heard::Counting{run.frame, run.offsets.total});
    hear(run, zero_in_force(run));
}

void hear_end(Telling& run, int m) {
    if (!run.listener || !keeps_offsets(run)) return;
    constexpr std::uint32_t first = 54;
    const KeptZero zero = kept_zero(run, first);  // the program may have written its parameters
    hear(run, heard::Zero{first, zero.at, {}, zero.turn});
    if (const auto* settings = run.env.settings; settings != nullptr)
        if (const auto drops = settings->find("RS274NGC/DISABLE_G92_PERSISTENCE");
            drops != settings->end() && drops->second == "1")
            hear(run, heard::Shift{{}, true});
    if (m == 30) hear(run, heard::PalletChange{});
}

}  // namespace obrys::interp
