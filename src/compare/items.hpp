#pragma once
/// What stands between the moves, held against its counterpart: the first with the first, and so on.

#include <deque>

#include "compare/found.hpp"
#include "compare/likeness.hpp"

namespace obrys::compare {

/// Items of one aspect, of both streams. A place is a number of pieces of the way that both have in common.
class ItemPairs {
public:
    ItemPairs(Aspect aspect, const Kept<Item>& a, const Kept<Item>& b) : aspect_(aspect), sides_{{{&a}, {&b}}} {}

    /// Those of a side that stand before its move `moves` stand at `piece`, and are all there is up to `settled`.
    void place(std::size_t side, std::size_t moves, std::size_t settled, std::size_t piece);
    struct Reached {
        std::size_t piece = 0;          ///< how far both have come
        std::array<bool, 2> here{};     ///< all that a side has up to there has been placed
        bool ended = false;             ///< there are no more of either
        std::array<bool, 2> at_rest{};  ///< nothing turns or flows where a side has come to
    };
    /// Compares those that both have.
    void compare(const Likeness& like, const Reached& reached, Found& found);
    /// Of those before this nobody asks any more.
    [[nodiscard]] std::size_t done(std::size_t side) const { return sides_[side].next; }
    [[nodiscard]] std::size_t waiting(std::size_t side) const { return sides_[side].items->size() - done(side); }
    [[nodiscard]] bool any_waits() const { return waiting(0) + waiting(1) != 0; }

private:
    struct Side {
        const Kept<Item>* items;
        std::size_t next = 0;             ///< to be compared
        std::deque<std::size_t> at = {};  ///< where those from there on stand, as far as that is known
        [[nodiscard]] const Item& head() const { return (*items)[next]; }
    };
    void compare_pair(const Likeness& like, Found& found);
    void compare_state(const Likeness& like, Found& found) const;
    void add_lone(std::size_t side, Found& found);
    void add_unsaid_end(std::size_t side, Found& found) const;
    [[nodiscard]] bool is_quiet_end(std::size_t side) const;
    [[nodiscard]] bool is_lone(std::size_t side, const Reached& reached) const;
    void drop();

    Aspect aspect_;
    std::array<Side, 2> sides_;
    bool over_ = false;  ///< they differ: the rest is not looked at
};

}  // namespace obrys::compare
