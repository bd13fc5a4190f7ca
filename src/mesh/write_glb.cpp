#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "base/number.hpp"
#include "mesh/export.hpp"
#include "mesh/little_endian.hpp"
#include "mesh/shading.hpp"

namespace obrys::mesh {

namespace {

using geom::Vec3;

/// Vertices and triangles of one colour.
struct Part {
    Colour colour;
    std::vector<std::uint32_t> vertices;  ///< shaded ones
    std::vector<std::uint32_t> indices;   ///< of `vertices`
};

std::vector<Part> parts_by_colour(const Mesh& m, const Shading& s, Palette palette) {
    const Palette all = palette.empty() ? Palette(&grey, 1) : palette;
    std::vector<std::vector<std::uint32_t>> triangles(all.size());
    for (std::uint32_t t = 0; t < m.triangles.size(); ++t)
        if (s.corners[3 * std::size_t{t}] != Shading::none)
            triangles[std::min<std::size_t>(m.tag(t), all.size() - 1)].push_back(t);
    std::vector<Part> parts;
    std::vector<std::uint32_t> place(s.vertex.size(), Shading::none);  // in the part at work
    for (std::size_t colour = 0; colour < all.size(); ++colour) {
        if (triangles[colour].empty()) continue;
        Part part;
        part.colour = all[colour];
        for (const std::uint32_t t : triangles[colour])
            for (std::size_t c = 0; c < 3; ++c) {
                const std::uint32_t v = s.corners[3 * std::size_t{t} + c];
                if (place[v] == Shading::none) {
                    place[v] = static_cast<std::uint32_t>(part.vertices.size());
                    part.vertices.push_back(v);
                }
                part.indices.push_back(place[v]);
            }
        for (const std::uint32_t v : part.vertices) place[v] = Shading::none;
        parts.push_back(std::move(part));
    }
    return parts;
}

std::string list(const std::array<double, 3>& v) {
    return "[" + base::shortest(v[0]) + "," + base::shortest(v[1]) + "," + base::shortest(v[2]) + "]";
}

std::array<float, 3> single(Vec3 v) {
    return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)};
}

double linear(std::uint8_t srgb) {
    const double c = srgb / 255.0;
    return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
}

/// Positions, then normals, then indices of all parts; each a buffer view. And the JSON that describes them.
class Writer {
public:
    Writer(const Mesh& m, const Shading& s, const std::vector<Part>& parts) : mesh_(m), shading_(s), parts_(parts) {
        for (const Part& p : parts) vertices_ += p.vertices.size(), indices_ += p.indices.size();
    }

    [[nodiscard]] std::size_t bytes() const { return 24 * vertices_ + 4 * indices_; }

    [[nodiscard]] std::string binary() const {
        std::string out;
        out.reserve(bytes());
        for (const Part& p : parts_)
            for (const std::uint32_t v : p.vertices) append_vector(out, mesh_.vertices[shading_.vertex[v]]);
        for (const Part& p : parts_)
            for (const std::uint32_t v : p.vertices) append_vector(out, shading_.normal[v]);
        for (const Part& p : parts_)
            for (const std::uint32_t i : p.indices) append_u32(out, i);
        return out;
    }

    [[nodiscard]] std::string json() const {
        std::string out = R"({"asset":{"version":"2.0","generator":"obrys"},"scene":0,)";
        if (parts_.empty()) return out + R"("scenes":[{}]})";
        std::string accessors, primitives, materials;
        std::size_t vertex = 0, index = 0, number = 0;
        for (const Part& p : parts_) {
            const std::string first = std::to_string(3 * number), comma = number > 0 ? "," : "";
            accessors += comma + part_accessors(p, vertex, index);
            primitives += comma + R"({"attributes":{"POSITION":)" + first + R"(,"NORMAL":)" +
                          std::to_string(3 * number + 1) + R"(},"indices":)" + std::to_string(3 * number + 2) +
                          R"(,"material":)" + std::to_string(number) + "}";
            materials += comma + material(p.colour);
            vertex += p.vertices.size(), index += p.indices.size(), ++number;
        }
        // Column by column: x stays, y goes to -z, z to y; mm to m.
        out += R"("scenes":[{"nodes":[0]}],"nodes":[{"mesh":0,)"
               R"("matrix":[0.001,0,0,0,0,0,-0.001,0,0,0.001,0,0,0,0,0,1]}],)";
        out += R"("meshes":[{"primitives":[)" + primitives + R"(]}],"materials":[)" + materials + "],";
        return out + R"("accessors":[)" + accessors + "]," + buffers() + "}";
    }

private:
    [[nodiscard]] std::string part_accessors(const Part& p, std::size_t vertex, std::size_t index) const {
        std::array<double, 3> lo{HUGE_VAL, HUGE_VAL, HUGE_VAL}, hi{-HUGE_VAL, -HUGE_VAL, -HUGE_VAL};
        for (const std::uint32_t v : p.vertices) {
            const auto at = single(mesh_.vertices[shading_.vertex[v]]);
            for (std::size_t c = 0; c < 3; ++c) {
                lo[c] = std::min(lo[c], static_cast<double>(at[c]));
                hi[c] = std::max(hi[c], static_cast<double>(at[c]));
            }
        }
        const std::string vectors = R"(,"byteOffset":)" + std::to_string(12 * vertex) +
                                    R"(,"componentType":5126,"type":"VEC3","count":)" +
                                    std::to_string(p.vertices.size());
        return R"({"bufferView":0)" + vectors + R"(,"min":)" + list(lo) + R"(,"max":)" + list(hi) +
               R"(},{"bufferView":1)" + vectors + R"(},{"bufferView":2,"byteOffset":)" + std::to_string(4 * index) +
               R"(,"componentType":5125,"type":"SCALAR","count":)" + std::to_string(p.indices.size()) + "}";
    }

    [[nodiscard]] static std::string material(Colour c) {
        return R"({"pbrMetallicRoughness":{"baseColorFactor":[)" + base::fixed(linear(c.red), 6) + "," +
               base::fixed(linear(c.green), 6) + "," + base::fixed(linear(c.blue), 6) +
               R"(,1],"metallicFactor":0.2,"roughnessFactor":0.6}})";
    }

    [[nodiscard]] std::string buffers() const {
        const auto view = [](std::size_t offset, std::size_t size, const char* rest) {
            return R"({"buffer":0,"byteOffset":)" + std::to_string(offset) + R"(,"byteLength":)" +
                   std::to_string(size) + rest + "}";
        };
        const char* vectors = R"(,"byteStride":12,"target":34962)";
        return R"("bufferViews":[)" + view(0, 12 * vertices_, vectors) + "," +
               view(12 * vertices_, 12 * vertices_, vectors) + "," +
               view(24 * vertices_, 4 * indices_, R"(,"target":34963)") + R"(],"buffers":[{"byteLength":)" +
               std::to_string(bytes()) + "}]";
    }

    const Mesh& mesh_;
    const Shading& shading_;
    const std::vector<Part>& parts_;
    std::size_t vertices_ = 0, indices_ = 0;
};

void append_chunk(std::string& out, std::uint32_t type, std::string_view content) {
    append_u32(out, static_cast<std::uint32_t>(content.size()));
    append_u32(out, type);
    out += content;
}

}  // namespace

std::optional<std::string> write_glb(const Mesh& m, Palette palette, double crease) {
    const Shading shading = shade(m, crease);
    const std::vector<Part> parts = parts_by_colour(m, shading, palette);
    const Writer writer(m, shading, parts);
    std::string json = writer.json();
    json.resize((json.size() + 3) / 4 * 4, ' ');
    const std::size_t total = 12 + 8 + json.size() + (parts.empty() ? 0 : 8 + writer.bytes());
    if (total > std::numeric_limits<std::uint32_t>::max()) return std::nullopt;
    std::string out = "glTF";
    out.reserve(total);
    append_u32(out, 2);
    append_u32(out, static_cast<std::uint32_t>(total));
    append_chunk(out, 0x4e4f534a, json);
    if (!parts.empty()) append_chunk(out, 0x004e4942, writer.binary());
    return out;
}

}  // namespace obrys::mesh
