#pragma once
/// A system of equations of first and second degree, solved by elimination: linear equations remove unknowns, an
/// equation in a single unknown parts the solution into branches, second-degree terms that several equations share
/// cancel each other, and two equations in the same two unknowns give a quartic. No step loses a real solution, none is
/// invented: every equation is checked in its original form when its unknowns have values. Inside of fk.hpp; not for
/// callers.

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "path/fk/algebra.hpp"
#include "path/fk/fk.hpp"

namespace obrys::path {

/// Unknowns come in groups of four numbers: 4g a coordinate or length, 4g+2 the second coordinate of the same point
/// (mm); 4g+1 and 4g+3 the components of a unit vector. Unused numbers stay unknown and appear nowhere.
[[nodiscard]] constexpr bool is_direction(int id) { return id % 2 == 1; }

enum class FkUnit : std::uint8_t { length, square, direction };  ///< of an equation's left side: mm, mm², 1

/// poly = 0, said by `datum` of element `tag`.
struct FkEquation {
    FkPoly poly;
    std::uint64_t tag = 0;
    FkDatum datum = FkDatum::element;
    FkUnit unit = FkUnit::length;
    double size = 0;  ///< largest contribution of a term so far: what is far smaller is noise
};
/// poly >= least; otherwise `datum` is wrong by the difference, mm.
struct FkLimit {
    FkPoly poly;
    double least = 0;
    std::uint64_t tag = 0;
    FkDatum datum = FkDatum::element;
};
/// Polar coordinates of a point, relative to those of other points: equations once these are known.
struct FkPolar {
    FkPoly x, y;
    geom::Vec2 pole;
    std::optional<double> radius, angle;
    std::array<FkPoly, 2> radius_from, angle_from;  ///< used where the flag says so
    bool radius_is_relative = false, angle_is_relative = false;
    std::uint64_t tag = 0;
    FkDatum radius_datum = FkDatum::pr, angle_datum = FkDatum::pa;
};
struct FkEquations {
    std::vector<FkEquation> equal;
    std::vector<FkLimit> least;
    std::vector<FkPolar> polar;
};

/// From an element's start to its end, for the weight of its directions.
struct FkChord {
    std::uint64_t tag = 0;
    FkPoly x, y;
};
/// How two branches are put in order: see order.cpp.
struct FkGuide {
    int end = -1, carrier = -1;  ///< numbers of the groups: end point with normal at the end; centre or offset
    bool arc = false;
    FkPoly from_x, from_y;                       ///< start point
    FkPoly normal_x, normal_y;                   ///< left normal at the end
    std::optional<geom::Vec2> on, beside, pole;  ///< first auxiliary point, PD, FPOL
};

/// One way the solution may go: what each unknown is in terms of the unknowns not yet found.
struct FkBranch {
    int base = 0;           ///< number of values[0]
    std::vector<int> path;  ///< which alternatives were taken
    std::vector<FkPoly> values;
    std::vector<FkEquation> open;    ///< still to use, in terms of the unknowns left
    std::vector<FkEquation> checks;  ///< as stated, until checked
    std::vector<FkEquation> stated;  ///< all of them, for polish()
    std::vector<FkLimit> limits;
    std::vector<FkPolar> polar;

    [[nodiscard]] FkPoly at(const FkPoly& p) const;  ///< p in terms of the unknowns left
    [[nodiscard]] std::optional<double> known(const FkPoly& p) const;
};

struct FkDeath {
    std::uint64_t tag = 0;
    FkDatum datum = FkDatum::element;
    double miss = 0;
};

/// Solves as far as the equations allow.
class FkSolver {
public:
    FkSolver(double scale, std::vector<FkChord> chords, std::vector<FkGuide> guides)
        : scale_(scale), chords_(std::move(chords)), guides_(std::move(guides)) {}

    /// Adds to the branch; solve() then works on it.
    void add(FkBranch& b, const FkEquations& equations) const;
    void solve(FkBranch b);
    /// The branches found, in the order that FSELECT counts.
    void put_in_order();

    std::vector<FkBranch> found;
    std::optional<FkDeath> nearest;  ///< of the branches that ended in a contradiction, the one that missed by least
    bool exhausted = false;          ///< limits of work or number reached: `found` is not all

private:
    enum class Progress : std::uint8_t { none, some, dead, parted };

    [[nodiscard]] double weight(int id) const { return is_direction(id) ? 1.0 : scale_; }
    [[nodiscard]] double contribution(const FkTerm& t) const;
    [[nodiscard]] double in_mm(const FkEquation& e, double value) const;
    [[nodiscard]] double reach(const FkBranch& b, std::uint64_t tag) const;
    void clean(FkEquation& e) const;
    void die(std::uint64_t tag, FkDatum datum, double miss);
    void put(FkBranch& b, int id, const FkPoly& by);
    Progress linear(FkBranch& b);
    Progress drop_constant(FkBranch& b);
    [[nodiscard]] bool whole(const FkBranch& b, const FkGuide& g) const;
    [[nodiscard]] bool settled(const FkBranch& b, const FkPoly& p) const;
    void shape(FkBranch& b) const;
    Progress check(FkBranch& b);
    Progress expand_polar(FkBranch& b) const;
    Progress one_unknown(FkBranch& b);
    [[nodiscard]] std::optional<std::vector<double>> roots(const FkEquation& e, int id) const;
    Progress cancel(FkBranch& b) const;
    Progress two_unknowns(FkBranch& b);
    void part(const FkBranch& b, std::size_t used, const std::vector<std::vector<std::pair<int, double>>>& ways);
    [[nodiscard]] std::vector<double> keys(const FkBranch& b) const;

    double scale_;
    std::vector<FkChord> chords_;
    std::vector<FkGuide> guides_;
    std::size_t work_ = 0;
};

/// Miss of an equation at known values, mm (or 1 for directions): value over the steepest point's gradient.
[[nodiscard]] double fk_miss(const FkEquation& e, const FkBranch& b);
/// Takes from the known values what rounding has left in them: Gauss-Newton steps on the stated equations, as long as
/// they are as small as that and the data agree far better than the tolerance asks.
void polish(FkBranch& b, double scale);
[[nodiscard]] FkEquations polar_equations(const FkPolar& p, double radius_base, double angle_base);

}  // namespace obrys::path
