#include "geom/clearing.hpp"

#include <algorithm>
#include <queue>

#include "geom/boolean.hpp"
#include "geom/nearest.hpp"
#include "geom/offset.hpp"

namespace obrys::geom {

namespace {

constexpr double ridge = 1e-6;  // mm: what is narrower is no ridge

bool good(const Region& r, const ClearingOptions& o) {
    for (const Contour& c : r.contours)
        for (const Vertex& v : c.vertices)
            if (!std::isfinite(v.p.x) || !std::isfinite(v.p.y) || !std::isfinite(v.bulge)) return false;
    return std::isfinite(o.radius) && o.radius > 0 && std::isfinite(o.allowance) && o.radius + o.allowance >= 0 &&
           std::isfinite(o.stepover) && o.stepover > 0 && std::isfinite(o.rounding) && o.rounding >= 0;
}

/// Inner corners rounded, unless a channel would be lost: then the part stays as it is.
Region rounded(const Region& r, double radius) {
    if (radius <= 0) return r;
    Region out;
    for (const Region& piece : pieces(r)) {
        const Region opened = offset(offset(piece, -radius), radius);
        const bool alike =
            opened.contours.size() == piece.contours.size() && subtract(piece, offset(opened, 3 * radius)).empty();
        const Region& kept = alike ? opened : piece;
        out.contours.insert(out.contours.end(), kept.contours.begin(), kept.contours.end());
    }
    return out;
}

/// The parts of the region that are wider than a ridge.
std::vector<Region> wide_pieces(const Region& r) {
    std::vector<Region> out = pieces(r);
    std::erase_if(out, [](const Region& p) { return area(p) <= 0.5 * ridge * length(p); });
    return out;
}

double farthest(const Edge& e, Vec2 p) {
    double d = std::max(distance(e.a, p), distance(e.b, p));
    if (!is_arc(e)) return d;
    const Circle c = circle(e);
    const Vec2 u = c.centre - p;
    if (const double l = length(u); l > 0) d = std::max(d, distance(nearest(e, c.centre + (c.radius / l) * u), p));
    return d;
}

/// Of the radius: passes that only just meet leave a skin between them, on paper of no width (the two sides of the
/// innermost ring of a pocket three tools wide).
constexpr double pass_overlap = 0.02;

/// A place in the piece from which the tool covers all of it.
bool one_place_covers(const Region& piece, double radius, Vec2& place) {
    const Box b = box(piece);
    place = 0.5 * (b.lo + b.hi);
    if (!contains(piece, place)) return false;
    for (const Edge& e : edges(piece))
        if (farthest(e, place) > radius) return false;
    return true;
}

class Builder {
public:
    explicit Builder(const ClearingOptions& o) : o_(o), reach_((1 - pass_overlap) * o.radius) {}

    Clearing build(const Region& r) {
        if (!good(r, o_)) return failed(ClearingFault::bad_input);
        const Box b = box(r);
        const double deep = b.empty() ? 0 : 0.5 * std::min(b.hi.x - b.lo.x, b.hi.y - b.lo.y);
        const double first = o_.radius + o_.allowance;
        Region level = rounded(offset(r, -first), o_.rounding);
        if (level.empty()) return failed(ClearingFault::no_room);
        if ((deep - first) / o_.stepover > static_cast<double>(o_.most)) return failed(ClearingFault::too_many);
        out_.room = level;
        std::vector<Part> here = parts(level, 0);
        for (std::uint32_t k = 0; !here.empty(); ++k) {
            // Each level from the one before: it has fewer edges than the contour, and levels lie in each other.
            level = rounded(offset(level, -o_.stepover), o_.rounding);
            std::vector<Part> there = parts(level, k + 1);
            for (const Part& p : here) connect(p, there, k);
            if (out_.rings.size() > o_.most) return failed(ClearingFault::too_many);
            here = std::move(there);
        }
        return std::move(out_);
    }

private:
    static constexpr std::size_t unknown = static_cast<std::size_t>(-1);
    /// Two rings; the gap between them once it is computed, till then what it is at least.
    struct Pair {
        double at_least = 0;
        std::size_t a = 0, b = 0, gap = unknown;
        /// Equal but for rounding: in the order of the rings.
        bool operator>(const Pair& o) const {
            const double mine = std::round(at_least * 1e7), other = std::round(o.at_least * 1e7);
            return mine != other ? mine > other : a != o.a ? a > o.a : b > o.b;
        }
    };
    /// A connected part of a level, and its rings.
    struct Part {
        Region region;
        std::vector<std::size_t> rings;
    };

    static Clearing failed(ClearingFault f) {
        Clearing c;
        c.fault = f;
        return c;
    }

    std::size_t add_ring(Contour path, std::uint32_t level, bool added) {
        chains_.push_back(edges(path));
        boxes_.push_back({});
        for (const Edge& e : chains_.back()) boxes_.back().add(box(e));
        if (chains_.back().empty()) {
            const Vec2 p = path.vertices.front().p;
            chains_.back().push_back({p, p, 0});
            boxes_.back().add(p);
        }
        class_.push_back(class_.size());
        out_.rings.push_back({std::move(path), level, added});
        return out_.rings.size() - 1;
    }

    std::vector<Part> parts(const Region& r, std::uint32_t level) {
        std::vector<Part> out;
        for (Region& piece : pieces(r)) {
            Part p;
            for (const Contour& c : piece.contours) p.rings.push_back(add_ring(c, level, false));
            p.region = std::move(piece);
            out.push_back(std::move(p));
        }
        return out;
    }

    /// Rings of the part, of the parts of the next level in it, and of what both leave standing.
    void connect(const Part& p, const std::vector<Part>& next, std::uint32_t level) {
        std::vector<std::size_t> group = p.rings;
        Region inner;
        for (const Part& q : next) {
            if (!contains(p.region, point_at(edges(q.region.contours.front()).front(), 0.5))) continue;
            group.insert(group.end(), q.rings.begin(), q.rings.end());
            inner.contours.insert(inner.contours.end(), q.region.contours.begin(), q.region.contours.end());
        }
        if (o_.stepover > reach_ || o_.rounding > 0) cover(p.region, inner, level, group);
        link(group);
    }

    void cover(const Region& part, const Region& inner, std::uint32_t level, std::vector<std::size_t>& group) {
        Region deeper = offset(part, -reach_);
        if (!deeper.empty() && !inner.empty()) deeper = subtract(deeper, offset(inner, reach_));
        std::vector<Region> left = wide_pieces(deeper);
        while (!left.empty() && out_.rings.size() <= o_.most) {
            const Region piece = std::move(left.back());
            left.pop_back();
            Vec2 place;
            if (one_place_covers(piece, reach_, place)) {
                group.push_back(add_ring({{{place}}, true}, level, true));
                continue;
            }
            for (const Contour& c : piece.contours) group.push_back(add_ring(c, level, true));
            for (Region& rest : wide_pieces(offset(piece, -reach_))) left.push_back(std::move(rest));
        }
    }

    std::size_t class_of(std::size_t ring) {
        while (class_[ring] != ring) ring = class_[ring] = class_[class_[ring]];
        return ring;
    }

    /// The shortest ways between rings of a group that are not connected yet, one after another. Such a way crosses no
    /// ring of the group, as a shorter one would end there; so it stays in the room.
    void link(const std::vector<std::size_t>& group) {
        std::priority_queue<Pair, std::vector<Pair>, std::greater<>> queue;
        std::vector<Gap> gaps;
        std::size_t open = group.size() - 1;
        for (std::size_t i = 0; i < group.size(); ++i)
            for (std::size_t j = i + 1; j < group.size(); ++j)
                queue.push({distance(boxes_[group[i]], boxes_[group[j]]), group[i], group[j]});
        while (!queue.empty() && open > 0) {
            Pair p = queue.top();
            queue.pop();
            if (class_of(p.a) == class_of(p.b)) continue;
            if (p.gap == unknown) {
                p.gap = gaps.size();
                gaps.push_back(nearest_points(chains_[p.a], chains_[p.b]));
                p.at_least = gaps.back().length;
                queue.push(p);
                continue;
            }
            class_[class_of(p.a)] = class_of(p.b);
            out_.links.push_back({p.a, p.b, gaps[p.gap].a, gaps[p.gap].b});
            --open;
        }
    }

    ClearingOptions o_;
    double reach_ = 0;  ///< of the tool, with which passes overlap
    Clearing out_;
    std::vector<std::vector<Edge>> chains_;  ///< of the rings
    std::vector<Box> boxes_;
    std::vector<std::size_t> class_;
};

}  // namespace

Clearing clearing_rings(const Region& r, const ClearingOptions& o) { return Builder(o).build(r); }

}  // namespace obrys::geom
