#pragma once
/// Colours of triangles: a mesh's tags number the entries of a palette.

#include <cstdint>
#include <span>

namespace obrys::mesh {

/// sRGB, 0 … 255.
struct Colour {
    std::uint8_t red = 0, green = 0, blue = 0;
    bool operator==(const Colour&) const = default;
};

/// Tags beyond the palette take its last colour; an empty palette means one grey for all.
using Palette = std::span<const Colour>;

inline constexpr Colour grey{168, 172, 178};

}  // namespace obrys::mesh
