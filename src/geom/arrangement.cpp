#include "geom/arrangement.hpp"

#include <algorithm>
#include <cmath>

#include "geom/split.hpp"
#include "geom/tolerance.hpp"

namespace obrys::geom {

namespace {

/// A half leaving a vertex: where it goes at a given distance from the vertex.
struct Ray {
    Arrangement::Half half = 0;
    double angle = 0;  ///< of its tangent, from the reference direction, 0 .. 2 pi
    double chord = 0;
    double curvature = 0;  ///< signed
    [[nodiscard]] double at(double d) const {
        return curvature == 0 ? angle : angle + std::asin(std::clamp(0.5 * d * curvature, -1.0, 1.0));
    }
};

Ray ray_of(const Edge& e, Arrangement::Half h) {
    Ray r;
    r.half = h;
    r.chord = chord(e);
    const double half_sweep = e.bulge == 0 ? 0 : 0.5 * sweep_angle(e);
    r.angle = std::atan2(e.b.y - e.a.y, e.b.x - e.a.x) - half_sweep;
    r.curvature = 2 * std::sin(half_sweep) / r.chord;
    return r;
}

/// Counter-clockwise by direction; halves that start alike are told apart half as far out as the shorter of them
/// reaches.
void sort_rays(std::vector<Ray>& rays) {
    const auto turn = [](double a) { return a < 0 ? a + 2 * pi : a >= 2 * pi ? a - 2 * pi : a; };
    for (Ray& r : rays) r.angle = turn(turn(r.angle));
    std::sort(rays.begin(), rays.end(), [](const Ray& a, const Ray& b) { return a.angle < b.angle; });
    // The reference direction lies in the widest gap, so that no two directions that are nearly alike lie around it.
    double gap = rays.front().angle + 2 * pi - rays.back().angle, reference = 0.5 * gap + rays.back().angle;
    for (std::size_t i = 1; i < rays.size(); ++i)
        if (const double g = rays[i].angle - rays[i - 1].angle; g > gap) {
            gap = g;
            reference = 0.5 * g + rays[i - 1].angle;
        }
    reference = turn(reference);
    for (Ray& r : rays) r.angle = turn(r.angle - reference);
    const auto before = [](const Ray& a, const Ray& b) {
        if (std::abs(a.angle - b.angle) > 0.01) return a.angle < b.angle;
        const double d = 0.5 * std::min(a.chord, b.chord);  // both may end in the same vertex
        return a.at(d) < b.at(d);
    };
    for (std::size_t i = 1; i < rays.size(); ++i)  // few, and the comparison need not be a strict order
        for (std::size_t j = i; j > 0 && before(rays[j], rays[j - 1]); --j) std::swap(rays[j], rays[j - 1]);
}

}  // namespace

Arrangement::Arrangement(const std::vector<SourceEdge>& sources, const ArrangeOptions& options) {
    SplitEdges s = split(sources, options);
    vertices_ = std::move(s.vertices);
    open_ = std::move(s.open);
    pieces_ = std::move(s.pieces);
    order_around_vertices();
}

void Arrangement::link(std::vector<Half>& around) {
    if (around.size() > 2) {
        std::vector<Ray> rays;
        rays.reserve(around.size());
        for (const Half h : around) rays.push_back(ray_of(edge(h), h));
        sort_rays(rays);
        for (std::size_t i = 0; i < rays.size(); ++i) around[i] = rays[i].half;
    }
    const std::size_t n = around.size();
    for (std::size_t i = 0; i < n; ++i) {
        const Half arriving = around[i] ^ 1U, leaving = around[(i + n - 1) % n];
        next_[arriving] = leaving;
        previous_[leaving] = arriving;
    }
}

void Arrangement::order_around_vertices() {
    const std::size_t halves = 2 * pieces_.size();
    next_.assign(halves, none);
    previous_.assign(halves, none);
    std::vector<std::uint32_t> start(vertices_.size() + 1, 0);
    for (Half h = 0; h < halves; ++h) ++start[from(h) + 1];
    for (std::size_t v = 0; v < vertices_.size(); ++v) start[v + 1] += start[v];
    std::vector<Half> leaving(halves);
    std::vector<std::uint32_t> fill(start.begin(), start.end() - 1);
    for (Half h = 0; h < halves; ++h) leaving[fill[from(h)]++] = h;
    std::vector<Half> around;
    for (std::size_t v = 0; v < vertices_.size(); ++v) {
        if (open_[v] || start[v] == start[v + 1]) continue;
        around.assign(leaving.begin() + start[v], leaving.begin() + start[v + 1]);
        link(around);
    }
}

std::vector<Arrangement::Half> Arrangement::spread(Half seed, std::vector<char>& seen) {
    std::vector<Half> part{seed};
    seen[seed] = 1;
    labels_[seed] = {};
    const auto visit = [&](Half h, Windings w) {
        if (h == none) return;
        if (seen[h]) {
            if (labels_[h] != w) consistent_ = false;
            return;
        }
        seen[h] = 1;
        labels_[h] = w;
        part.push_back(h);
    };
    for (std::size_t i = 0; i < part.size(); ++i) {
        const Half h = part[i];
        const Windings w = labels_[h], step = pieces_[h / 2].step;
        const int sign = h & 1U ? 1 : -1;
        visit(h ^ 1U, {w.a + sign * step.a, w.b + sign * step.b});
        visit(next_[h], w);
        visit(previous_[h], w);
    }
    return part;
}

Arrangement::Half Arrangement::outer_half(const std::vector<Half>& part) {
    // The face outside a connected part is the one that is run around clockwise: its area is the least.
    const Vec2 origin = -vertices_[from(part.front())];
    std::vector<char> seen(labels_.size(), 0), met(vertices_.size(), 0);
    Half outer = part.front();
    double least = std::numeric_limits<double>::infinity();
    std::size_t faces = 0, corners = 0;
    for (const Half seed : part) {
        if (!met[from(seed)]) ++corners;
        met[from(seed)] = 1;
        if (seen[seed]) continue;
        ++faces;
        double sum = 0;
        for (Half h = seed; h != none && !seen[h]; h = next_[h]) {
            seen[h] = 1;
            sum += area_term(moved(edge(h), origin));
        }
        if (sum < least) {
            least = sum;
            outer = seed;
        }
    }
    if (corners + faces != part.size() / 2 + 2) consistent_ = false;  // Euler: halves in an order no drawing has
    return outer;
}

Vec2 Arrangement::clear_point(const std::vector<Half>& part, const std::vector<char>& own) const {
    // Where the part comes near to others without meeting them, inside and outside cannot be told.
    constexpr double clear = 1e-6;
    constexpr std::size_t most = 32;
    Vec2 best = vertices_[from(part.front())];
    double widest = -1;
    const std::size_t stride = 1 + part.size() / most;
    for (std::size_t k = 0; k < part.size() && widest < clear; k += stride) {
        const Vec2 p = point_at(edge(part[k]), 0.5);
        double room = clear;
        for (std::size_t i = 0; i < pieces_.size() && room > widest; ++i)
            if (!own[i] && contains(box(pieces_[i].edge), p, clear))
                room = std::min(room, distance(pieces_[i].edge, p));
        if (room > widest) {
            widest = room;
            best = p;
        }
    }
    return best;
}

Windings Arrangement::winding_elsewhere(const std::vector<Half>& part) const {
    std::vector<char> own(pieces_.size(), 0);
    for (const Half h : part) own[h / 2] = 1;
    Windings w;
    if (part.size() == labels_.size()) return w;
    const Vec2 p = clear_point(part, own);
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
        if (own[i]) continue;
        const int k = winding_term(pieces_[i].edge, p);
        w.a += k * pieces_[i].step.a;
        w.b += k * pieces_[i].step.b;
    }
    return w;
}

void Arrangement::label() {
    labels_.assign(2 * pieces_.size(), {});
    std::vector<char> seen(labels_.size(), 0);
    for (Half seed = 0; seed < labels_.size(); ++seed) {
        if (seen[seed]) continue;
        const std::vector<Half> part = spread(seed, seen);
        const Half outer = outer_half(part);
        const Windings around = winding_elsewhere(part), is = labels_[outer];
        for (const Half h : part) {
            labels_[h].a += around.a - is.a;
            labels_[h].b += around.b - is.b;
        }
    }
}

bool Arrangement::windings_within(int lo, int hi) const {
    return std::all_of(labels_.begin(), labels_.end(),
                       [&](Windings w) { return w.a >= lo && w.a <= hi && w.b >= lo && w.b <= hi; });
}

void Arrangement::label_clean(base::FunctionRef<int(Vec2)> winding_a, base::FunctionRef<int(Vec2)> winding_b) {
    labels_.assign(2 * pieces_.size(), {});
    std::vector<char> seen(labels_.size(), 0);
    for (Half seed = 0; seed < labels_.size(); ++seed) {
        if (seen[seed]) continue;
        const std::vector<Half> part = spread(seed, seen);
        // Along an edge of a set the winding is 1 on its left; half h runs along it where the step is positive.
        bool know_a = false, know_b = false;
        Windings shift;
        for (const Half h : part) {
            const Windings step = pieces_[h / 2].step;
            const int sign = h & 1U ? -1 : 1;
            if (!know_a && sign * step.a > 0) shift.a = 1 - labels_[h].a, know_a = true;
            if (!know_b && sign * step.b > 0) shift.b = 1 - labels_[h].b, know_b = true;
            if (know_a && know_b) break;
        }
        Vec2 p;
        if (!know_a || !know_b) {
            std::vector<char> own(pieces_.size(), 0);
            for (const Half h : part) own[h / 2] = 1;
            p = clear_point(part, own);
        }
        if (!know_a) shift.a = winding_a(p) - labels_[part.front()].a;
        if (!know_b) shift.b = winding_b(p) - labels_[part.front()].b;
        for (const Half h : part) {
            labels_[h].a += shift.a;
            labels_[h].b += shift.b;
            if (labels_[h].a < 0 || labels_[h].a > 1 || labels_[h].b < 0 || labels_[h].b > 1) consistent_ = false;
        }
    }
}

Arrangement::Half Arrangement::following(Half h, Inside inside) const {
    Half g = next_[h];
    while (g != none && !bounds(g, inside)) {
        if (g == (h ^ 1U)) return none;  // only where labels contradict each other
        g = next_[g ^ 1U];
    }
    return g;
}

Region Arrangement::region(Inside inside) const {
    Region out;
    std::vector<char> used(labels_.size(), 0);
    for (Half seed = 0; seed < labels_.size(); ++seed) {
        if (used[seed] || !bounds(seed, inside)) continue;
        std::vector<Edge> chain;
        double sum = 0, around = 0;
        const Vec2 origin = -vertices_[from(seed)];
        for (Half h = seed; h != none && !used[h]; h = following(h, inside)) {
            used[h] = 1;
            chain.push_back(edge(h));
            sum += area_term(moved(chain.back(), origin));
            around += length(chain.back());
        }
        if (std::abs(sum) <= 0.5 * snap * around) continue;
        out.contours.push_back(contour_of(joined(chain, true)));
    }
    return out;
}

}  // namespace obrys::geom
