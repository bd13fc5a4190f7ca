#pragma once
/// The caller's events that are due before an element, in order. Most elements have none or one; so few need no memory
/// of their own, and an element that is handed on takes them along as it takes its numbers.

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <memory>
#include <utility>
#include <vector>

namespace obrys::path {

class Events {
public:
    Events() = default;
    Events(std::initializer_list<int> events) { append(events.begin(), events.end()); }
    Events(const Events& other) { append(other.begin(), other.end()); }
    Events(Events&& other) noexcept
        : many_(std::move(other.many_)), few_(other.few_), count_(std::exchange(other.count_, 0)) {}
    Events& operator=(const Events& other) {
        if (this != &other) *this = Events(other);
        return *this;
    }
    Events& operator=(Events&& other) noexcept {
        many_ = std::move(other.many_);
        few_ = other.few_;
        count_ = std::exchange(other.count_, 0);
        return *this;
    }
    ~Events() = default;

    [[nodiscard]] bool empty() const { return begin() == end(); }
    [[nodiscard]] std::size_t size() const { return static_cast<std::size_t>(end() - begin()); }
    [[nodiscard]] const int* begin() const { return many_ ? many_->data() : few_.data(); }
    [[nodiscard]] const int* end() const { return many_ ? many_->data() + many_->size() : few_.data() + count_; }
    bool operator==(const Events& other) const { return std::equal(begin(), end(), other.begin(), other.end()); }

    void push_back(int event) { append(&event, &event + 1); }
    void clear() {
        many_.reset();
        count_ = 0;
    }
    /// Behind those that are there.
    void append(const Events& more) { append(more.begin(), more.end()); }
    /// Before those that are there; `sooner` is left empty.
    void put_before(Events& sooner) {
        if (sooner.empty()) return;
        sooner.append(*this);
        *this = std::move(sooner);
    }

private:
    void append(const int* first, const int* last) {
        const auto more = static_cast<std::size_t>(last - first);
        if (!many_ && count_ + more <= few_.size()) {
            std::copy(first, last, few_.begin() + count_);
            count_ += static_cast<std::uint32_t>(more);
            return;
        }
        if (!many_) many_ = std::make_unique<std::vector<int>>(few_.begin(), few_.begin() + count_);
        many_->insert(many_->end(), first, last);
        count_ = 0;
    }

    std::unique_ptr<std::vector<int>> many_;  ///< all of them, where `few_` cannot take them
    std::array<int, 3> few_{};
    std::uint32_t count_ = 0;  ///< in `few_`
};
}  // namespace obrys::path
