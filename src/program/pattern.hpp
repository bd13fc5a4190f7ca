#pragma once
/// Places and shapes for cycles: points at which a cycle is called, and contours made of other contours.

#include <cstdint>
#include <vector>

#include "base/source.hpp"
#include "program/expr.hpp"

namespace obrys::program {

/// Figures of points. Source: HEIDENHAIN iTNC 530 cycle programming, "Pattern definition PATTERN DEF".
enum class FigureKind : std::uint8_t {
    position,
    row,
    grid,
    frame,  ///< the border of a grid
    circle,
    arc,  ///< part of a circle
};
/// Lengths in the program's unit, angles in degrees.
enum class FigureRole : std::uint8_t {
    x,
    y,  ///< first point; centre of circle and arc
    z,  ///< of the surface there
    spacing,
    spacing_x,
    spacing_y,
    diameter,
    count,
    columns,
    rows,
    rotation,
    rotation_x,
    rotation_y,
    start_angle,
    angle_step,
};
struct FigureSetting {
    FigureRole role = FigureRole::x;
    ExprId value = no_expr;
    bool incremental = false;  ///< of x and y: from the first point of the figure before
};
struct PatternFigure {
    FigureKind kind = FigureKind::position;
    std::vector<FigureSetting> settings;
    base::Span where;
};
/// The pattern at which cycles are called from here on: figures, or a table of points by its name.
struct Pattern {
    std::vector<PatternFigure> figures;
    ExprId table = no_expr;
    base::Span where;
};

/// Contours of contour cycles. Source: HEIDENHAIN iTNC 530 cycle programming, "SL cycles with contour formula" and "…
/// with simple contour formula".
enum class ContourOperator : std::uint8_t {
    contour,    ///< none: a contour by its number
    unite,      ///< |
    intersect,  ///< &
    subtract,   ///< without the second
    either,     ///< ^: in one of both, not in both
};
struct ContourNode {
    ContourOperator op = ContourOperator::contour;
    std::uint32_t number = 0;           ///< of `contour`
    std::uint32_t left = 0, right = 0;  ///< nodes before this one
};
/// A closed contour that a label or a program describes.
struct ContourPart {
    std::uint32_t number = 0;
    bool island = false;
    ExprId label = no_expr, program = no_expr;  ///< one of them
    ExprId depth = no_expr;                     ///< of its own
    base::Span where;
};
struct ContourStatement {
    enum class Kind : std::uint8_t {
        definition,   ///< `parts` are the contour: all pockets less all islands
        declaration,  ///< the one part is contour `number` from here on
        formula,      ///< contour `number` is what the last of `nodes` makes
        selection,    ///< the contour is what the program `program` declares
    };
    Kind kind = Kind::definition;
    std::uint32_t number = 0;
    std::vector<ContourPart> parts;
    std::vector<ContourNode> nodes;
    bool mixed = false;  ///< different operators stand side by side without parentheses
    ExprId program = no_expr;
    base::Span where;
};

}  // namespace obrys::program
