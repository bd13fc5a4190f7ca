#include "cl/canon.hpp"

#include <algorithm>
#include <cmath>
#include <cstdarg>
#include <cstdio>
#include <utility>

#include "base/whole.hpp"
#include "cl/totals.hpp"
#include "geom/vec.hpp"

namespace obrys::cl {

namespace {

/// printf's fixed point in the C locale: this program never sets another one.
std::string text(const char* format, ...) __attribute__((format(printf, 1, 2)));
std::string text(const char* format, ...) {
    std::array<char, 512> buffer{};
    va_list values;
    va_start(values, format);
    const int n = std::vsnprintf(buffer.data(), buffer.size(), format, values);
    va_end(values);
    return {buffer.data(), static_cast<std::size_t>(std::min(std::max(n, 0), static_cast<int>(buffer.size()) - 1))};
}

/// A length that went through millimetres is printed as the number it was: ties round as they did.
double restored(double v) {
    if (!(std::abs(v) < 1e6)) return std::isnan(v) ? 0 : v;
    const double r = std::round(v * 1e10) / 1e10;
    return r == 0 ? 0 : r;
}

}  // namespace

void CanonWriter::call(std::string what) {
    out_(text("%5llu ", static_cast<unsigned long long>(++lines_)) + prefix_ + what + "\n");
}

void CanonWriter::begin() {
    begun_ = true;
    call("SET_FEED_REFERENCE(CANON_XYZ)");
    call("ON_RESET()");
}

geom::Vec3 CanonWriter::programmed(const geom::Vec3& stream) const {
    const geom::Vec3 p = (1 / unit_) * geom::apply(into_program_, stream);
    return {restored(p.x), restored(p.y), restored(p.z)};
}

std::string CanonWriter::axes(const std::array<double, 12>& values, std::size_t from, std::size_t to,
                              std::string_view between) const {
    std::string out;
    for (std::size_t k = from; k < to; ++k) {
        const bool rotary = k >= 3 && k < 6;
        out += (k > from ? std::string(between) : "") + text("%.4f", restored(values[k] / (rotary ? 1 : unit_)));
    }
    return out;
}

bool CanonWriter::offsets(const Setting& s) {
    const auto& v = s.values;
    switch (s.kind) {
        case SettingKind::frame: {
            geom::Frame f;
            f.linear = {v[0], v[1], v[2], v[4], v[5], v[6], v[8], v[9], v[10]};
            f.origin = {v[3], v[7], v[11]};
            into_program_ = geom::inverse(f);
            return true;
        }
        case SettingKind::axis_offsets:
            for (std::size_t k = 3; k < 9; ++k) offset_[k] = v[k];
            return true;
        case SettingKind::datum:
            if (lines_ == 0) call("USE_LENGTH_UNITS(CANON_UNITS_MM)");
            call("SET_G5X_OFFSET(" + std::to_string(s.number) + ", " + axes(v, 0, 6, ", ") + ")");
            return true;
        case SettingKind::shift: {
            const std::string set = "SET_G92_OFFSET(" + axes(v, 0, 6, ", ") + ")";
            if (s.number == 1)
                at_end_ = set;
            else
                call(set);
            return true;
        }
        case SettingKind::datum_rotation:
            call("SET_XY_ROTATION(" + text("%.4f", v[0]) + ")");
            if (!begun_) begin();
            return true;
        case SettingKind::datum_kept:
            call("COMMENT(\"interpreter: continuing to use same coordinate system\")");
            return true;
        case SettingKind::datum_written:
            call("COMMENT(\"interpreter: setting coordinate system origin\")");
            return true;
        case SettingKind::tool_offset:
            for (std::size_t k = 0; k < 3; ++k) moved_[k] += length_[k] - v[k], length_[k] = v[k];
            call("USE_TOOL_LENGTH_OFFSET(" + axes(v, 0, 3, " ") + ", " + axes(v, 3, 6, " ") + ", " +
                 axes(v, 6, 9, " ") + ")");
            return true;
        case SettingKind::tool_entry: {
            const double inch = unit_;
            unit_ = 25.4;  // the table's
            call(text("SET_TOOL_TABLE_ENTRY(%d, %d, ", s.number, s.second) + axes(v, 0, 9, " ") +
                 text(", %.4f, %.4f, %d)", v[9], v[10], base::clipped<int>(v[11], 0, 99)));
            unit_ = inch;
            return true;
        }
        default: return false;
    }
}

bool CanonWriter::modes(const Setting& s) {
    const auto comment = [&](const std::string& what) {
        call("COMMENT(\"interpreter: " + what + "\")");
        return true;
    };
    switch (s.kind) {
        case SettingKind::unit:
            unit_ = s.number == 1 ? 25.4 : 1;
            call(s.number == 1 ? "USE_LENGTH_UNITS(CANON_UNITS_INCHES)" : "USE_LENGTH_UNITS(CANON_UNITS_MM)");
            return true;
        case SettingKind::plane:
            plane_ = s.number;
            call(std::string("SELECT_PLANE(CANON_PLANE_") + (plane_ == 17 ? "XY)" : plane_ == 18 ? "XZ)" : "YZ)"));
            return true;
        case SettingKind::feed_mode:
            comment(std::string("feed mode set to ") + (s.number == 93   ? "inverse time"
                                                        : s.number == 94 ? "units per minute"
                                                                         : "units per revolution"));
            call(text("SET_FEED_MODE(0, %d)", s.number == 95 ? 1 : 0));
            if (s.number != 93) call("SET_FEED_RATE(0.0000)");
            return true;
        case SettingKind::path_mode:
            if (s.number == 0) call("SET_MOTION_CONTROL_MODE(CANON_EXACT_PATH)");
            if (s.number == 1) call("SET_MOTION_CONTROL_MODE(CANON_EXACT_STOP)");
            if (s.number == 2) {
                call(text("SET_MOTION_CONTROL_MODE(CANON_CONTINUOUS, %f)", restored(s.values[0] / unit_)));
                call(text("SET_NAIVECAM_TOLERANCE(%.4f)", restored(s.values[1] / unit_)));
            }
            return true;
        case SettingKind::compensation:
            return comment(std::string("cutter radius compensation ") + (s.number == 0   ? "off"
                                                                         : s.number == 1 ? "on left"
                                                                                         : "on right"));
        case SettingKind::incremental:
            return comment(std::string("distance mode changed to ") + (s.number == 1 ? "incremental" : "absolute"));
        case SettingKind::centre_incremental:
            return comment(std::string("IJK distance mode changed to ") + (s.number == 1 ? "incremental" : "absolute"));
        case SettingKind::diameter:
            return comment(std::string("Lathe diameter mode changed to ") + (s.number == 1 ? "diameter" : "radius"));
        case SettingKind::retract_clearance:
            return comment(std::string("retract mode set to ") + (s.number == 1 ? "r_plane" : "old_z"));
        case SettingKind::motion_off: return comment("motion mode set to none");
        default: return false;
    }
}

bool CanonWriter::technology(const Setting& s) {
    switch (s.kind) {
        case SettingKind::feed_rate: call(text("SET_FEED_RATE(%.4f)", s.values[0])); return true;
        case SettingKind::tool_selected: call(text("SELECT_TOOL(%d)", s.number)); return true;
        case SettingKind::tool_changed:
            call("STOP_SPINDLE_TURNING(0)");
            call("CHANGE_TOOL()");
            return true;
        case SettingKind::tool_numbered: call(text("CHANGE_TOOL_NUMBER(%d)", s.number)); return true;
        case SettingKind::surface_speed: call(text("SET_SPINDLE_MODE(0 %.4f)", s.values[0])); return true;
        case SettingKind::spindle_speed: call(text("SET_SPINDLE_SPEED(0, %.4f)", s.values[0])); return true;
        case SettingKind::spindle_turn:
            call(s.number == 0   ? "STOP_SPINDLE_TURNING(0)"
                 : s.number == 1 ? "START_SPINDLE_CLOCKWISE(0)"
                                 : "START_SPINDLE_COUNTERCLOCKWISE(0)");
            return true;
        case SettingKind::spindle_orient:
            call(text("ORIENT_SPINDLE(0, %.4f, %d)", s.values[0], s.number));
            if (s.values[1] > 0) call(text("SPINDLE.0.WAIT_ORIENT_COMPLETE(%.4f)", s.values[1]));
            return true;
        case SettingKind::synchronised:
            call(s.number == 1 ? text("START_SPEED_FEED_SYNC(%f,0)", restored(s.values[0] / unit_))
                               : std::string("STOP_SPEED_FEED_SYNCH()"));
            return true;
        case SettingKind::curve: call(text("NURBS_FEED(%d, ...)", s.number)); return true;
        case SettingKind::coolant:
            if (s.number == 7) call("MIST_ON()");
            if (s.number == 8) call("FLOOD_ON()");
            if (s.number == 9) call("MIST_OFF()");
            if (s.number == 9) call("FLOOD_OFF()");
            mist_ = s.number != 9 && (mist_ || s.number == 7);
            flood_ = s.number != 9 && (flood_ || s.number == 8);
            return true;
        case SettingKind::pallet_change: pallet_ = true; return true;
        default: return false;
    }
}

void CanonWriter::setting(const Setting& s) {
    if (!offsets(s) && !modes(s)) technology(s);
}

/// Another length has moved the zero under a tool that stands still: in the stream a line leads to where the next arc
/// begins, which the control does not call.
bool CanonWriter::only_leads(const Linear& l) const {
    constexpr double same_place = 1e-6;  // mm
    if (l.rapid || moved_ == std::array<double, 3>{}) return false;
    const geom::Vec3 stands = geom::apply(into_program_, at_) + geom::Vec3{moved_[0], moved_[1], moved_[2]};
    return geom::distance(stands, geom::apply(into_program_, l.to)) < same_place;
}

void CanonWriter::move(std::string_view name, const geom::Vec3& to) {
    const geom::Vec3 p = programmed(to);
    call(std::string(name) + text("(%.4f, %.4f, %.4f, %.4f, %.4f, %.4f)", p.x, p.y, p.z,
                                  restored(stream_[3] - offset_[3]), restored(stream_[4] - offset_[4]),
                                  restored(stream_[5] - offset_[5])));
}

void CanonWriter::line(const Linear& l) {
    if (l.seek == Seek::nothing) return move(l.rapid ? "STRAIGHT_TRAVERSE" : "STRAIGHT_FEED", l.to);
    call("TURN_PROBE_ON()");
    move("STRAIGHT_PROBE", l.to);
    call("TURN_PROBE_OFF()");
}

void CanonWriter::output(const Output& o) {
    if (o.analog)
        return call(
            text("SET_%s_OUTPUT_VALUE(%d,%f)", o.with_motion ? "MOTION" : "AUX", static_cast<int>(o.number), o.value));
    call(text("%s_%s_OUTPUT_BIT(%d)", o.value != 0 ? "SET" : "CLEAR", o.with_motion ? "MOTION" : "AUX",
              static_cast<int>(o.number)));
}

void CanonWriter::allow(const Override& o) {
    constexpr std::array<std::string_view, 4> names{"FEED_OVERRIDE()", "SPEED_OVERRIDE(0)", "ADAPTIVE_FEED()",
                                                    "FEED_HOLD()"};
    if (o.kind == OverrideKind::feed) feed_override_ = o.on;
    call(std::string(o.on ? "ENABLE_" : "DISABLE_") + std::string(names[static_cast<std::size_t>(o.kind)]));
}

void CanonWriter::arc(const Arc& a) {
    const geom::Vec3 end = programmed(a.to), centre = programmed(a.centre);
    const geom::Vec3 normal = geom::apply_direction(into_program_, a.normal);
    const double along = plane_ == 17 ? normal.z : plane_ == 18 ? normal.y : normal.x;
    const double turns = std::ceil(std::abs(a.sweep) / (2 * geom::pi) - 1e-9);
    const int sense = (a.sweep > 0) == (along > 0) ? 1 : -1;
    const std::array<double, 5> v = plane_ == 17   ? std::array{end.x, end.y, centre.x, centre.y, end.z}
                                    : plane_ == 18 ? std::array{end.z, end.x, centre.z, centre.x, end.y}
                                                   : std::array{end.y, end.z, centre.y, centre.z, end.x};
    call(text("ARC_FEED(%.4f, %.4f, %.4f, %.4f, %d, %.4f, %.4f, %.4f, %.4f)", v[0], v[1], v[2], v[3],
              sense * base::clipped<int>(turns, 1, 1'000'000'000), v[4], restored(stream_[3] - offset_[3]),
              restored(stream_[4] - offset_[4]), restored(stream_[5] - offset_[5])));
}

/// A rigid tap is one call for its way down; the way back is not printed.
void CanonWriter::thread(const Thread& t) {
    if (t.rigid_tap && tapped_) {
        tapped_ = false;
        return;
    }
    tapped_ = t.rigid_tap;
    if (!t.rigid_tap) return move("STRAIGHT_FEED", t.to);
    const geom::Vec3 p = programmed(t.to);
    call(text("RIGID_TAP(%.4f, %.4f, %.4f)", p.x, p.y, p.z));
}

void CanonWriter::program_end() {
    if (plane_ != 17) call("SELECT_PLANE(CANON_PLANE_XY)");
    call("SET_FEED_MODE(0, 0)");
    call("SET_FEED_RATE(0.0000)");
    if (!feed_override_) call("ENABLE_FEED_OVERRIDE()");
    call("STOP_SPINDLE_TURNING(0)");
    call("SET_SPINDLE_MODE(0 0.0000)");
    if (mist_) call("MIST_OFF()");
    if (flood_) call("FLOOD_OFF()");
    if (!at_end_.empty()) call(at_end_);
    if (pallet_) call("PALLET_SHUTTLE()");
    call("PROGRAM_END()");
    ended_ = true;
}

void CanonWriter::stop(const Stop& s) {
    if (s.kind == StopKind::optional) call("OPTIONAL_PROGRAM_STOP()");
    if (s.kind == StopKind::end) return program_end();
    if (s.kind != StopKind::program) return;
    if (pallet_) call("PALLET_SHUTTLE()");
    pallet_ = false;
    call("PROGRAM_STOP()");
}

void CanonWriter::operator()(const Record& r) {
    if (const std::optional<Record> lead = std::exchange(lead_, std::nullopt)) {
        if (!std::holds_alternative<Arc>(r.step) || !(r.from == lead->from)) print(*lead);
    } else if (const auto* l = std::get_if<Linear>(&r.step); l != nullptr && only_leads(*l)) {
        lead_ = r;
        return;
    }
    print(r);
}

void CanonWriter::take(const AxisEnds& ends) {
    for (const AxisEnd& end : ends) {
        const auto k = std::string_view("XYZABCUVW").find(end.name[0]);
        if (k != std::string_view::npos && end.name[1] == 0) stream_[k] = end.to;
    }
}

void CanonWriter::print(const Record& r) {
    if (is_move(r.step)) at_ = position_after(at_, r.step), moved_ = {};
    const std::string n = block_number_(r.from);
    prefix_ = n.empty() ? "N..... " : "N" + n + (n.size() < 6 ? std::string(6 - n.size(), ' ') : "");
    if (const auto* s = std::get_if<Setting>(&r.step)) return setting(*s);
    if (const auto* o = std::get_if<Output>(&r.step)) return output(*o);
    if (const auto* o = std::get_if<Override>(&r.step)) return allow(*o);
    if (!begun_ && lines_ > 0) begin();
    if (const AxisEnds* ends = ends_of(r.step)) take(*ends);
    if (const auto* l = std::get_if<Linear>(&r.step)) return line(*l);
    if (const auto* a = std::get_if<Arc>(&r.step)) return arc(*a);
    if (const auto* t = std::get_if<Thread>(&r.step)) return thread(*t);
    if (const auto* s = std::get_if<Stop>(&r.step)) return stop(*s);
    if (const auto* d = std::get_if<Dwell>(&r.step)) call(text("DWELL(%.4f)", d->seconds));
    if (const auto* c = std::get_if<Comment>(&r.step)) {
        if (c->terminal)
            out_(c->text + "\n");
        else
            call((c->message ? "MESSAGE(\"" : "COMMENT(\"") + c->text + "\")");
    }
}

void CanonWriter::finish(int percents, int resets, bool refused) {
    if (const std::optional<Record> lead = std::exchange(lead_, std::nullopt)) print(*lead);
    prefix_ = "N..... ";
    if (lines_ > 0 && !begun_) begin();
    if (ended_ && percents == 1) call("COMMENT(\"interpreter: percent sign missing from end of file\")");
    if (!ended_ && percents == 2 && !refused) call("FINISH()");
    for (int i = 0; i < resets; ++i) call("ON_RESET()");
}

}  // namespace obrys::cl
