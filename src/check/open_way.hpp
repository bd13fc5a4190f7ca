#pragma once
/// Straight moves one of whose ends is not known: what of them can be held against the stock all the same. A place
/// that is not known (start, home position) is taken to lie away from the stock, where machines start and have their
/// reference points; ADR 5.

#include <array>
#include <cmath>
#include <cstdint>

#include "geom/vec.hpp"

namespace obrys::check {

struct OpenWay {
    enum class Kind : std::uint8_t {
        swept,   ///< `from` to `to` is the whole way, as far as it can meet the stock
        end,     ///< only the end can be judged: `from` is a hair's breadth before it
        beside,  ///< what is known proves that it passes beside the stock
        clear,   ///< the same, if what is not known lies away from it
        lost,    ///< nothing can be said
    };
    Kind kind = Kind::lost;
    geom::Vec3 from, to;
};

/// `from` and `to` as far as they are known. `away`: from where on, towards plus, the tool is clear of the stock, by
/// coordinate; NaN: nowhere in that direction.
[[nodiscard]] OpenWay open_way(geom::Vec3 from, geom::Vec3 to, geom::Vec3 away);

/// What becomes of such a move.
struct OpenMove {
    OpenWay way;
    bool start = false;     ///< it is counted among the first moves, of which nothing is known yet
    bool assumed = false;   ///< a place that is not known is taken to lie away from the stock
    bool left_out = false;  ///< it is not simulated, or only its end
};

/// Follows a program's moves as far as it is known where they begin and end.
class Whereabouts {
public:
    /// A move that leads to `to`, with both ends known.
    void known(geom::Vec3 to);
    /// A straight move one of whose ends is not known.
    [[nodiscard]] OpenMove open(geom::Vec3 from, geom::Vec3 to, bool rapid, geom::Vec3 away);
    [[nodiscard]] bool began() const { return began_; }

private:
    bool began_ = false;  ///< a position was known
    bool lost_ = false;   ///< the tool went where nobody knows, out of the stock's reach or not
};

}  // namespace obrys::check
