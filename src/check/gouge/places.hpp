#pragma once
/// Gouging moves and what the rays saw of them, put together to places.

#include <cstddef>
#include <cstdint>
#include <map>
#include <vector>

#include "check/gouge/certify.hpp"

namespace obrys::check {

/// Moves that belong to one place.
class MoveGroups {
public:
    explicit MoveGroups(std::size_t n);
    std::size_t root(std::size_t i);
    void join(std::size_t a, std::size_t b);

private:
    std::vector<std::size_t> parent_;
};

class GougePlaces {
public:
    /// All outlive this.
    GougePlaces(const std::vector<Certificate::Found>& found, const std::vector<mesh::Place>& rays,
                const std::vector<MilledMove>& moves, double allowed);
    /// The moves found, place by place.
    [[nodiscard]] std::vector<std::vector<std::uint32_t>> groups();
    /// Whether a move that was found has a share in a place of the rays.
    [[nodiscard]] bool is_claimed(std::size_t rays) const { return first_[rays] < found_.size(); }
    /// The deepest first.
    [[nodiscard]] std::vector<Gouge> taken();

private:
    void join(const std::vector<MilledMove>& moves);
    void measure();
    [[nodiscard]] const std::vector<std::size_t>* by_tag(std::uint32_t tag) const;
    void add_rays(std::size_t place);
    void add_unseen(std::size_t i);

    const std::vector<Certificate::Found>& found_;
    const std::vector<mesh::Place>& rays_;
    double allowed_ = 0;
    MoveGroups groups_;
    std::vector<char> seen_;          ///< by the rays
    std::vector<std::size_t> first_;  ///< of each place of the rays: one of the moves found; else their number
    std::map<std::uint32_t, std::vector<std::size_t>> of_move_;
    std::map<std::size_t, std::size_t> worst_;  ///< by the root of a group
    std::map<std::size_t, Gouge> all_;          ///< the same
};

/// The deepest first.
void sort_gouges(std::vector<Gouge>& gouges);

}  // namespace obrys::check
