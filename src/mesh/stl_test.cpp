#include "mesh/stl.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <limits>

#include "base/codes.hpp"
#include "base/text.hpp"
#include "mesh/primitives.hpp"

namespace obrys::mesh {
namespace {

using geom::Vec3;

struct Reading {
    base::Sources sources;
    base::Diagnostics said;
    std::optional<StlFile> file;

    explicit Reading(const std::string& bytes, StlOptions options = {}) {
        const std::uint32_t number = sources.add("part.stl", bytes);
        file = read_stl(number, bytes, said, options);
    }
    [[nodiscard]] std::string text() const {
        std::string all;
        for (const base::Diagnostic& d : said.all()) all += d.text + " [" + std::string(d.code) + "]\n";
        return all;
    }
    [[nodiscard]] bool says(std::string_view part) const { return text().find(part) != std::string::npos; }
};

std::string ascii(const Mesh& m, const std::string& gap = "\n") {
    std::string s = "solid part of mine\n";
    for (std::size_t i = 0; i < m.triangles.size(); ++i) {
        s += "facet normal 0 0 0" + gap + "outer loop" + gap;
        for (const Vec3& c : corners(m, i))
            s += "vertex " + std::to_string(c.x) + " " + std::to_string(c.y) + " " + std::to_string(c.z) + gap;
        s += "endloop" + gap + "endfacet" + gap;
    }
    return s + "endsolid part of mine\n";
}

void set_float(std::string& bytes, std::size_t at, float value) {
    const auto bits = std::bit_cast<std::uint32_t>(value);
    for (std::size_t i = 0; i < 4; ++i) bytes[at + i] = static_cast<char>(bits >> (8 * i) & 0xffU);
}

TEST(Stl, written_and_read_again_is_the_same) {
    const Mesh m = box({-1.5, 2, 3}, {40.25, 60, 8});
    const std::string bytes = write_stl(m);
    EXPECT_EQ(bytes.size(), 84U + 50 * 12);
    const Reading r(bytes);
    ASSERT_TRUE(r.file) << r.text();
    EXPECT_EQ(r.text(), "");
    EXPECT_TRUE(r.file->binary);
    EXPECT_EQ(r.file->mesh.vertices.size(), 8U);
    EXPECT_EQ(r.file->mesh.triangles.size(), 12U);
    EXPECT_TRUE(r.file->topology.closed());
    EXPECT_DOUBLE_EQ(volume(r.file->mesh), volume(m));
    EXPECT_EQ(write_stl(r.file->mesh), bytes);
}

TEST(Stl, text_is_read_whatever_its_case_and_line_ends) {
    const Mesh m = box({0, 0, 0}, {40, 60, 8});
    for (const std::string gap : {"\n", "\r\n", "   \t\n", " ", "\r"}) {
        std::string text = ascii(m, gap);
        for (const bool shout : {false, true}) {
            if (shout)
                for (char& c : text) c = base::upper(c);
            const Reading r(text);
            ASSERT_TRUE(r.file) << r.text();
            EXPECT_FALSE(r.file->binary);
            EXPECT_NEAR(volume(r.file->mesh), volume(m), 1e-6);
            EXPECT_EQ(r.text(), "");
        }
    }
}

TEST(Stl, text_takes_all_forms_of_numbers_and_several_solids) {
    const std::string facet =
        "facet normal nan -nan(ind) -1.#INF outer loop vertex +1.5e+2 0 0 vertex 0 2E1 1e-400 vertex 0 0 -.5 "
        "endloop endfacet\n";
    const Reading r("\n solid a\n" + facet + "endsolid a\nsolid b\n" + facet + "endsolid\n");
    ASSERT_TRUE(r.file) << r.text();
    EXPECT_EQ(r.file->triangles, 2U);
    EXPECT_EQ(r.file->mesh.vertices[0], (Vec3{150, 0, 0}));
    EXPECT_EQ(r.file->mesh.vertices[1], (Vec3{0, 20, 0}));
    EXPECT_EQ(r.file->mesh.vertices[2], (Vec3{0, 0, -0.5}));
}

TEST(Stl, a_corner_that_is_no_number_is_refused) {
    for (const char* word : {"nan", "inf", "-1.#IND", "NaN", "1e", "x"}) {
        const Reading r(std::string("solid a\nfacet normal 0 0 1 outer loop vertex 0 0 ") + word +
                        " vertex 1 0 0 vertex 0 1 0 endloop endfacet\nendsolid a\n");
        EXPECT_FALSE(r.file) << word;
        EXPECT_TRUE(r.says(std::string("a number expected, \"") + word)) << r.text();
    }
}

TEST(Stl, binary_that_begins_with_solid_is_known_by_its_size) {
    std::string bytes = write_stl(box({0, 0, 0}, {40, 60, 8}));
    bytes.replace(0, 10, "solid part");
    const Reading r(bytes);
    ASSERT_TRUE(r.file) << r.text();
    EXPECT_TRUE(r.file->binary);
}

TEST(Stl, every_truncation_is_refused) {
    const std::string bytes = write_stl(box({0, 0, 0}, {40, 60, 8})), text = ascii(box({0, 0, 0}, {40, 60, 8}));
    for (std::size_t n = 0; n < bytes.size(); ++n) EXPECT_FALSE(Reading(bytes.substr(0, n)).file) << n;
    const std::size_t end = text.rfind("endsolid") + 8;
    for (std::size_t n = 0; n < end; n += 7) EXPECT_FALSE(Reading(text.substr(0, n)).file) << n;
    EXPECT_TRUE(Reading(bytes.substr(0, 200)).says("announces 12 triangles, the file's 200 bytes hold 2"));
    EXPECT_TRUE(Reading("").says("[file-empty]"));
    EXPECT_TRUE(Reading("abc").says("[mesh-file]"));
}

TEST(Stl, a_wrong_word_is_told_with_its_line) {
    std::string text = ascii(box({0, 0, 0}, {40, 60, 8}));
    text.replace(text.find("vertex"), 6, "vortex");
    const Reading r(text);
    ASSERT_FALSE(r.file);
    ASSERT_EQ(r.said.all().size(), 1U);
    const base::Diagnostic& d = r.said.all()[0];
    EXPECT_EQ(d.text, "STL, triangle 1: vertex expected, \"vortex\" found");
    EXPECT_EQ(r.sources.position(d.where).line, 4U);
    EXPECT_EQ(r.sources.text(d.where), "vortex");
    EXPECT_NE(base::render(d, r.sources).find("part.stl:4:1: error"), std::string::npos) << base::render(d, r.sources);
}

TEST(Stl, a_count_beyond_the_file_takes_no_memory) {
    std::string bytes = write_stl(box({0, 0, 0}, {40, 60, 8}));
    for (std::size_t i = 80; i < 84; ++i) bytes[i] = '\xff';
    EXPECT_TRUE(Reading(bytes).says("4294967295 triangles"));
    bytes = write_stl(box({0, 0, 0}, {40, 60, 8})) + "more";
    EXPECT_TRUE(Reading(bytes).says("4 bytes are left over"));
}

TEST(Stl, coordinates_that_are_no_numbers_are_refused_with_their_byte) {
    for (const float bad : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(), -1e30F}) {
        std::string bytes = write_stl(box({0, 0, 0}, {40, 60, 8}));
        set_float(bytes, 84 + 50 * 4 + 12 + 12 + 4, bad);
        const Reading r(bytes);
        EXPECT_FALSE(r.file);
        EXPECT_TRUE(r.says("corner 2 of triangle 5 (byte 308)")) << r.text();
    }
    for (const std::string bad : {"nan", "-inf", "1e999", "1e10", "1,5", "0x10", "--1", "1.5.2"}) {
        std::string text = ascii(box({0, 0, 0}, {40, 60, 8}));
        text.replace(text.find("40.000000"), 9, bad);
        const Reading r(text);
        EXPECT_FALSE(r.file) << bad;
        EXPECT_TRUE(r.says("\"" + bad + "\" found")) << r.text();
    }
}

TEST(Stl, what_is_wrong_with_the_surface_is_told_once_with_its_first_place) {
    Mesh m = box({0, 0, 0}, {40, 60, 8});
    m.triangles.pop_back();
    const Reading open(write_stl(m));
    ASSERT_TRUE(open.file);
    EXPECT_TRUE(open.says("3 edges with one triangle only")) << open.text();
    EXPECT_TRUE(open.says("X 40.000")) << open.text();
    m = box({0, 0, 0}, {40, 60, 8});
    std::swap(m.triangles[3][0], m.triangles[3][1]);
    EXPECT_TRUE(Reading(write_stl(m)).says("3 edges between triangles of opposite orientation"));
    append(m, box({40, 60, 0}, {80, 90, 8}));
    const Reading crowded(write_stl(m));
    EXPECT_TRUE(crowded.says("1 edge with more than two triangles")) << crowded.text();
    EXPECT_TRUE(crowded.says("[mesh-not-closed]"));
}

TEST(Stl, inside_out_is_turned_over_and_said) {
    Mesh m = box({0, 0, 0}, {40, 60, 8});
    turn_over(m);
    const Reading r(write_stl(m));
    ASSERT_TRUE(r.file);
    EXPECT_TRUE(r.file->turned_over);
    EXPECT_GT(volume(r.file->mesh), 0);
    EXPECT_TRUE(r.says("inside out"));
}

TEST(Stl, a_small_part_is_only_hinted_at) {
    const Reading r(write_stl(box({0, 0, 0}, {4, 2.5, 0.5})));
    ASSERT_TRUE(r.file);
    EXPECT_TRUE(r.file->maybe_inch);
    EXPECT_DOUBLE_EQ(bounds(r.file->mesh).size().x, 4);
    EXPECT_TRUE(r.says("the part measures 4.000 x 2.500 x 0.500 mm")) << r.text();
}

TEST(Stl, triangles_without_area_are_left_out_and_counted) {
    Mesh m = box({0, 0, 0}, {40, 60, 8});
    m.triangles.push_back({3, 3, 5});
    const Reading r(write_stl(m));
    ASSERT_TRUE(r.file);
    EXPECT_EQ(r.file->degenerate, 1U);
    EXPECT_TRUE(r.file->topology.closed());
    EXPECT_TRUE(r.says("1 triangle of 13 left out")) << r.text();
    m.triangles = {{1, 1, 2}};
    EXPECT_TRUE(Reading(write_stl(m)).says("no triangle with three different corners"));
}

TEST(Stl, corners_rounded_apart_are_joined_by_a_tolerance) {
    Mesh m = box({0, 0, 0}, {40, 60, 8});
    std::string bytes = write_stl(m);
    set_float(bytes, 84 + 12, 0.00004F);
    set_float(bytes, 84 + 50 * 7 + 12 + 4, 60.00004F);
    const Reading apart(bytes), joined(bytes, {.weld = 1e-4});
    ASSERT_TRUE(apart.file && joined.file);
    EXPECT_FALSE(apart.file->topology.closed());
    EXPECT_TRUE(joined.file->topology.closed()) << joined.text();
    EXPECT_EQ(joined.file->mesh.vertices.size(), 8U);
}

}  // namespace
}  // namespace obrys::mesh
