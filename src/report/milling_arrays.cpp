#include "report/milling_arrays.hpp"

#include <algorithm>
#include <span>
#include <string_view>
#include <type_traits>

#include "base/float_chars.hpp"

namespace obrys::report {

namespace {

template <std::size_t bytes>
using Unsigned = std::conditional_t<
    bytes == 8, std::uint64_t,
    std::conditional_t<bytes == 4, std::uint32_t, std::conditional_t<bytes == 2, std::uint16_t, std::uint8_t>>>;

/// Base64 (RFC 4648, chapter 4) of numbers that come one after the other, lowest byte first.
class Base64 {
public:
    explicit Base64(std::string& out) : out_(out) {}

    template <typename Number>
    void put(Number v) {
        auto bits = base::bit_cast<Unsigned<sizeof(Number)>>(v);
        for (std::size_t i = 0; i < sizeof(Number); ++i) {
            byte(static_cast<std::uint8_t>(bits & 0xFFU));
            if constexpr (sizeof(Number) > 1) bits = static_cast<decltype(bits)>(bits >> 8U);
        }
    }
    void finish() {
        if (held_ == 0) return;
        const int missing = 3 - held_;
        for (int i = 0; i < missing; ++i) byte(0);
        for (int i = 0; i < missing; ++i) out_[out_.size() - 1 - static_cast<std::size_t>(i)] = '=';
    }

private:
    static constexpr std::string_view letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

    void byte(std::uint8_t b) {
        three_ = three_ << 8U | b;
        if (++held_ < 3) return;
        for (unsigned shift = 24; shift > 0;) out_ += letters[three_ >> (shift -= 6U) & 63U];
        three_ = 0;
        held_ = 0;
    }

    std::string& out_;
    std::uint32_t three_ = 0;
    int held_ = 0;
};

/// One element; `fill` puts the numbers.
template <typename Fill>
void element(std::string& out, std::string_view id, const Fill& fill) {
    out.append("<script type=\"text/plain\" id=\"array-").append(id).append("\">");
    Base64 base64(out);
    fill(base64);
    base64.finish();
    out += "</script>\n";
}

template <typename Number>
void element(std::string& out, std::string_view id, std::span<const Number> numbers) {
    element(out, id, [numbers](Base64& to) {
        for (const Number n : numbers) to.put(n);
    });
}

/// The value of each move, made by `of`.
template <typename Of>
void by_move(std::string& out, std::string_view id, std::span<const PageMove> moves, const Of& of) {
    element(out, id, [&](Base64& to) {
        for (const PageMove& m : moves) to.put(of(m));
    });
}

constexpr std::uint16_t none16 = 0xFFFF;
std::uint16_t narrow(std::size_t index, std::size_t count) {
    return index < count && index < none16 ? static_cast<std::uint16_t>(index) : none16;
}

std::uint16_t tool_of(const MillingPage& page, std::int32_t number) {
    const auto at =
        std::find_if(page.tools.begin(), page.tools.end(), [number](const PageTool& t) { return t.number == number; });
    return narrow(static_cast<std::size_t>(at - page.tools.begin()), page.tools.size());
}

bool has_corners(const PageSurface& s, std::size_t triangle) {
    for (std::size_t k = 3 * triangle; k < 3 * triangle + 3; ++k)
        if (s.indices[k] >= s.vertices.size() / 3) return false;
    return true;
}

void path_arrays(std::string& out, const MillingPage& page, const PageCounts& counts) {
    const std::span<const PageMove> moves(page.path.moves.data(), counts.moves);
    element(out, "points", std::span<const float>(page.path.points.data(), 3 * counts.points));
    element(out, "moveOfPoint", std::span<const std::uint32_t>(page.path.move_of_point.data(), counts.points));
    by_move(out, "kind", moves, [](const PageMove& m) { return static_cast<std::uint8_t>(m.rapid ? 1 : 0); });
    by_move(out, "file", moves, [&](const PageMove& m) { return narrow(m.where.file, page.texts.size()); });
    by_move(out, "line", moves, [](const PageMove& m) { return m.where.line; });
    by_move(out, "tool", moves, [&](const PageMove& m) { return tool_of(page, m.tool); });
    by_move(out, "number", moves, [](const PageMove& m) { return static_cast<std::uint32_t>(m.number); });
    by_move(out, "seconds", moves, [](const PageMove& m) { return m.end_s; });
    by_move(out, "lengths", moves, [](const PageMove& m) { return m.end_mm; });
    if (page.path.axes.size() >= 3 * counts.moves)
        element(out, "axes", std::span<const float>(page.path.axes.data(), 3 * counts.moves));
}

void surface_arrays(std::string& out, const PageSurface& s, const PageCounts& counts) {
    element(out, "vertices", std::span<const float>(s.vertices.data(), s.vertices.size() / 3 * 3));
    const auto each = [&](const auto& put) {
        for (std::size_t t = 0; t < counts.triangles; ++t)
            if (has_corners(s, t)) put(t);
    };
    element(out, "indices", [&](Base64& to) {
        each([&](std::size_t t) {
            for (std::size_t k = 3 * t; k < 3 * t + 3; ++k) to.put(s.indices[k]);
        });
    });
    element(out, "moveOf", [&](Base64& to) {
        each([&](std::size_t t) {
            const std::uint32_t move = t < s.move_of.size() ? s.move_of[t] : page_none;
            to.put(move < counts.moves ? move : page_none);
        });
    });
    if (s.deviation.size() >= counts.triangles && !s.deviation.empty())
        element(out, "deviation", [&](Base64& to) { each([&](std::size_t t) { to.put(s.deviation[t]); }); });
}

}  // namespace

PageCounts usable(const MillingPage& page) {
    const PagePath& path = page.path;
    PageCounts counts;
    counts.moves = path.moves.size();
    const std::size_t most = std::min(path.points.size() / 3, path.move_of_point.size());
    std::uint32_t last = 0;
    while (counts.points < most) {
        const std::uint32_t move = path.move_of_point[counts.points];
        if (move < last || move >= counts.moves) break;
        last = move;
        ++counts.points;
    }
    counts.triangles = page.surface.indices.size() / 3;
    return counts;
}

std::string page_arrays(const MillingPage& page) {
    const PageCounts counts = usable(page);
    std::string out;
    out.reserve(4096 + counts.moves * 44 + counts.points * 22 + page.surface.vertices.size() * 6 +
                counts.triangles * 27);
    path_arrays(out, page, counts);
    surface_arrays(out, page.surface, counts);
    return out;
}

}  // namespace obrys::report
