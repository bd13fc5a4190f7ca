#include "write/holes/lone_taps.hpp"

#include <cmath>
#include <utility>

namespace obrys::write {

namespace {

constexpr double still = 1e-6;  // mm

geom::Frame whole(const cl::Frame& frame) {
    geom::Frame out;
    for (const cl::FramePart& p : frame.parts) out = out * p.frame;
    return out;
}

/// What may stand between the way in and the way back.
bool may_wait(const cl::Step& step) {
    return std::holds_alternative<cl::Spindle>(step) || std::holds_alternative<cl::Feed>(step) ||
           std::holds_alternative<cl::Comment>(step);
}

const cl::Thread* tap_of(const cl::Step& step) {
    const auto* thread = std::get_if<cl::Thread>(&step);
    return thread != nullptr && thread->rigid_tap && thread->ends.empty() ? thread : nullptr;
}

/// The tap as a cycle in the frame in force; nothing where it does not go down along its Z.
std::optional<cl::Cycle> cycle_of(const cl::Thread& tap, const geom::Vec3& from, const cl::Frame& frame) {
    cl::Cycle out;
    out.kind = cl::CycleKind::canned_tap_rigid;
    out.plane = whole(frame);
    if (!geom::is_invertible(out.plane)) return std::nullopt;
    const geom::Frame into = geom::inverse(out.plane);
    const geom::Vec3 begin = geom::apply(into, from), end = geom::apply(into, tap.to);
    const bool along = std::abs(end.x - begin.x) <= still && std::abs(end.y - begin.y) <= still && end.z < begin.z;
    if (!along || !(std::abs(tap.pitch) > 0)) return std::nullopt;
    out.values = {{cl::CycleRole::spindle_direction, tap.pitch < 0 ? -1.0 : 1.0},
                  {cl::CycleRole::retract_plane, begin.z},
                  {cl::CycleRole::bottom, end.z},
                  {cl::CycleRole::pitch, std::abs(tap.pitch)}};
    return out;
}

}  // namespace

bool LoneTaps::begins_tap(const cl::Record& record) const {
    const cl::Thread* tap = tap_of(record.step);
    return tap != nullptr && brackets_ == 0 && !cursor_.state().compensation &&
           cycle_of(*tap, cursor_.position().here(), cursor_.state().frame);
}

bool LoneTaps::ends_tap(const cl::Record& record) const {
    const cl::Thread* back = tap_of(record.step);
    const double pitch = std::get<cl::Thread>(waiting_.front().step).pitch;
    return back != nullptr && geom::distance(back->to, from_) <= still && back->pitch == pitch;
}

void LoneTaps::hand_on(const cl::Record& record) {
    static_cast<void>(cursor_.take(record));
    out_(record);
}

void LoneTaps::settle() {
    for (const cl::Record& record : std::exchange(waiting_, {})) hand_on(record);
}

void LoneTaps::take(const cl::Record& record) {
    if (!waiting_.empty()) {
        if (may_wait(record.step)) return waiting_.push_back(record);
        if (ends_tap(record)) {
            const cl::Record& in = waiting_.front();
            const auto cycle = cycle_of(std::get<cl::Thread>(in.step), from_, cursor_.state().frame);
            if (cycle) out_({cl::CycleBegin{*cycle, from_}, in.from, in.stack});
            settle();
            hand_on(record);
            if (cycle) out_({cl::CycleEnd{}, record.from, record.stack});
            return;
        }
        settle();
    }
    if (begins_tap(record)) {
        from_ = cursor_.position().here();
        return waiting_.push_back(record);
    }
    const cl::Step& step = record.step;
    if (std::holds_alternative<cl::CycleBegin>(step) || std::holds_alternative<cl::LeadBegin>(step)) ++brackets_;
    if (std::holds_alternative<cl::CycleEnd>(step) || std::holds_alternative<cl::LeadEnd>(step)) --brackets_;
    hand_on(record);
}

}  // namespace obrys::write
