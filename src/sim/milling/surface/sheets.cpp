#include "sim/milling/surface/sheets.hpp"

#include <cstddef>

#include "sim/milling/lattice.hpp"

namespace obrys::sim::milling {

namespace {

constexpr unsigned bit_of(int axis) { return 1U << static_cast<unsigned>(axis); }

/// The edge between two neighbouring nodes of a cell.
constexpr int edge_between(unsigned a, unsigned b) {
    const unsigned along = a ^ b, low = a & b;
    const int axis = along == 1 ? 0 : along == 2 ? 1 : 2;
    return cell_edge(axis, (low & bit_of(first_across(axis))) != 0 ? 1 : 0,
                     (low & bit_of(second_across(axis))) != 0 ? 1 : 0);
}

/// The nodes of a face, one round.
constexpr std::array<unsigned, 4> face_nodes(int face) {
    const int axis = face / 2;
    const unsigned base = face % 2 == 1 ? bit_of(axis) : 0, u = bit_of(first_across(axis)),
                   v = bit_of(second_across(axis));
    return {base, base | u, base | u | v, base | v};
}

constexpr bool is_set(unsigned corners, unsigned node) { return (corners >> node & 1U) != 0; }

/// Material at two opposite nodes of the face only.
constexpr bool is_ambiguous(unsigned corners, int face) {
    const auto n = face_nodes(face);
    return is_set(corners, n[0]) == is_set(corners, n[2]) && is_set(corners, n[1]) == is_set(corners, n[3]) &&
           is_set(corners, n[0]) != is_set(corners, n[1]);
}

/// Edges of a cell that belong together.
struct Groups {
    std::array<int, 12> parent{0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11};
    [[nodiscard]] int root(int edge) const {
        while (parent[static_cast<std::size_t>(edge)] != edge) edge = parent[static_cast<std::size_t>(edge)];
        return edge;
    }
    void join(int a, int b) {
        const int ra = root(a), rb = root(b);
        parent[static_cast<std::size_t>(ra > rb ? ra : rb)] = ra > rb ? rb : ra;
    }
};

/// Joins the edges that the surface's traces on a face connect: around the nodes that are cut off.
void join_on_face(Groups& groups, unsigned corners, int face, bool joined) {
    const auto n = face_nodes(face);
    const auto edge = [&](std::size_t at) { return edge_between(n[at % 4], n[(at + 1) % 4]); };
    const auto crossed = [&](std::size_t at) { return is_set(corners, n[at % 4]) != is_set(corners, n[(at + 1) % 4]); };
    if (is_ambiguous(corners, face)) {
        for (std::size_t i = 0; i < 4; ++i)
            if (is_set(corners, n[i]) != joined) groups.join(edge(i + 3), edge(i));
        return;
    }
    int first = -1;
    for (std::size_t i = 0; i < 4; ++i) {
        if (!crossed(i)) continue;
        if (first < 0) first = edge(i);
        groups.join(first, edge(i));
    }
}

Groups groups_of(unsigned corners, int joined_face) {
    Groups groups;
    for (int face = 0; face < 6; ++face) join_on_face(groups, corners, face, face == joined_face);
    return groups;
}

int find_doubtful_face(unsigned corners) {
    const Groups groups = groups_of(corners, -1);
    for (int face = 0; face < 6; ++face) {
        if (!is_ambiguous(corners, face)) continue;
        const auto n = face_nodes(face);
        if (groups.root(edge_between(n[0], n[1])) == groups.root(edge_between(n[2], n[3])) &&
            groups.root(edge_between(n[1], n[2])) == groups.root(edge_between(n[3], n[0])) &&
            groups.root(edge_between(n[0], n[1])) == groups.root(edge_between(n[1], n[2])))
            return face;
    }
    return -1;
}

Sheets number_sheets(unsigned corners, int joined_face) {
    const Groups groups = groups_of(corners, joined_face);
    Sheets s;
    for (unsigned a = 0; a < 8; ++a)
        for (const unsigned along : {1U, 2U, 4U}) {
            if ((a & along) != 0 || is_set(corners, a) == is_set(corners, a | along)) continue;
            const auto edge = static_cast<std::size_t>(edge_between(a, a | along));
            auto& number = s.of_edge[static_cast<std::size_t>(groups.root(static_cast<int>(edge)))];
            if (number == Sheets::none) number = s.count++;
            s.of_edge[edge] = number;
        }
    return s;
}

struct Table {
    std::array<std::array<Sheets, 256>, 2> sheets;
    std::array<std::int8_t, 256> doubtful{};
};

Table make_table() {
    Table t;
    for (unsigned corners = 0; corners < 256; ++corners) {
        const int face = find_doubtful_face(corners);
        t.doubtful[corners] = static_cast<std::int8_t>(face);
        t.sheets[0][corners] = number_sheets(corners, -1);
        t.sheets[1][corners] = number_sheets(corners, face);
    }
    return t;
}

const Table& table() {
    static const Table t = make_table();
    return t;
}

}  // namespace

const Sheets& sheets(unsigned corners, bool joined) { return table().sheets[joined ? 1 : 0][corners & 255U]; }

int doubtful_face(unsigned corners) { return table().doubtful[corners & 255U]; }

}  // namespace obrys::sim::milling
