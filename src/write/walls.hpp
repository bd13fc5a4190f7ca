#pragma once
/// The contour that a tool follows under radius compensation, as walls that its other ways must not cut into. In the
/// plane of X and Y, mm.

#include <cstdint>
#include <optional>
#include <unordered_map>
#include <vector>

#include "geom/vec.hpp"

namespace obrys::write {

class Walls {
public:
    /// `radius` of the tool.
    explicit Walls(double radius) : radius_(radius) {}

    void add_line(geom::Vec2 from, geom::Vec2 to);
    /// From `from` on by `sweep` about the centre, counter-clockwise positive; a point where radius is 0.
    void add_arc(geom::Vec2 centre, double radius, double start, double sweep);
    /// Another wall would be too much to look through: walls may be missing.
    [[nodiscard]] bool is_full() const { return pieces_.size() >= most_pieces; }

    /// How much nearer than the tool's radius, and nearer than both its ends, a way from `a` by `corner` to `b` comes
    /// to the walls: so much does it cut that the ends do not.
    [[nodiscard]] double cut(geom::Vec2 a, geom::Vec2 corner, geom::Vec2 b) const;

private:
    struct Piece {
        geom::Vec2 from, to;
    };
    struct Cells {
        std::int64_t left, right, low, high;
    };
    static constexpr std::size_t most_pieces = 200'000;
    static constexpr std::int64_t most_cell = 0x7FFF'FFFF;  ///< a key holds two of them

    void add_piece(geom::Vec2 from, geom::Vec2 to);
    /// Of a way and what lies `around` it, `most` of them.
    [[nodiscard]] std::optional<Cells> cells_of(const geom::Vec2& from, const geom::Vec2& to, double around,
                                                double most) const;
    /// Distance of the nearest wall from a straight way, the tool's radius where none is nearer.
    [[nodiscard]] double clearance(geom::Vec2 from, geom::Vec2 to) const;

    double radius_;
    std::vector<Piece> pieces_;
    std::unordered_map<std::uint64_t, std::vector<std::uint32_t>> cells_;  ///< pieces that come near
    std::vector<std::uint32_t> wide_;  ///< pieces that lie in no cell: looked at for every way
};

}  // namespace obrys::write
