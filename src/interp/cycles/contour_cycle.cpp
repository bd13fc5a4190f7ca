/// Contour cycles: the labels that CYCL DEF 14 names become areas and trains, and these the tool's path.

#include "interp/cycles/contour_cycle.hpp"

#include <cmath>

#include "base/codes.hpp"
#include "base/whole.hpp"
#include "cycles/shapes.hpp"
#include "geom/edge.hpp"
#include "interp/capture.hpp"
#include "interp/cycles/cycles.hpp"
#include "path/corner_stage.hpp"

namespace obrys::interp {

namespace codes = base::codes;
using geom::Vec2;

namespace {

constexpr double closing_gap = 1e-3;  ///< mm; ends nearer than this close a contour

/// The element in the frame of the cycle's call, where the label has one of its own (datum shifts in contours).
path::Element in_frame(const Captured& c, const geom::Frame& frame, const PlaneAxes& a) {
    if (c.frame == frame) return c.element;
    const geom::Frame into = geom::inverse(frame) * c.frame;
    const auto moved = [&](Vec2 p, double w) {
        geom::Vec3 v;
        coordinate(v, a.u) = p.x;
        coordinate(v, a.v) = p.y;
        coordinate(v, a.w) = w;
        v = geom::apply(into, v);
        return Vec2{coordinate(v, a.u), coordinate(v, a.v)};
    };
    path::Element e = c.element;
    e.from = moved(c.element.from, c.element.w_from);
    e.to = moved(c.element.to, c.element.w_to);
    e.centre = moved(c.element.centre, c.element.w_from);
    if (geom::determinant(into) < 0) e.sweep = -e.sweep;
    return e;
}

void add_edge(geom::Contour& c, const path::Element& e, const Captured& from, ContourElements& elements) {
    const double most = geom::pi;
    const int parts =
        path::is_arc(e) ? base::clipped<int>(std::ceil(std::abs(e.sweep) / most - 1e-9), 1, 1'000'000) : 1;
    for (int i = 0; i < parts; ++i) {
        c.vertices.back().bulge = path::is_arc(e) ? std::tan(e.sweep / parts / 4) : 0;
        const Vec2 p = i + 1 == parts ? e.to : path::point_at(e, static_cast<double>(i + 1) / parts);
        elements.push_back({{c.vertices.back().p, p, c.vertices.back().bulge}, from.where, from.stack});
        c.vertices.push_back({p, 0});
    }
}

/// The first element only leads to the contour, and nothing comes behind the last one.
void say_loose_corner(Saying& run, const Captured& c, const char* where) {
    if (c.corner.kind == path::CornerKind::none || c.corner.modal) return;
    unchecked(run, codes::value_range, c.where,
              std::string("a contour cannot ") + where + " with a chamfer or rounding: it is left out",
              "write it between two elements of the contour");
}

}  // namespace

geom::Contour contour_of(Reckoning& run, const std::vector<Captured>& all, ContourElements& elements) {
    const PlaneAxes a = plane_axes(run.modal.plane);
    geom::Contour contour;
    contour.closed = false;
    if (all.empty()) return contour;
    contour.vertices.push_back({in_frame(all.front(), run.frame, a).to, 0});
    say_loose_corner(run, all.front(), "begin");
    if (all.size() > 1) say_loose_corner(run, all.back(), "end");
    path::CornerStage corners;
    const auto take = [&](const path::CornerOutput& out) {
        if (path::moves_in_plane(out.element)) add_edge(contour, out.element, all[out.element.tag], elements);
    };
    for (std::size_t i = 1; i < all.size(); ++i) {
        path::Element e = in_frame(all[i], run.frame, a);
        e.tag = i;
        const auto fault = corners.push(std::move(e), all[i].corner, take);
        if (fault)
            unchecked(run, codes::value_range, all[i].where,
                      "this chamfer or rounding of the contour cannot be made: it is left out");
    }
    corners.flush(take);
    if (contour.vertices.size() > 2 &&
        geom::distance(contour.vertices.front().p, contour.vertices.back().p) < closing_gap) {
        contour.vertices.pop_back();
        contour.closed = true;
    }
    return contour;
}

bool is_known(const geom::Contour& c) {
    for (const geom::Vertex& v : c.vertices)
        if (!std::isfinite(v.p.x) || !std::isfinite(v.p.y) || !std::isfinite(v.bulge)) return false;
    return true;
}

namespace {

int side_of(const std::vector<Captured>& all) {
    for (const Captured& c : all) {
        if (c.compensation == Modal::compensation_left) return 1;
        if (c.compensation == Modal::compensation_right) return -1;
    }
    return 0;
}

/// Which side counts where it changes is not documented.
void say_other_side(Saying& run, const std::vector<Captured>& all, int side) {
    for (const Captured& c : all)
        if (c.compensation != Modal::compensation_off && (c.compensation == Modal::compensation_left) != (side > 0))
            return unchecked(run, codes::unsupported, c.where,
                             "radius compensation changes its side within the contour: the first one is taken",
                             "write RL or RR at the beginning of the contour alone");
}

double radius_of_tool(const Reckoning& run, const cycles::Demand& d, cl::CycleRole role) {
    const auto number = d.find(role);
    if (!number || *number == 0) return cycles::unknown;
    for (const shop::Tool& t : run.tools)
        if (t.number == *number && mill_radius(t)) return *mill_radius(t);
    return cycles::unknown;
}

struct Label {
    std::string name;
    geom::Contour contour;
    int side = 0;
};

/// False after a complaint.
bool read_labels(Cycling& run, std::vector<Label>& labels, ContourElements& elements) {
    if (run.contour_unit == nullptr || run.contour_labels.empty()) {
        alarm(run, codes::missing_label, run.here(), "no contour is defined for this cycle",
              "name its labels with CYCL DEF 14 before the call");
        return false;
    }
    const std::vector<std::string> names = run.contour_labels;
    for (const std::string& name : names) {
        const auto all = run.onward->label(*run.contour_unit, name).said(run);
        if (!all) {
            alarm(run, codes::missing_label, run.here(),
                  "the contour label " + name + " of CYCL DEF 14 is missing or does not end");
            return false;
        }
        Label l{name, contour_of(run, *all, elements), side_of(*all)};
        say_other_side(run, *all, l.side);
        if (!is_known(l.contour)) {
            unchecked(run, codes::unknown_value, run.here(),
                      "the contour of label " + name + " depends on a value that is not known: the cycle is not run");
            return false;
        }
        labels.push_back(std::move(l));
    }
    return true;
}

bool combine(Saying& run, const std::vector<Label>& labels, geom::Region& area) {
    std::vector<cycles::ProgrammedContour> parts;
    for (const Label& l : labels) {
        const auto is = cycles::classify(l.contour, l.side);
        if (!is) {
            alarm(run, codes::contour, run.here(),
                  "the contour of label " + l.name +
                      (l.contour.closed ? " has no radius compensation: it is neither pocket nor island"
                                        : " is not closed"));
            return false;
        }
        parts.push_back({l.contour, *is});
    }
    area = cycles::area_of(parts);
    return true;
}

}  // namespace

namespace {

/// What the labels of CYCL DEF 14 say.
std::optional<cycles::ContourTask> labelled_task(Cycling& run, bool train, ContourElements& elements) {
    std::vector<Label> labels;
    if (!read_labels(run, labels, elements)) return std::nullopt;
    cycles::ContourTask task;
    if (train) {
        task.train = {labels.front().contour, labels.front().side};
        if (labels.size() > 1)
            unchecked(run, codes::unsupported, run.here(), "a contour train has one label: the others are left out");
    } else if (!combine(run, labels, task.area)) {
        return std::nullopt;
    }
    return task;
}

}  // namespace

std::optional<std::vector<ContourLayer>> contour_layers(Cycling& run, const cycles::Demand& demand,
                                                        ContourElements& elements) {
    const bool train = demand.kind == cl::CycleKind::contour_train;
    std::optional<std::vector<ContourLayer>> layers;
    if (run.contour_choices.empty()) {
        if (auto task = labelled_task(run, train, elements)) layers = {{std::move(*task), {}}};
    } else if (train) {
        unchecked(run, codes::unsupported, run.here(),
                  "a contour train along a contour of CONTOUR DEF or a formula is not run",
                  "name its label with CYCL DEF 14");
    } else {
        layers = chosen_layers(run, demand, elements);
    }
    const auto role =
        demand.kind == cl::CycleKind::pilot_drill ? cl::CycleRole::pilot_tool : cl::CycleRole::coarse_tool;
    if (layers)
        for (ContourLayer& l : *layers) l.task.other_radius = radius_of_tool(run, demand, role);
    return layers;
}

}  // namespace obrys::interp
