#include "path/nose.hpp"

#include <array>

namespace obrys::path {

std::optional<geom::Vec2> nose_offset(int orientation, double radius) {
    static constexpr std::array<geom::Vec2, 9> towards_tip{
        {{1, 1}, {-1, 1}, {-1, -1}, {1, -1}, {1, 0}, {0, 1}, {-1, 0}, {0, -1}, {0, 0}}};
    if (orientation < 1 || orientation > 9) return std::nullopt;
    return radius * towards_tip[static_cast<std::size_t>(orientation - 1)];
}

}  // namespace obrys::path
