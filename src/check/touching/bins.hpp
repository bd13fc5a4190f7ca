#pragma once
/// A rectangle of the plane in square bins, each with what belongs to it. Millimetres.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "base/whole.hpp"
#include "check/touching/clearing_cut.hpp"

namespace obrys::check {

template <class Bin>
class Bins {
public:
    /// At most `most` bins along each side, none smaller than `least`.
    Bins(const Patch& around, double least, std::size_t most) : around_(around) {
        const geom::Vec2 size = around.hi - around.lo;
        side_ = std::max({least, size.x / static_cast<double>(most), size.y / static_cast<double>(most)});
        across_ = base::clipped<std::size_t>(std::ceil(size.x / side_), 1, most + 1);
        bins_.resize(across_ * base::clipped<std::size_t>(std::ceil(size.y / side_), 1, most + 1));
    }
    [[nodiscard]] const Patch& around() const { return around_; }
    [[nodiscard]] double side() const { return side_; }

    /// Calls `f(bin, patch)` for every bin that a patch meets, as long as it says true; whether it always did.
    template <class Self, class F>
    static bool each(Self& self, const Patch& p, F&& f) {
        const std::size_t down = self.bins_.size() / self.across_;
        const auto number = [&](double v, double from, std::size_t n) {
            return base::clipped<std::size_t>(std::floor((v - from) / self.side_), 0, n - 1);
        };
        const Patch& all = self.around_;
        if (p.hi.x < all.lo.x || p.lo.x > all.hi.x || p.hi.y < all.lo.y || p.lo.y > all.hi.y) return true;
        const std::size_t x1 = number(p.hi.x, all.lo.x, self.across_), y1 = number(p.hi.y, all.lo.y, down);
        for (std::size_t y = number(p.lo.y, all.lo.y, down); y <= y1; ++y)
            for (std::size_t x = number(p.lo.x, all.lo.x, self.across_); x <= x1; ++x)
                if (!f(self.bins_[y * self.across_ + x], self.patch(x, y))) return false;
        return true;
    }

private:
    [[nodiscard]] Patch patch(std::size_t x, std::size_t y) const {
        const geom::Vec2 lo = around_.lo + geom::Vec2{static_cast<double>(x) * side_, static_cast<double>(y) * side_};
        return {lo, {std::min(lo.x + side_, around_.hi.x), std::min(lo.y + side_, around_.hi.y)}};
    }

    Patch around_;
    double side_ = 1;
    std::size_t across_ = 1;
    std::vector<Bin> bins_;
};

}  // namespace obrys::check
