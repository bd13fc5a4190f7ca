#pragma once
/// Words of one line of the text form. Private to cl.

#include <array>
#include <charconv>
#include <cstddef>
#include <string>
#include <string_view>

#include "base/text.hpp"
#include "geom/vec.hpp"

namespace obrys::cl {

/// Takes the words of one line from left to right. After the first wrong word everything fails and `wrong` holds it.
class Words {
public:
    explicit Words(std::string_view line) : line_(line) {}

    [[nodiscard]] bool ok() const { return message_.empty(); }
    [[nodiscard]] const std::string& message() const { return message_; }
    [[nodiscard]] std::size_t wrong_begin() const { return begin_; }
    [[nodiscard]] std::size_t wrong_end() const { return at_; }
    [[nodiscard]] bool at_end() {
        skip_blanks();
        return at_ == line_.size();
    }
    void fail(std::string message) {
        if (ok()) message_ = std::move(message);
    }

    std::string_view word() {
        skip_blanks();
        begin_ = at_;
        while (at_ < line_.size() && !base::is_blank(line_[at_])) ++at_;
        return line_.substr(begin_, at_ - begin_);
    }
    /// The next word without taking it.
    std::string_view peek() {
        skip_blanks();
        std::size_t end = at_;
        while (end < line_.size() && !base::is_blank(line_[end])) ++end;
        return line_.substr(at_, end - at_);
    }
    void expect(std::string_view wanted) {
        if (ok() && word() != wanted) fail("expected \"" + std::string(wanted) + "\"");
    }
    /// True and taken where the next word is `wanted`.
    bool accept(std::string_view wanted) {
        if (!ok() || peek() != wanted) return false;
        word();
        return true;
    }
    /// A number, `?` (NaN), `inf` or `-inf`.
    double number();
    geom::Vec3 vec() {
        const double x = number(), y = number(), z = number();
        return {x, y, z};
    }
    template <class Integer>
    Integer integer() {
        if (!ok()) return 0;
        return integer_of<Integer>(word());
    }
    template <class Integer>
    Integer integer_of(std::string_view w) {
        Integer value = 0;
        const auto [end, error] = std::from_chars(w.data(), w.data() + w.size(), value);
        if (w.empty() || error != std::errc{} || end != w.data() + w.size()) fail("expected a whole number");
        return value;
    }
    /// The index of the next word in `words`.
    template <std::size_t N>
    std::size_t choice(const std::array<std::string_view, N>& words) {
        if (!ok()) return 0;
        const std::string_view w = word();
        std::string all;
        for (std::size_t i = 0; i < N; ++i) {
            if (w == words[i]) return i;
            all += (i == 0 ? "" : ", ") + std::string(words[i]);
        }
        fail("expected one of: " + all);
        return 0;
    }
    std::string quoted();

private:
    void skip_blanks() {
        while (at_ < line_.size() && base::is_blank(line_[at_])) ++at_;
    }
    char escape();

    std::string_view line_;
    std::size_t at_ = 0, begin_ = 0;
    std::string message_;
};

}  // namespace obrys::cl
