#include "sim/milling/exact/leaves.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

#include "base/float_chars.hpp"
#include "base/whole.hpp"

namespace obrys::sim::milling {

namespace {

constexpr std::int64_t most_places = (std::int64_t{1} << 21) - 1;

constexpr std::int32_t down_to(std::int32_t value, std::int32_t size) { return value & ~(size - 1); }

}  // namespace

std::uint64_t mixed_of(std::span<const geom::Vec3> points, std::uint64_t with) {
    std::uint64_t mixed = with;
    for (const geom::Vec3& p : points)
        for (const double v : {p.x, p.y, p.z})
            mixed = (mixed ^ base::bit_cast<std::uint64_t>(v)) * 0x9E3779B97F4A7C15U, mixed ^= mixed >> 29U;
    return mixed;
}

std::optional<Place> cell_at(const Lattice& lattice, geom::Vec3 p) {
    Place cell{};
    for (int a = 0; a < 3; ++a) {
        const auto n = static_cast<std::size_t>(a);
        const double at = std::floor((component(p, a) - component(lattice.origin, a)) / component(lattice.step, a));
        const auto whole = base::whole<std::int32_t>(at, 0);
        if (!whole || !(at + 1 < lattice.count[n])) return std::nullopt;
        cell[n] = *whole;
    }
    return cell;
}

Leaves::Leaves(const Lattice& lattice, int levels) : lattice_(lattice) {
    const std::int64_t cells = std::max({lattice.count[0], lattice.count[1], lattice.count[2]});
    while (levels_ < levels && cells << (levels_ + 1) <= most_places) ++levels_;
    unit_ = std::int32_t{1} << levels_;
    split_.resize(static_cast<std::size_t>(levels_) + 1);
}

geom::Vec3 Leaves::node(const Place& p) const {
    const double share = 1.0 / unit_;  // a power of two: exact
    return {lattice_.origin.x + p[0] * share * lattice_.step.x, lattice_.origin.y + p[1] * share * lattice_.step.y,
            lattice_.origin.z + p[2] * share * lattice_.step.z};
}

Place Leaves::cell_of(const Place& p) const { return {p[0] / unit_, p[1] / unit_, p[2] / unit_}; }

int Leaves::level_of(std::int32_t size) const {
    return levels_ - (std::bit_width(static_cast<std::uint32_t>(size)) - 1);
}

bool Leaves::is_split(const Place& at, std::int32_t size) const {
    return split_[static_cast<std::size_t>(level_of(size))].find(key_of(at)) != KeyMap::none;
}

Leaf Leaves::leaf_at(const Place& p) const {
    for (std::int32_t size = unit_;; size /= 2) {
        const Place at{down_to(p[0], size), down_to(p[1], size), down_to(p[2], size)};
        if (size == 1 || !is_split(at, size)) return {at, size};
    }
}

void Leaves::split(const Leaf& leaf, std::uint32_t round) {
    KeyMap& level = split_[static_cast<std::size_t>(level_of(leaf.size))];
    const std::size_t before = level.size();
    level.add(key_of(leaf.at), round);
    if (leaf.size == unit_ && level.size() > before) split_cells_.push_back(cell_of(leaf.at));
}

bool Leaves::is_of(const Leaf& leaf, std::uint32_t round) const {
    const std::int32_t size = 2 * leaf.size;
    if (size > unit_) return false;
    const Place at{down_to(leaf.at[0], size), down_to(leaf.at[1], size), down_to(leaf.at[2], size)};
    return split_[static_cast<std::size_t>(level_of(size))].find(key_of(at)) == round;
}

std::vector<Place> Leaves::cells_beside() const {
    std::vector<Place> beside;
    KeyMap known;
    for (const Place& c : split_cells_)
        for (int dz = -1; dz <= 1; ++dz)
            for (int dy = -1; dy <= 1; ++dy)
                for (int dx = -1; dx <= 1; ++dx) {
                    if (dx * dy * dz != 0) continue;  // shares a node alone
                    const Place p{c[0] + dx, c[1] + dy, c[2] + dz};
                    bool inside = true;
                    for (std::size_t a = 0; a < 3; ++a) inside = inside && p[a] >= 0 && p[a] + 1 < lattice_.count[a];
                    if (!inside || is_split({p[0] * unit_, p[1] * unit_, p[2] * unit_}, unit_)) continue;
                    const std::size_t before = known.size();
                    known.add(key_of(p), 1);
                    if (known.size() > before) beside.push_back(p);
                }
    std::sort(beside.begin(), beside.end(), [](const Place& a, const Place& b) { return key_of(a) < key_of(b); });
    return beside;
}

void Leaves::each_leaf(const Place& cell, base::FunctionRef<void(const Leaf&)> take) const {
    std::vector<Leaf> open{{{cell[0] * unit_, cell[1] * unit_, cell[2] * unit_}, unit_}};
    while (!open.empty()) {
        const Leaf leaf = open.back();
        open.pop_back();
        if (leaf.size == 1 || !is_split(leaf.at, leaf.size)) {
            take(leaf);
            continue;
        }
        const std::int32_t half = leaf.size / 2;
        for (int c = 8; c-- > 0;)
            open.push_back(
                {{leaf.at[0] + (c & 1) * half, leaf.at[1] + (c >> 1 & 1) * half, leaf.at[2] + (c >> 2) * half}, half});
    }
}

std::array<Leaf, 4> Leaves::around(const Place& at, int axis) const {
    const auto u = static_cast<std::size_t>(first_across(axis)), v = static_cast<std::size_t>(second_across(axis));
    std::array<Leaf, 4> leaves;
    for (std::size_t q = 0; q < 4; ++q) {
        Place p = at;
        p[u] -= quadrants[q][0];
        p[v] -= quadrants[q][1];
        leaves[q] = leaf_at(p);
    }
    return leaves;
}

bool Leaves::is_short(const Place& at, std::int32_t size, int axis) const {
    // A leaf as long as the stretch that reaches its first part reaches all of it: both are aligned. It is shorter
    // where a cell of that size is halved.
    if (size == 1) return true;
    const auto u = static_cast<std::size_t>(first_across(axis)), v = static_cast<std::size_t>(second_across(axis));
    return std::none_of(quadrants.begin(), quadrants.end(), [&](const std::array<int, 2>& q) {
        Place p = at;
        p[u] -= q[0];
        p[v] -= q[1];
        return is_split({down_to(p[0], size), down_to(p[1], size), down_to(p[2], size)}, size);
    });
}

void Leaves::pieces(const Place& at, std::int32_t size, int axis, std::vector<ShortEdge>& out) const {
    if (size == 1 || is_short(at, size, axis)) {
        out.push_back({at, size, axis});
        return;
    }
    Place middle = at;
    middle[static_cast<std::size_t>(axis)] += size / 2;
    pieces(at, size / 2, axis, out);
    pieces(middle, size / 2, axis, out);
}

}  // namespace obrys::sim::milling
