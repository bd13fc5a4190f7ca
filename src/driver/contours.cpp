#include "driver/contours.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/codes.hpp"
#include "geom/boolean.hpp"
#include "geom/offset.hpp"

namespace obrys::driver {

namespace codes = base::codes;

namespace {

/// Collects the feed moves of a stream as one contour in the (z, x) plane; rapids before the first and behind the last
/// feed move do not belong to it.
class ContourSink {
public:
    void operator()(const cl::Record& r) {
        if (const auto* line = std::get_if<cl::Linear>(&r.step)) {
            if (!line->rapid) add(line->to, 0);
            at_ = line->to;
        } else if (const auto* arc = std::get_if<cl::Arc>(&r.step)) {
            // Counter-clockwise about +y is counter-clockwise in (z, x) drawn with z to the right and x up.
            add(arc->to, std::tan((arc->normal.y < 0 ? -arc->sweep : arc->sweep) / 4));
            at_ = arc->to;
        } else if (const auto* spline = std::get_if<cl::Spline>(&r.step)) {
            if (!spline_) spline_ = r.from;
            at_ = spline->to;
        }
    }
    /// The first move that no contour of lines and arcs can hold.
    [[nodiscard]] std::optional<base::Span> spline() const { return spline_; }
    [[nodiscard]] geom::Contour contour() const { return contour_; }

private:
    void add(const geom::Vec3& to, double bulge) {
        if (!geom::is_finite(to) || !geom::is_finite(at_)) return;
        if (contour_.vertices.empty()) contour_.vertices.push_back({{at_.z, at_.x}, 0});
        contour_.vertices.back().bulge = bulge;
        contour_.vertices.push_back({{to.z, to.x}, 0});
    }
    geom::Contour contour_{{}, false};
    geom::Vec3 at_{NAN, 0, NAN};
    std::optional<base::Span> spline_;
};

geom::Region closed_to_axis(geom::Contour c) {
    const geom::Vec2 first = c.vertices.front().p, last = c.vertices.back().p;
    if (geom::distance(first, last) > 1e-6) {
        c.vertices.push_back({{last.x, 0}, 0});
        c.vertices.push_back({{first.x, 0}, 0});
    }
    c.closed = true;
    return geom::tidied({c});
}

std::optional<geom::Region> run_contour(Session& s, const shop::ProfileFromProgram& from, const fs::path& job_path) {
    const fs::path path = (job_path.parent_path() / from.program).lexically_normal();
    const auto file = load(*s.storage, path, s.sources, s.diagnostics, from.where);
    const program::Unit* unit = file ? s.programs->read(*file) : nullptr;
    if (unit == nullptr) return std::nullopt;
    ContourSink sink;
    const program::Unit* main = s.main;
    s.main = unit;
    interpret(s, [&](const cl::Record& r) { sink(r); });
    s.main = main;
    if (const auto where = sink.spline()) {
        s.diagnostics.add({base::Severity::error,
                           codes::job_value,
                           *where,
                           "a contour is made of lines and arcs: " + from.program + " moves along a spline here",
                           {},
                           {},
                           {}});
        return std::nullopt;
    }
    const geom::Contour contour = sink.contour();
    if (contour.vertices.size() >= 2) return closed_to_axis(contour);
    s.diagnostics.add({base::Severity::error,
                       codes::job_value,
                       from.where,
                       from.program + " makes no feed moves from which a contour could be taken",
                       {},
                       {},
                       {}});
    return std::nullopt;
}

/// The part with material of this thickness on it; nothing lies beyond the axis.
geom::Region with_allowance(const geom::Region& part, double normal) {
    const geom::Region grown = geom::offset(part, normal);
    const geom::Box box = geom::box(grown);
    const double left = box.lo.x - 1, right = box.hi.x + 1, top = box.hi.y + 1;
    const geom::Contour half{{{{left, 0}, 0}, {{right, 0}, 0}, {{right, top}, 0}, {{left, top}, 0}}, true};
    return geom::intersect(grown, {{half}});
}

/// Whether somebody drew the face with which a profile ends at its right, not only the contour up to it.
bool draws_right_face(const geom::Contour& drawn) {
    if (drawn.vertices.empty()) return false;
    const auto& v = drawn.vertices;
    const auto ends_there = [&](geom::Vec2 end) {
        return end.y <= 1e-9 &&
               std::all_of(v.begin(), v.end(), [&](const geom::Vertex& o) { return o.p.x <= end.x + 1e-9; });
    };
    return drawn.closed || ends_there(v.front().p) || ends_there(v.back().p);
}

}  // namespace

void resolve_contours(Session& s, const fs::path& job_path) {
    if (s.job.part) s.part = s.job.part->region;
    if (s.job.part) s.right_face = draws_right_face(s.job.part->drawn);
    if (s.job.part_program) s.part = run_contour(s, *s.job.part_program, job_path);
    if (!s.job.allowance) return;
    const shop::Allowance& a = *s.job.allowance;
    if (a.profile)
        s.allowance = a.profile->region;
    else if (a.program)
        s.allowance = run_contour(s, *a.program, job_path);
    else if (s.part && a.normal > 0)
        s.allowance = with_allowance(*s.part, a.normal);
}

std::vector<check::TurnedClamp> turned_clamps(Session& s) {
    std::vector<check::TurnedClamp> out;
    if (s.job.machine.kind != shop::MachineKind::lathe) return out;
    for (const shop::Clamp& c : s.job.clamps) {
        const auto* round = std::get_if<shop::SolidCylinder>(&c.solid);
        if (round != nullptr && round->axis == 2 && round->centre.x == 0 && round->centre.y == 0) {
            const double a = round->min, b = round->max, r = round->radius;
            out.push_back({c.name, {{{{{{a, 0}, 0}, {{b, 0}, 0}, {{b, r}, 0}, {{a, r}, 0}}, true}}}});
            continue;
        }
        s.diagnostics.add({base::Severity::warning,
                           codes::not_simulated,
                           c.where,
                           "on a lathe a clamp is a cylinder about the turning axis: " + c.name + " is not checked",
                           "give what turns with the workpiece as cylinder = {diameter, min, max}",
                           {},
                           {}});
    }
    return out;
}

}  // namespace obrys::driver
