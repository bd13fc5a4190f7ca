#pragma once
/// A sequence that is read from its front and forgotten there; what is left keeps its numbers.

#include <cstddef>
#include <vector>

namespace obrys::compare {

template <class T>
class Kept {
public:
    void push_back(T item) { items_.push_back(std::move(item)); }
    /// Of all that there ever were.
    [[nodiscard]] std::size_t size() const { return gone_ + items_.size(); }
    [[nodiscard]] bool none_left() const { return items_.empty(); }
    [[nodiscard]] const T& operator[](std::size_t i) const { return items_[i - gone_]; }
    [[nodiscard]] T& back() { return items_.back(); }
    [[nodiscard]] const T& back() const { return items_.back(); }
    [[nodiscard]] auto begin() { return items_.begin(); }
    [[nodiscard]] auto end() { return items_.end(); }
    /// Those before `i`: now, or when there are enough of them for that to cost nothing to speak of.
    void forget(std::size_t i) {
        const std::size_t done = i - gone_;
        if (done < 64 || 2 * done < items_.size()) return;
        items_.erase(items_.begin(), items_.begin() + static_cast<std::ptrdiff_t>(done));
        gone_ = i;
    }

private:
    std::vector<T> items_;
    std::size_t gone_ = 0;
};

}  // namespace obrys::compare
