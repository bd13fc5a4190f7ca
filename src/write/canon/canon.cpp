/// Canonical calls of the stream.

#include "write/canon/canon.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/whole.hpp"
#include "cl/totals.hpp"
#include "cl/zero.hpp"
#include "geom/vec.hpp"

namespace obrys::write {

namespace {

using cl::CycleKind;

bool taps(CycleKind k) { return k == CycleKind::canned_tap_floating || k == CycleKind::canned_tap_rigid; }

/// Cycles of one hole that blocks call (G81 … G89): the control calls their spindle functions one by one.
bool is_canned(CycleKind k) { return k >= CycleKind::canned_drill && k <= CycleKind::canned_bore_manual; }

bool turns_thread(CycleKind k) {
    return k == CycleKind::lathe_thread_degressive || k == CycleKind::lathe_thread_passes ||
           k == CycleKind::lathe_box_thread;
}

/// What the machine does, and not how the program is built.
bool is_step(const cl::Step& s) {
    return cl::is_move(s) || std::holds_alternative<cl::Dwell>(s) || std::holds_alternative<cl::Feed>(s) ||
           std::holds_alternative<cl::Spindle>(s) || std::holds_alternative<cl::Stop>(s);
}

}  // namespace

void CanonWriter::take_number(const base::Span& from) { calls_.set_number(block_number_(from)); }

void CanonWriter::begin() {
    begun_ = true;
    calls_.call("SET_FEED_REFERENCE(CANON_XYZ)");
    calls_.call("ON_RESET()");
}

geom::Vec3 CanonWriter::programmed(const geom::Vec3& stream) const {
    const geom::Vec3 p = (1 / unit_) * geom::apply(into_program_, stream + from_first_);
    return {restored(p.x), restored(p.y), restored(p.z)};
}

std::string CanonWriter::rotary() const {
    return listed(
        {restored(stream_[3] - offset_[3]), restored(stream_[4] - offset_[4]), restored(stream_[5] - offset_[5])});
}

/// Another length has moved the zero under a tool that stands still: in the stream a line leads to where the next arc
/// begins, which the control does not call.
bool CanonWriter::only_leads(const cl::Linear& l) const {
    constexpr double same_place = 1e-6;  // mm
    if (l.rapid || moved_ == std::array<double, 3>{}) return false;
    const geom::Vec3 stands = geom::apply(into_program_, at_) + geom::Vec3{moved_[0], moved_[1], moved_[2]};
    return geom::distance(stands, geom::apply(into_program_, l.to + from_first_)) < same_place;
}

void CanonWriter::move(std::string_view name, const geom::Vec3& to) {
    const geom::Vec3 p = programmed(to);
    calls_.call(std::string(name) + "(" + listed({p.x, p.y, p.z}) + ", " + rotary() + ")");
}

void CanonWriter::line(const cl::Linear& l) {
    if (l.seek == cl::Seek::nothing) return move(l.rapid ? "STRAIGHT_TRAVERSE" : "STRAIGHT_FEED", l.to);
    calls_.call("TURN_PROBE_ON()");
    move("STRAIGHT_PROBE", l.to);
    calls_.call("TURN_PROBE_OFF()");
}

void CanonWriter::arc(const cl::Arc& a) {
    const geom::Vec3 end = programmed(a.to), centre = programmed(a.centre);
    const geom::Vec3 normal = geom::apply_direction(into_program_, a.normal);
    const double along = plane_ == 17 ? normal.z : plane_ == 18 ? normal.y : normal.x;
    const double turns = std::ceil(std::abs(a.sweep) / (2 * geom::pi) - 1e-9);
    const int sense = (a.sweep > 0) == (along > 0) ? 1 : -1;
    const std::array<double, 5> v = plane_ == 17   ? std::array{end.x, end.y, centre.x, centre.y, end.z}
                                    : plane_ == 18 ? std::array{end.z, end.x, centre.z, centre.x, end.y}
                                                   : std::array{end.y, end.z, centre.y, centre.z, end.x};
    calls_.call("ARC_FEED(" + listed({v[0], v[1], v[2], v[3]}) + ", " +
                std::to_string(sense * base::clipped<int>(turns, 1, 1'000'000'000)) + ", " + decimals(v[4]) + ", " +
                rotary() + ")");
}

void CanonWriter::start_synchronised(double pitch) {
    calls_.call("START_SPEED_FEED_SYNC(" + decimals(restored(std::abs(pitch) / unit_), 6) + ",0)");
}

/// A rigid tap is one call for its way down; the way back is not printed.
void CanonWriter::thread(const cl::Thread& t) {
    if (t.rigid_tap && std::exchange(tapped_, false)) return;
    tapped_ = t.rigid_tap;
    const bool alone = cycles_.empty() || cycles_.back().kind == CycleKind::lathe_finish;  // a block of the program
    if (alone) start_synchronised(t.pitch);
    if (t.rigid_tap) {
        const geom::Vec3 p = programmed(t.to);
        calls_.call("RIGID_TAP(" + listed({p.x, p.y, p.z}) + ")");
    } else {
        move("STRAIGHT_FEED", t.to);
    }
    if (alone) calls_.call("STOP_SPEED_FEED_SYNCH()");
}

void CanonWriter::program_end() {
    if (plane_ != 17) calls_.call("SELECT_PLANE(CANON_PLANE_XY)");
    calls_.call("SET_FEED_MODE(0, 0)");
    calls_.call("SET_FEED_RATE(0.0000)");
    if (!feed_override_) calls_.call("ENABLE_FEED_OVERRIDE()");
    calls_.call("STOP_SPINDLE_TURNING(0)");
    calls_.call("SET_SPINDLE_MODE(0 0.0000)");
    if (mist_) calls_.call("MIST_OFF()");
    if (flood_) calls_.call("FLOOD_OFF()");
    if (!at_end_.empty()) calls_.call(at_end_);
    if (pallet_) calls_.call("PALLET_SHUTTLE()");
    calls_.call("PROGRAM_END()");
    ended_ = true;
}

void CanonWriter::stop(const cl::Stop& s) {
    if (s.kind == cl::StopKind::optional) calls_.call("OPTIONAL_PROGRAM_STOP()");
    if (s.kind == cl::StopKind::end) return program_end();
    if (s.kind != cl::StopKind::program) return;
    if (pallet_) calls_.call("PALLET_SHUTTLE()");
    pallet_ = false;
    calls_.call("PROGRAM_STOP()");
}

void CanonWriter::comment(const cl::Comment& c) {
    if (c.terminal)
        calls_.plain(c.text);
    else
        calls_.call((c.message ? "MESSAGE(\"" : "COMMENT(\"") + c.text + "\")");
}

// --- steps of cycles

/// A tap holds both overrides while it is in the hole; what the program has switched off before stays off behind it.
void CanonWriter::allow_in_cycle(cl::OverrideKind kind, bool on) {
    const bool feed = kind == cl::OverrideKind::feed;
    if (on && !(feed ? feed_override_ : speed_override_)) return;
    calls_.call(std::string(on ? "ENABLE_" : "DISABLE_") + (feed ? "FEED_OVERRIDE()" : "SPEED_OVERRIDE(0)"));
}

void CanonWriter::tap_overrides(const cl::Step& s) {
    OpenCycle& c = cycles_.back();
    if (!taps(c.kind) || !cl::is_move(s) || c.taps != cl::is_rapid(s)) return;
    c.taps = !c.taps;
    for (const cl::OverrideKind kind : {cl::OverrideKind::feed, cl::OverrideKind::spindle})
        allow_in_cycle(kind, !c.taps);
}

/// The thread of a lathe's cycle goes on over its moves until something else comes, and holds the feed override.
void CanonWriter::synchronise(const cl::Step& s) {
    if (!turns_thread(cycles_.back().kind)) return;
    const auto* thread = std::get_if<cl::Thread>(&s);
    if (thread != nullptr && pitch_ == 0) calls_.call("DISABLE_FEED_OVERRIDE()");
    if (thread != nullptr && thread->pitch != pitch_) start_synchronised(thread->pitch);
    if (thread == nullptr && pitch_ != 0) calls_.call("STOP_SPEED_FEED_SYNCH()");
    pitch_ = thread != nullptr ? thread->pitch : 0;
}

void CanonWriter::before_step(const cl::Step& s) {
    tap_overrides(s);
    synchronise(s);
    if (const auto* spindle = std::get_if<cl::Spindle>(&s); spindle != nullptr && is_canned(cycles_.back().kind))
        say(interp::heard::SpindleTurn{spindle->direction});
}

void CanonWriter::close_cycle() {
    pitch_ = 0;
    if (cycles_.empty()) return;
    if (cycles_.back().taps)
        for (const cl::OverrideKind kind : {cl::OverrideKind::feed, cl::OverrideKind::spindle})
            allow_in_cycle(kind, true);
    cycles_.pop_back();
}

// --- records

void CanonWriter::print_lead() {
    if (const std::optional<cl::Record> lead = std::exchange(lead_, std::nullopt)) print(*lead);
}

void CanonWriter::operator()(const cl::Record& r) {
    if (lead_ && std::holds_alternative<cl::Arc>(r.step) && r.from == lead_->from) {
        lead_.reset();
    } else if (lead_) {
        print_lead();
    } else if (const auto* l = std::get_if<cl::Linear>(&r.step); l != nullptr && only_leads(*l)) {
        lead_ = r;
        return;
    }
    print(r);
}

void CanonWriter::take(const cl::AxisEnds& ends) {
    for (const cl::AxisEnd& end : ends) {
        const auto k = std::string_view("XYZABCUVW").find(end.name[0]);
        if (k != std::string_view::npos && end.name[1] == 0) stream_[k] = end.to;
    }
}

void CanonWriter::take(const cl::Datum& datum) {
    if (!first_) first_ = datum;
    from_first_ = cl::way(*first_, datum);
}

void CanonWriter::print(const cl::Record& r) {
    if (cl::is_move(r.step)) at_ = cl::position_after(at_ - from_first_, r.step) + from_first_, moved_ = {};
    take_number(r.from);
    if (const auto* o = std::get_if<cl::Output>(&r.step)) {
        const std::string number = std::to_string(static_cast<int>(o->number));
        const std::string with = o->with_motion ? "MOTION" : "AUX";
        return calls_.call(o->analog ? "SET_" + with + "_OUTPUT_VALUE(" + number + "," + decimals(o->value, 6) + ")"
                                     : (o->value != 0 ? "SET_" : "CLEAR_") + with + "_OUTPUT_BIT(" + number + ")");
    }
    if (const auto* o = std::get_if<cl::Override>(&r.step)) {
        constexpr std::array<std::string_view, 4> names{"FEED_OVERRIDE()", "SPEED_OVERRIDE(0)", "ADAPTIVE_FEED()",
                                                        "FEED_HOLD()"};
        if (o->kind == cl::OverrideKind::feed) feed_override_ = o->on;
        if (o->kind == cl::OverrideKind::spindle) speed_override_ = o->on;
        return calls_.call(std::string(o->on ? "ENABLE_" : "DISABLE_") +
                           std::string(names[static_cast<std::size_t>(o->kind)]));
    }
    if (!begun_ && calls_.any()) begin();
    if (const auto* d = std::get_if<cl::Datum>(&r.step)) return take(*d);
    if (const auto* c = std::get_if<cl::CycleBegin>(&r.step)) return cycles_.push_back({c->cycle->kind, false});
    if (std::holds_alternative<cl::CycleEnd>(r.step)) return close_cycle();
    step(r);
}

void CanonWriter::step(const cl::Record& r) {
    const bool in_thread = pitch_ != 0;
    if (!cycles_.empty() && is_step(r.step)) before_step(r.step);
    if (const cl::AxisEnds* ends = cl::ends_of(r.step)) take(*ends);
    if (const auto* l = std::get_if<cl::Linear>(&r.step)) line(*l);
    if (const auto* a = std::get_if<cl::Arc>(&r.step)) arc(*a);
    if (const auto* t = std::get_if<cl::Thread>(&r.step)) thread(*t);
    if (const auto* s = std::get_if<cl::Stop>(&r.step)) stop(*s);
    if (const auto* d = std::get_if<cl::Dwell>(&r.step)) calls_.call("DWELL(" + decimals(d->seconds) + ")");
    if (const auto* c = std::get_if<cl::Comment>(&r.step)) comment(*c);
    if (in_thread && pitch_ == 0) calls_.call("ENABLE_FEED_OVERRIDE()");
}

void CanonWriter::finish(int percents, int resets, bool refused) {
    print_lead();
    calls_.set_number({});
    if (calls_.any() && !begun_) begin();
    if (ended_ && percents == 1) calls_.remark("percent sign missing from end of file");
    if (!ended_ && percents == 2 && !refused) calls_.call("FINISH()");
    for (int i = 0; i < resets; ++i) calls_.call("ON_RESET()");
}

}  // namespace obrys::write
