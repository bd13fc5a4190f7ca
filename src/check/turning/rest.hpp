#pragma once
/// Material left outside the contour that a program must reach.

#include <memory>
#include <vector>

#include "check/collect.hpp"
#include "check/result.hpp"
#include "check/setup.hpp"
#include "check/words.hpp"

namespace obrys::check {

[[nodiscard]] Box box_of(const geom::Region& region);
[[nodiscard]] Box box_of(const geom::Contour& contour);

/// Which moves cut last at each place of the section; of a fixed size, whatever the number of moves.
class LastCuts {
public:
    struct Entry {
        base::Span where;
        cl::StackId stack = 0;
        std::uint64_t index = 0;
        geom::Vec3 from, to;
        geom::Region removed;
        Box box;
    };

    LastCuts() = default;
    explicit LastCuts(const Box& stock) : stock_(stock), last_(cells * cells) {}
    void add(const Move& move, const geom::Region& removed);
    /// Of the moves that are still known the last one whose cut bounds much of what is deep of the piece above the
    /// wanted contour.
    [[nodiscard]] const Entry* beside(const geom::Region& piece, const geom::Region& wanted) const;

private:
    static constexpr std::size_t cells = 64;
    struct Range {
        std::size_t z0, z1, x0, x1;
    };
    [[nodiscard]] Range range(const Box& box, double margin) const;
    Box stock_;
    std::vector<std::shared_ptr<const Entry>> last_;  ///< a large cut fills many cells: they share its entry
};

/// What a program leaves.
struct Left {
    const geom::Region& stock;
    const geom::Region& ridges;  ///< of threads: they are no rest material
    bool in_front = false;       ///< its tools have stood in front of the right face
};

/// Adds one `rest-material` finding for every piece of what is left outside the wanted contour, placed at the last cut
/// beside it or, where none is known, at the last record of the program.
void find_rest(const Setup& setup, const Left& left, const LastCuts& cuts, const cl::Record& end, Collector& out);

}  // namespace obrys::check
