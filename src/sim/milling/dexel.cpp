#include "sim/milling/dexel.hpp"

#include <algorithm>
#include <cmath>

namespace obrys::sim::milling {

void Tile::reserve(Slot& slot, std::size_t count) {
    if (count <= slot.capacity) return;
    const std::size_t capacity = slot.capacity == 0 ? count : std::max<std::size_t>(count, 2U * slot.capacity);
    if (pool_.size() > 2 * live_ + 64) compact();
    const std::size_t first = pool_.size();
    pool_.resize(first + capacity);
    std::copy_n(pool_.begin() + slot.first, slot.count, pool_.begin() + static_cast<std::ptrdiff_t>(first));
    live_ += capacity - slot.capacity;
    slot.first = static_cast<std::uint32_t>(first);
    slot.capacity = static_cast<std::uint32_t>(capacity);
}

/// Gives back what slots have left behind when they moved.
void Tile::compact() {
    std::vector<Interval> packed;
    packed.reserve(live_ + live_ / 2);
    for (Slot& slot : slots_) {
        const auto from = pool_.begin() + slot.first;
        slot.first = static_cast<std::uint32_t>(packed.size());
        packed.insert(packed.end(), from, from + slot.count);
        packed.resize(slot.first + std::size_t{slot.capacity});
    }
    pool_ = std::move(packed);
}

void Tile::set(int local, std::span<const Interval> intervals) {
    const auto at = static_cast<std::size_t>(local);
    Slot& slot = slots_[at];
    reserve(slot, intervals.size());
    std::copy(intervals.begin(), intervals.end(), pool_.begin() + slot.first);
    slot.count = static_cast<std::uint32_t>(intervals.size());
    upper_[at] = intervals.empty() ? -std::numeric_limits<double>::infinity() : intervals.back().end;
    gap_low_[at] = upper_[at] - thinnest;
    gap_high_[at] = std::numeric_limits<double>::infinity();
}

/// [begin, end] lies inside interval `at`: it becomes two.
void Tile::split(int local, std::size_t at, double begin, double end, std::uint32_t cut) {
    Slot& slot = slots_[static_cast<std::size_t>(local)];
    reserve(slot, slot.count + 1U);
    Interval* v = pool_.data() + slot.first;
    std::copy_backward(v + at, v + slot.count, v + slot.count + 1);
    v[at].end = begin;
    v[at].end_cut = cut;
    v[at + 1].begin = end;
    v[at + 1].begin_cut = cut;
    ++slot.count;
}

void Tile::subtract(int local, int met, double begin, double end, std::uint32_t cut, Removed& removed) {
    const auto index = static_cast<std::size_t>(local);
    Slot& slot = slots_[index];
    Interval* v = pool_.data() + slot.first;
    const std::size_t count = slot.count;
    auto i = static_cast<std::size_t>(met);
    removed.lowest = std::max(begin, v[i].begin);
    const bool stays_below = v[i].begin < begin - thinnest;
    if (stays_below && v[i].end > end + thinnest) {
        removed.highest = end;
        removed.length = end - begin;
        split(local, i, begin, end, cut);
        gap_low_[index] = begin - thinnest;
        gap_high_[index] = end + thinnest;
        return;
    }
    if (stays_below) {
        removed.highest = v[i].end;
        removed.length = v[i].end - begin;
        v[i].end = begin;
        v[i].end_cut = cut;
        ++i;
    }
    std::size_t j = i;
    for (; j < count && v[j].end <= end + thinnest; ++j) {
        removed.highest = v[j].end;
        removed.length += v[j].end - v[j].begin;
    }
    if (j < count && v[j].begin < end - thinnest) {
        removed.highest = end;
        removed.length += end - v[j].begin;
        v[j].begin = end;
        v[j].begin_cut = cut;
    }
    gap_low_[index] = i > 0 ? v[i - 1].end - thinnest : -std::numeric_limits<double>::infinity();
    gap_high_[index] = j < count ? v[j].begin + thinnest : std::numeric_limits<double>::infinity();
    if (j > i) {
        std::copy(v + j, v + count, v + i);
        slot.count = static_cast<std::uint32_t>(count - (j - i));
    }
    upper_[index] = slot.count == 0 ? -std::numeric_limits<double>::infinity() : v[slot.count - 1].end;
}

void Tile::measure(int local, double begin, double end, Removed& found) const {
    each_met(local, begin, end, [&](double from, double to) {
        found.length += to - from;
        found.lowest = std::min(found.lowest, from);
        found.highest = std::max(found.highest, to);
    });
}

Dexels::Dexels(const Lattice& lattice) : lattice_(lattice) {
    const auto empty = std::make_shared<Tile>();
    for (int axis = 0; axis < 3; ++axis) {
        Tiles& t = tiles_[static_cast<std::size_t>(axis)];
        t.across = (rays_a(axis) + Tile::edge - 1) / Tile::edge;
        t.down = (rays_b(axis) + Tile::edge - 1) / Tile::edge;
        t.all.assign(static_cast<std::size_t>(t.across) * static_cast<std::size_t>(t.down), empty);
    }
}

std::size_t Dexels::bytes() const {
    std::size_t sum = 0;
    for (const Tiles& t : tiles_)
        for (const auto& tile : t.all) sum += tile->bytes();
    return sum;
}

std::size_t Dexels::bytes_apart_from(const Dexels& other) const {
    std::size_t sum = 0;
    for (std::size_t axis = 0; axis < 3; ++axis)
        for (std::size_t n = 0; n < tiles_[axis].all.size(); ++n)
            if (tiles_[axis].all[n] != other.tiles_[axis].all[n]) sum += tiles_[axis].all[n]->bytes();
    return sum;
}

}  // namespace obrys::sim::milling
