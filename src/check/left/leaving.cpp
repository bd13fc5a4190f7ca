#include "check/left/leaving.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace obrys::check {

namespace milling = sim::milling;

using geom::Vec2;
using geom::Vec3;

namespace {

constexpr double facing = 1e-9;       ///< of a cosine: faces along the way count as looking ahead
constexpr double widest_angle = 1.2;  ///< rad, of a cell
constexpr double finest = 0.25;       ///< of what is allowed: no smaller cells

/// What a piece of a face comes through: ways from places on it.
struct Ahead {
    Vec2 low, high;             ///< of the face's half section
    double from = 0, to = 0;    ///< angles about the axis
    double begin = 0, end = 1;  ///< shares of the way
};

class LeavingSearch {
public:
    LeavingSearch(const LeftBody& body, const LeftSearch& s)
        : body_(body), s_(s), frame_(milling::orientation_of(body.axis)), way_(frame_.to_tool(body.edges[0])) {}
    [[nodiscard]] bool is_clear();

private:
    void add_face(Vec2 low, Vec2 high);
    [[nodiscard]] Vec3 place(Vec2 at, double angle, double share) const;
    [[nodiscard]] bool is_clear(const Ahead& cell);
    [[nodiscard]] bool is_deep(const Ahead& cell) const;
    [[nodiscard]] bool is_within(std::span<const Disc> places);
    [[nodiscard]] bool split(const Ahead& cell);

    const LeftBody& body_;
    const LeftSearch& s_;
    milling::Orientation frame_;
    Vec3 way_;
    std::vector<Ahead> open_;
    std::size_t last_ = 0;  ///< a cut that held a cell
};

/// The part of a face whose normal does not look back. Where a way through a convex body ends, one of its faces there
/// looks ahead, so all that the body reaches anew lies ahead of such places.
void LeavingSearch::add_face(Vec2 low, Vec2 high) {
    const Vec2 along = high - low;
    const double size = geom::length(along);
    if (!(size > 0)) return;
    const double across = along.y / size, up = -along.x / size;  // of the normal, outwards
    const double flat = std::hypot(way_.x, way_.y), length = geom::length(way_);
    const double most = across * flat, rest = up * way_.z;
    if (most + rest < -facing * length) return;  // looks back all around
    double half = geom::pi;
    if (most > facing * length && rest - most < 0) half = std::acos(std::clamp(-rest / most - facing, -1.0, 1.0));
    const double middle = flat > 0 ? std::atan2(way_.y, way_.x) : 0;
    open_.push_back({low, high, middle - half, middle + half});
}

Vec3 LeavingSearch::place(Vec2 at, double angle, double share) const {
    return body_.corner + frame_.to_stock(Vec3{at.x * std::cos(angle), at.x * std::sin(angle), at.y} + share * way_);
}

/// Whether the stock's faces or one cut leave nothing of the hull of some places deeper than allowed.
bool LeavingSearch::is_within(std::span<const Disc> places) {
    const double most = s_.allowed;
    const auto beyond = [&](const StockPlane& plane) {
        return std::all_of(places.begin(), places.end(),
                           [&](const Disc& d) { return plane.at - geom::dot(plane.out, d.centre) <= most; });
    };
    if (s_.planes != nullptr && std::any_of(s_.planes->planes.begin(), s_.planes->planes.end(), beyond)) return true;
    Vec3 middle;
    for (const Disc& d : places) middle = middle + (1 / static_cast<double>(places.size())) * d.centre;
    if (deepest_in(s_.stock, s_.air, places, body_.axis, middle) <= most) return true;
    const double enough = std::nextafter(most, INFINITY);
    const auto held = [&](std::size_t cut) { return s_.cuts[cut].farthest(places, body_.axis, enough) <= most; };
    if (last_ < s_.cuts.size() && held(last_)) return true;
    for (std::size_t i = 0; i < s_.cuts.size(); ++i)
        if (held(i)) return last_ = i, true;
    return false;
}

/// An arc lies between its ends and where the tangents there meet.
bool LeavingSearch::is_clear(const Ahead& cell) {
    if (cell.to - cell.from > widest_angle) return false;
    const double half = 0.5 * (cell.to - cell.from), middle = 0.5 * (cell.from + cell.to), out = 1 / std::cos(half);
    std::array<Disc, 12> places;
    std::size_t n = 0;
    for (const Vec2& at : {cell.low, cell.high})
        for (const double share : {cell.begin, cell.end}) {
            places[n++].centre = place(at, cell.from, share);
            places[n++].centre = place(at, cell.to, share);
            places[n++].centre = place({out * at.x, at.y}, middle, share);
        }
    return is_within(places);
}

/// Whether the place in its middle stands in what is left: then nothing is to be shown.
bool LeavingSearch::is_deep(const Ahead& cell) const {
    const Disc at{place(0.5 * (cell.low + cell.high), 0.5 * (cell.from + cell.to), 0.5 * (cell.begin + cell.end)), 0};
    return s_.air.outside(0, at.centre) > s_.allowed &&
           std::none_of(s_.cuts.begin(), s_.cuts.end(),
                        [&](const LeftCut& c) { return c.farthest(at, body_.axis) <= s_.allowed; });
}

/// Its longest side in two; false: it is too small for that.
bool LeavingSearch::split(const Ahead& cell) {
    const double around = std::max(cell.low.x, cell.high.x) * (cell.to - cell.from);
    const double along = geom::length(cell.high - cell.low), ahead = (cell.end - cell.begin) * geom::length(way_);
    const double longest = std::max({around, along, ahead});
    if (longest < finest * s_.allowed) return false;
    Ahead first = cell, second = cell;
    if (longest == around || cell.to - cell.from > widest_angle)
        first.to = second.from = 0.5 * (cell.from + cell.to);
    else if (longest == along)
        first.high = second.low = 0.5 * (cell.low + cell.high);
    else
        first.end = second.begin = 0.5 * (cell.begin + cell.end);
    open_.push_back(first);
    open_.push_back(second);
    return true;
}

bool LeavingSearch::is_clear() {
    const std::vector<Vec2>& section = body_.profile;
    add_face({0, section.front().y}, section.front());
    for (std::size_t i = 1; i < section.size(); ++i) add_face(section[i - 1], section[i]);
    add_face(section.back(), {0, section.back().y});
    for (std::size_t cells = 0; !open_.empty(); ++cells) {
        const Ahead cell = open_.back();
        open_.pop_back();
        if (is_clear(cell)) continue;
        if (cells >= s_.most_cells || is_deep(cell) || !split(cell)) return false;
    }
    return true;
}

}  // namespace

bool leaves_clear(const LeftBody& body, const LeftSearch& search) {
    if (body.profile.size() < 2 || !(geom::length(body.edges[0]) > thin_piece)) return false;
    return LeavingSearch(body, search).is_clear();
}

}  // namespace obrys::check
