#include "check/touching/cleared.hpp"

#include <algorithm>
#include <cmath>

namespace obrys::check {

namespace milling = sim::milling;

using geom::Vec2;
using geom::Vec3;

namespace {

constexpr std::size_t most_bins = 96;       ///< along each side of the stock
constexpr int deepest_level = 5;            ///< a bin is quartered so often
constexpr std::size_t most_columns = 2000;  ///< looked at for one body
constexpr std::size_t most_axes = 16;       ///< cut with: beyond, depths are not told

std::optional<Patch> common(const Patch& a, const Patch& b) {
    const Patch p{{std::max(a.lo.x, b.lo.x), std::max(a.lo.y, b.lo.y)},
                  {std::min(a.hi.x, b.hi.x), std::min(a.hi.y, b.hi.y)}};
    if (p.lo.x > p.hi.x || p.lo.y > p.hi.y) return std::nullopt;
    return p;
}

/// The part of a body's way that comes near enough to a patch to reach it.
Upright part_near(const Upright& body, const Patch& patch) {
    const Vec3 way = body.to - body.from;
    const double square = way.x * way.x + way.y * way.y;
    if (square == 0) return body;
    const Vec2 middle = 0.5 * (patch.lo + patch.hi);
    const double size = std::sqrt(square), reach = (body.radius + 0.5 * geom::length(patch.hi - patch.lo)) / size;
    const double at = ((middle.x - body.from.x) * way.x + (middle.y - body.from.y) * way.y) / square;
    const double first = std::clamp(at - reach, 0.0, 1.0), last = std::clamp(at + reach, 0.0, 1.0);
    Upright part = body;
    part.from = body.from + first * way;
    part.to = body.from + last * way;
    return part;
}

double from_box(Vec3 p, const Patch& patch, Zone z) {
    const Vec3 off{std::max({patch.lo.x - p.x, p.x - patch.hi.x, 0.0}),
                   std::max({patch.lo.y - p.y, p.y - patch.hi.y, 0.0}), std::max({z.low - p.z, p.z - z.high, 0.0})};
    return std::sqrt(geom::dot(off, off));
}

/// Axes made to unit length once more may differ in their last digit.
bool are_same(const milling::Orientation& a, const milling::Orientation& b) {
    constexpr double same = 1e-12;
    return geom::distance(a.x, b.x) <= same && geom::distance(a.y, b.y) <= same && geom::distance(a.z, b.z) <= same;
}

/// As far off as that for sure, without a root.
bool is_beyond(Vec3 p, const Patch& patch, Zone z, double depth) {
    return std::max({z.low - p.z, p.z - z.high, patch.lo.x - p.x, p.x - patch.hi.x, patch.lo.y - p.y,
                     p.y - patch.hi.y}) >= depth;
}

}  // namespace

Cleared::Cleared(const milling::Stock& stock, double slack, double finest)
    : stock_(stock), slack_(slack), finest_(finest) {}

void Cleared::advance(const milling::Simulation& simulation, std::uint32_t pass) {
    simulation_ = &simulation;
    while (cuts_ < simulation.sweeps() && simulation.pass_of(cuts_ + 1) < pass) ++cuts_;
}

Cleared::Field& Cleared::field_for(const milling::Orientation& frame) {
    for (Field& f : fields_)
        if (are_same(f.frame, frame)) return f;
    const milling::Box3 box = frame.box_in_tool(milling::box_of(stock_));
    const Patch around{{box.min.x, box.min.y}, {box.max.x, box.max.y}};
    fields_.push_back({frame, {box.min.z, box.max.z}, Bins<Column>(around, finest_, most_bins), {}, {}});
    return fields_.back();
}

/// Columns that nobody asks for stay as they are.
void Cleared::fill(Field& field, Column& column, const Patch& patch) const {
    if (column.taken == cuts_) return;
    const Zone z = field.heights;
    const milling::Box3 box =
        field.frame.box_in_stock({{patch.lo.x, patch.lo.y, z.low}, {patch.hi.x, patch.hi.y, z.high}});
    for (const std::uint32_t number : simulation_->cuts_in(box, column.taken, cuts_))
        take(field, column, patch, number);
    column.taken = cuts_;
}

void Cleared::take(Field& field, Column& column, const Patch& patch, std::uint32_t number) const {
    const milling::Air::Sweep sweep = simulation_->body_of(number);
    if (!are_same(sweep.frame, field.frame)) return;
    const ClearingCut cut(sweep);
    if (cut.heights().low > field.heights.high || !common(cut.around(), patch)) return;
    if (column.empty.cover({cut.heights().low, std::min(cut.heights().high, field.heights.high)})) return;
    cut.add_over(patch, 0, column.empty);
    if (cut.is_flat() && column.empty.cover({cut.heights().low, cut.heights().high})) return;
    const auto [at, is_new] = field.known.try_emplace(number, static_cast<std::uint32_t>(field.cuts.size()));
    if (is_new) field.cuts.push_back({cut, number});
    column.cuts.push_back(at->second);
}

bool Cleared::misses_stock(const Field& field, const Patch& patch) const {
    const auto* bar = std::get_if<milling::CylinderStock>(&stock_);
    if (bar == nullptr || field.frame.along != bar->axis) return false;
    const Vec3 c = field.frame.to_tool(bar->centre);
    const Vec2 off{std::max({patch.lo.x - c.x, c.x - patch.hi.x, 0.0}),
                   std::max({patch.lo.y - c.y, c.y - patch.hi.y, 0.0})};
    return geom::length(off) >= bar->radius;
}

bool Cleared::is_empty(Query& q, const Column& column, const Patch& patch, int level) const {
    const Upright& body = q.body;
    const auto flat = [](Vec3 p) { return Vec2{p.x, p.y}; };
    if (distance_between(flat(body.from), flat(body.to), patch) >= body.radius || misses_stock(q.field, patch))
        return true;
    if (q.left == 0) return false;
    --q.left;
    const Upright part = part_near(body, patch);
    const Zone needed{std::max(q.field.heights.low, std::min(part.from.z, part.to.z) + body.bottom),
                      std::min(q.field.heights.high, std::max(part.from.z, part.to.z) + body.top)};
    if (needed.low >= needed.high || column.empty.cover(needed)) return true;
    Zones empty = column.empty;
    bool any = false;
    for (auto at = column.cuts.rbegin(); at != column.cuts.rend(); ++at) {
        const ClearingCut& cut = q.field.cuts[*at].shape;
        if (cut.heights().low >= needed.high || cut.heights().high <= needed.low) continue;
        if (!common(cut.around(), patch)) continue;
        if (empty.cover({std::max(needed.low, cut.heights().low), std::min(needed.high, cut.heights().high)})) continue;
        any = true;
        cut.add_over(patch, slack_, empty);
        cut.add_along(part, slack_, empty);
        if (empty.cover(needed)) return true;
    }
    if (level == 0 || !any) return false;
    const Vec2 middle = 0.5 * (patch.lo + patch.hi);
    for (int quarter = 0; quarter < 4; ++quarter) {
        Patch p = patch;
        ((quarter & 1) != 0 ? p.lo : p.hi).x = middle.x;
        ((quarter & 2) != 0 ? p.lo : p.hi).y = middle.y;
        if (!is_empty(q, column, p, level - 1)) return false;
    }
    return true;
}

bool Cleared::is_clear(const Upright& given, Vec3 axis) {
    Field& field = field_for(milling::orientation_of(axis));
    Upright body = given;
    body.from = field.frame.to_tool(given.from);
    body.to = field.frame.to_tool(given.to);
    if (std::min(body.from.z, body.to.z) + body.bottom >= field.heights.high) return true;
    const Patch around{
        {std::min(body.from.x, body.to.x) - body.radius, std::min(body.from.y, body.to.y) - body.radius},
        {std::max(body.from.x, body.to.x) + body.radius, std::max(body.from.y, body.to.y) + body.radius}};
    Query q{body, field, most_columns};
    return Bins<Column>::each(field.columns, around, [&](Column& column, const Patch& patch) {
        const std::optional<Patch> p = common(patch, around);
        if (!p) return true;
        fill(field, column, patch);
        return is_empty(q, column, *p, deepest_level);
    });
}

/// Fields of all axes that were cut with.
bool Cleared::know_axes() {
    for (; axes_from_ < cuts_ && fields_.size() <= most_axes; ++axes_from_)
        if (simulation_->cutting_of(axes_from_ + 1) != nullptr)
            static_cast<void>(field_for(simulation_->body_of(axes_from_ + 1).frame));
    return fields_.size() <= most_axes;
}

double Cleared::depth_in(Field& field, Vec3 place, double depth) const {
    const Vec3 p = field.frame.to_tool(place);
    const Vec2 at{p.x, p.y};
    const auto look = [&](Column& c, const Patch& patch) {
        fill(field, c, patch);
        for (const Zone& z : c.empty.all()) depth = std::min(depth, from_box(p, patch, z));
        for (auto k = c.cuts.rbegin(); k != c.cuts.rend() && depth > 0; ++k) {
            const Cut& cut = field.cuts[*k];
            if (is_beyond(p, cut.shape.around(), cut.shape.heights(), depth)) continue;
            const milling::Air::Sweep s = simulation_->body_of(cut.number);
            depth = std::min(depth, milling::outside_sweep(*s.shape, s.track, s.frame.to_tool(place - s.from), depth));
        }
        return depth > 0;
    };
    // Most places are in the air, and their own column tells.
    if (!Bins<Column>::each(field.columns, {at, at}, look)) return 0;
    const Vec2 reach{depth, depth};
    static_cast<void>(Bins<Column>::each(field.columns, {at - reach, at + reach}, look));
    return depth;
}

double Cleared::depth_at(Vec3 place, double enough) {
    double depth = std::min(enough, simulation_->stock_body().within(place));
    if (!(depth > 0) || !know_axes()) return 0;
    for (Field& field : fields_) depth = std::min(depth, depth_in(field, place, depth));
    return std::max(0.0, depth);
}

}  // namespace obrys::check
