#include <cmath>
#include <optional>

#include "base/codes.hpp"
#include "base/float_chars.hpp"
#include "base/number.hpp"
#include "base/text.hpp"
#include "mesh/stl_soup.hpp"

namespace obrys::mesh {

namespace {

using geom::Vec3;

constexpr bool is_space(char c) { return base::is_blank(c) || c == '\n' || c == '\r' || c == '\v' || c == '\f'; }

class Reader {
public:
    Reader(std::uint32_t file, std::string_view text, Soup& soup, base::Diagnostics& out)
        : file_(file), text_(text), soup_(soup), out_(out) {}

    bool solids() {
        do {
            if (!expect("solid")) return false;
            to_line_end();
            if (!facets()) return false;
            to_line_end();
            next();
        } while (!word_.empty());
        return true;
    }

private:
    /// The next word; empty at the end of the file.
    void next() {
        while (at_ < text_.size() && is_space(text_[at_])) ++at_;
        const std::size_t begin = at_;
        while (at_ < text_.size() && !is_space(text_[at_])) ++at_;
        word_ = text_.substr(begin, at_ - begin);
        begin_ = begin;
    }

    void to_line_end() {
        while (at_ < text_.size() && text_[at_] != '\n' && text_[at_] != '\r') ++at_;
    }

    /// Takes the word on which the reader stands, or reads one; then it must be `wanted`.
    bool expect(std::string_view wanted) {
        if (word_.empty()) next();
        if (!base::equals_ignoring_case(word_, wanted)) return refuse(wanted);
        word_ = {};
        return true;
    }

    bool facets() {
        for (;;) {
            next();
            if (base::equals_ignoring_case(word_, "endsolid")) break;
            if (!facet()) return false;
        }
        word_ = {};
        return true;
    }

    bool facet() {
        Vec3 normal;
        std::array<Vec3, 3> corners;
        if (!expect("facet") || !expect("normal") || !numbers(normal, false) || !expect("outer") || !expect("loop"))
            return false;
        for (Vec3& c : corners)
            if (!expect("vertex") || !numbers(c, true)) return false;
        if (!expect("endloop") || !expect("endfacet")) return false;
        soup_.add(corners);
        return true;
    }

    /// The normal is read over: it follows from the corners, and files are found where it is NaN.
    bool numbers(Vec3& v, bool is_corner) {
        for (double* c : {&v.x, &v.y, &v.z}) {
            next();
            std::string_view digits = word_;
            if (digits.starts_with('+')) digits.remove_prefix(1);
            const auto [end, error] = base::from_chars(digits.data(), digits.data() + digits.size(), *c);
            const bool is_number = !digits.empty() && end == digits.data() + digits.size();
            // Too small for a double (1e-400) is zero, too large is told as such.
            if (is_number && error == std::errc::result_out_of_range) *c = too_small(digits) ? 0 : HUGE_VAL;
            if (!is_number && (is_corner || !is_not_finite(digits))) return refuse("a number");
            if (is_corner && !(std::abs(*c) <= largest_coordinate)) return refuse("a coordinate below 1000 km");
        }
        word_ = {};
        return true;
    }

    /// What C libraries print where a number has become none: "nan", "-nan(ind)", "inf", "-1.#IND".
    static bool is_not_finite(std::string_view word) {
        if (word.starts_with('-')) word.remove_prefix(1);
        return word.find('#') != std::string_view::npos || base::equals_ignoring_case(word.substr(0, 3), "nan") ||
               base::equals_ignoring_case(word.substr(0, 3), "inf");
    }

    static bool too_small(std::string_view digits) {
        return digits.find("e-") != std::string_view::npos || digits.find("E-") != std::string_view::npos ||
               digits.find_first_of("123456789") == std::string_view::npos;
    }

    bool refuse(std::string_view wanted) {
        base::Diagnostic d;
        d.code = base::codes::mesh_file;
        const std::size_t shown = std::min<std::size_t>(word_.size(), 40);
        d.where = {file_, static_cast<std::uint32_t>(begin_), static_cast<std::uint32_t>(begin_ + shown)};
        const std::string triangle = "triangle " + std::to_string(soup_.read + 1);
        if (word_.empty()) {
            d.text = "the STL file ends in " + triangle + ", where " + std::string(wanted) + " is expected";
            d.remedy = "it was cut off: export or copy it again";
        } else {
            d.text = "STL, " + triangle + ": " + std::string(wanted) + " expected, \"" +
                     base::as_utf8(word_.substr(0, shown)) + "\" found";
        }
        out_.add(std::move(d));
        return false;
    }

    std::uint32_t file_;
    std::string_view text_, word_;
    std::size_t at_ = 0, begin_ = 0;
    Soup& soup_;
    base::Diagnostics& out_;
};

}  // namespace

bool read_ascii_stl(std::uint32_t file, std::string_view text, Soup& soup, base::Diagnostics& out) {
    return Reader(file, text, soup, out).solids();
}

}  // namespace obrys::mesh
