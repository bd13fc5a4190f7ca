#pragma once
/// The planar graph of many edges, split where they meet, with winding numbers of two sets of contours on either
/// side of every piece: what the set operations on regions and the turning removal are made of.

#include <cstdint>
#include <vector>

#include "base/function_ref.hpp"
#include "geom/edge.hpp"
#include "geom/region.hpp"

namespace obrys::geom {

/// Winding numbers about the contours of set A and of set B.
struct Windings {
    int a = 0, b = 0;
    bool operator==(const Windings&) const = default;
};

/// One edge put in. `of`: which set it bounds, {1, 0} or {0, 1}. `open_a`, `open_b`: the contour goes on beyond that
/// end with edges that are not put in; nothing else meets there.
struct SourceEdge {
    Edge edge;
    Windings of{1, 0};
    std::int32_t tag = -1;
    bool open_a = false, open_b = false;
};

struct ArrangeOptions {
    double tolerance = 1e-9;      ///< mm
    bool sets_are_clean = false;  ///< edges of one set meet only at their ends: they are not held against each other
};

class Arrangement {
public:
    /// A piece between two vertices; edges that run together are one piece.
    struct Piece {
        Edge edge;
        std::uint32_t from = 0, to = 0;
        Windings step;          ///< winding left of the piece less winding right of it
        std::int32_t tag = -1;  ///< of the first source
        bool whole = false;     ///< the first source's edge, unchanged
    };
    /// A piece with its direction: 2 * piece, + 1 against it.
    using Half = std::uint32_t;
    static constexpr Half none = 0xffffffffU;

    Arrangement(const std::vector<SourceEdge>& sources, const ArrangeOptions& options);

    /// Labels every side, sources being closed contours of any kind.
    void label();
    /// Labels every side, the sources being boundaries of clean regions (material, winding 1, on the left). Of a part
    /// of the graph with no edge of a set, the winding of that set is asked for at a point of it.
    void label_clean(base::FunctionRef<int(Vec2)> winding_a, base::FunctionRef<int(Vec2)> winding_b);
    /// False where labels contradict each other: the graph is not planar to the tolerance.
    [[nodiscard]] bool consistent() const { return consistent_; }
    /// Of two clean regions, every winding is 0 or 1.
    [[nodiscard]] bool windings_within(int lo, int hi) const;

    [[nodiscard]] const std::vector<Piece>& pieces() const { return pieces_; }
    [[nodiscard]] Vec2 vertex(std::uint32_t v) const { return vertices_[v]; }
    [[nodiscard]] bool is_open(std::uint32_t v) const { return open_[v] != 0; }
    [[nodiscard]] std::uint32_t from(Half h) const { return h & 1U ? pieces_[h / 2].to : pieces_[h / 2].from; }
    [[nodiscard]] std::uint32_t to(Half h) const { return from(h ^ 1U); }
    [[nodiscard]] Edge edge(Half h) const { return h & 1U ? reversed(pieces_[h / 2].edge) : pieces_[h / 2].edge; }
    [[nodiscard]] Windings left(Half h) const { return labels_[h]; }

    using Inside = base::FunctionRef<bool(Windings)>;
    /// Material on the left, none on the right.
    [[nodiscard]] bool bounds(Half h, Inside inside) const { return inside(left(h)) && !inside(left(h ^ 1U)); }
    /// The boundary half after `h` about the same material; none at an open end.
    [[nodiscard]] Half following(Half h, Inside inside) const;
    /// The contours of the set where `inside` holds: corners on straight or circular runs joined, slivers dropped.
    [[nodiscard]] Region region(Inside inside) const;

private:
    void order_around_vertices();
    void link(std::vector<Half>& around);
    std::vector<Half> spread(Half seed, std::vector<char>& seen);
    [[nodiscard]] Windings winding_elsewhere(const std::vector<Half>& part) const;
    [[nodiscard]] Vec2 clear_point(const std::vector<Half>& part, const std::vector<char>& own) const;
    Half outer_half(const std::vector<Half>& part);

    std::vector<Vec2> vertices_;
    std::vector<char> open_;
    std::vector<Piece> pieces_;
    std::vector<Half> next_, previous_;
    std::vector<Windings> labels_;
    bool consistent_ = true;
};

/// Joins neighbours that lie on one line or circle. `closed`: the last is followed by the first.
[[nodiscard]] std::vector<Edge> joined(const std::vector<Edge>& chain, bool closed);
/// The one edge in place of two that follow each other, where they lie on one line or circle.
[[nodiscard]] bool join_edges(const Edge& first, const Edge& second, Edge& result);

}  // namespace obrys::geom
