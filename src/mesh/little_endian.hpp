#pragma once
/// Numbers in binary files, lowest byte first, whatever the machine.

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "base/float_chars.hpp"
#include "geom/vec.hpp"

namespace obrys::mesh {

/// The text must hold the bytes.
[[nodiscard]] inline std::uint32_t read_u32(std::string_view bytes, std::size_t at) {
    std::uint32_t value = 0;
    for (std::size_t i = 4; i-- > 0;) value = value << 8U | static_cast<unsigned char>(bytes[at + i]);
    return value;
}

inline void append_u32(std::string& out, std::uint32_t value) {
    for (unsigned shift = 0; shift < 32; shift += 8) out += static_cast<char>(value >> shift & 0xffU);
}

/// In single precision.
inline void append_vector(std::string& out, geom::Vec3 v) {
    for (const double c : {v.x, v.y, v.z}) append_u32(out, base::bit_cast<std::uint32_t>(static_cast<float>(c)));
}

}  // namespace obrys::mesh
