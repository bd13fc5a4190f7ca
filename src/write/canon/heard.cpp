/// Canonical calls of what the control is told.

#include "base/whole.hpp"
#include "write/canon/canon.hpp"

namespace obrys::write {

namespace heard = interp::heard;

namespace {

/// X … of nine axes.
std::span<const double> axes(const interp::Axes& values, std::size_t from, std::size_t to) {
    return std::span(values).subspan(from, to - from);
}

/// G54 is 1, G59.3 is 9; G54.1 P1 is 1001.
std::uint32_t place_of(std::uint32_t zero) {
    return zero >= 5401 ? zero - 5401 + 1001 : zero >= 591 ? zero - 584 : zero - 53;
}

std::string with_sense(bool incremental) { return incremental ? "incremental" : "absolute"; }

}  // namespace

void CanonWriter::hear(const interp::Heard& what, const base::Span& from) {
    print_lead();
    take_number(from);
    std::visit([this](const auto& w) { say(w); }, what);
}

void CanonWriter::say(const heard::Zero& z) {
    if (!calls_.any()) calls_.call("USE_LENGTH_UNITS(CANON_UNITS_MM)");
    calls_.call("SET_G5X_OFFSET(" + std::to_string(place_of(z.number)) + ", " +
                canon_axes(axes(z.at, 0, 6), 0, unit_, ", ") + ")");
    if (z.shift) say(heard::Shift{*z.shift});
    if (!z.turn) return;
    calls_.call("SET_XY_ROTATION(" + decimals(*z.turn) + ")");
    if (!begun_) begin();
}

void CanonWriter::say(const heard::SameZero&) { calls_.remark("continuing to use same coordinate system"); }

void CanonWriter::say(const heard::OtherZero&) { calls_.remark("setting coordinate system origin"); }

void CanonWriter::say(const heard::Shift& s) {
    const std::string set = "SET_G92_OFFSET(" + canon_axes(axes(s.by, 0, 6), 0, unit_, ", ") + ")";
    if (s.at_end)
        at_end_ = set;
    else
        calls_.call(set);
}

void CanonWriter::say(const heard::Counting& c) {
    into_program_ = geom::inverse(c.frame);
    offset_ = c.axes;
}

void CanonWriter::say(const heard::ToolOffset& o) {
    for (std::size_t k = 0; k < 3; ++k) moved_[k] += length_[k] - o.by[k], length_[k] = o.by[k];
    std::string lists;
    for (std::size_t k = 0; k < 9; k += 3)
        lists += (k > 0 ? ", " : "") + canon_axes(axes(o.by, k, k + 3), k, unit_, " ");
    calls_.call("USE_TOOL_LENGTH_OFFSET(" + lists + ")");
}

void CanonWriter::say(const heard::Unit& u) {
    unit_ = u.inch ? 25.4 : 1;
    calls_.call(u.inch ? "USE_LENGTH_UNITS(CANON_UNITS_INCHES)" : "USE_LENGTH_UNITS(CANON_UNITS_MM)");
}

void CanonWriter::say(const heard::Plane& p) {
    plane_ = p.number;
    calls_.call(std::string("SELECT_PLANE(CANON_PLANE_") + (plane_ == 17 ? "XY)" : plane_ == 18 ? "XZ)" : "YZ)"));
}

void CanonWriter::say(const heard::FeedKind& f) {
    constexpr const char* names[] = {"units per minute", "units per revolution", "inverse time"};
    calls_.remark(std::string("feed mode set to ") + names[static_cast<std::size_t>(f.mode)]);
    calls_.call(f.mode == cl::FeedMode::per_rev ? "SET_FEED_MODE(0, 1)" : "SET_FEED_MODE(0, 0)");
    if (f.mode != cl::FeedMode::inverse_time) calls_.call("SET_FEED_RATE(0.0000)");
}

void CanonWriter::say(const heard::FeedNumber& f) { calls_.call("SET_FEED_RATE(" + decimals(f.value) + ")"); }

void CanonWriter::say(const heard::Joining& j) {
    if (j.kind == cl::PathKind::exact) return calls_.call("SET_MOTION_CONTROL_MODE(CANON_EXACT_PATH)");
    if (j.kind == cl::PathKind::exact_stop) return calls_.call("SET_MOTION_CONTROL_MODE(CANON_EXACT_STOP)");
    calls_.call("SET_MOTION_CONTROL_MODE(CANON_CONTINUOUS, " + decimals(restored(j.tolerance / unit_), 6) + ")");
    calls_.call("SET_NAIVECAM_TOLERANCE(" + decimals(restored(j.merge / unit_)) + ")");
}

void CanonWriter::say(const heard::Compensation& c) {
    calls_.remark(std::string("cutter radius compensation ") + (c.side == heard::Side::off    ? "off"
                                                                : c.side == heard::Side::left ? "on left"
                                                                                              : "on right"));
}

void CanonWriter::say(const heard::Increments& i) {
    calls_.remark((i.of_centres ? "IJK distance mode changed to " : "distance mode changed to ") + with_sense(i.on));
}

void CanonWriter::say(const heard::Diameters& d) {
    calls_.remark(std::string("Lathe diameter mode changed to ") + (d.on ? "diameter" : "radius"));
}

void CanonWriter::say(const heard::RetractLevel& l) {
    calls_.remark(std::string("retract mode set to ") + (l.at_r ? "r_plane" : "old_z"));
}

void CanonWriter::say(const heard::NoMotion&) { calls_.remark("motion mode set to none"); }

void CanonWriter::say(const heard::ToolWord& t) { calls_.call("SELECT_TOOL(" + std::to_string(t.number) + ")"); }

void CanonWriter::say(const heard::ToolChanged&) {
    calls_.call("STOP_SPINDLE_TURNING(0)");
    calls_.call("CHANGE_TOOL()");
}

void CanonWriter::say(const heard::ToolNumbered& t) {
    calls_.call("CHANGE_TOOL_NUMBER(" + std::to_string(t.place) + ")");
}

void CanonWriter::say(const heard::ToolEntry& t) {
    constexpr double unit_of_table = 25.4;
    calls_.call("SET_TOOL_TABLE_ENTRY(" + std::to_string(t.place) + ", " + std::to_string(t.number) + ", " +
                canon_axes(t.offset, 0, unit_of_table, " ") + ", " + listed({t.front_angle, t.back_angle}) + ", " +
                std::to_string(t.orientation) + ")");
}

void CanonWriter::say(const heard::SpeedKind& s) {
    calls_.call("SET_SPINDLE_MODE(0 " + decimals(s.surface_limit) + ")");
}

void CanonWriter::say(const heard::SpeedNumber& s) { calls_.call("SET_SPINDLE_SPEED(0, " + decimals(s.value) + ")"); }

void CanonWriter::say(const heard::SpindleTurn& s) {
    calls_.call(s.direction == 0   ? "STOP_SPINDLE_TURNING(0)"
                : s.direction == 1 ? "START_SPINDLE_CLOCKWISE(0)"
                                   : "START_SPINDLE_COUNTERCLOCKWISE(0)");
}

void CanonWriter::say(const heard::SpindleOrient& s) {
    calls_.call("ORIENT_SPINDLE(0, " + decimals(s.angle) + ", " + std::to_string(s.sense) + ")");
    if (s.wait > 0) calls_.call("SPINDLE.0.WAIT_ORIENT_COMPLETE(" + decimals(s.wait) + ")");
}

void CanonWriter::say(const heard::CoolantWord& c) {
    if (c.function == 7) calls_.call("MIST_ON()");
    if (c.function == 8) calls_.call("FLOOD_ON()");
    if (c.function == 9) calls_.call("MIST_OFF()");
    if (c.function == 9) calls_.call("FLOOD_OFF()");
    mist_ = c.function != 9 && (mist_ || c.function == 7);
    flood_ = c.function != 9 && (flood_ || c.function == 8);
}

void CanonWriter::say(const heard::Curve& c) { calls_.call("NURBS_FEED(" + std::to_string(c.points) + ", ...)"); }

void CanonWriter::say(const heard::PalletChange&) { pallet_ = true; }

}  // namespace obrys::write
