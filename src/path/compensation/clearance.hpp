#pragma once
/// Zones of elements that are not neighbours: what Clearance::reported and avoided need. Inside of compensation.hpp;
/// not for callers. The boundary of all zones on the tool's side consists of the parallels and of the arcs round outer
/// corners; so these arcs become items of their own, and the path is the walk along items that changes over to a later
/// one where it would enter that one's zone, if what lies between is a pocket (contour_loop.hpp).

#include <cmath>
#include <deque>
#include <optional>

#include "path/compensation/contour_loop.hpp"

namespace obrys::path {

/// Item::zone of an item whose setting, role and offsets are given.
[[nodiscard]] double zone_of(const Item& item);
[[nodiscard]] inline bool has_zone(const Item& item) { return item.zone != 0; }
/// True where both have zones and the tool stands equally far on the same side.
[[nodiscard]] inline bool same_zone(const Item& a, const Item& b) {
    return has_zone(a) && has_zone(b) && std::abs(a.zone - b.zone) <= same_point;
}
/// Box round the item's parallel, generous for arcs.
[[nodiscard]] geom::Box box_of(const Curve& c);

/// Settles the corner between two contour items or arcs too tight: closes an outer corner by prolonging both parallels
/// where asked for, else makes the arc between them (b's events come before it).
[[nodiscard]] std::optional<Item> make_corner(Item& a, Item& b);

/// How the path leaves `a` for `b`.
struct Exit {
    std::size_t item = 1;  ///< index of b in the window
    Crossing at;
    bool straight = false;  ///< from a's end to b's start, with a link where they are apart
};
/// To the next item; nothing where there is no sound way.
[[nodiscard]] std::optional<Exit> exit_to_next(const Item& a, const Item& b);
/// Where a enters the zone of a later or earlier item.
[[nodiscard]] std::optional<Crossing> entry(const Item& a, const Item& zone);
/// Number of items from the front on that are looked at: those with the same zone, up to the front's `window` of
/// contour elements and at least one. `complete`: no further item would change it.
struct Reach {
    std::size_t count = 1;
    bool complete = false;
};
[[nodiscard]] Reach reach(const std::deque<Item>& window);
/// The items from the front one to item m.
[[nodiscard]] Chain chain_to(const std::deque<Item>& window, std::size_t m);
/// The first exit of the front item within reach, `avoided`: to the next item or over a pocket; of equally early ones
/// to the nearest item.
[[nodiscard]] std::optional<Exit> first_exit(const std::deque<Item>& window, std::size_t reach);
/// The sound exits from item to item lead from the front one to item m.
[[nodiscard]] bool leads_to(const std::deque<Item>& window, std::size_t m);
/// True where a, between two places, comes into the zone by more than `blend`.
[[nodiscard]] bool cuts_into(const Item& zone, const Item& a, double from, double to);

}  // namespace obrys::path
