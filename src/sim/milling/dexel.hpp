#pragma once
/// Material as intervals on rays in three directions (dexels). Frame of the stock, millimetres.
///
/// Ray (axis, a, b): axis 0 runs along x at y index a and z index b; axis 1 along y at x index a and z index b; axis 2
/// along z at x index a and y index b. Coordinates on a ray are those of its axis in the stock's frame, not counted
/// from the lattice's origin.

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <memory>
#include <span>
#include <vector>

#include "sim/milling/lattice.hpp"

namespace obrys::sim::milling {

/// Material on a ray from `begin` to `end`. A cut is the number of the sweep that made this end, 0 = the stock's own
/// face
/// (`Simulation::normal_at`, `Simulation::pass_of`).
struct Interval {
    double begin = 0, end = 0;
    std::uint32_t begin_cut = 0, end_cut = 0;
    bool operator==(const Interval&) const = default;
};

inline constexpr double thinnest = 1e-9;  ///< mm; thinner material does not stay, thinner cuts are not made

/// What was taken from a ray.
struct Removed {
    double length = 0;
    double lowest = std::numeric_limits<double>::infinity();    ///< smallest coordinate of what was removed
    double highest = -std::numeric_limits<double>::infinity();  ///< largest
};

/// A square of rays of one direction, kept together: what one task works on, and what copies of a stock share.
class Tile {
public:
    static constexpr int edge = 16;
    static constexpr int rays = edge * edge;

    [[nodiscard]] std::span<const Interval> ray(int local) const {
        const Slot& s = slots_[static_cast<std::size_t>(local)];
        return {pool_.data() + s.first, s.count};
    }
    /// Largest coordinate of material on a ray; -infinity where there is none.
    [[nodiscard]] double upper(int local) const { return upper_[static_cast<std::size_t>(local)]; }
    [[nodiscard]] const double* uppers() const { return upper_.data(); }
    /// Where a ray is known to be empty, for a quick look; rays of one b lie one after the other, three more than there
    /// are rays can be read.
    [[nodiscard]] const double* gaps_low() const { return gap_low_.data(); }
    [[nodiscard]] const double* gaps_high() const { return gap_high_.data(); }
    /// Sets the material of a ray: intervals in ascending order that do not touch.
    void set(int local, std::span<const Interval> intervals);
    /// The first interval of a ray that [begin, end] reaches, from 0; -1: none. Cuts thinner than `thinnest` are none.
    [[nodiscard]] int first_met(int local, double begin, double end) const {
        const Slot& slot = slots_[static_cast<std::size_t>(local)];
        const Interval* v = pool_.data() + slot.first;
        const double low = begin + thinnest;
        std::uint32_t i = 0;
        while (i < slot.count && v[i].end <= low) ++i;
        return i < slot.count && v[i].begin < end - thinnest ? static_cast<int>(i) : -1;
    }
    /// Takes [begin, end] from a ray, `met` as `first_met` says. Material thinner than `thinnest` does not stay.
    void subtract(int local, int met, double begin, double end, std::uint32_t cut, Removed& removed);
    /// Length of material in [begin, end], where it lies.
    void measure(int local, double begin, double end, Removed& found) const;
    /// Pieces of material between two coordinates, upwards, as met(from, to).
    template <class Met>
    void each_met(int local, double begin, double end, const Met& met) const {
        for (const Interval& v : ray(local)) {
            if (v.begin >= end - thinnest) return;
            const double from = std::max(begin, v.begin), to = std::min(end, v.end);
            if (to - from > thinnest) met(from, to);
        }
    }
    [[nodiscard]] std::size_t bytes() const { return pool_.capacity() * sizeof(Interval) + sizeof(Tile); }

    Tile() {
        upper_.fill(-std::numeric_limits<double>::infinity());
        gap_low_.fill(-std::numeric_limits<double>::infinity());
        gap_high_.fill(std::numeric_limits<double>::infinity());
    }

private:
    struct Slot {
        std::uint32_t first = 0, count = 0, capacity = 0;
    };
    void reserve(Slot& slot, std::size_t count);
    void compact();
    void split(int local, std::size_t at, double begin, double end, std::uint32_t cut);

    std::array<double, rays> upper_{};
    std::array<double, rays> gap_low_{},
        gap_high_{};  ///< the empty stretch that was cut last, less what is too thin to cut
    std::array<Slot, rays> slots_{};
    std::vector<Interval> pool_;
    std::size_t live_ = 0;  ///< intervals of pool_ that a slot holds or has reserved
};

/// A copy costs a pointer for each tile; tiles part from those of copies when they are changed.
class Dexels {
public:
    explicit Dexels(const Lattice& lattice = {});
    [[nodiscard]] const Lattice& lattice() const { return lattice_; }
    /// Number of rays of a direction along its first and second index.
    [[nodiscard]] int rays_a(int axis) const { return lattice_.count[static_cast<std::size_t>(first_across(axis))]; }
    [[nodiscard]] int rays_b(int axis) const { return lattice_.count[static_cast<std::size_t>(second_across(axis))]; }
    /// Material on a ray, ascending; the indices must be those of a node.
    [[nodiscard]] std::span<const Interval> ray(int axis, int a, int b) const {
        return tile(axis, a / Tile::edge, b / Tile::edge).ray(local(a, b));
    }
    void set(int axis, int a, int b, std::span<const Interval> intervals) {
        tile(axis, a / Tile::edge, b / Tile::edge).set(local(a, b), intervals);
    }

    [[nodiscard]] int tiles_a(int axis) const { return tiles_[static_cast<std::size_t>(axis)].across; }
    [[nodiscard]] int tiles_b(int axis) const { return tiles_[static_cast<std::size_t>(axis)].down; }
    /// To be changed. By several threads at once only where each was asked for before, since the last copy.
    [[nodiscard]] Tile& tile(int axis, int ta, int tb) {
        Tiles& t = tiles_[static_cast<std::size_t>(axis)];
        std::shared_ptr<Tile>& own = t.all[t.number(ta, tb)];
        if (own.use_count() > 1) own = std::make_shared<Tile>(*own);
        return *own;
    }
    [[nodiscard]] const Tile& tile(int axis, int ta, int tb) const {
        const Tiles& t = tiles_[static_cast<std::size_t>(axis)];
        return *t.all[t.number(ta, tb)];
    }
    [[nodiscard]] static constexpr int local(int a, int b) { return (b % Tile::edge) * Tile::edge + a % Tile::edge; }
    [[nodiscard]] std::size_t bytes() const;
    /// Of the tiles that another, with the same lattice, does not share.
    [[nodiscard]] std::size_t bytes_apart_from(const Dexels& other) const;

private:
    struct Tiles {
        int across = 0, down = 0;
        std::vector<std::shared_ptr<Tile>> all;
        [[nodiscard]] std::size_t number(int ta, int tb) const {
            return static_cast<std::size_t>(tb) * static_cast<std::size_t>(across) + static_cast<std::size_t>(ta);
        }
    };
    Lattice lattice_;
    std::array<Tiles, 3> tiles_;
};

}  // namespace obrys::sim::milling
