#pragma once
/// Numbers found by 64-bit keys: open addressing, keys are never all ones. Copies are cheap to make, order is not kept.

#include <cstddef>
#include <cstdint>
#include <vector>

namespace obrys::sim::milling {

class KeyMap {
public:
    static constexpr std::uint32_t none = 0xFFFFFFFF;

    [[nodiscard]] std::size_t size() const { return used_; }
    /// The number of a key, or `none`.
    [[nodiscard]] std::uint32_t find(std::uint64_t key) const {
        if (slots_.empty()) return none;
        for (std::size_t i = place(key);; i = (i + 1) & mask()) {
            if (slots_[i].key == key) return slots_[i].number;
            if (slots_[i].key == free) return none;
        }
    }
    void set(std::uint64_t key, std::uint32_t number) {
        if (add(key, number) == number) return;
        for (std::size_t i = place(key);; i = (i + 1) & mask())
            if (slots_[i].key == key) {
                slots_[i].number = number;
                return;
            }
    }
    /// The number of a key; `number` becomes it where there is none yet.
    std::uint32_t add(std::uint64_t key, std::uint32_t number) {
        if (2 * (used_ + 1) > slots_.size()) grow();
        for (std::size_t i = place(key);; i = (i + 1) & mask()) {
            if (slots_[i].key == key) return slots_[i].number;
            if (slots_[i].key != free) continue;
            slots_[i] = {key, number};
            ++used_;
            return number;
        }
    }

private:
    static constexpr std::uint64_t free = ~std::uint64_t{0};
    struct Slot {
        std::uint64_t key = free;
        std::uint32_t number = 0;
    };
    [[nodiscard]] std::size_t mask() const { return slots_.size() - 1; }
    [[nodiscard]] std::size_t place(std::uint64_t key) const {
        key ^= key >> 31U;
        key *= 0x9E3779B97F4A7C15U;  // 2^64 over the golden ratio: Knuth, The Art of Computer Programming, 6.4
        return static_cast<std::size_t>(key ^ key >> 29U) & mask();
    }
    void grow() {
        std::vector<Slot> old(slots_.empty() ? 64 : 2 * slots_.size());
        old.swap(slots_);
        used_ = 0;
        for (const Slot& s : old)
            if (s.key != free) add(s.key, s.number);
    }

    std::vector<Slot> slots_;
    std::size_t used_ = 0;
};

}  // namespace obrys::sim::milling
