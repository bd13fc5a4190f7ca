#include "check/turning/parting.hpp"

#include <algorithm>
#include <vector>

#include "check/turning/rest.hpp"
#include "geom/boolean.hpp"

namespace obrys::check {

namespace {

constexpr double slice = 1e-3;              ///< mm
constexpr double cut_off_within = 20;       ///< mm behind the part in which it is cut off
constexpr std::size_t most_corners = 1000;  ///< places that are looked at
constexpr double through = 0.01;            ///< mm: a skin of rounding, not of a cut that stopped

Neck section_at(const geom::Region& body, double z) {
    const Box all = box_of(body);
    const geom::Region strip{{{{{{z - slice / 2, all.min_x - 1}, 0},
                                {{z + slice / 2, all.min_x - 1}, 0},
                                {{z + slice / 2, all.max_x + 1}, 0},
                                {{z - slice / 2, all.max_x + 1}, 0}},
                               true}}};
    const geom::Region cut = geom::intersect(body, strip);
    const Box box = box_of(cut);
    return {z, geom::area(cut) / slice, box.min_x, box.max_x};
}

}  // namespace

std::optional<Neck> neck_behind(const geom::Region& part, const geom::Region& stock) {
    const Box own = box_of(part), all = box_of(stock);
    const double from = std::max(own.min_z - cut_off_within, all.min_z);
    if (own.empty() || all.empty() || !(from < own.min_z - slice)) return std::nullopt;
    std::vector<double> corners{from, own.min_z};
    for (const geom::Contour& c : stock.contours)
        for (const geom::Vertex& v : c.vertices)
            if (v.p.x > from && v.p.x < own.min_z && corners.size() < most_corners) corners.push_back(v.p.x);
    std::sort(corners.begin(), corners.end());
    std::optional<Neck> thinnest;
    for (std::size_t i = 0; i + 1 < corners.size(); ++i) {
        if (corners[i + 1] - corners[i] < 2 * slice) continue;
        const Neck n = section_at(stock, (corners[i] + corners[i + 1]) / 2);
        if (!thinnest || n.thickness < thinnest->thickness) thinnest = n;
    }
    if (!thinnest || thinnest->thickness < through) return std::nullopt;
    return thinnest->thickness < section_at(part, own.min_z + slice).thickness / 2 ? thinnest : std::nullopt;
}

}  // namespace obrys::check
