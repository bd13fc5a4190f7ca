#pragma once
/// Values one behind the other, added at the end only, kept in pieces that copies share: a copy costs a pointer for
/// each `piece` of them, and what is added to it afterwards the last piece once more. Changed by one thread at a time,
/// while none makes or drops a copy.

#include <array>
#include <cstddef>
#include <memory>
#include <vector>

namespace obrys::base {

template <class T, std::size_t piece = 1024>
class SharedLog {
public:
    [[nodiscard]] std::size_t size() const { return size_; }
    [[nodiscard]] bool empty() const { return size_ == 0; }
    [[nodiscard]] const T& operator[](std::size_t i) const { return (*pieces_[i / piece])[i % piece]; }
    [[nodiscard]] const T& back() const { return (*this)[size_ - 1]; }
    /// To be changed: copies keep what they have.
    [[nodiscard]] T& edit(std::size_t i) {
        std::shared_ptr<Piece>& p = pieces_[i / piece];
        if (p.use_count() > 1) p = std::make_shared<Piece>(*p);
        return (*p)[i % piece];
    }
    void push_back(const T& value) {
        if (size_ == pieces_.size() * piece) pieces_.push_back(std::make_shared<Piece>());
        ++size_;
        edit(size_ - 1) = value;
    }
    /// Leaves the first `count` alone.
    void cut_to(std::size_t count) {
        if (count >= size_) return;
        size_ = count;
        pieces_.resize((count + piece - 1) / piece);
    }
    [[nodiscard]] std::size_t bytes() const { return pieces_.size() * sizeof(Piece); }

private:
    using Piece = std::array<T, piece>;
    std::vector<std::shared_ptr<Piece>> pieces_;
    std::size_t size_ = 0;
};

}  // namespace obrys::base
