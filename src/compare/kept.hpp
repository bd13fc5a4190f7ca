#pragma once
/// A sequence that is read from its front and forgotten there; what is left keeps its numbers. Stands in a ring, whose
/// room is used again.

#include <cstddef>
#include <utility>
#include <vector>

namespace obrys::compare {

template <class T>
class Kept {
public:
    /// One more at the end, to be filled: it may still hold what one that is forgotten held.
    [[nodiscard]] T& grow() {
        if (count_ == ring_.size()) widen();
        return place(count_++);
    }
    void push_back(T item) { grow() = std::move(item); }
    /// Of all that there ever were.
    [[nodiscard]] std::size_t size() const { return gone_ + count_; }
    [[nodiscard]] bool none_left() const { return count_ == 0; }
    [[nodiscard]] const T& operator[](std::size_t i) const { return place(i - gone_); }
    [[nodiscard]] T& operator[](std::size_t i) { return place(i - gone_); }
    [[nodiscard]] T& back() { return place(count_ - 1); }
    [[nodiscard]] const T& back() const { return place(count_ - 1); }
    /// Those before `i`.
    void forget(std::size_t i) {
        const std::size_t done = i - gone_;
        first_ = (first_ + done) & (ring_.size() - 1);
        count_ -= done;
        gone_ = i;
    }

private:
    [[nodiscard]] T& place(std::size_t n) { return ring_[(first_ + n) & (ring_.size() - 1)]; }
    [[nodiscard]] const T& place(std::size_t n) const { return ring_[(first_ + n) & (ring_.size() - 1)]; }
    /// A ring of twice the room, which stays a power of two.
    void widen() {
        constexpr std::size_t least = 16;
        std::vector<T> wider(ring_.empty() ? least : 2 * ring_.size());
        for (std::size_t i = 0; i < count_; ++i) wider[i] = std::move(place(i));
        ring_ = std::move(wider);
        first_ = 0;
    }

    std::vector<T> ring_;
    std::size_t first_ = 0, count_ = 0, gone_ = 0;
};

}  // namespace obrys::compare
