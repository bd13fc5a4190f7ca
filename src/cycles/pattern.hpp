#pragma once
/// Point patterns: where a cycle is to be called, in the order of the control. Working plane, mm; angles in degrees as
/// parameters, counter-clockwise from the u axis.
/// Source: HEIDENHAIN iTNC 530 cycle programming, point patterns (220, 221) and PATTERN DEF.

#include <cstdint>
#include <vector>

#include "cycles/cycle.hpp"
#include "geom/vec.hpp"

namespace obrys::cycles {

struct Positions {
    std::vector<geom::Vec2> at;
    std::vector<Complaint> complaints;
    bool at_second_clearance =
        true;                   ///< between positions the tool moves at the 2nd set-up clearance, else at the first
    bool along_circle = false;  ///< it moves on the pitch circle instead of straight
    geom::Vec2 centre;          ///< of that circle

    [[nodiscard]] bool ok() const;
};

/// For kinds pattern_circle and pattern_lines.
[[nodiscard]] Positions pattern_positions(const Demand& demand);

/// One figure of PATTERN DEF.
struct Figure {
    enum class Kind : std::uint8_t {
        position,  ///< POS
        row,       ///< ROW: from `start` on, every `spacing.x` along `rotation`
        grid,      ///< PAT: columns along u, rows along v
        frame,     ///< FRAME: the border of that grid
        circle,    ///< CIRC: full circle about `start`
        arc,       ///< PITCHCIRC: `angle_step` apart
    };
    Kind kind = Kind::position;
    geom::Vec2 start{};  ///< first position; centre of circle and arc
    geom::Vec2 spacing{};
    double diameter = 0;
    int columns = 1, rows = 1;              ///< `columns` is the number of row, circle and arc
    double rotation = 0;                    ///< of the whole about `start`, degrees
    double rotation_u = 0, rotation_v = 0;  ///< additionally of the grid's first and second axis
    double start_angle = 0, angle_step = 0;
};
[[nodiscard]] Positions figure_positions(const Figure& figure);

/// More positions than this are a complaint.
inline constexpr int most_positions = 100'000;

}  // namespace obrys::cycles
