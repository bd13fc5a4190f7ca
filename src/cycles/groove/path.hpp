#pragma once
/// The path of a blade through a groove, and what it does on it.

#include <vector>

#include "cycles/groove/contour.hpp"
#include "cycles/groove/skyline.hpp"

namespace obrys::cycles::groove {

/// One move of the blade's left corner, in (u, v).
struct Move {
    enum class Kind : std::uint8_t { rapid, feed, arc, dwell };
    Kind kind = Kind::rapid;
    Vec2 to, centre{};
    double sweep = 0;  ///< radians, counter-clockwise positive
    double feed = 1;   ///< times the feed of the groove
    double seconds = 0;
    bool right = false;  ///< the right corner of the insert makes the contour
};

/// What the strategies did, as the stock saw it.
struct Doings {
    std::size_t plunges = 0;   ///< cuts straight down, those onto a flank with them
    double feed = 0, air = 0;  ///< length at feed; of it down to the stock and of moves that meet none
    double rapid = 0;
    double area = 0;      ///< removed, mm2
    double slot = 0;      ///< highest lower wall beside the blade at the end of a plunge
    double confined = 0;  ///< length of plunges in slots deeper than the insert is wide
    double open = std::numeric_limits<double>::quiet_NaN();  ///< least open area by blade and depth; NaN: never deep
    double longest = 0;                                      ///< plunge without a break
    double widest_plunge = 0;                                ///< of the material
    double thickest_side = 0;                                ///< cut of a move sideways, along v
    double first_traverse = 0;                               ///< of side stepping: area of the first way across
    std::size_t columns = 0, full_columns = 0, ribs = 0, layers = 0, passes = 0, traverses = 0;
    double rib_width = 0, layer = 0;
};

/// The blade at work: writes moves, knows the stock exactly.
class Blade {
public:
    Blade(const Request& request, const Contour& contour, Skyline stock);

    /// To above u, clear of all stock between, and down to the clearance above the stock there.
    void link(double u);
    /// A cut straight down from where a link leads to; false and nothing done where there is no stock.
    bool plunge(double u, double v, bool even_without_stock = false);
    /// The same in pecks; 0: in one cut.
    void peck(double u, double v, double depth);
    void straight(Vec2 to);
    void along(const Piece& piece, double shift, bool right);
    /// Down the contour of a side, from the height where the blade is.
    void follow(Side side, double v);
    /// From the flank's contact at `above`, where the blade is, to that at v: along a leaning flank, else a plunge.
    void descend(Side side, double above, double v);
    void lift(double height);
    void dwell();
    void out();  ///< above all stock
    void set_feed(double factor) { factor_ = factor; }
    void set_right(bool right) { right_ = right; }

    /// The flank's wedge from the level that is cut up to the level that is clean, in steps from the bottom outward.
    void wedge(Side side, double level, double clean);

    /// Left edge of the blade that touches this side at height v.
    [[nodiscard]] double flush(Side side, double v) const;
    [[nodiscard]] const Skyline& stock() const { return stock_; }
    [[nodiscard]] double highest(double u) const { return stock_.highest(u, u + width_); }
    [[nodiscard]] bool has_stock(double u, double v) const;
    [[nodiscard]] Vec2 at() const { return at_; }
    [[nodiscard]] double width() const { return width_; }
    [[nodiscard]] double corner_radius() const { return request_.insert.corner_radius; }
    [[nodiscard]] const Contour& contour() const { return contour_; }
    [[nodiscard]] const Manner& manner() const { return request_.manner; }
    [[nodiscard]] Doings& doings() { return doings_; }
    [[nodiscard]] const std::vector<Move>& moves() const { return moves_; }

private:
    [[nodiscard]] std::vector<Piece> between(Side side, double high, double low) const;
    [[nodiscard]] double shift_of(Side side) const { return side == Side::right ? -width_ : 0; }
    void rapid(Vec2 to);
    void feed(const BladeMove& move);
    [[nodiscard]] double lower_wall() const;
    void look_at_plunge(double top, double v);

    const Request& request_;
    const Contour& contour_;
    Skyline stock_, surface_;
    double width_;
    Vec2 at_{};
    bool placed_ = false, right_ = false;
    double factor_ = 1;
    std::vector<Move> moves_;
    Doings doings_;
};

}  // namespace obrys::cycles::groove
