#include <cmath>

#include "base/codes.hpp"
#include "base/float_chars.hpp"
#include "mesh/little_endian.hpp"
#include "mesh/stl.hpp"
#include "mesh/stl_soup.hpp"

namespace obrys::mesh {

namespace {

using geom::Vec3;

constexpr std::size_t header = 84, record = 50;

double f32(std::string_view bytes, std::size_t at) {
    return static_cast<double>(base::bit_cast<float>(read_u32(bytes, at)));
}

bool refuse(std::uint32_t file, base::Diagnostics& out, std::string text, std::string remedy) {
    base::Diagnostic d;
    d.code = base::codes::mesh_file;
    d.where = {file, 0, 0};
    d.text = std::move(text);
    d.remedy = std::move(remedy);
    out.add(std::move(d));
    return false;
}

/// Whether the file has room for the triangles it announces, and no more.
bool check_count(std::uint32_t file, std::string_view bytes, base::Diagnostics& out) {
    const std::string cut_off = "it was cut off: export or copy it again";
    const std::string size = std::to_string(bytes.size()) + " bytes";
    if (bytes.size() < header)
        return refuse(file, out, "binary STL of " + size + ": its header alone takes 84", cut_off);
    const std::size_t count = read_u32(bytes, 80), room = (bytes.size() - header) / record;
    const std::string says = "binary STL: the header (byte 80) announces " + std::to_string(count) + " triangles, ";
    if (count > room) return refuse(file, out, says + "the file's " + size + " hold " + std::to_string(room), cut_off);
    if (bytes.size() != header + record * count)
        return refuse(
            file, out,
            says + "behind them " + std::to_string(bytes.size() - header - record * count) + " bytes are left over",
            "its count is wrong, or it is no STL file: export it again");
    return true;
}

}  // namespace

bool read_binary_stl(std::uint32_t file, std::string_view bytes, Soup& soup, base::Diagnostics& out) {
    if (!check_count(file, bytes, out)) return false;
    const std::size_t count = read_u32(bytes, 80);
    soup.triangles.reserve(count);
    for (std::size_t i = 0; i < count; ++i) {
        std::array<Vec3, 3> corners;
        for (std::size_t c = 0; c < 3; ++c) {
            const std::size_t at = header + record * i + 12 + 12 * c;
            corners[c] = {f32(bytes, at), f32(bytes, at + 4), f32(bytes, at + 8)};
            const auto usable = [](double v) { return std::abs(v) <= largest_coordinate; };  // false for NaN
            if (!usable(corners[c].x) || !usable(corners[c].y) || !usable(corners[c].z))
                return refuse(file, out,
                              "binary STL: corner " + std::to_string(c + 1) + " of triangle " + std::to_string(i + 1) +
                                  " (byte " + std::to_string(at) +
                                  ") has a coordinate that is no number or farther than 1000 km off",
                              "");
        }
        soup.add(corners);
    }
    return true;
}

std::string write_stl(const Mesh& m) {
    std::string out = "binary STL by obrys, millimetres";
    out.resize(80, ' ');
    out.reserve(header + record * m.triangles.size());
    append_u32(out, static_cast<std::uint32_t>(m.triangles.size()));
    for (std::size_t i = 0; i < m.triangles.size(); ++i) {
        const Vec3 n = area_vector(m, i);
        const double size = length(n);
        append_vector(out, size > 0 ? (1 / size) * n : Vec3{});
        for (const Vec3& c : corners(m, i)) append_vector(out, c);
        out.append(2, '\0');
    }
    return out;
}

}  // namespace obrys::mesh
