#include <algorithm>

#include "base/text.hpp"
#include "cl/totals.hpp"
#include "motion/technology.hpp"
#include "report/sheet/sheet.hpp"

namespace obrys::report::sheet {

namespace {

constexpr std::size_t most_messages = 100;  ///< of a program that says something with every part

void widen_range(double& least, double& most, double value) {
    if (!std::isfinite(value) || value == 0) return;
    least = std::isnan(least) ? value : std::min(least, value);
    most = std::isnan(most) ? value : std::max(most, value);
}

void describe(ToolUse& use, const shop::Tool* tool) {
    if (tool == nullptr) return;
    use.kind = shop::kind_word(tool->kind);
    if (use.name.empty()) use.name = tool->name;
    if (tool->radius > 0) use.diameter = 2 * (tool->radius + tool->delta_radius);
    if (tool->kind == shop::ToolKind::groove && tool->width > 0) use.width = tool->width;
    if (tool->corner_radius > 0) use.corner = tool->corner_radius;
    if (tool->kind == shop::ToolKind::turning && tool->nose_radius > 0) use.corner = tool->nose_radius;
    if (tool->length > 0) use.length = tool->length + tool->delta_length;
}

void add_once(std::vector<std::string>& to, const std::string& text) {
    if (!text.empty() && to.size() < most_messages && std::find(to.begin(), to.end(), text) == to.end())
        to.push_back(text);
}

}  // namespace

void Times::add(const Times& o) {
    feed_mm += o.feed_mm, rapid_mm += o.rapid_mm;
    feed_s += o.feed_s, rapid_s += o.rapid_s, dwell_s += o.dwell_s;
    untimed_mm += o.untimed_mm, untimed_dwells += o.untimed_dwells, unmeasured += o.unmeasured, rotary += o.rotary;
}

Collector::Collector(std::span<const shop::Tool> tools, const shop::Machine& machine)
    : machine_(machine), cursor_(tools) {
    highest_ = machine.spindle.max;
    program_.machine = machine.name;
    program_.lathe = machine.kind == shop::MachineKind::lathe;
    constexpr double minute = 60, metre = 1000;
    program_.rapid = minute * metre / motion::rapid_seconds(machine, metre);
}

ToolUse& Collector::tool() {
    const cl::ToolChange& now = cursor_.state().change;
    const auto same = [&](const ToolUse& t) {
        return t.number == now.number && t.edge == now.edge && (now.name.empty() || t.name == now.name);
    };
    const auto found = std::find_if(program_.tools.begin(), program_.tools.end(), same);
    if (found != program_.tools.end()) return *found;
    ToolUse use;
    use.number = now.number;
    use.edge = now.edge;
    use.name = base::as_utf8(now.name);
    describe(use, cursor_.state().tool);
    program_.tools.push_back(std::move(use));
    return program_.tools.back();
}

ZeroUse& Collector::zero() {
    const cl::Datum& now = cursor_.state().datum;
    const auto same = [](double a, double b) { return a == b || (std::isnan(a) && std::isnan(b)); };
    const auto found = std::find_if(program_.zeros.begin(), program_.zeros.end(), [&](const ZeroUse& z) {
        return z.number == now.number && same(z.origin.x, now.origin.x) && same(z.origin.y, now.origin.y) &&
               same(z.origin.z, now.origin.z);
    });
    if (found != program_.zeros.end()) return *found;
    program_.zeros.push_back({now.number, now.origin, 0, {}});
    return program_.zeros.back();
}

double Collector::speed_at(double radius) const {
    return motion::spindle_speed(cursor_.state().spindle, std::abs(radius), highest_);
}

void Collector::take_feed(const motion::Step& step, double way, ToolUse& use) {
    const double radius = std::isnan(step.from.x) ? step.to.x : (step.from.x + step.to.x) / 2;
    const double speed = speed_at(radius);
    constexpr double minute = 60;
    const bool takes_time = way > 0 || cursor_.state().feed.mode == cl::FeedMode::inverse_time;
    const double seconds = takes_time ? motion::feed_seconds(step, way, highest_) : 0;
    use.times.feed_mm += way;
    if (std::isnan(seconds)) {
        use.times.untimed_mm += way;
    } else {
        use.times.feed_s += seconds;
        if (seconds > 0) widen_range(use.least_feed, use.most_feed, minute * way / seconds);
    }
    if (cursor_.state().spindle.direction != 0) widen_range(use.least_speed, use.most_speed, speed);
    add_way(use.cut, step);
}

void Collector::take_move(const motion::Step& step) {
    ++program_.moves;
    ToolUse& use = tool();
    const cl::AxisEnds& ends = *cl::ends_of(step.record.step);
    const bool rotary = std::any_of(ends.begin(), ends.end(), [](const cl::AxisEnd& end) { return end.rotary; });
    const double way = cl::move_length(step.from, step.record.step);
    ZeroUse& in = zero();
    ++in.moves;
    add_way(in.extent, step);
    Extent own;
    add_way(own, step);
    for (const geom::Vec3& p : {own.low, own.high}) {
        program_.travel.add(p + step.to_stock);
        if (!step.rapid) program_.cut.add(p + step.to_stock);
    }
    if (std::isnan(way)) {
        ++use.times.unmeasured;
    } else if (way == 0 && rotary) {
        ++use.times.rotary;
    } else if (step.rapid) {
        use.times.rapid_mm += way;
        use.times.rapid_s += way > 0 ? motion::rapid_seconds(machine_, way) : 0;
    } else {
        take_feed(step, way, use);
    }
    use.flood = use.flood || cursor_.state().coolant.flood;
    use.mist = use.mist || cursor_.state().coolant.mist;
}

void Collector::take_dwell(const cl::Dwell& dwell) {
    Times& times = tool().times;
    const double seconds = motion::dwell_seconds(dwell, cursor_.state().spindle, cursor_.position().here().x, highest_);
    if (std::isfinite(seconds))
        times.dwell_s += seconds;
    else
        ++times.untimed_dwells;  // the spindle stands, or nobody knows how long
}

void Collector::take(const cl::Record& record) {
    if (const auto step = cursor_.take(record)) return take_move(*step);
    if (const auto* change = std::get_if<cl::ToolChange>(&record.step); change != nullptr) {
        if (change->number != 0 || !change->name.empty()) ++tool().calls;
        if (!change->standing) ++program_.tool_changes;
    }
    if (const auto* dwell = std::get_if<cl::Dwell>(&record.step)) take_dwell(*dwell);
    if (const auto* cycle = std::get_if<cl::CycleBegin>(&record.step))
        ++tool().cycles[std::string(cl::spelling(cycle->cycle->kind))];
    if (const auto* stop = std::get_if<cl::Stop>(&record.step)) {
        program_.stops += stop->kind == cl::StopKind::program ? 1 : 0;
        program_.optional_stops += stop->kind == cl::StopKind::optional ? 1 : 0;
    }
    if (const auto* comment = std::get_if<cl::Comment>(&record.step); comment != nullptr && comment->message)
        add_once(program_.messages, base::as_utf8(comment->text));
    if (const auto* part = std::get_if<cl::PartBegin>(&record.step);
        part != nullptr && part->kind == cl::PartKind::call)
        add_once(program_.called, base::as_utf8(part->name));
}

Program Collector::finish() {
    for (const ToolUse& use : program_.tools) program_.times.add(use.times);
    return std::move(program_);
}

}  // namespace obrys::report::sheet
