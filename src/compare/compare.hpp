#pragma once
/// Two streams held against each other: the same way of the tool, with the same feed, speed and all else that holds,
/// and the same cycles, contours, frames, parts and preparations. Where the source texts stand does not count, nor at
/// how many points a line or an arc is cut.

#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "cl/record.hpp"
#include "compare/path.hpp"

namespace obrys::compare {

/// What is compared, each for itself; what a machine does first, then how the program says it.
enum class Aspect : std::uint8_t {
    motion,        ///< moves: places, centres, sweeps, rapid or feed, additional axes
    feed,          ///< of moves at feed
    spindle,       ///< while the tool moves
    coolant,       ///< the same
    tool,          ///< the same: number, edge, name, rise
    events,        ///< stops, dwells, functions, texts, tool changes, and where they stand between the moves
    datum,         ///< zeros while the tool moves
    frame,         ///< in which coordinates are programmed, while the tool moves
    tolerance,     ///< of the contour and how moves are joined, while the tool moves
    cycles,        ///< kinds, values and places
    compensation,  ///< sides, radii, programmed elements and corners, the control's own ways onto contours
    parts,         ///< calls, labels and repetitions, and where they stand between the moves
    preparation,   ///< the tool that will be wanted next, and where that is said
    count,
};
inline constexpr std::size_t aspect_count = static_cast<std::size_t>(Aspect::count);
[[nodiscard]] std::string_view name_of(Aspect a);
/// Motion to events: what the machine does. The others say how the program says it; where both are of one control, how
/// far it may leave the contour and how it joins moves is what it does, too (Difference::is_done).
[[nodiscard]] constexpr bool is_done(Aspect a) { return a <= Aspect::events; }
/// It holds while the tool moves, and is compared move by move.
[[nodiscard]] constexpr bool holds(Aspect a) {
    return (a >= Aspect::feed && a <= Aspect::tool) || (a >= Aspect::datum && a <= Aspect::tolerance);
}

/// The first place where two streams differ in an aspect.
struct Difference {
    Aspect aspect = Aspect::motion;
    bool is_done = true;                   ///< the machine does something else
    std::string what;                      ///< "feed 200 mm/min, in B 150 mm/min"
    std::size_t move = 0;                  ///< of A
    std::size_t move_b = 0;                ///< of B, where the motion differs
    std::optional<base::Span> in_a, in_b;  ///< none: the stream has ended
    cl::StackId stack_a = 0, stack_b = 0;
};

struct Result {
    std::vector<Difference> first;  ///< at most one of each aspect
    std::size_t moves_a = 0, moves_b = 0;
    /// Moves up to which feed and all else that holds has been compared, where the moves behind do not stand side by
    /// side.
    std::optional<std::size_t> looked_to;
    /// B, which was written from A, compensates the lengths of several tools, and A none: whether its zeros are for
    /// that nobody knows.
    std::optional<Difference> lengths;
    /// The control turns the rotary axes to a tilted plane by itself, and which of their positions it takes one says
    /// and the other does not: whether the machine does the same nobody knows.
    std::optional<Difference> turns;
    std::vector<std::string>
        assumed;  ///< what is taken for granted besides, where one says otherwise what the other does
    [[nodiscard]] const Difference* of(Aspect a) const;
    /// It does not differ, and all of it has been looked at.
    [[nodiscard]] bool is_equal(Aspect a) const;
};

struct Tolerance {
    double length = 1e-4;  ///< mm, between places
    double angle = 1e-3;   ///< degrees, of additional axes and of values in degrees
    double share = 1e-6;   ///< of speeds, feeds and factors
    double turn = 0;       ///< radians, by which tilted planes and the tool on them may be turned further
    double on_arcs = 0;    ///< mm, between places on arcs but their ends, where that is more than `length`
    /// mm: one of them counts in such increments; a move that is no longer may be missing, while all places lie within
    /// `length`.
    double increment = 0;
    double speed_step = 0;  ///< spindle speeds may lie so far apart, in their units
    double feed_step = 0;   ///< feeds may lie so far apart, in their units, and no more than a thousandth
    /// Both are of one control: zeros of other numbers are other zeros, also where nobody knows their places, and
    /// a length that one of them never compensates is missing there.
    bool same_control = false;
    /// B was written from A: a length that A compensates has to be compensated, and a zero that both call by a number
    /// of the same kind (G54 to G59, presets) has to be the same one, also where nobody knows its place.
    bool is_written_from_a = false;
    /// Until a program says otherwise both join moves as far as speed needs (G64): that is how their control begins.
    bool joins_freely = false;
    /// A control that moves one axis at a time: which of them were said together is no matter.
    bool is_axis_by_axis = false;
};

/// Compares two streams as they come. Only what has no counterpart yet is kept.
class Comparison {
public:
    explicit Comparison(const Tolerance& tolerance);
    /// Of two collected paths, which must outlive it.
    Comparison(const Path& a, const Path& b, const Tolerance& tolerance);
    ~Comparison();
    Comparison(const Comparison&) = delete;
    Comparison& operator=(const Comparison&) = delete;

    enum class Side : std::uint8_t { a, b };
    void take(Side side, const cl::Record& record);
    /// It has no more records.
    void end(Side side);
    /// The one whose records are wanted next.
    [[nodiscard]] Side waits_for() const;
    /// So much of it has no counterpart yet that the other one should go on.
    [[nodiscard]] bool is_ahead(Side side) const;
    /// Compares what both have and forgets it.
    void advance();
    /// Both have ended.
    [[nodiscard]] Result finish();

private:
    std::unique_ptr<struct Walk> walk_;
    std::array<std::optional<Path>, 2> own_;
};

[[nodiscard]] Result compare(const Path& a, const Path& b, const Tolerance& tolerance);

}  // namespace obrys::compare
