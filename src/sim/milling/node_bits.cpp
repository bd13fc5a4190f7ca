#include "sim/milling/node_bits.hpp"

#include <algorithm>
#include <cmath>

#include "base/parallel.hpp"
#include "base/whole.hpp"

namespace obrys::sim::milling {

namespace {

/// The first node at or above a coordinate, neither the first nor beyond the last of `count`.
std::size_t first_node(double value, double origin, double step, int count) {
    const double node = std::ceil((value - origin) / step);
    return base::clipped<std::size_t>(node, 1, static_cast<std::size_t>(count - 1));
}

/// Each bit replaced by that of the next node.
std::uint64_t next_of(std::uint64_t word, std::uint64_t following) { return word >> 1U | following << 63U; }

}  // namespace

NodeBits::NodeBits(const Lattice& lattice, Rays rays) : count_(lattice.count), words_(0), rows_(0) {
    if (std::min({count_[0], count_[1], count_[2]}) < 3) return;
    words_ = (static_cast<std::size_t>(count_[0]) + 63) / 64;
    rows_ = static_cast<std::size_t>(count_[1]) * static_cast<std::size_t>(count_[2]);
    bits_.assign(rows_ * words_, 0);
    base::in_pieces(static_cast<std::size_t>(count_[1] - 2), 4, [&](const base::Piece& some) {
        for (std::size_t j = some.begin(); j < some.end(); ++j) set_rows_of(static_cast<int>(j) + 1, lattice, rays);
    });
}

/// Marks where each ray along z enters and leaves material; a running exclusive or upwards then fills in between.
void NodeBits::set_rows_of(int j, const Lattice& lattice, Rays rays) {
    for (int i = 1; i < count_[0] - 1; ++i) {
        const std::uint64_t bit = std::uint64_t{1} << (static_cast<unsigned>(i) % 64);
        for (const Interval& m : rays(2, i, j)) {
            if (!(m.begin < m.end)) continue;
            for (const double end : {m.begin, m.end}) {
                const std::size_t k = first_node(end, lattice.origin.z, lattice.step.z, count_[2]);
                bits_[row(j, static_cast<int>(k)) * words_ + static_cast<std::size_t>(i) / 64] ^= bit;
            }
        }
    }
    for (int k = 1; k < count_[2]; ++k)
        for (std::size_t w = 0; w < words_; ++w) bits_[row(j, k) * words_ + w] ^= bits_[row(j, k - 1) * words_ + w];
    for (std::size_t w = 0; w < words_; ++w) bits_[row(j, count_[2] - 1) * words_ + w] = 0;
}

std::uint64_t NodeBits::crossed(int axis, std::size_t row, std::size_t w) const {
    const std::uint64_t here = at(row, w);
    const auto nodes_in_layer = static_cast<std::size_t>(count_[1]);
    if (axis == 0) return here ^ next_of(here, at(row, w + 1));
    if (axis == 1) return j(row) + 1 < count_[1] ? here ^ at(row + 1, w) : 0;
    return k(row) + 1 < count_[2] ? here ^ at(row + nodes_in_layer, w) : 0;
}

std::uint64_t NodeBits::mixed(std::size_t row, std::size_t w) const {
    if (j(row) + 1 >= count_[1] || k(row) + 1 >= count_[2]) return 0;
    const std::size_t above = row + static_cast<std::size_t>(count_[1]);
    const auto any = [&](std::size_t v) { return at(row, v) | at(row + 1, v) | at(above, v) | at(above + 1, v); };
    const auto all = [&](std::size_t v) { return at(row, v) & at(row + 1, v) & at(above, v) & at(above + 1, v); };
    const std::uint64_t some = any(w), every = all(w);
    return (some | next_of(some, any(w + 1))) & ~(every & next_of(every, all(w + 1)));
}

unsigned NodeBits::corners(int i, int j, int k) const {
    unsigned result = 0;
    for (int c = 0; c < 8; ++c)
        if (material(i + (c & 1), j + (c >> 1 & 1), k + (c >> 2))) result |= 1U << static_cast<unsigned>(c);
    return result;
}

}  // namespace obrys::sim::milling
