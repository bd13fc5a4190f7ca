/// Steps of contour cycles, and the elements of the contour along which they run.

#include <cmath>

#include "cycles/along.hpp"
#include "interp/cycles/contour_cycle.hpp"
#include "interp/cycles/cycles.hpp"

namespace obrys::interp {

namespace {

/// The step's way in the plane and where it ends; nothing where it is no feed move.
std::optional<geom::Edge> way_of(const cl::Step& step, geom::Vec3 from, geom::Vec3& to) {
    double sweep = 0;
    bool feed = true;
    if (const auto* line = std::get_if<cl::Linear>(&step)) {
        to = line->to;
        feed = !line->rapid;
    } else if (const auto* arc = std::get_if<cl::Arc>(&step)) {
        to = arc->to;
        sweep = arc->normal.z < 0 ? -arc->sweep : arc->sweep;
    } else {
        return std::nullopt;
    }
    // A turn and more has no bulge; such arcs go down, beside the contour.
    if (!feed || std::abs(sweep) > 1.9 * geom::pi) return std::nullopt;
    return geom::Edge{{from.x, from.y}, {to.x, to.y}, std::tan(sweep / 4)};
}

}  // namespace

void emit_along(Telling& run, std::vector<cl::Step>& steps, const ContourElements& elements, geom::Vec3 from) {
    std::vector<geom::Edge> edges;
    edges.reserve(elements.size());
    for (const ContourElement& e : elements) edges.push_back(e.edge);
    const cycles::Along along(std::move(edges));
    for (cl::Step& step : steps) {
        if (run.stopped) break;
        geom::Vec3 to = from;
        const auto way = elements.empty() ? std::nullopt : way_of(step, from, to);
        const auto element = way ? along.find(*way) : std::nullopt;
        run.along = element ? &elements[*element] : nullptr;
        from = to;
        emit_step(run, std::move(step));
    }
    run.along = nullptr;
}

}  // namespace obrys::interp
