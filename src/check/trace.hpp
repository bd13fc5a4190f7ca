#pragma once
/// Keeps moves and snapshots of the stock for pictures, within a bound.

#include "check/result.hpp"

namespace obrys::check {

constexpr double drawn_chord = 0.01;  ///< mm the picture of a curve that is no arc in its plane may leave it
constexpr int drawn_chords = 256;     ///< more are not kept, however long the curve

class Trace {
public:
    /// At most `limit` moves are kept.
    explicit Trace(std::size_t limit) : limit_(limit) {}

    [[nodiscard]] bool keeps_more() const { return moves_.size() < limit_; }
    void add(MoveTrace move) { moves_.push_back(std::move(move)); }
    /// Whether the stock after the last added move is to be handed in.
    [[nodiscard]] bool wants_snapshot() const { return !moves_.empty() && moves_.size() % every_ == 0; }
    void add(geom::Region stock);
    void finish(Result& result);

private:
    static constexpr std::size_t most_snapshots = 64;
    std::size_t limit_, every_ = 16;
    std::vector<MoveTrace> moves_;
    std::vector<Snapshot> snapshots_;
};

}  // namespace obrys::check
