#include "mesh/export.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <nlohmann/json.hpp>

#include "mesh/primitives.hpp"
#include "mesh/shading.hpp"

namespace obrys::mesh {
namespace {

using geom::Vec3;
using nlohmann::json;

std::uint32_t u32(const std::string& bytes, std::size_t at) {
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < 4; ++i)
        value |= static_cast<std::uint32_t>(static_cast<unsigned char>(bytes.at(at + i))) << (8 * i);
    return value;
}

/// A binary glTF file taken apart by the specification, and its scene put together again in metres, y up.
struct Glb {
    json head;
    std::string binary;

    explicit Glb(const std::string& file) {
        EXPECT_EQ(file.substr(0, 4), "glTF");
        EXPECT_EQ(u32(file, 4), 2U);
        EXPECT_EQ(u32(file, 8), file.size());
        const std::uint32_t size = u32(file, 12);
        EXPECT_EQ(size % 4, 0U);
        EXPECT_EQ(file.substr(16, 4), "JSON");
        head = json::parse(file.substr(20, size));
        if (file.size() == 20 + size) return;
        EXPECT_EQ(file.substr(24 + size, 3), "BIN");
        EXPECT_EQ(u32(file, 20 + size) % 4, 0U);
        binary = file.substr(28 + size);
        EXPECT_EQ(binary.size(), u32(file, 20 + size));
    }

    [[nodiscard]] std::size_t offset(const json& accessor) const {
        const json& view = head["bufferViews"][accessor["bufferView"].get<std::size_t>()];
        const std::size_t at = accessor["byteOffset"].get<std::size_t>(), width = accessor["type"] == "VEC3" ? 12 : 4;
        EXPECT_LE(at + width * accessor["count"].get<std::size_t>(), view["byteLength"].get<std::size_t>());
        return view["byteOffset"].get<std::size_t>() + at;
    }
    [[nodiscard]] Vec3 vector(const json& accessor, std::size_t i) const {
        const std::size_t at = offset(accessor) + 12 * i;
        const auto f = [&](std::size_t c) { return double{std::bit_cast<float>(u32(binary, at + 4 * c))}; };
        return {f(0), f(1), f(2)};
    }
    [[nodiscard]] Vec3 placed(Vec3 p) const {
        const auto m = head["nodes"][0]["matrix"].get<std::vector<double>>();
        return {m[0] * p.x + m[4] * p.y + m[8] * p.z + m[12], m[1] * p.x + m[5] * p.y + m[9] * p.z + m[13],
                m[2] * p.x + m[6] * p.y + m[10] * p.z + m[14]};
    }
    [[nodiscard]] const json& accessor(const json& index) const { return head["accessors"][index.get<std::size_t>()]; }

    [[nodiscard]] Mesh scene() const {
        Mesh m;
        for (const json& p : head["meshes"][0]["primitives"]) {
            const json &positions = accessor(p["attributes"]["POSITION"]), &indices = accessor(p["indices"]);
            EXPECT_EQ(positions["componentType"], 5126);
            EXPECT_EQ(indices["componentType"], 5125);
            const auto first = static_cast<std::uint32_t>(m.vertices.size());
            for (std::size_t i = 0; i < positions["count"]; ++i) m.vertices.push_back(placed(vector(positions, i)));
            for (std::size_t i = 0; i + 2 < indices["count"]; i += 3) {
                const std::size_t at = offset(indices) + 4 * i;
                m.triangles.push_back(
                    {first + u32(binary, at), first + u32(binary, at + 4), first + u32(binary, at + 8)});
                m.tags.push_back(p["material"]);
            }
        }
        return m;
    }
};

TEST(Gltf, stands_in_metres_with_y_up) {
    const auto file = write_glb(box({1000, 2000, 3000}, {1010, 2020, 3030}));
    ASSERT_TRUE(file);
    const Glb glb(*file);
    const Mesh m = glb.scene();
    EXPECT_NEAR(volume(m), 0.010 * 0.020 * 0.030, 1e-9);
    const Box b = bounds(m);
    EXPECT_NEAR(b.lo.x, 1.0, 1e-6);
    EXPECT_NEAR(b.lo.y, 3.0, 1e-6);
    EXPECT_NEAR(b.hi.y, 3.03, 1e-6);
    EXPECT_NEAR(b.hi.z, -2.0, 1e-6);
    EXPECT_EQ(m.triangles.size(), 12U);
    EXPECT_EQ(m.vertices.size(), 24U) << "a corner of a box has three normals";
    EXPECT_EQ(glb.binary.size(), glb.head["buffers"][0]["byteLength"]);
}

TEST(Gltf, extents_and_normals_are_those_of_the_data) {
    const Mesh rod = cylinder({0.1, 0.2, 0.3}, 4, 7, 60);
    const Glb glb(*write_glb(rod));
    const json& primitive = glb.head["meshes"][0]["primitives"][0];
    const json &positions = glb.accessor(primitive["attributes"]["POSITION"]),
               &normals = glb.accessor(primitive["attributes"]["NORMAL"]);
    ASSERT_EQ(positions["count"], normals["count"]);
    EXPECT_EQ(positions["count"], 2 + 4 * 60) << "the wall's normals are shared, the ends' are others";
    std::array<double, 3> lo{1e9, 1e9, 1e9}, hi{-1e9, -1e9, -1e9};
    for (std::size_t i = 0; i < positions["count"]; ++i) {
        const Vec3 p = glb.vector(positions, i), n = glb.vector(normals, i);
        EXPECT_NEAR(length(n), 1, 1e-6);
        const bool end = std::abs(n.z) > 0.9, rim = std::hypot(p.x - 0.1, p.y - 0.2) > 3.9;
        if (!end) {
            EXPECT_NEAR(n.x, (p.x - 0.1) / 4, 0.03);
        }
        EXPECT_TRUE(end || rim);
        lo = {std::min(lo[0], p.x), std::min(lo[1], p.y), std::min(lo[2], p.z)};
        hi = {std::max(hi[0], p.x), std::max(hi[1], p.y), std::max(hi[2], p.z)};
    }
    const auto same = [](double a, double b) { return static_cast<float>(a) == static_cast<float>(b); };
    for (std::size_t c = 0; c < 3; ++c) {
        EXPECT_TRUE(same(positions["min"][c], lo[c]));
        EXPECT_TRUE(same(positions["max"][c], hi[c]));
    }
}

TEST(Gltf, has_a_material_for_each_colour_in_use) {
    Mesh m = box({0, 0, 0}, {1, 1, 1});
    m.tags = {0, 0, 2, 2, 9, 9, 0, 0, 0, 0, 0, 0};
    const std::array<Colour, 4> palette{Colour{255, 0, 0}, Colour{0, 255, 0}, Colour{0, 0, 255}, Colour{188, 188, 188}};
    const Glb glb(*write_glb(m, palette));
    ASSERT_EQ(glb.head["materials"].size(), 3U) << "green is not in use";
    const auto colour = [&](std::size_t i) {
        return glb.head["materials"][i]["pbrMetallicRoughness"]["baseColorFactor"].get<std::vector<double>>();
    };
    EXPECT_EQ(colour(0), (std::vector<double>{1, 0, 0, 1}));
    EXPECT_EQ(colour(1), (std::vector<double>{0, 0, 1, 1}));
    EXPECT_NEAR(colour(2)[0], 0.503, 0.001) << "half the light is 188 in sRGB; tags beyond the palette take its last";
    const Mesh back = glb.scene();
    EXPECT_EQ(back.triangles.size(), 12U);
    EXPECT_EQ(std::count(back.tags.begin(), back.tags.end(), 1U), 2);
}

TEST(Gltf, of_nothing_is_an_empty_scene) {
    const auto file = write_glb(Mesh{});
    ASSERT_TRUE(file);
    EXPECT_EQ(Glb(*file).head["scenes"].size(), 1U);
    Mesh flat;
    flat.vertices = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}};
    flat.triangles = {{0, 1, 2}};
    EXPECT_FALSE(Glb(*write_glb(flat)).head.contains("meshes")) << "triangles without area are not shown";
}

TEST(Shading, follows_the_crease_angle) {
    const Mesh rod = cylinder({0, 0, 0}, 4, 7, 12);  // 30 degrees from face to face
    EXPECT_EQ(shade(rod, geom::radians(31)).vertex.size(), 2U + 4 * 12);
    EXPECT_EQ(shade(rod, geom::radians(29)).vertex.size(), 2U + 6 * 12);
}

}  // namespace
}  // namespace obrys::mesh
