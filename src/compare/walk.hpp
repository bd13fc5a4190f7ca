#pragma once
/// Both streams followed move by move, cut to pieces that both have.

#include "compare/items.hpp"
#include "compare/piece.hpp"

namespace obrys::compare {

/// How far one of the streams has been followed.
class Follower {
public:
    explicit Follower(const Path& path) : path_(path) {}

    void end() { ended_ = true; }
    [[nodiscard]] bool ended() const { return ended_; }
    [[nodiscard]] bool has_piece() const { return next_ + (ended_ ? 0 : 1) < path_.moves.size(); }
    /// It has ended, and all of it has been followed.
    [[nodiscard]] bool is_over() const { return ended_ && next_ == path_.moves.size(); }
    /// What comes next, of move number `number`.
    [[nodiscard]] Piece piece() const;
    [[nodiscard]] const Move& move() const { return path_.moves[next_]; }
    [[nodiscard]] std::size_t number() const { return next_; }
    [[nodiscard]] std::size_t waiting() const { return path_.moves.size() - next_; }
    [[nodiscard]] bool is_begun() const { return rest_.has_value(); }
    [[nodiscard]] const Path& path() const { return path_; }
    /// A length matters once the tool goes to a height, not where it goes over at rapid before.
    [[nodiscard]] bool goes_to_height() const;

    void pass();                 ///< all that is left of the move
    void pass_to(Piece behind);  ///< that is left

private:
    const Path& path_;
    bool ended_ = false;
    std::size_t next_ = 0;
    std::optional<Piece> rest_;
    geom::Vec3 from_{NAN, NAN, NAN}, tool_{NAN, NAN, NAN};
    std::optional<double> line_z_;  ///< of the move before, a line
    std::shared_ptr<const Holding> ground_;
};

struct Walk {
    Walk(const Path& a, const Path& b, const Tolerance& t);

    void advance();
    [[nodiscard]] Result finish();
    void compare_items(bool ended);

    Likeness like;
    std::array<Follower, 2> sides;
    std::array<ItemPairs, 5> items;

private:
    [[nodiscard]] bool pass_alike();
    [[nodiscard]] bool is_lost_in_increments(const Follower& s) const;
    [[nodiscard]] bool compare_piece();
    void compare_turns(const Move& a, const Move& b);
    void compare_holding(const Move& a, const Move& b);
    void compare_calls(Found& to) const;
    void compare_ends(Found& to) const;
    void add_motion(Found& to, const Move* a, const Move* b, std::size_t at, std::string what) const;
    void differs(const Move& a, const Move& b, std::size_t at);
    void pass_lone(std::size_t side);
    void pass_joined();
    [[nodiscard]] std::size_t number() const { return sides[0].number(); }
    /// Behind a move that differs nothing is known to stand side by side until the end.
    [[nodiscard]] Found& found() { return differs_at_ ? behind_ : firm_; }

    /// The moves that began beside each other and do not end so.
    struct Joined {
        Move a, b;
        std::size_t number = 0;
    };

    std::size_t pieces_ = 0;
    std::optional<Joined> joined_;           ///< the last of them
    std::optional<std::size_t> differs_at_;  ///< first move that does
    std::optional<std::size_t> lone_at_;     ///< first move that has none beside it
    Found firm_, behind_, lone_;
    std::array<Found, 5> between_;  ///< moves: of each of `items`
    std::shared_ptr<const Holding> last_a_, last_b_;
};

}  // namespace obrys::compare
