#pragma once
/// Turning cycles that follow a contour, as structs. Lengths in mm, those in X as radii; what counts beyond the
/// comments: turning.hpp.

#include "cycles/typed.hpp"

namespace obrys::cycles {

/// What LinuxCNC's contour cycles say. Not said, the target is where the tool stands.
struct TurnedContour {
    Said target_u;
    Said target_v;
    Said length_unit;  ///< mm per unit of the program, which matters to tolerances; not said: 1
};

/// lathe-finish-offset (G70)
struct OffsetFinishing : TurnedContour {
    static constexpr Kind kind = Kind::lathe_finish_offset;
    Said allowance_first;  ///< D: distance of the first pass; 0
    Said allowance_last;   ///< E: of the last one; 0
    Said passes;           ///< P; 1
};

/// What G71 and G72 say.
struct ParallelRoughing : TurnedContour {
    Said infeed;          ///< I; 1 unit
    Said escape;          ///< R; 0.5 units
    Said allowance_side;  ///< D; 0
    Said offset_u;        ///< W; 0
    Said offset_v;        ///< U; 0
    Said pockets;         ///< 0 all, 1 leaves them, 2 only them
};

/// lathe-rough-along (G71, G71.1, G71.2)
struct RoughingAlong : ParallelRoughing {
    static constexpr Kind kind = Kind::lathe_rough_along;
};

/// lathe-rough-across (G72, G72.1, G72.2)
struct RoughingAcross : ParallelRoughing {
    static constexpr Kind kind = Kind::lathe_rough_across;
};

/// lathe-finish (Fanuc G70): the contour says it all
struct ContourFinishing {
    static constexpr Kind kind = Kind::lathe_finish;
    Said length_unit;  ///< mm per unit of the program, which matters to tolerances; not said: 1
};

/// What Fanuc's G71 and G72 say.
struct StockRemoval {
    double infeed = unknown;  ///< depth of cut
    double escape = unknown;
    Said pockets;      ///< 1: type II, which has them
    Said allowance_u;  ///< W, signed; 0
    Said allowance_v;  ///< U/2, signed; 0
    Said relief_u;     ///< what the cuts leave for the last pass (Haas K); 0
    Said relief_v;     ///< the same (Haas I)
    Said length_unit;  ///< mm per unit of the program, which matters to tolerances; not said: 1
};

/// lathe-remove-along (G71)
struct RemovalAlong : StockRemoval {
    static constexpr Kind kind = Kind::lathe_remove_along;
};

/// lathe-remove-across (G72)
struct RemovalAcross : StockRemoval {
    static constexpr Kind kind = Kind::lathe_remove_across;
};

/// lathe-repeat-pattern (G73)
struct PatternRepeating {
    static constexpr Kind kind = Kind::lathe_repeat_pattern;
    Said allowance_u;           ///< W, signed; 0
    Said allowance_v;           ///< U/2, signed; 0
    double relief_u = unknown;  ///< W: shift of the first pass against the last
    double relief_v = unknown;  ///< U
    double passes = unknown;    ///< R
    Said length_unit;           ///< mm per unit of the program, which matters to tolerances; not said: 1
};

// --- The tables.

template <>
inline constexpr auto members_of<TurnedContour> = rows<TurnedContour>({
    {Role::target_u, &TurnedContour::target_u},
    {Role::target_v, &TurnedContour::target_v},
    {Role::length_unit, &TurnedContour::length_unit, Must::be_above_0},
});

template <>
inline constexpr auto members_of<OffsetFinishing> =
    joined<OffsetFinishing>(members_of<TurnedContour>, rows<OffsetFinishing>({
                                                           {Role::allowance_first, &OffsetFinishing::allowance_first},
                                                           {Role::allowance_last, &OffsetFinishing::allowance_last},
                                                           {Role::passes, &OffsetFinishing::passes},
                                                       }));

template <>
inline constexpr auto members_of<ParallelRoughing> =
    joined<ParallelRoughing>(members_of<TurnedContour>, rows<ParallelRoughing>({
                                                            {Role::infeed, &ParallelRoughing::infeed},
                                                            {Role::escape, &ParallelRoughing::escape},
                                                            {Role::allowance_side, &ParallelRoughing::allowance_side},
                                                            {Role::offset_u, &ParallelRoughing::offset_u},
                                                            {Role::offset_v, &ParallelRoughing::offset_v},
                                                            {Role::pockets, &ParallelRoughing::pockets},
                                                        }));

template <>
inline constexpr auto members_of<RoughingAlong> = joined<RoughingAlong>(members_of<ParallelRoughing>);

template <>
inline constexpr auto members_of<RoughingAcross> = joined<RoughingAcross>(members_of<ParallelRoughing>);

template <>
inline constexpr auto members_of<ContourFinishing> = rows<ContourFinishing>({
    {Role::length_unit, &ContourFinishing::length_unit, Must::be_above_0},
});

template <>
inline constexpr auto members_of<StockRemoval> = rows<StockRemoval>({
    {Role::infeed, &StockRemoval::infeed},
    {Role::escape, &StockRemoval::escape, Must::be_at_least_0},
    {Role::pockets, &StockRemoval::pockets},
    {Role::allowance_u, &StockRemoval::allowance_u},
    {Role::allowance_v, &StockRemoval::allowance_v},
    {Role::relief_u, &StockRemoval::relief_u},
    {Role::relief_v, &StockRemoval::relief_v},
    {Role::length_unit, &StockRemoval::length_unit, Must::be_above_0},
});

template <>
inline constexpr auto members_of<RemovalAlong> = joined<RemovalAlong>(members_of<StockRemoval>);

template <>
inline constexpr auto members_of<RemovalAcross> = joined<RemovalAcross>(members_of<StockRemoval>);

template <>
inline constexpr auto members_of<PatternRepeating> = rows<PatternRepeating>({
    {Role::allowance_u, &PatternRepeating::allowance_u},
    {Role::allowance_v, &PatternRepeating::allowance_v},
    {Role::relief_u, &PatternRepeating::relief_u},
    {Role::relief_v, &PatternRepeating::relief_v},
    {Role::passes, &PatternRepeating::passes},
    {Role::length_unit, &PatternRepeating::length_unit, Must::be_above_0},
});

}  // namespace obrys::cycles
