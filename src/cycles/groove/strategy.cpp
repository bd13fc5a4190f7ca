#include "cycles/groove/strategy.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/number.hpp"

namespace obrys::cycles::groove {

namespace {

constexpr std::array<Named, 10> names{{
    {Strategy::side_stepping, "side-stepping", "side stepping"},
    {Strategy::side_stepping_high, "side-stepping-high", "side stepping, from the high side"},
    {Strategy::stepwise, "stepwise", "stepwise alternating"},
    {Strategy::cycle93, "cycle93", "paraxial columns, pecked"},
    {Strategy::single, "single", "single plunge, first slot only"},
    {Strategy::layers, "layers", "layer by layer"},
    {Strategy::multiple, "multiple", "multiple with ribs"},
    {Strategy::plunge_turning, "plunge-turning", "plunge turning"},
    {Strategy::ramping, "ramping", "ramping"},
    {Strategy::finishing, "finishing", "finishing"},
}};

/// u that no blade of the groove leaves.
struct Extent {
    double begin = 0, end = 0;
};
Extent extent_of(const Request& r, const Contours& c) {
    const double beside = 20 * r.insert.width + 10 * r.manner.clearance + 20 * r.manner.infeed + c.finished.flat();
    return {c.finished.wall(Side::left).top().x - beside, c.finished.wall(Side::right).top().x + beside};
}

Side low_side(const Shape& s) { return s.slope >= 0 ? Side::left : Side::right; }

std::optional<Refusal> make(Blade& blade, const Request& r, Strategy strategy) {
    switch (strategy) {
        case Strategy::side_stepping: side_stepping(blade, low_side(r.shape)); break;
        case Strategy::side_stepping_high: side_stepping(blade, other(low_side(r.shape))); break;
        case Strategy::stepwise: stepwise(blade); break;
        case Strategy::cycle93: pecked_columns(blade, false); break;
        case Strategy::single: pecked_columns(blade, true); break;
        case Strategy::layers: layer_by_layer(blade); break;
        case Strategy::multiple: return multiple(blade);
        case Strategy::plunge_turning: return plunge_turning(blade);
        case Strategy::ramping: return ramping(blade);
        case Strategy::finishing: finishing(blade); break;
    }
    return std::nullopt;
}

}  // namespace

std::span<const Named> strategies() { return names; }
const Named& named(Strategy strategy) { return names[static_cast<std::size_t>(strategy)]; }

Skyline full_stock(const Request& r, const Contours& c) {
    const Extent e = extent_of(r, c);
    return {c.finished.wall(Side::right).edge, r.shape.slope, e.begin, e.end};
}

Skyline roughed_stock(const Request& r, const Contours& c) {
    Skyline stock = full_stock(r, c);
    // A blade without width along the contour leaves just it.
    for (const Side side : {Side::left, Side::right})
        for (const Piece& p : c.rough.wall(side).pieces)
            if (p.from.x != p.to.x) stock.cut({p.from, p.to, p.centre, p.sweep}, 0);
    const double begin = c.rough.wall(Side::left).foot().x;
    stock.cut({{begin, c.rough.bottom}, {begin, c.rough.bottom}}, c.rough.flat());
    return stock;
}

double rest_bound(const Request& r, Strategy strategy) {
    const double round = r.insert.corner_radius, gap = r.manner.stepover - r.insert.width + 2 * round;
    // The corner that the path reckons with stands out of the round one by this much, at 45 degrees; a wall that leans
    // otherwise keeps less: round * (cos + sin - 1).
    double rest = round * (std::sqrt(2) - 1);
    if (gap > 0) rest = std::max(rest, round - std::sqrt(std::max(0.0, round * round - gap * gap / 4)));
    return rest + (strategy == Strategy::plunge_turning ? r.manner.lift : 0);
}

std::variant<Path, Refusal> path_of(const Request& request, const Contours& contours, Strategy strategy) {
    if (std::optional<Refusal> r = refused(request, contours)) return *r;
    const bool finish = strategy == Strategy::finishing;
    if (finish && request.insert.width > contours.finished.flat() + nothing)
        return Refusal{Guard::insert_wider,
                       "the insert of " + base::shortest(request.insert.width) +
                           " mm is wider than the flat bottom of the finished groove, " +
                           base::shortest(contours.finished.flat()) + " mm",
                       "take a narrower insert, or make the inner corners smaller"};
    Blade blade(request, finish ? contours.finished : contours.rough,
                finish ? roughed_stock(request, contours) : full_stock(request, contours));
    if (std::optional<Refusal> r = make(blade, request, strategy)) return *r;
    return Path{blade.moves(), blade.doings()};
}

}  // namespace obrys::cycles::groove
