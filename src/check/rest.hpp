#pragma once
/// Material left outside the contour that a program must reach.

#include <array>
#include <memory>

#include "check/check.hpp"
#include "check/collect.hpp"
#include "check/words.hpp"

namespace obrys::check {

[[nodiscard]] Box box_of(const geom::Region& region);
[[nodiscard]] Box box_of(const geom::Contour& contour);

/// Which move cut last at each place along z; of a fixed size, whatever the number of moves.
class LastCuts {
public:
    struct Entry {
        base::Span where;
        cl::StackId stack = 0;
        std::uint64_t index = 0;
        geom::Vec3 from, to;
        Box box;
    };

    LastCuts() = default;
    LastCuts(double min_z, double max_z) : min_z_(min_z), max_z_(max_z) {}
    void add(const Move& move, const Box& removed);
    /// The last move that removed material next to the box, if it is still known.
    [[nodiscard]] const Entry* beside(const Box& piece) const;

private:
    static constexpr std::size_t cells = 512;
    [[nodiscard]] std::size_t cell(double z) const;
    double min_z_ = 0, max_z_ = 1;
    std::array<std::shared_ptr<const Entry>, cells> last_;  ///< a long cut fills many cells: they share its entry
};

/// Adds one `rest-material` finding for every piece of `left` outside the wanted contour, placed at the last cut beside
/// it or, where none is known, at the last record of the program.
void find_rest(const Setup& setup, const geom::Region& left, const LastCuts& cuts, const cl::Record& end,
               Collector& out);

}  // namespace obrys::check
