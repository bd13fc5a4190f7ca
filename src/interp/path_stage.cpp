#include "interp/path_stage.hpp"

#include <cmath>

#include "base/codes.hpp"
#include "base/number.hpp"
#include "path/nose.hpp"

namespace obrys::interp {

namespace codes = base::codes;

namespace {

bool is_on(const path::Setting& s) { return s.side != path::Side::off; }

int nose_orientation(const shop::Tool& t) {
    if (t.kind == shop::ToolKind::turning) return t.orientation;
    return t.reference == shop::ReferenceCorner::left ? 3 : 4;
}

std::optional<double> compensation_radius(const shop::Tool& t) {
    if (t.kind == shop::ToolKind::turning) return t.nose_radius;
    if (t.kind == shop::ToolKind::groove) return t.corner_radius;
    if (t.radius > 0) return t.radius;
    return std::nullopt;
}

}  // namespace

path::Setting PathStage::setting(Run& run) const {
    path::Setting s;
    if (run.modal.compensation == Modal::compensation_off) return s;
    s.side = run.modal.compensation == Modal::compensation_left ? path::Side::left : path::Side::right;
    s.approach = run.modal.approach == Modal::approach_contour ? path::Approach::around : path::Approach::normal;
    s.corner = run.modal.corner == Modal::corner_intersection ? path::OuterCorner::intersection : path::OuterCorner::arc;
    const shop::Tool* tool = run.tool.data;
    const auto radius = tool == nullptr || run.tool.edge == 0 ? std::nullopt : compensation_radius(*tool);
    if (!radius)
        unchecked(run, codes::unknown_value, run.here(), "G41/G42 with tool T" + std::to_string(run.tool.number) + " D" + std::to_string(run.tool.edge) + ", whose radius is not known: the contour is run without compensation",
                  "give the tool with its radius in the job");
    s.radius = radius.value_or(0);
    return s;
}

int PathStage::keep(const cl::Record& record) {
    events_.push_back(record);
    return static_cast<int>(events_.size()) - 1;
}

int PathStage::feed_event(const Run& run, double feed) {
    return keep({cl::Feed{feed, run.modal.feed_mode}, run.here(), run.calls.back().stack});
}

path::CornerRequest PathStage::corner_request(Run& run) {
    const BlockWords& b = run.block;
    const double unit = run.modal.inch_geometry ? 25.4 : 1;
    path::CornerRequest r;
    if (b.has(Code::chamfer_length)) r = {path::CornerKind::chamfer, b.get(Code::chamfer_length) * unit, false, false, true, {}, {}};
    else if (b.has(Code::chamfer_leg)) r = {path::CornerKind::chamfer_leg, b.get(Code::chamfer_leg) * unit, false, false, true, {}, {}};
    else if (b.has(Code::round)) r = {path::CornerKind::rounding, b.get(Code::round) * unit, false, false, true, {}, {}};
    else if (run.modal.round_modal > 0 && run.modal.motion != Modal::rapid) r = {path::CornerKind::rounding, run.modal.round_modal, true, false, true, {}, {}};
    const double feed = b.has(Code::corner_feed) ? b.get(Code::corner_feed) : run.modal.corner_feed_modal;
    if (r.kind != path::CornerKind::none && feed > 0) {
        r.before.push_back(feed_event(run, feed));
        r.after.push_back(feed_event(run, run.feed));
    }
    return r;
}

void PathStage::push(Run& run, path::Element e, bool rapid) {
    const path::Setting s = setting(run);
    const bool was_on = !settings_.empty() && is_on(settings_.back());
    nose_ = {};
    if (run.modal.plane == 18 && run.env.machine.kind == shop::MachineKind::lathe && run.tool.data != nullptr && (is_on(s) || was_on)) {
        const double radius = compensation_radius(*run.tool.data).value_or(0);
        nose_ = path::nose_offset(nose_orientation(*run.tool.data), radius).value_or(geom::Vec2{});
    }
    // Off the contour the program moves the tip P, on it the contour is touched by the nose about its centre S = P - nose.
    if (!was_on) e.from = e.from - nose_;
    if (!is_on(s)) {
        e.to = e.to - nose_;
        e.centre = e.centre - nose_;
    }
    e.tag = origins_.size();
    e.before = std::move(waiting_);
    waiting_.clear();
    origins_.push_back({run.here(), run.top().stack, rapid});
    settings_.push_back(s);
    active_ = true;
    const auto fault = corners_.push(std::move(e), corner_request(run), [&](const path::CornerOutput& o) { compensate(run, o); });
    if (fault) report(run, *fault);
    const bool plain = !is_on(s) && run.modal.round_modal == 0 && !run.block.has(Code::round) && !run.block.has(Code::chamfer_length) && !run.block.has(Code::chamfer_leg);
    if (plain && !run.stopped) flush(run);
}

void PathStage::compensate(Run& run, const path::CornerOutput& o) {
    const path::Setting s = settings_[o.element.tag];
    report(run, compensation_.push(o.element, s, [&](const path::Output& out) { output(run, out); }));
}

void PathStage::output(Run& run, const path::Output& out) {
    for (const int event : out.element.before) run.sink(events_[static_cast<std::size_t>(event)]);
    const Origin& origin = origins_[out.element.tag];
    path::Element e = out.element;
    e.from = e.from + nose_;
    e.to = e.to + nose_;
    e.centre = e.centre + nose_;
    run.record.from = origin.from;
    run.record.stack = origin.stack;
    emit_element(run, e, origin.rapid && !path::is_arc(e));
}

void PathStage::hold(const cl::Record& record) { waiting_.push_back(keep(record)); }

void PathStage::flush(Run& run) {
    if (!active_ || flushing_) return;
    flushing_ = true;
    corners_.flush([&](const path::CornerOutput& o) { compensate(run, o); });
    report(run, compensation_.flush([&](const path::Output& o) { output(run, o); }));
    for (const int event : waiting_) run.sink(events_[static_cast<std::size_t>(event)]);
    waiting_.clear();
    const path::Setting last = settings_.empty() ? path::Setting{} : settings_.back();
    active_ = is_on(last);
    if (!active_) {
        origins_.clear();
        settings_.clear();
        events_.clear();
    }
    flushing_ = false;
}

void PathStage::report(Run& run, const std::vector<path::Fault>& faults) {
    for (const path::Fault& f : faults) {
        const Origin& at = origins_[f.tag];
        const std::string radius = base::fixed(settings_[f.tag].radius, 3) + " mm";
        std::string text;
        switch (f.reason) {
            case path::Reason::tool_radius_too_large: text = "the tool radius " + radius + " is larger than this arc: the arc is left out"; break;
            case path::Reason::arc_needs_line_at_start: text = "compensation must be switched on and off by a straight move G0 or G1, this is an arc"; break;
            case path::Reason::no_intersection: text = "with tool radius " + radius + " this inner corner has no point where both contour elements can be reached"; break;
            case path::Reason::element_vanishes: text = f.bridged ? "with tool radius " + radius + " the tool does not fit into this contour element: it is left out and material stays" : "with tool radius " + radius + " this contour element cannot be reached"; break;
        }
        base::Diagnostic d{base::Severity::error, codes::compensation, at.from, std::move(text), "use a smaller tool or widen the contour", run.stacks.sites(at.stack), {}};
        if (origins_[f.other].from != at.from) d.related.push_back({origins_[f.other].from, "the neighbouring element"});
        run.diagnostics.add(std::move(d));
    }
}

void PathStage::report(Run& run, const path::CornerFault& f) {
    const Origin& at = origins_[f.tag];
    std::string text;
    switch (f.failure) {
        case path::CornerFailure::none: return;
        case path::CornerFailure::bad_size: text = "a chamfer or rounding needs a size above 0"; break;
        case path::CornerFailure::not_joined: text = "no corner follows: the next element does not start here"; break;
        case path::CornerFailure::tangential: text = "there is no corner to chamfer or round: the next element goes straight on"; break;
        case path::CornerFailure::reversal: text = "the next element runs back along this one: there is no corner to chamfer or round"; break;
        case path::CornerFailure::too_short: text = "a chamfer or rounding of " + base::fixed(f.size, 3) + " mm is too large for the elements beside it"; break;
    }
    run.diagnostics.add({base::Severity::error, codes::value_range, at.from, std::move(text), {}, run.stacks.sites(at.stack), {}});
}

}  // namespace obrys::interp
