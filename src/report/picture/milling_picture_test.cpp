/// The three pictures of a machined part, read back from their PNG.
#include "report/picture/milling_picture.hpp"

#include <cairo.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "mesh/primitives.hpp"

namespace obrys::report::picture {
namespace {

using geom::Vec3;
using mesh::Colour;

struct Png {
    int width = 0, height = 0;
    std::vector<std::uint32_t> pixels;
    [[nodiscard]] Colour at(int i, int j) const {
        const std::uint32_t p =
            pixels[static_cast<std::size_t>(j) * static_cast<std::size_t>(width) + static_cast<std::size_t>(i)];
        return {static_cast<std::uint8_t>(p >> 16), static_cast<std::uint8_t>(p >> 8), static_cast<std::uint8_t>(p)};
    }
};

Png decode(const std::string& bytes) {
    std::string_view rest = bytes;
    const auto read = [](void* from, unsigned char* to, unsigned int count) {
        auto& text = *static_cast<std::string_view*>(from);
        if (text.size() < count) return CAIRO_STATUS_READ_ERROR;
        std::memcpy(to, text.data(), count);
        text.remove_prefix(count);
        return CAIRO_STATUS_SUCCESS;
    };
    cairo_surface_t* s = cairo_image_surface_create_from_png_stream(read, &rest);
    EXPECT_EQ(cairo_surface_status(s), CAIRO_STATUS_SUCCESS);
    Png out{cairo_image_surface_get_width(s), cairo_image_surface_get_height(s), {}};
    const int stride = cairo_image_surface_get_stride(s);
    for (int j = 0; j < out.height; ++j)
        for (int i = 0; i < out.width; ++i) {
            std::uint32_t pixel = 0;
            std::memcpy(&pixel, cairo_image_surface_get_data(s) + std::ptrdiff_t{j} * stride + 4 * std::ptrdiff_t{i},
                        4);
            out.pixels.push_back(pixel);
        }
    cairo_surface_destroy(s);
    return out;
}

int light(Colour c) { return (c.red + c.green + c.blue) / 3; }

bool alike(Colour a, Colour b, int by = 12) {
    return std::abs(a.red - b.red) <= by && std::abs(a.green - b.green) <= by && std::abs(a.blue - b.blue) <= by;
}

/// The smallest rectangle round the pixels of a colour within the columns [from, to).
struct Extent {
    int left = 1 << 20, top = 1 << 20, right = -1, bottom = -1, count = 0;
};
Extent extent(const Png& p, Colour colour, int from = 0, int to = 1 << 20, int down_to = 1 << 20, int down_from = 0) {
    Extent e;
    for (int j = down_from; j < std::min(p.height, down_to); ++j)
        for (int i = from; i < std::min(p.width, to); ++i) {
            if (!alike(p.at(i, j), colour, 4)) continue;
            e.left = std::min(e.left, i), e.right = std::max(e.right, i + 1);
            e.top = std::min(e.top, j), e.bottom = std::max(e.bottom, j + 1);
            ++e.count;
        }
    return e;
}

void quad(mesh::Mesh& m, Vec3 a, Vec3 b, Vec3 c, Vec3 d, std::uint32_t tag) {
    const auto first = static_cast<std::uint32_t>(m.vertices.size());
    for (const Vec3 v : {a, b, c, d}) m.vertices.push_back(v);
    m.triangles.push_back({first, first + 1, first + 2});
    m.triangles.push_back({first, first + 2, first + 3});
    m.tags.insert(m.tags.end(), 2, tag);
}

constexpr Vec3 lo{0, 0, -20}, hi{40, 30, 0};

/// A block 40 x 30 x 20 under Z0 with a pocket from (10, 8) to (30, 20), 8 deep, whose faces have tag 1.
mesh::Mesh pocket() {
    mesh::Mesh m;
    const double x[] = {0, 10, 30, 40}, y[] = {0, 8, 20, 30}, deep = -8;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) {
            const bool floor = i == 1 && j == 1;
            const double z = floor ? deep : 0;
            quad(m, {x[i], y[j], z}, {x[i + 1], y[j], z}, {x[i + 1], y[j + 1], z}, {x[i], y[j + 1], z}, floor ? 1 : 0);
        }
    quad(m, {10, 8, deep}, {10, 8, 0}, {30, 8, 0}, {30, 8, deep}, 1);
    quad(m, {30, 20, deep}, {30, 20, 0}, {10, 20, 0}, {10, 20, deep}, 1);
    quad(m, {10, 20, deep}, {10, 20, 0}, {10, 8, 0}, {10, 8, deep}, 1);
    quad(m, {30, 8, deep}, {30, 8, 0}, {30, 20, 0}, {30, 20, deep}, 1);
    quad(m, {0, 0, -20}, {40, 0, -20}, {40, 0, 0}, {0, 0, 0}, 0);
    quad(m, {40, 30, -20}, {0, 30, -20}, {0, 30, 0}, {40, 30, 0}, 0);
    quad(m, {0, 30, -20}, {0, 0, -20}, {0, 0, 0}, {0, 30, 0}, 0);
    quad(m, {40, 0, -20}, {40, 30, -20}, {40, 30, 0}, {40, 0, 0}, 0);
    quad(m, {0, 30, -20}, {40, 30, -20}, {40, 0, -20}, {0, 0, -20}, 0);
    return m;
}

constexpr Colour stock_colour{170, 170, 180}, tool_colour{90, 160, 210};
const std::vector<Colour> palette{stock_colour, tool_colour};

MillingScene scene(const mesh::Mesh& m) {
    MillingScene s{m};
    s.stock.add(lo);
    s.stock.add(hi);
    s.palette = palette;
    s.title = "POCKET.H";
    return s;
}

constexpr MillingView views[] = {MillingView::plan, MillingView::projections, MillingView::solid};
constexpr Colour highest_colour{248, 244, 226}, deepest_colour{18, 34, 88};

TEST(MillingPicture, ThePlanShowsAPocketDarkerAtItsPlace) {
    const mesh::Mesh m = pocket();
    const Png p = decode(milling_png(MillingView::plan, scene(m)));
    ASSERT_EQ(p.width, 1200);
    ASSERT_EQ(p.height, 900);
    constexpr int legend = 1080;
    const Extent block = extent(p, highest_colour, 0, legend), deep = extent(p, deepest_colour, 0, legend);
    const double scale = (block.right - block.left) / 40.0;
    EXPECT_GT(scale, 15);
    EXPECT_NEAR(block.bottom - block.top, 30 * scale, 3);
    EXPECT_NEAR(deep.left, block.left + 10 * scale, 3);
    EXPECT_NEAR(deep.right, block.left + 30 * scale, 3);
    EXPECT_NEAR(deep.bottom, block.bottom - 8 * scale, 3);
    EXPECT_NEAR(deep.top, block.bottom - 20 * scale, 3);
    EXPECT_NEAR(deep.count, 20 * 12 * scale * scale, 0.02 * deep.count);
    const int i = (deep.left + deep.right) / 2, j = (deep.top + deep.bottom) / 2;
    EXPECT_LT(light(p.at(i, j)) + 100, light(p.at(block.left + 20, block.top + 20)));
}

TEST(MillingPicture, ProjectionsHaveOneScaleAndCutsShowTheDepth) {
    const mesh::Mesh m = pocket();
    MillingScene s = scene(m);
    s.cut = {20, 14};
    const Png p = decode(milling_png(MillingView::projections, s));
    const Extent floor = extent(p, tool_colour, 0, 1200, 900, 400);  // the pocket's floor, in the plan
    const double scale = (floor.right - floor.left) / 20.0;
    EXPECT_NEAR(floor.bottom - floor.top, 12 * scale, 4);
    // The cut through the front view: as wide as the block, hollow over the pocket.
    constexpr Colour cut{236, 214, 170};
    const Extent front = extent(p, cut, 0, static_cast<int>(floor.right + 10 * scale + 6), floor.top);
    ASSERT_GT(front.count, 0);
    EXPECT_NEAR(front.right - front.left, 40 * scale, 4);
    EXPECT_NEAR(front.bottom - front.top, 20 * scale, 4);
    EXPECT_NEAR(front.left, floor.left - 10 * scale, 4);
    EXPECT_NEAR(front.count, (40 * 20 - 20 * 8) * scale * scale, 0.2 * front.count);
    const auto over_pocket = p.at(static_cast<int>(front.left + 20 * scale), static_cast<int>(front.top + 4 * scale));
    EXPECT_FALSE(alike(over_pocket, cut, 30));
    // First angle: what is seen from the left stands to the right of the front view, 30 wide.
    const Extent side = extent(p, cut, front.right + 5);
    EXPECT_NEAR(side.right - side.left, 30 * scale, 4);
    EXPECT_EQ(side.top, front.top);
}

TEST(MillingPicture, InSpaceTheHiddenBackIsHidden) {
    mesh::Mesh m = mesh::box(lo, hi);
    const Png p = decode(milling_png(MillingView::solid, scene(m)));
    // A red mark's colour on the back and the bottom never shows.
    constexpr Colour loud{255, 0, 255};
    const std::vector<Colour> two{stock_colour, loud};
    for (std::size_t t = 0; t < m.triangles.size(); ++t) {
        const Vec3 n = area_vector(m, t);
        m.tags.push_back(n.z < 0 || n.y > 0 || n.x < 0 ? 1 : 0);
    }
    MillingScene s = scene(m);
    s.palette = two;
    const Png hidden = decode(milling_png(MillingView::solid, s));
    EXPECT_EQ(p.pixels, hidden.pixels);
    for (std::uint32_t& tag : m.tags) tag = 1 - tag;
    EXPECT_NE(decode(milling_png(MillingView::solid, s)).pixels, hidden.pixels);
}

TEST(MillingPicture, TheSameSceneGivesTheSameBytes) {
    const mesh::Mesh m = pocket();
    const std::vector<PictureMark> marks{{"1", {20, 14, -8}}, {"2", {20.1, 14, -8}}, {"3", {0, 30, -20}}};
    const std::vector<PicturePath> path{{{{-5, 14, 5}, {15, 14, 5}}, true}, {{{15, 14, -8}, {25, 14, -8}}, false}};
    MillingScene s = scene(m);
    const PictureSize small{500, 400};
    s.marks = marks;
    s.path = path;
    for (const MillingView view : views) {
        const std::string png = milling_png(view, s, small), svg = milling_svg(view, s, small);
        EXPECT_EQ(png, milling_png(view, s, small));
        EXPECT_EQ(svg, milling_svg(view, s, small));
        EXPECT_NE(svg.find("<svg"), std::string::npos);
        EXPECT_NE(svg.find("data:image/png;base64"), std::string::npos);
        EXPECT_NE(svg.find("</svg>"), std::string::npos);
        EXPECT_NE(png, milling_png(view, scene(m), small));
    }
}

TEST(MillingPicture, WithoutASurfaceItSaysSo) {
    const mesh::Mesh none;
    mesh::Mesh wrong = pocket();
    wrong.triangles.push_back({0, 1, 4'000'000});
    mesh::Mesh unknown = pocket();
    for (Vec3& v : unknown.vertices) v.y = NAN;
    for (const mesh::Mesh* m :
         {&none, static_cast<const mesh::Mesh*>(&wrong), static_cast<const mesh::Mesh*>(&unknown)})
        for (const MillingView view : views) {
            const Png p = decode(milling_png(view, scene(*m)));
            EXPECT_EQ(p.width, 1200);
            EXPECT_GT(extent(p, {150, 156, 164}).count, 200);
            EXPECT_EQ(extent(p, highest_colour).count, 0);
        }
}

TEST(MillingPicture, StrayCoordinatesDoNoHarm) {
    for (const double stray : {double(NAN), double(INFINITY), 1e300, -1e9, 1e5, 1e-300}) {
        mesh::Mesh m = pocket();
        m.vertices[3] = {stray, -stray, stray};
        MillingScene s = scene(m);
        const std::vector<PictureMark> marks{{"1", {stray, 0, 0}}, {"\xff\xc3", {1, 2, stray}}};
        const std::vector<PicturePath> path{{{{stray, 0, 0}, {1, 1, 1}, {0, stray, 0}}, false}};
        s.marks = marks;
        s.path = path;
        s.title = std::string("\xc3\xa9 \xed\xa0\x80 \xf8 \0 end", 14);
        for (const MillingView view : views) {
            const Png p = decode(milling_png(view, s, {400, 300}));
            EXPECT_GT(extent(p, view == MillingView::plan ? deepest_colour : tool_colour, 0, 360).count,
                      view == MillingView::solid ? -1 : 100)
                << stray;
        }
        s.stock = {};
        s.stock.add(Vec3{stray, stray, stray});
        s.cut = {stray, stray};
        EXPECT_FALSE(milling_svg(MillingView::projections, s, {400, 300}).empty());
    }
}

TEST(MillingPicture, SizesAreHeldAndSmallOnesWork) {
    const mesh::Mesh m = pocket();
    for (const PictureSize size : {PictureSize{-5, 0}, PictureSize{1 << 30, 250}, PictureSize{320, 240}})
        for (const MillingView view : views) {
            const Png p = decode(milling_png(view, scene(m), size));
            EXPECT_EQ(p.width, std::clamp(size.width, 200, 4000));
            EXPECT_EQ(p.height, std::clamp(size.height, 200, 4000));
        }
    mesh::Mesh flat;
    quad(flat, {0, 0, 1}, {5, 0, 1}, {5, 0, 1}, {0, 0, 1}, 0);
    MillingScene s = scene(flat);
    s.stock = {};
    for (const MillingView view : views) EXPECT_FALSE(milling_png(view, s).empty());
}

/// Pixels that have the clamps' red in them, on paper or on the part.
int reddish(const Png& p, int from = 0, int to = 1 << 20) {
    int count = 0;
    for (int j = 0; j < p.height; ++j)
        for (int i = from; i < std::min(p.width, to); ++i) {
            const Colour c = p.at(i, j);
            count += c.red > c.green + 20 && c.blue > c.green + 4 && c.red < c.green + 90 ? 1 : 0;
        }
    return count;
}

TEST(MillingPicture, ClampsAreDrawnAndInTheLegend) {
    const mesh::Mesh m = pocket();
    for (const MillingView view : views) {
        MillingScene s = scene(m);
        constexpr int legend = 970;
        const int before = reddish(decode(milling_png(view, s)));
        s.clamps = mesh::box({40, 5, -15}, {60, 25, 6});
        s.clamp_name = "clamp vice";
        const Png p = decode(milling_png(view, s));
        EXPECT_GT(reddish(p), before + 10'000);
        EXPECT_GT(reddish(p, view == MillingView::projections ? 0 : legend), 100);
    }
}

TEST(MillingPicture, ClampsReachIntoThePicture) {
    const mesh::Mesh m = pocket();
    MillingScene s = scene(m);
    const Png alone = decode(milling_png(MillingView::plan, s));
    s.clamps = mesh::box({-500, 5, -15}, {0, 25, 6});
    const Png p = decode(milling_png(MillingView::plan, s));
    const Extent block = extent(p, highest_colour, 0, 1080);
    EXPECT_LT(block.right - block.left,
              extent(alone, highest_colour, 0, 1080).right - extent(alone, highest_colour, 0, 1080).left);
    EXPECT_GT(reddish(p, 0, block.left), 20'000);
    EXPECT_GT(block.right - block.left, 400) << "a long clamp must not make the part small";
}

TEST(MillingPicture, ThePartHidesClampsBehindIt) {
    const mesh::Mesh m = pocket();
    MillingScene s = scene(m);
    s.clamps = mesh::box({5, 5, -19}, {35, 25, -12});
    EXPECT_EQ(reddish(decode(milling_png(MillingView::plan, s)), 0, 1000),
              reddish(decode(milling_png(MillingView::plan, scene(m))), 0, 1000));
}

}  // namespace
}  // namespace obrys::report::picture
