#pragma once
/// FK, free contour programming of HEIDENHAIN controls: contour elements that a drawing does not dimension for NC are
/// given by whatever is known of them, and end point, centre and direction follow from their neighbours.
/// Elements are pushed one after another; each comes out as soon as the data so far leave one solution for it.
/// Plane coordinates as in element.hpp, millimetres; all angles in radians, counter-clockwise from the first axis: the
/// caller converts degrees and inches. Source: HEIDENHAIN iTNC 530 User's Manual, conversational, chapter 6.6; TNC 407
/// (280 580) and TNC 370 manuals, FK chapters, where they say more. What no manual found says is marked "assumed".
/// RND and CHF between FK elements act on what comes out, as between any others (contour_path.hpp).

#include <array>
#include <cstdint>
#include <deque>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include "path/arc_input.hpp"
#include "path/element.hpp"

namespace obrys::path {

/// Largest distance by which a redundant datum may miss, mm. Direction data count with the length of their element.
/// Assumed: the manual gives no figure; this is the resolution of coordinates in a drawing.
inline constexpr double fk_tolerance = 1e-3;
/// Most elements that may wait for data, and most solutions kept beside each other (assumed).
inline constexpr std::size_t fk_most_pending = 16, fk_most_solutions = 64;
/// How many elements back relative data may refer (TNC 320 manual: 64 positioning blocks).
inline constexpr std::size_t fk_history = 64;
/// Largest length or coordinate taken, mm.
inline constexpr double fk_most_length = 1e6;

/// What relates a value: nothing, the element's own predecessor (IX, IPR, IAN, ICCX …) or an element pushed before
/// (RX, RY, RPR, RPA, RAN, RCCX … with its tag in `block`).
enum class FkBase : std::uint8_t { absolute, incremental, block };
struct FkValue {
    double value = 0;
    FkBase base = FkBase::absolute;
    std::uint64_t block = 0;  ///< tag
    bool operator==(const FkValue&) const = default;
};
/// An auxiliary point; both coordinates must be given.
struct FkPoint {
    std::optional<double> x, y;
    bool operator==(const FkPoint&) const = default;
};
enum class FkClosed : std::uint8_t { no, begins, ends };  ///< CLSD+, CLSD-

/// One FL, FLT (line) or FC, FCT (arc) block.
struct FkElement {
    std::uint64_t tag = 0;    ///< the caller's, unique among the last fk_history elements
    bool arc = false;         ///< FC, FCT
    bool tangential = false;  ///< FLT, FCT: leaves in the direction in which the element before ends
    /// X, Y, PR, PA: end point, absolute, from the element's start, or from the end point of another element. PR and PA
    /// are about `pole`; incremental ones add to the polar coordinates of the start (assumed) or of the other end
    /// point.
    std::optional<FkValue> x, y, pr, pa;
    /// AN: direction of a line or of an arc's entry tangent. Incremental: from the direction in which the element
    /// before ends; block: from the direction in which that element ends (for an arc there: assumed).
    std::optional<FkValue> an;
    std::optional<double> length;  ///< LEN: of a line, or of an arc's chord, mm
    std::optional<double> radius;  ///< R, positive
    std::optional<Sense> sense;    ///< DR
    /// CCX, CCY, CCPR, CCPA: centre, absolute, from the arc's start, or from the END point of another element.
    std::optional<FkValue> ccx, ccy, ccpr, ccpa;
    /// CCA: direction in which the arc's end point lies seen from its centre (TNC 407: angle from the leading axis to
    /// the arc's end point). Incremental: the angle swept, positive (assumed). Not relative to a block.
    std::optional<FkValue> cca;
    /// P1 to P3: points on the line or its prolongation, on the arc's circle. PD with D: a point beside either.
    std::array<FkPoint, 3> on;
    FkPoint beside;
    std::optional<double> distance;
    /// PAR: the line is parallel to element `parallel` (an arc: to its entry tangent), in either sense; DP apart.
    std::optional<std::uint64_t> parallel;
    std::optional<double> parallel_distance;
    FkClosed closed = FkClosed::no;
    std::optional<geom::Vec2> pole;  ///< FPOL in force
};
/// A conventionally programmed element (L, C, CR …) between FK elements: its start is where the one before ends.
[[nodiscard]] FkElement fk_conventional(const Element& e);

/// A datum of an element, for faults. `element`: its shape as such; `tangent`: the T of FLT, FCT.
enum class FkDatum : std::uint8_t {
    element,
    tangent,
    x,
    y,
    pr,
    pa,
    an,
    len,
    r,
    dr,
    ccx,
    ccy,
    ccpr,
    ccpa,
    cca,
    p1,
    p2,
    p3,
    pd,
    par,
    dp,
    clsd,
    fselect,
};
/// The control's word: "X", "PR", "CLSD" …; "" for element and tangent.
[[nodiscard]] std::string_view word(FkDatum d);

enum class FkReason : std::uint8_t {
    not_known,         ///< `datum` is not a finite number
    bad_value,         ///< `datum` is out of range, or not for this kind of element
    incomplete,        ///< `datum` lacks its companion: P1X without P1Y, PD without D, DP without PAR, PR without FPOL
    unknown_block,     ///< `datum` refers to an element not pushed before, or too long ago; CLSD- without CLSD+
    no_direction,      ///< tangential, and there is no direction to be tangential to
    contradictory,     ///< `datum` misses by `miss` mm what the other data say
    under_determined,  ///< any one of `missing` would say more about the element; also where the data suffice but the
                       ///< solver knows no way: it never guesses
    ambiguous,         ///< `solutions` contours agree with the data; they part at this element; FSELECT is missing
    no_such_solution,  ///< FSELECT names more than `solutions`
    too_many_pending,  ///< more than fk_most_pending elements wait for data
    too_many_solutions,  ///< more than fk_most_solutions, or more work than is allowed
};
struct FkFault {
    FkReason reason = FkReason::contradictory;
    std::uint64_t tag = 0;  ///< the element at fault
    FkDatum datum = FkDatum::element;
    double miss = 0;  ///< mm; of the nearest of several solutions
    std::size_t solutions = 0;
    std::vector<FkDatum> missing;
    bool operator==(const FkFault&) const = default;
};

/// What a call determined: elements in order, with their tags, and at most one fault. After a fault nothing more comes
/// out, and every further call repeats it: make a new contour where the position is known again.
struct FkResult {
    std::vector<Element> elements;
    std::optional<FkFault> fault;
};

struct FkState;

class FkContour {
public:
    /// Where the contour starts, and the direction in which the element before ends (any length), if there is one.
    explicit FkContour(geom::Vec2 start, std::optional<geom::Vec2> direction = {}, double w = 0);
    FkContour(const FkContour&);
    FkContour(FkContour&&) noexcept;
    FkContour& operator=(const FkContour&);
    FkContour& operator=(FkContour&&) noexcept;
    ~FkContour();

    [[nodiscard]] FkResult push(const FkElement& e);
    /// FSELECT n: keeps the n-th, from 1, of the solutions left by the elements pushed so far. Their order is the same
    /// for the same data, and the same when the contour is moved or turned. No document found tells the
    /// control's own order; order.cpp says what this one agrees with.
    [[nodiscard]] FkResult select(std::size_t n);
    /// End of the contour: what is left comes out, or the reason why not.
    [[nodiscard]] FkResult finish();

    /// Partial or complete solutions for the pending elements, at least 1.
    [[nodiscard]] std::size_t solutions() const;
    [[nodiscard]] std::size_t pending() const;
    /// The elements of one solution (0 …) that are determined in it, from the first pending one on.
    [[nodiscard]] std::vector<Element> solution(std::size_t index) const;

private:
    std::unique_ptr<FkState> state_;
};

}  // namespace obrys::path
