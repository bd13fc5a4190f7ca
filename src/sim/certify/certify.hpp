#pragma once
/// How deep a moving tool goes into a part, by geometry: no rays, no samples, so nothing is too narrow to be seen.
/// Millimetres.
///
/// A tool is a union of convex bodies, and what such a body sweeps on a straight way is convex. Made smaller by an
/// amount so that a ball of that radius covers the difference, it either meets no triangle of the part and lies outside
/// of it: then no point of the tool is deeper in the part than that, and no point of the part's surface deeper in the
/// tool. Or it does: then the depth is looked for. Curved ways are cut into chords until what lies between is a
/// twentieth of what is allowed; that counts as depth.

#include <array>
#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <vector>

#include "geom/interpolation.hpp"
#include "mesh/distance.hpp"
#include "sim/certify/body.hpp"
#include "sim/certify/joined.hpp"

namespace obrys::sim::certify {

/// A tool that moves with its axis held.
struct Move {
    geom::PathElement path;    ///< of the programmed point
    geom::Vec3 axis{0, 0, 1};  ///< from the tip to the holder, any length
    const Shape* shape = nullptr;
};

/// How deep, and where: there is no depth without a place.
struct Depth {
    Depth(double how_deep, geom::Vec3 deepest, geom::Vec3 nearest, geom::Vec3 out_of_part)
        : depth(how_deep), at(deepest), surface(nearest), normal(out_of_part) {}
    double depth;        ///< how far the tool went past the surface along its normal
    geom::Vec3 at;       ///< the deepest place of the tool
    geom::Vec3 surface;  ///< the part's surface nearest to it
    geom::Vec3 normal;   ///< out of the part there
    double width = 0;    ///< of the tool in the surface there, across the way where it moves along the surface, within
                         ///< the part's box
    bool edge = false;   ///< an edge of the part is taken off; `depth` is that of the edge in the tool
};

/// The material there was before anything was cut: what lies beside it cannot be cut.
struct Before {
    std::function<double(geom::Vec3)> depth = {};        ///< of a place in it, negative beside it; empty: everywhere
    std::shared_ptr<const mesh::Distance> surface = {};  ///< closed
    double off = 0;                                      ///< how far that may lie within the material
    bool convex = false;                                 ///< known to be
};

class Judge {
public:
    /// The part must be closed and outlives the judge.
    Judge(const mesh::Distance& part, double allowed, Before before = {});

    /// Where the part is known to be another one than its mesh. Both from several threads at once.
    using Triangle = std::array<geom::Vec3, 3>;
    struct Known {
        std::function<double(geom::Vec3, double)> judged;  ///< what counts of a deviation (negative within the part)
        std::function<double(const Triangle&)> more;       ///< how much deeper a tool may go, all over a triangle
    };
    void judge_by(Known known) { known_ = std::move(known); }

    enum class Of : std::uint8_t { part, part_in_stock };
    /// Whether certainly nothing is deeper than allowed in the part, or in what of it there was before; in a
    /// microsecond or so. Of moves that are not finite: false.
    [[nodiscard]] bool is_clear(const Move& move, Of of = Of::part) const { return is_clear(move, allowed_, of); }
    /// The same of another depth.
    [[nodiscard]] bool is_clear(const Move& move, double depth, Of of) const;
    /// The same of moves that go through something thinner than allowed, which is met however small the body is made:
    /// nothing is deeper than half of what is allowed. `normal`: about that of the thin thing. Takes milliseconds;
    /// false where it would take too long.
    [[nodiscard]] bool is_thin(const Move& move, geom::Vec3 normal) const;
    /// The same of moves that take a corner or an edge off: no place of the tool is deeper than allowed in the part,
    /// and none of the part's surface by more than a twentieth deeper than that in the tool. `normal`: any of unit
    /// length.
    [[nodiscard]] bool is_no_deeper(const Move& move, geom::Vec3 normal) const;
    /// Of moves that are not clear; nothing where no place in the part was found. `from`: a place that is known to be
    /// deep, or near one. From several threads at once, like `is_clear`.
    [[nodiscard]] std::optional<Depth> deepest(const Move& move, std::optional<geom::Vec3> from = {}) const;
    /// A place that is reached, found in a tenth of the time.
    [[nodiscard]] std::optional<Depth> rough(const Move& move) const;
    [[nodiscard]] double allowed() const { return allowed_; }

private:
    /// A chord of the way and one of the tool's bodies, which are not clear.
    using Piece = Swept;
    struct Spot {
        double depth = -std::numeric_limits<double>::infinity();
        geom::Vec3 at;
        mesh::Nearest place;
        const Piece* piece = nullptr;
    };
    struct Effort {
        std::size_t starts = 0, climbs = 0;
        int steps = 0, vain = 0;
        std::size_t pieces = 0, more = 0;
    };
    struct Met {
        bool clear = false;
        std::vector<std::uint32_t> triangles;
        Swept inner;
    };
    static const Effort whole_effort, rough_effort;

    struct Asked {
        double depth = 0;
        Of of = Of::part;
    };
    [[nodiscard]] bool clear_between(const Move& move, double u0, double u1, Asked asked,
                                     std::vector<Piece>* failing) const;
    [[nodiscard]] bool clear_piece(const Swept& whole, Asked asked) const;
    [[nodiscard]] bool is_excused(const Swept& inner, std::uint32_t triangle) const;
    [[nodiscard]] bool meets(const Swept& inner) const;
    [[nodiscard]] std::vector<std::uint32_t> met_by(const Swept& inner) const;
    [[nodiscard]] Met fewest_met(const Swept& whole, double depth) const;
    [[nodiscard]] Spot spot_at(geom::Vec3 p) const;
    [[nodiscard]] geom::Vec3 inwards_at(const Spot& spot) const;
    [[nodiscard]] Spot climb(const Swept& whole, Spot from, int steps) const;
    [[nodiscard]] std::vector<std::vector<std::uint32_t>> patches_of(const std::vector<std::uint32_t>& met) const;
    [[nodiscard]] std::vector<Spot> starts_in(const Swept& whole, const Met& met, double depth,
                                              const Effort& effort) const;
    [[nodiscard]] Spot polished(const Swept& whole, Spot best) const;
    [[nodiscard]] Spot around(const Swept& whole, const std::vector<Spot>& starts, Spot best) const;
    [[nodiscard]] double more_than(double depth) const;
    [[nodiscard]] Spot risen(const Piece& whole, Spot best, const Effort& effort) const;
    [[nodiscard]] Spot deepest_of(const std::vector<Piece>& pieces, Spot best, const Effort& effort) const;
    [[nodiscard]] bool is_shallow(const Piece& whole, geom::Vec3 normal, double depth, std::size_t& cells) const;
    [[nodiscard]] bool holds_surface(const Piece& whole, const std::vector<Joined>& joined, double depth) const;
    using Core = std::function<Shape(double)>;  ///< what lies so deep in a body, or in those it stands on
    [[nodiscard]] double edge_depth(const Swept& whole, const Core& core, double depth, double most) const;
    [[nodiscard]] double reach_along(const Swept& whole, geom::Vec3 from, geom::Vec3 direction, double most) const;
    [[nodiscard]] double through(const Spot& spot) const;
    [[nodiscard]] double through_any(const std::vector<Piece>& pieces, const Spot& best) const;
    [[nodiscard]] Spot climbed_from(const std::vector<Piece>& pieces, geom::Vec3 from) const;
    [[nodiscard]] static Depth at_spot(const Spot& spot);
    void measure_edge(const Shape& shape, const std::vector<Piece>& pieces, const Spot& best, Depth& out) const;

    const mesh::Distance& part_;
    mesh::Box box_, stock_box_;
    double allowed_ = 0.01;
    Before before_;
    Known known_;
};

}  // namespace obrys::sim::certify
