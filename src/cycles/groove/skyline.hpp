#pragma once
/// The stock of a groove while it is being cut, exact: one height over every u. A blade that is straight above its
/// edge leaves nothing hanging over, so that one height says everything.

#include <vector>

#include "geom/vec.hpp"

namespace obrys::cycles::groove {

/// A stretch of the stock's top: a line from `from` to `to`, or of a circle the upper (`half` 1) or lower half (-1).
struct Stretch {
    double begin = 0, end = 0;  ///< u
    double from = 0, to = 0;    ///< v of a line's ends
    geom::Vec2 centre{};
    double radius = 0;
    int half = 0;  ///< 0: a line
    [[nodiscard]] double at(double u) const;
    [[nodiscard]] double area_below(double a, double b) const;  ///< above v = 0
};

/// A move of the blade's left corner; `sweep` 0: straight. An arc is one that only rises or only falls.
struct BladeMove {
    geom::Vec2 from, to, centre{};
    double sweep = 0;
};

struct Removed {
    double area = 0;
    double depth = 0;  ///< largest, along v
};

class Skyline {
public:
    /// A flat surface that goes through `p`.
    Skyline(geom::Vec2 p, double slope, double begin, double end);
    /// A chain of stretches without gaps.
    explicit Skyline(std::vector<Stretch> stretches) : stretches_(std::move(stretches)) {}

    /// Highest and lowest stock over the open interval; below everything where there is none.
    [[nodiscard]] double highest(double begin, double end) const;
    [[nodiscard]] double at(double u) const;
    /// Area above the stock and below `top`, from `begin` to `end`, of what lies above `v`.
    [[nodiscard]] double open_area(double begin, double end, double v, const Skyline& top) const;
    Removed cut(const BladeMove& move, double blade);
    /// What `move` would remove.
    [[nodiscard]] Removed met(const BladeMove& move, double blade) const;
    [[nodiscard]] const std::vector<Stretch>& stretches() const { return stretches_; }

private:
    template <class Keep>
    Removed against(const std::vector<Stretch>& lower, Keep&& keep) const;
    std::vector<Stretch> stretches_;
};

/// The lowest places of the blade's edge during the move, over each u.
[[nodiscard]] std::vector<Stretch> lowest(const BladeMove& move, double blade);

}  // namespace obrys::cycles::groove
