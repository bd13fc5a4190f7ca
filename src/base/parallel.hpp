#pragma once
/// Work shared out among threads. What is made must not depend on their number: each piece writes what belongs to it.
/// Built without OBRYS_TBB, all is done one after the other.

#include <algorithm>
#include <cstddef>
#include <vector>

#include "base/function_ref.hpp"

namespace obrys::base {

/// Numbers from `begin()` up to `end()`.
class Piece {
public:
    Piece(std::size_t first, std::size_t end) : first_(first), end_(end) {}
    [[nodiscard]] std::size_t begin() const { return first_; }
    [[nodiscard]] std::size_t end() const { return end_; }

private:
    std::size_t first_, end_;
};

/// Calls `work` for pieces of 0 … n - 1, in no order. Of n in all, about `grain` and more belong to a piece.
void in_pieces(std::size_t n, std::size_t grain, FunctionRef<void(const Piece&)> work);
/// The same for every number by itself, each a task of its own: few and large ones, the largest first.
void one_by_one(std::size_t n, FunctionRef<void(std::size_t)> work);
/// What `work` shares out is done by so many threads; 0: as many as there are processors.
void with_threads(int threads, FunctionRef<void()> work);

/// Calls `work(i)` for 0 … n - 1.
template <class Work>
void for_all(std::size_t n, Work&& work) {
    in_pieces(n, 1, [&](const Piece& some) {
        for (std::size_t i = some.begin(); i < some.end(); ++i) work(i);
    });
}

/// Pieces are sorted and then joined, two by two. `before` orders all elements, or equal ones are alike.
template <class T, class Before>
void sort_all(std::vector<T>& all, const Before& before) {
    constexpr std::size_t worth = 20'000, pieces = 8;
    if (all.size() < worth) return std::sort(all.begin(), all.end(), before);
    const auto at = [&](std::size_t k, std::size_t of) {
        return all.begin() + static_cast<std::ptrdiff_t>(all.size() * k / of);
    };
    one_by_one(pieces, [&](std::size_t k) { std::sort(at(k, pieces), at(k + 1, pieces), before); });
    for (std::size_t of = pieces; of > 1; of /= 2)
        one_by_one(of / 2, [&](std::size_t k) {
            std::inplace_merge(at(2 * k, of), at(2 * k + 1, of), at(2 * k + 2, of), before);
        });
}

}  // namespace obrys::base
