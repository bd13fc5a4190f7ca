#pragma once
/// The exact surface near cells of a lattice: where material is, how far a point lies from it, where it ends on a line.
/// From the sweeps themselves, not from rays. Frame of the stock, millimetres.

#include <algorithm>
#include <optional>
#include <span>
#include <vector>

#include "sim/milling/cut/job.hpp"
#include "sim/milling/cut/simulation.hpp"
#include "sim/milling/exact/convex_parts.hpp"
#include "sim/milling/exact/corners.hpp"
#include "sim/milling/exact/key_map.hpp"
#include "sim/milling/exact/leaves.hpp"

namespace obrys::sim::milling {

/// Material begins (`rising`) or ends on a line.
struct LineEnd {
    double at = 0;
    std::uint32_t cut = 0;  ///< as of Interval
    bool rising = false;
};

/// Of the tolerance: how far a triangle may lie in the air beside the material, which is proved to 1.02 times that;
/// chords of what was swept take a twentieth.
inline constexpr double beside_share = 0.93;
inline constexpr double beside_left = 0.98;            ///< the same, of what could not be halved
inline constexpr std::size_t most_beside_parts = 150;  ///< of one triangle

class Exact {
public:
    Exact(const Simulation& simulation, const Lattice& lattice);

    [[nodiscard]] const Lattice& lattice() const { return lattice_; }
    /// What lies near a cell of the lattice: no farther from it than about a step.
    struct Near {
        std::vector<Air::Sweep> sweeps;
        std::vector<Job> jobs;  ///< the same, and those that these cover: who cut first is told by all
        bool stock = false;     ///< the stock's own face is near
        bool blank = true;      ///< else: within the stock
    };
    /// Finds the sweeps near these cells; `near` is asked of such cells alone, from several threads at once.
    void prepare(const std::vector<Place>& cells);
    /// `lines`: they are made ready for `ends`.
    [[nodiscard]] Near near(const Place& cell, bool lines) const;

    /// What lies no farther than so from a point in the block of a cell that was made ready; no more than `margin`
    /// steps beyond that block.
    [[nodiscard]] Near near(const Place& cell, geom::Vec3 centre, double reach, bool lines) const;
    /// Cells, along each axis, in whose boxes sweeps are kept.
    static constexpr std::int32_t block = 8;
    static constexpr std::int32_t margin = 3;
    /// The same; none where that may be more than is known there.
    [[nodiscard]] std::optional<Near> about(const Place& cell, geom::Vec3 centre, double radius) const;
    /// All that lies at a point belongs to what is near a cell.
    [[nodiscard]] bool reaches(const Place& cell, geom::Vec3 p) const;
    [[nodiscard]] bool is_material(const Near& near, geom::Vec3 p) const;
    [[nodiscard]] double in_blank(geom::Vec3 p) const { return stock_.within(p); }
    /// No place between these lies deeper in the stock as it was.
    [[nodiscard]] double most_in_blank(std::span<const geom::Vec3> corners) const {
        return stock_.most_within(corners);
    }
    /// How far a point lies outside of a body of air, and the direction from that into the material, along which this
    /// grows.
    struct Side {
        double outside = 0;
        geom::Vec3 in;
    };
    /// Bodies of `near`: 0 is what lies beside the stock, the others are the sweeps.
    [[nodiscard]] static std::size_t bodies(const Near& near) { return near.sweeps.size() + 1; }
    [[nodiscard]] Side side(const Near& near, std::size_t body, geom::Vec3 p) const;
    /// The same of one of its tool's convex parts; not of body 0.
    [[nodiscard]] static double outside_of(const Near& near, std::size_t body, const Shape& part, geom::Vec3 p);
    /// Moves a point to where the faces of two or three bodies meet, the shortest way; false where that is not found.
    [[nodiscard]] bool meet(const Near& near, std::span<const std::size_t> of, geom::Vec3& p) const;
    /// The shortest way out of all bodies of air that a point lies in, by their tangent planes; the point itself where
    /// that is longer than `allowed`.
    [[nodiscard]] geom::Vec3 out_of_air(const Near& near, geom::Vec3 p, double allowed) const;
    /// Two bodies of air touch at a point that lies no farther from both than so, with no material between them: cuts
    /// side by side without a gap.
    [[nodiscard]] bool is_touch(const Near& near, geom::Vec3 p, double allowed) const;
    /// The surface lies no farther from a point than so; from one in the material no farther than `in_material`.
    [[nodiscard]] bool is_on_surface(const Near& near, geom::Vec3 p, double allowed, double in_material) const;
    [[nodiscard]] bool is_on_surface(const Near& near, geom::Vec3 p, double allowed) const {
        return is_on_surface(near, p, allowed, allowed);
    }
    /// Every place of a triangle that lies in air has material no farther from it than 1.02 times so. `near`: what lies
    /// no farther from its places. False where so many parts of the triangle do not show it. Beyond feather edges of
    /// less than a degree it may be farther, and of a stock that is a mesh corners and middles alone are asked.
    [[nodiscard]] bool is_beside_material(const Near& near, const Corners& triangle, double allowed,
                                          std::size_t parts) const;
    /// It lies farther from it; false where that is not known.
    [[nodiscard]] bool is_clear(const Near& near, geom::Vec3 p, double radius) const;
    /// Where material ends on a line along `axis` from a point up to `high`, ascending; a little beyond both ends.
    void ends(const Near& near, int axis, geom::Vec3 from, double high, std::vector<LineEnd>& out) const;
    /// All bodies of air; moves that were cut in pieces are one.
    [[nodiscard]] const std::vector<Simulation::Whole>& wholes() const { return wholes_; }
    /// Convex parts of a tool that has cut something.
    [[nodiscard]] const std::vector<const Shape*>& parts_of(const Shape* shape) const { return parts_.of(shape); }
    /// The one that a cut belongs to.
    [[nodiscard]] Air::Sweep body(std::uint32_t cut) const { return simulation_.body_of(wholes_[whole_of_[cut]]); }
    /// As of Simulation.
    [[nodiscard]] geom::Vec3 normal(std::uint32_t cut, geom::Vec3 p) const;

private:
    class BesideSearch;
    [[nodiscard]] geom::Vec3 middle_of(const Place& cell) const {
        return lattice_.node(cell[0], cell[1], cell[2]) + 0.5 * lattice_.step;
    }
    /// How far from the middle of a cell `near` looks.
    [[nodiscard]] double reach() const {
        return 0.5 * length(lattice_.step) + std::max({lattice_.step.x, lattice_.step.y, lattice_.step.z});
    }
    static constexpr std::size_t most_around = 24;  ///< faces asked together how far material is from a point in air
    static void add_side(const Side& side, std::array<Side, most_around>& around, std::size_t& count);
    [[nodiscard]] static bool is_left(std::span<const Side> around, double allowed) {
        return way_out(around, allowed).has_value();
    }
    [[nodiscard]] static std::optional<geom::Vec3> way_out(std::span<const Side> around, double allowed);
    [[nodiscard]] static Place block_of(const Place& cell) {
        return {cell[0] / block, cell[1] / block, cell[2] / block};
    }
    void gaps(const Job& job, int axis, geom::Vec3 from, double low, double high, std::vector<Interval>& out) const;
    void stock_ends(const Near& near, int axis, geom::Vec3 from, double low, double high,
                    std::vector<Interval>& out) const;

    const Simulation& simulation_;
    const StockBody& stock_;
    Lattice lattice_;
    KeyMap blocks_;                                   ///< number in `sweeps_`
    std::vector<std::vector<std::uint32_t>> sweeps_;  ///< numbers in `wholes_`, by block
    std::vector<Simulation::Whole> wholes_;
    std::vector<std::uint32_t> whole_of_;  ///< by cut
    /// Around a whole, no smaller than it is.
    struct Around {
        std::array<float, 3> low{}, high{};
    };
    std::vector<Around> around_;         ///< by whole
    std::vector<std::uint8_t> covered_;  ///< by whole: another one has taken all of it, too (covered.hpp)
    ConvexParts parts_;
};

}  // namespace obrys::sim::milling
