#include "driver/large_text.hpp"

#ifndef _WIN32

#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <stdexcept>
#include <utility>
#include <vector>

#include "base/memory.hpp"

namespace obrys::driver {

namespace {

/// A number that differs, but for one chance in 2^64, where the bytes do. Four chains, so that they run side by side.
std::uint64_t sum_of(const char* bytes, std::size_t size) {
    constexpr std::uint64_t factor = 0x9E3779B97F4A7C15u;
    const auto step = [](std::uint64_t chain, std::uint64_t word) {
        chain = (chain ^ word) * factor;
        return chain ^ chain >> 29;
    };
    std::uint64_t a = size, b = 1, c = 2, d = 3;
    std::uint64_t words[4];
    std::size_t at = 0;
    for (; at + sizeof words <= size; at += sizeof words) {
        std::memcpy(words, bytes + at, sizeof words);
        a = step(a, words[0]), b = step(b, words[1]), c = step(c, words[2]), d = step(d, words[3]);
    }
    if (at < size) {
        std::memset(words, 0, sizeof words);
        std::memcpy(words, bytes + at, size - at);
        a = step(a, words[0]), b = step(b, words[1]), c = step(c, words[2]), d = step(d, words[3]);
    }
    std::uint64_t sum = 0;
    for (const std::uint64_t chain : {a, b, c, d}) sum = ((sum ^ chain) * factor) ^ (sum >> 32);
    return sum;
}

class LargeText final : public base::Store {
public:
    /// Takes the open file over.
    LargeText(int file, std::string shown, std::size_t capacity)
        : file_(file), shown_(std::move(shown)), capacity_((capacity / piece + 1) * piece) {
        const std::size_t room = capacity_ + piece;  // for pieces that are large pages
        void* memory = ::mmap(nullptr, room, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
        if (memory == MAP_FAILED) return;
        char* begin = static_cast<char*>(memory);
        const std::size_t in_front = (piece - reinterpret_cast<std::uintptr_t>(begin) % piece) % piece;
        memory_ = begin + in_front;
        if (in_front > 0) ::munmap(begin, in_front);
        if (in_front < piece) ::munmap(memory_ + capacity_, piece - in_front);
        base::prefer_large_pages(memory_, capacity_);
    }
    LargeText(const LargeText&) = delete;
    LargeText& operator=(const LargeText&) = delete;
    ~LargeText() override {
        if (memory_ != nullptr) ::munmap(memory_, capacity_);
        ::close(file_);
    }

    /// At most `capacity` bytes, so that a NUL is left behind them.
    bool read_all(std::size_t capacity) {
        if (memory_ == nullptr || !read(0, capacity, size_)) return false;
        sums_.resize((size_ + piece - 1) / piece);
        aside_.resize(sums_.size());
        return true;
    }

    [[nodiscard]] std::string_view bytes() const override { return {memory_, size_}; }

    void lay_aside(std::size_t begin, std::size_t end) override {
        const std::size_t last = end >= size_ ? aside_.size() : end / piece;
        for (std::size_t i = (begin + piece - 1) / piece; i < last; ++i) {
            if (aside_[i]) continue;
            if (sums_[i] == 0) sums_[i] = sum_of(memory_ + i * piece, length(i));
            map_anew(i, PROT_NONE);
            aside_[i] = true;
        }
    }

    bool fetch(std::size_t begin, std::size_t end) override {
        bool any = false;
        for (std::size_t i = begin / piece; i < aside_.size() && i * piece < end; ++i) {
            if (!aside_[i]) continue;
            map_anew(i, PROT_READ | PROT_WRITE);
            std::size_t count = 0;
            if (!read(i * piece, length(i), count) || count != length(i) ||
                sum_of(memory_ + i * piece, count) != sums_[i])
                throw std::runtime_error(shown_ + " was changed while it was read; run obrys again");
            aside_[i] = false;
            any = true;
        }
        return any;
    }

private:
    [[nodiscard]] std::size_t length(std::size_t i) const { return std::min(piece, size_ - i * piece); }

    /// Fresh memory in the place of piece `i`; what was there is given back. Without access a reader that looks back
    /// all the same ends here, instead of reading blanks.
    void map_anew(std::size_t i, int access) {
        if (::mmap(memory_ + i * piece, piece, access, MAP_PRIVATE | MAP_ANONYMOUS | MAP_FIXED, -1, 0) == MAP_FAILED)
            throw std::runtime_error("no memory for the text of " + shown_);
        if (access != PROT_NONE) base::prefer_large_pages(memory_ + i * piece, piece);
    }

    /// Bytes `[from, from + most)` of the file to their place; `count`: how many there were.
    bool read(std::size_t from, std::size_t most, std::size_t& count) {
        for (count = 0; count < most;) {
            const auto n = ::pread(file_, memory_ + from + count, most - count, static_cast<off_t>(from + count));
            if (n == 0) break;
            if (n < 0 && errno != EINTR) return false;
            if (n > 0) count += static_cast<std::size_t>(n);
        }
        return true;
    }

    int file_;
    std::string shown_;
    char* memory_ = nullptr;
    std::size_t capacity_, size_ = 0;
    std::vector<std::uint64_t> sums_;  ///< by piece; 0: not made yet
    std::vector<bool> aside_;          ///< by piece
};

}  // namespace

std::unique_ptr<base::Store> read_large_text(const std::string& path, const std::string& shown, std::uintmax_t size) {
    const int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
    if (file < 0) return nullptr;
    const auto capacity = static_cast<std::size_t>(size);
    auto text = std::make_unique<LargeText>(file, shown, capacity);
    if (!text->read_all(capacity)) return nullptr;
    return text;
}

}  // namespace obrys::driver

#else

namespace obrys::driver {

std::unique_ptr<base::Store> read_large_text(const std::string&, const std::string&, std::uintmax_t) { return nullptr; }

}  // namespace obrys::driver

#endif
