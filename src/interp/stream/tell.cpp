/// What a program sets besides its moves, in the order in which it acts: outputs and overrides for everybody, the rest
/// for those who want to compare it with canonical calls (cl::Setting).

#include <algorithm>

#include "base/whole.hpp"
#include "interp/stream/stream.hpp"

namespace obrys::interp {

using cl::SettingKind;

namespace {

template <class Numbers>
void emit_setting(Telling& run, SettingKind kind, int number, const Numbers& values, int second = 0) {
    if (!run.env.tell_settings) return;
    cl::Setting s;
    s.kind = kind;
    s.number = number;
    s.second = second;
    std::copy(values.begin(), values.end(), s.values.begin());
    emit(run, s);
}

}  // namespace

void tell(Telling& run, SettingKind kind, int number, std::initializer_list<double> values) {
    emit_setting(run, kind, number, values);
}

void tell_tool_entry(Telling& run, int place, int tool, std::initializer_list<double> values) {
    emit_setting(run, SettingKind::tool_entry, place, values, tool);
}

void tell(Telling& run, SettingKind kind, int number, const Axes& values) { emit_setting(run, kind, number, values); }

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

void tell_path_mode(Telling& run) {
    const ModalState& m = run.modal;
    const int number = m.path_mode == Modal::path_exact ? 0 : m.path_mode == Modal::path_stop ? 1 : 2;
    tell(run, SettingKind::path_mode, number, {m.blend, m.merge});
}

void tell_feed_override(Telling& run, bool on) {
    if (run.env.tell_settings) emit(run, cl::Override{cl::OverrideKind::feed, on});
}

void switch_override(Telling& run, cl::OverrideKind kind, bool on) {
    if (kind == cl::OverrideKind::feed) run.overrides.feed = on;
    if (kind == cl::OverrideKind::spindle) run.overrides.speed = on;
    if (kind == cl::OverrideKind::feed_hold) run.overrides.hold = on;
    emit(run, cl::Override{kind, on});
}

void tell_frame(Telling& run) {
    if (!run.env.tell_settings || run.capture != nullptr || run.statement == nullptr) return;
    const geom::Frame& f = run.frame;
    const geom::Vec3 o = f.origin;
    const geom::Vec3 x = geom::apply_direction(f, {1, 0, 0}), y = geom::apply_direction(f, {0, 1, 0}),
                     z = geom::apply_direction(f, {0, 0, 1});
    tell(run, SettingKind::frame, 0, {x.x, y.x, z.x, o.x, x.y, y.y, z.y, o.y, x.z, y.z, z.z, o.z});
    tell(run, SettingKind::axis_offsets, 0, run.offsets.total);
}

void tell_end(Telling& run, int m) {
    if (!run.env.tell_settings || !keeps_offsets(run)) return;
    run.modal.datum = 54;
    load_datum(run);  // also where it is in force: the program may have written its parameters
    tell(run, SettingKind::datum, 1, run.offsets.datum);
    tell(run, SettingKind::datum_rotation, 0, {run.offsets.rotation});
    const auto* settings = run.env.settings;
    const auto drops = settings == nullptr ? std::map<std::string, std::string>::const_iterator{}
                                           : settings->find("RS274NGC/DISABLE_G92_PERSISTENCE");
    if (settings != nullptr && drops != settings->end() && drops->second == "1")
        tell(run, SettingKind::shift, 1, Axes{});
    if (m == 30) tell(run, SettingKind::pallet_change);
}

void begin_telling(Telling& run) {
    if (!run.env.tell_settings || !keeps_offsets(run) || run.statement == nullptr) return;
    const auto place = place_of_datum(run.modal.datum);
    tell_frame(run);
    tell(run, SettingKind::datum, static_cast<int>(place), run.offsets.datum);
    tell(run, SettingKind::shift, 0, run.offsets.shift);
    tell(run, SettingKind::datum_rotation, 0, {run.offsets.rotation});
}

}  // namespace obrys::interp
