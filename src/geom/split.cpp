#include "geom/split.hpp"

#include <algorithm>
#include <cmath>

#include "base/whole.hpp"

namespace obrys::geom {

namespace {

/// Points nearer to each other than the tolerance become one vertex: the one that came first.
class Welder {
public:
    Welder(std::vector<Vec2>& vertices, double tolerance, std::size_t expected)
        : vertices_(vertices), tolerance_(tolerance), cell_(std::max(1e-6, 8 * tolerance)) {
        std::size_t n = 64;
        while (n < 2 * expected) n *= 2;
        heads_.assign(n, none);
    }

    std::uint32_t add(Vec2 p) {
        const double gx = p.x / cell_, gy = p.y / cell_;
        const double fx = std::floor(gx), fy = std::floor(gy), edge = tolerance_ / cell_;
        const int x0 = gx - fx < edge ? -1 : 0, x1 = fx + 1 - gx < edge ? 1 : 0;
        const int y0 = gy - fy < edge ? -1 : 0, y1 = fy + 1 - gy < edge ? 1 : 0;
        std::uint32_t best = none;
        double best_square = tolerance_ * tolerance_;
        for (int dx = x0; dx <= x1; ++dx)
            for (int dy = y0; dy <= y1; ++dy)
                for (std::uint32_t v = heads_[slot(fx + dx, fy + dy)]; v != none; v = chain_[v])
                    if (const Vec2 d = vertices_[v] - p; dot(d, d) <= best_square) {
                        best = v;
                        best_square = dot(d, d);
                    }
        if (best != none) return best;
        const auto v = static_cast<std::uint32_t>(vertices_.size());
        std::uint32_t& head = heads_[slot(fx, fy)];
        vertices_.push_back(p);
        chain_.push_back(head);
        head = v;
        return v;
    }

private:
    static constexpr std::uint32_t none = 0xffffffffU;
    [[nodiscard]] std::size_t slot(double x, double y) const {
        const auto a = static_cast<std::uint64_t>(base::cut<std::int64_t>(x).value_or(0));
        const auto b = static_cast<std::uint64_t>(base::cut<std::int64_t>(y).value_or(0));
        std::uint64_t h = a * 0x9e3779b97f4a7c15ULL ^ (b * 0xc2b2ae3d27d4eb4fULL);
        h ^= h >> 29;
        return static_cast<std::size_t>(h) & (heads_.size() - 1);
    }

    std::vector<Vec2>& vertices_;
    double tolerance_, cell_;
    std::vector<std::uint32_t> heads_, chain_;
};

/// An edge of at most a quarter circle, and the points that split it.
struct Strand {
    Edge edge;
    Box box;
    std::uint32_t source = 0;
    std::uint32_t from = 0, to = 0;  ///< vertices
    bool first = true, last = true;
    std::vector<Vec2> points;
};

constexpr double quarter = 0.41421356;  ///< bulge, of a hair less than a quarter circle

std::vector<Strand> strands_of(const std::vector<SourceEdge>& sources) {
    std::vector<Strand> out;
    out.reserve(sources.size());
    for (std::uint32_t i = 0; i < sources.size(); ++i) {
        const Edge& e = sources[i].edge;
        const bool short_arc = std::abs(e.bulge) <= quarter;
        const int n = !short_arc && is_arc(e)
                          ? base::clipped<int>(std::ceil(std::abs(sweep_angle(e)) / (pi / 2) - 1e-9), 1, 4)
                          : 1;
        for (int k = 0; k < n; ++k) {
            Strand s;
            s.edge = n == 1 ? e : part(e, static_cast<double>(k) / n, static_cast<double>(k + 1) / n);
            if (k > 0) s.edge.a = out.back().edge.b;
            if (!is_arc(s.edge)) s.edge.bulge = 0;
            s.box = box(s.edge);
            s.source = i;
            s.first = k == 0;
            s.last = k == n - 1;
            out.push_back(std::move(s));
        }
    }
    return out;
}

void touch(Strand& s, Vec2 p, double tolerance) {
    if (p != s.edge.a && p != s.edge.b && contains(s.box, p, tolerance) && distance(s.edge, p) <= tolerance)
        s.points.push_back(p);
}

void meet(Strand& e, Strand& f, double tolerance, std::vector<Vec2>& met) {
    const Crossings c = crossings(e.edge, f.edge, tolerance);
    for (int i = 0; i < c.count; ++i) met.push_back(c.points[static_cast<std::size_t>(i)]);
    touch(e, f.edge.a, tolerance);
    touch(e, f.edge.b, tolerance);
    touch(f, e.edge.a, tolerance);
    touch(f, e.edge.b, tolerance);
}

/// Where, in this order, the strands of another set begin: thousands of edges of a stock are passed over at once.
std::vector<std::size_t> ends_of_runs(const std::vector<Strand>& strands, const std::vector<SourceEdge>& sources,
                                      const std::vector<std::uint32_t>& order) {
    std::vector<std::size_t> end(order.size(), order.size());
    const auto set_of = [&](std::size_t i) { return sources[strands[order[i]].source].of; };
    for (std::size_t i = order.size(); i-- > 1;) end[i - 1] = set_of(i - 1) == set_of(i) ? end[i] : i;
    return end;
}

void meet_all(std::vector<Strand>& strands, const std::vector<SourceEdge>& sources, const ArrangeOptions& options) {
    std::vector<std::uint32_t> order(strands.size());
    for (std::uint32_t i = 0; i < order.size(); ++i) order[i] = i;
    std::sort(order.begin(), order.end(),
              [&](std::uint32_t i, std::uint32_t j) { return strands[i].box.lo.x < strands[j].box.lo.x; });
    const std::vector<std::size_t> next_set = ends_of_runs(strands, sources, order);
    std::vector<Vec2> met;
    for (std::size_t i = 0; i < order.size(); ++i) {
        Strand& e = strands[order[i]];
        for (std::size_t j = i + 1, next = j; j < order.size(); j = next) {
            Strand& f = strands[order[j]];
            if (f.box.lo.x > e.box.hi.x + options.tolerance) break;
            const bool passed_over = options.sets_are_clean && sources[e.source].of == sources[f.source].of;
            next = passed_over ? next_set[j] : j + 1;
            if (passed_over) continue;
            if (overlap(e.box, f.box, options.tolerance)) meet(e, f, options.tolerance, met);
        }
    }
    // A crossing splits every strand that passes there, not only the two: strands that nearly coincide do not each
    // cross a third one at the same place when they meet it at a small angle.
    const auto by_x = [](Vec2 p, Vec2 q) { return p.x < q.x; };
    std::sort(met.begin(), met.end(), by_x);
    for (Strand& s : strands) {
        const Vec2 lo{s.box.lo.x - options.tolerance, 0};
        for (auto p = std::lower_bound(met.begin(), met.end(), lo, by_x);
             p != met.end() && p->x <= s.box.hi.x + options.tolerance; ++p)
            touch(s, *p, options.tolerance);
    }
}

struct Stop {
    double t = 0;
    std::uint32_t vertex = 0;
};

/// The pieces of one strand between the vertices on it.
void cut_up(const Strand& s, const SourceEdge& source, Welder& weld, const std::vector<Vec2>& vertices,
            std::vector<Arrangement::Piece>& out) {
    const std::uint32_t first = s.from, last = s.to;
    std::vector<Stop> stops{{0, first}};
    for (const Vec2 p : s.points) {
        const std::uint32_t v = weld.add(p);
        if (v == first || v == last) continue;
        const double t = parameter(s.edge, vertices[v]);
        if (t > 0 && t < 1) stops.push_back({t, v});
    }
    std::sort(stops.begin() + 1, stops.end(), [](const Stop& x, const Stop& y) { return x.t < y.t; });
    stops.push_back({1, last});
    const bool straight = s.edge.bulge == 0;
    const double sweep = straight ? 0 : sweep_angle(s.edge);
    for (std::size_t i = 0; i + 1 < stops.size(); ++i) {
        const Stop &p = stops[i], &q = stops[i + 1];
        if (p.vertex == q.vertex) continue;
        Arrangement::Piece piece;
        piece.from = p.vertex;
        piece.to = q.vertex;
        piece.edge = {vertices[p.vertex], vertices[q.vertex], straight ? 0 : std::tan(0.25 * sweep * (q.t - p.t))};
        if (stops.size() == 2) piece.edge.bulge = s.edge.bulge;
        if (!is_arc(piece.edge)) piece.edge.bulge = 0;
        piece.step = source.of;
        piece.tag = source.tag;
        piece.whole = piece.edge == source.edge;
        out.push_back(piece);
    }
}

/// Pieces with the same ends and the same sagitta become one.
void merge_equal(std::vector<Arrangement::Piece>& pieces, double tolerance) {
    std::vector<std::uint32_t> order(pieces.size());
    for (std::uint32_t i = 0; i < order.size(); ++i) order[i] = i;
    const auto key = [&](std::uint32_t i) {
        const auto [lo, hi] = std::minmax(pieces[i].from, pieces[i].to);
        return (static_cast<std::uint64_t>(lo) << 32U) | hi;
    };
    std::sort(order.begin(), order.end(),
              [&](std::uint32_t i, std::uint32_t j) { return key(i) != key(j) ? key(i) < key(j) : i < j; });
    std::vector<char> merged(pieces.size(), 0);
    for (std::size_t i = 0; i < order.size(); ++i) {
        if (merged[order[i]]) continue;
        Arrangement::Piece& p = pieces[order[i]];
        for (std::size_t j = i + 1; j < order.size() && key(order[j]) == key(order[i]); ++j) {
            const Arrangement::Piece& q = pieces[order[j]];
            const int sign = p.from == q.from ? 1 : -1;
            if (merged[order[j]] || std::abs(sagitta(p.edge) - sign * sagitta(q.edge)) > 2 * tolerance) continue;
            p.step.a += sign * q.step.a;
            p.step.b += sign * q.step.b;
            merged[order[j]] = 1;
        }
        if (p.step == Windings{}) merged[order[i]] = 1;
    }
    std::size_t n = 0;
    for (std::size_t i = 0; i < pieces.size(); ++i)
        if (!merged[i]) pieces[n++] = pieces[i];
    pieces.resize(n);
}

}  // namespace

SplitEdges split(const std::vector<SourceEdge>& sources, const ArrangeOptions& options) {
    std::vector<Strand> strands = strands_of(sources);
    meet_all(strands, sources, options);
    std::size_t expected = 0;
    for (const Strand& s : strands) expected += 1 + s.points.size();
    SplitEdges out;
    Welder weld(out.vertices, options.tolerance, expected);
    // Ends first: they keep their place, crossings near them move onto them.
    for (Strand& s : strands) {
        s.from = weld.add(s.edge.a);
        s.to = weld.add(s.edge.b);
    }
    for (const Strand& s : strands) cut_up(s, sources[s.source], weld, out.vertices, out.pieces);
    merge_equal(out.pieces, options.tolerance);
    out.open.assign(out.vertices.size(), 0);
    for (const Strand& s : strands) {
        const SourceEdge& source = sources[s.source];
        if (source.open_a && s.first) out.open[s.from] = 1;
        if (source.open_b && s.last) out.open[s.to] = 1;
    }
    return out;
}

}  // namespace obrys::geom
