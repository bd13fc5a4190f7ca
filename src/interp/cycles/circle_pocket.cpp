/// Circular pockets milled by one block: G12 clockwise, G13 counter-clockwise.
/// Source: Haas, Mill Operator's Manual 96-8000, "Circular Pocket Milling"; the same, June 1999, page 237 (figure).

#include <cmath>

#include "base/codes.hpp"
#include "base/whole.hpp"
#include "interp/cycles/cycles.hpp"

namespace obrys::interp {

namespace codes = base::codes;

namespace {

constexpr int most_passes = 10'000;

struct Pocket {
    geom::Vec3 centre;
    std::vector<double> circles;  ///< radii of the tool centre's circles, mm, growing
    double from = 0, step = 0;    ///< level of the first pass and way from pass to pass, mm
    int passes = 1;
    double sense = 1;  ///< +1 counter-clockwise
};

bool refuse_pocket(Moving& run, std::string text, std::string remedy = {}) {
    alarm(run, codes::value_range, run.here(), std::string(run.block.special_number == 1 ? "G13: " : "G12: ") + text,
          std::move(remedy));
    return false;
}

/// Radius by which the circles are smaller, mm: of offset D, of the last D, of the tool; nothing where none is known.
std::optional<double> radius_taken_off(Moving& run) {
    if (run.block.has(Code::offset_d))
        take_offset_radius(run, run.block.get(Code::offset_d));
    else if (run.traits->offset_numbers_stay && !std::isnan(run.modal.offset_d))
        take_offset_radius(run, run.modal.offset_d);
    if (run.stopped) return std::nullopt;
    if (!std::isnan(run.modal.compensation_radius)) return std::abs(run.modal.compensation_radius);
    if (const auto r = run.tool.data == nullptr ? std::nullopt : mill_radius(*run.tool.data)) return r;
    unchecked(run, codes::unknown_value, run.here(),
              "the pocket is milled without compensation: the radius of its tool is not known",
              "give the tool with its radius in the job, or D0 where the tool's centre is programmed");
    return 0;
}

/// I alone is the finished circle; with K the circles grow from I by Q up to K.
bool take_circles(Moving& run, double tool, Pocket& pocket) {
    const BlockWords& b = run.block;
    const double unit = length_unit(run.modal);
    const double first = b.has(Code::i) ? std::abs(b.get(Code::i)) * unit : 0;
    if (!(first > tool))
        return refuse_pocket(run, "I, the radius of the first circle, must be greater than the tool's radius");
    if (!b.has(Code::k)) {
        pocket.circles = {first - tool};
        return true;
    }
    const double last = std::abs(b.get(Code::k)) * unit, by = b.has(Code::q) ? std::abs(b.get(Code::q)) * unit : 0;
    if (!(last > first)) return refuse_pocket(run, "K, the radius of the finished circle, must be greater than I");
    if (!(by > 0) || (last - first) / by > most_passes)
        return refuse_pocket(run, "Q, by which the circles grow, must be greater than 0");
    for (double r = first; r < last - 1e-9; r += by) pocket.circles.push_back(r - tool);
    pocket.circles.push_back(last - tool);
    return true;
}

bool take_levels(Moving& run, const geom::Vec3& target, Pocket& pocket) {
    const double n = run.block.has(Code::l) ? run.block.get(Code::l) : 1;
    const auto passes = base::whole<int>(n, 1, most_passes);
    if (!passes) return refuse_pocket(run, "L must be a whole number of passes");
    pocket.passes = *passes;
    pocket.from = target.z;
    pocket.step = run.modal.absolute ? 0 : target.z - run.programmed_position.z;
    return true;
}

void line(Telling& run, const geom::Vec3& to, bool rapid) { emit_step(run, cl::Linear{to, {0, 0, 1}, rapid}); }

void arc(Telling& run, const Pocket& p, const geom::Vec2& centre, const geom::Vec3& to, double sweep) {
    emit_step(run, cl::Arc{to, {centre.x, centre.y, to.z}, {0, 0, 1}, p.sense * sweep});
}

/// One level: half a circle out of the middle, circle after circle, half a circle back.
void pass(Telling& run, const Pocket& p, double level) {
    const geom::Vec2 middle{p.centre.x, p.centre.y};
    const geom::Vec3 centre{p.centre.x, p.centre.y, level};
    line(run, centre, false);
    double before = 0;
    for (const double r : p.circles) {
        const geom::Vec3 start{middle.x + r, middle.y, level};
        if (before == 0)
            arc(run, p, {middle.x + r / 2, middle.y}, start, geom::pi);
        else
            line(run, start, false);
        arc(run, p, middle, start, 2 * geom::pi);
        before = r;
    }
    arc(run, p, {middle.x + before / 2, middle.y}, centre, geom::pi);
}

/// What the stream says of it.
cycles::Demand demand_of(const Pocket& p, double tool) {
    using Role = cl::CycleRole;
    const std::size_t n = p.circles.size();
    cycles::Demand d{cl::CycleKind::canned_circular_pocket,
                     {{Role::radius, p.circles.back() + tool},
                      {Role::bottom, p.from + (p.passes - 1) * p.step},
                      {Role::passes, double(p.passes)},
                      {Role::infeed, std::abs(p.step)},
                      {Role::direction, p.sense}}};
    if (n < 2) return d;
    d.values.push_back({Role::first_radius, p.circles.front() + tool});
    d.values.push_back({Role::stepover, p.circles[1] - p.circles[0]});
    return d;
}

}  // namespace

bool circle_pocket(Moving& run) {
    if (run.modal.plane != 17)
        return refuse_pocket(run, "circular pockets lie in the plane of G17", "write G17 before it");
    if (run.modal.compensation != Modal::compensation_off)
        return refuse_pocket(run, "the pocket has a compensation of its own", "write G40 before it");
    flush_path(run);
    Pocket pocket;
    const geom::Vec3 target = programmed_target(run);
    pocket.centre = {target.x, target.y, run.programmed_position.z};
    pocket.sense = run.block.special_number == 1 ? 1 : -1;
    const auto tool = radius_taken_off(run);
    if (!tool || !take_circles(run, *tool, pocket) || !take_levels(run, target, pocket)) return false;
    require_feed(run);
    if (run.stopped) return false;
    if (pocket.circles.size() > 1)
        assume(run, run.here(), "circular pocket: from one circle to the next the tool goes straight along +X");
    if (run.block.has(Code::x) || run.block.has(Code::y)) line(run, pocket.centre, true);
    begin_bracket(run, demand_of(pocket, *tool), run.block.special_number == 1 ? "G13" : "G12");
    for (int i = 0; i < pocket.passes && !run.stopped; ++i) {
        pass(run, pocket, pocket.from + i * pocket.step);
        if (over_budget(run, false)) return false;
    }
    end_bracket(run);
    return true;
}

}  // namespace obrys::interp
