#include "sim/milling/surface/sheets.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <set>

namespace obrys::sim::milling {
namespace {

bool set(unsigned corners, unsigned node) { return (corners >> node & 1U) != 0; }

std::set<int> crossed_edges(unsigned corners) {
    // Node numbers: 1 in x, 2 in y, 4 in z; the two bits of an edge's place come in the order of the axes.
    std::set<int> edges;
    for (unsigned a = 0; a < 8; ++a) {
        const int x = a & 1U ? 1 : 0, y = a & 2U ? 1 : 0, z = a & 4U ? 1 : 0;
        if (x == 0 && set(corners, a) != set(corners, a | 1U)) edges.insert(cell_edge(0, y, z));
        if (y == 0 && set(corners, a) != set(corners, a | 2U)) edges.insert(cell_edge(1, x, z));
        if (z == 0 && set(corners, a) != set(corners, a | 4U)) edges.insert(cell_edge(2, x, y));
    }
    return edges;
}

TEST(SheetsOf, a_cell_cover_its_crossed_edges_and_no_others) {
    for (const bool joined : {false, true})
        for (unsigned corners = 0; corners < 256; ++corners) {
            const Sheets& s = sheets(corners, joined);
            const std::set<int> crossed = crossed_edges(corners);
            std::array<int, 4> size{};
            for (int e = 0; e < 12; ++e) {
                const std::uint8_t n = s.of_edge[static_cast<std::size_t>(e)];
                ASSERT_EQ(n != Sheets::none, crossed.count(e) == 1) << corners << " edge " << e;
                if (n == Sheets::none) continue;
                ASSERT_LT(n, s.count);
                ++size.at(n);
            }
            for (unsigned n = 0; n < s.count; ++n) EXPECT_GE(size.at(n), 3) << corners << ": a piece has three edges";
        }
}

TEST(SheetsOf, opposite_nodes_are_apart) {
    EXPECT_EQ(sheets(0b00000001, false).count, 1);
    EXPECT_EQ(sheets(0b10000001, false).count, 2) << "two nodes through the body";
    EXPECT_EQ(sheets(0b00001001, false).count, 2) << "two nodes across a face";
    EXPECT_EQ(sheets(0b01101001, false).count, 4) << "every second node";
    EXPECT_EQ(sheets(0b10010110, false).count, 4);
    EXPECT_EQ(sheets(0b00001111, false).count, 1) << "a flat cut";
    EXPECT_EQ(sheets(0, false).count + sheets(255, false).count, 0);
}

TEST(SheetsOf, a_doubtful_face_is_the_only_one_and_joining_parts_its_two_pieces) {
    int found = 0;
    for (unsigned corners = 0; corners < 256; ++corners) {
        const int face = doubtful_face(corners);
        if (face < 0) continue;
        ++found;
        const int axis = face / 2, side = face % 2;
        // The four edges of that face.
        std::set<int> before, after;
        for (int other = 0; other < 3; ++other) {
            if (other == axis) continue;
            for (int far = 0; far < 2; ++far) {
                const int first_axis = other == 0 ? 1 : 0;
                const int edge = axis == first_axis ? cell_edge(other, side, far) : cell_edge(other, far, side);
                before.insert(sheets(corners, false).of_edge[static_cast<std::size_t>(edge)]);
                after.insert(sheets(corners, true).of_edge[static_cast<std::size_t>(edge)]);
            }
        }
        EXPECT_EQ(before.size(), 1U) << corners;
        EXPECT_EQ(after.size(), 2U) << corners;
        EXPECT_GE(std::popcount(corners), 5) << "cases 16 and 19 of the literature have few nodes of air";
    }
    EXPECT_GT(found, 0);
}

}  // namespace
}  // namespace obrys::sim::milling
