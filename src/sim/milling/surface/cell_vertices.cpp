#include "sim/milling/surface/cell_vertices.hpp"

#include <algorithm>
#include <bit>

#include "base/parallel.hpp"
#include "sim/milling/surface/qef.hpp"

namespace obrys::sim::milling {

namespace {

using geom::Vec3;
/// Distances of a vertex from its planes, in steps: plane faces that meet in one point; what makes it worth leaving the
/// cell. Found by trial on boxes, bores and rows of ball trenches in all directions.
constexpr double meets = 5e-4, worth_leaving = 0.02;

/// The pieces of surface in one cell, and where they cross its edges.
class CellFit {
public:
    CellFit(const Lattice& lattice, const NodeBits& nodes, const Crossings& crossings, int i, int j, int k)
        : lattice_(lattice),
          nodes_(nodes),
          crossings_(crossings),
          at_{i, j, k},
          lo_(lattice.node(i, j, k)),
          hi_(lattice.node(i + 1, j + 1, k + 1)) {}

    [[nodiscard]] Vec3 vertex(const Sheets& sheets, std::uint8_t sheet, double tolerance, bool& rough) const {
        PlaneFit fit;
        const Vec3 v = vertex_of(sheets, sheet, fit);
        // On the smallest radius that the step is made for, planes of crossings a cell's diagonal apart stand off each
        // other by four times the sagitta, which is 0.75 of the tolerance (step_for).
        rough = tolerance > 0 && (fit.spread() > 3 * tolerance || fit.miss(v) > 0.5 * tolerance);
        return v;
    }

private:
    [[nodiscard]] Vec3 vertex_of(const Sheets& sheets, std::uint8_t sheet, PlaneFit& fit) const {
        for (int edge = 0; edge < 12; ++edge)
            if (sheets.of_edge[static_cast<std::size_t>(edge)] == sheet) add(fit, edge);
        // The tip of an edge or corner may reach into a neighbouring cell without moving one of its nodes, or an edge
        // may pass beside the cell. Held in its cell such a vertex would lie beside both faces. Smooth surfaces and
        // flat creases, whose planes meet somewhere far aside, are told by how little there is to win.
        const Vec3 wide = fit.vertex(lo_ - lattice_.step, hi_ + lattice_.step);
        if (is_free(wide)) return wide;
        const Vec3 held = fit.vertex(lo_, hi_);
        const double step = std::max({lattice_.step.x, lattice_.step.y, lattice_.step.z});
        const double wide_miss = fit.miss(wide), held_miss = fit.miss(held);
        return wide_miss < meets * step || (held_miss > worth_leaving * step && wide_miss < 0.5 * held_miss) ? wide
                                                                                                             : held;
    }

    /// In this cell, or in a neighbour that has no surface as far as its nodes tell.
    [[nodiscard]] bool is_free(Vec3 p) const {
        std::array<int, 3> cell = at_;
        for (int axis = 0; axis < 3; ++axis) {
            int& n = cell[static_cast<std::size_t>(axis)];
            if (component(p, axis) < component(lo_, axis)) --n;
            if (component(p, axis) > component(hi_, axis)) ++n;
            if (n < 0 || n + 2 > lattice_.count[static_cast<std::size_t>(axis)]) return false;
        }
        if (cell == at_) return true;
        const unsigned corners = nodes_.corners(cell[0], cell[1], cell[2]);
        return corners == 0 || corners == 255;
    }

    void add(PlaneFit& fit, int edge) const {
        const int axis = edge / 4;
        std::array<int, 3> node = at_;
        node[static_cast<std::size_t>(first_across(axis))] += edge & 1;
        node[static_cast<std::size_t>(second_across(axis))] += edge >> 1 & 1;
        const auto number = crossings_.number(axis, node[0], node[1], node[2]);
        const Crossing& c = crossings_.along(axis)[number];
        Vec3 p = lattice_.node(node[0], node[1], node[2]), within = p;
        set_component(p, axis, c.at);
        set_component(within, axis, std::clamp(c.at, component(lo_, axis), component(hi_, axis)));
        const Vec3 normal{c.normal[0], c.normal[1], c.normal[2]};
        if (normal == Vec3{}) {
            fit.add(within);
        } else {
            fit.add(p, within, normal);
        }
    }

    const Lattice& lattice_;
    const NodeBits& nodes_;
    const Crossings& crossings_;
    std::array<int, 3> at_;
    Vec3 lo_, hi_;
};

}  // namespace

CellVertices::CellVertices(const Lattice& lattice, const NodeBits& nodes, const Crossings& crossings, double tolerance)
    : nodes_(nodes) {
    find_cells();
    if (tolerance > 0) rough_.resize(vertices_.size());
    place(lattice, crossings, tolerance);
}

CellVertices::Cell CellVertices::describe(int i, int j, int k) const {
    Cell cell;
    cell.corners = static_cast<std::uint8_t>(nodes_.corners(i, j, k));
    const int face = doubtful_face(cell.corners);
    if (face < 0) return cell;
    // The outermost nodes are air, so a cell at the rim has no such face there.
    std::array<int, 3> beside{i, j, k};
    beside[static_cast<std::size_t>(face / 2)] += face % 2 == 1 ? 1 : -1;
    cell.joined = doubtful_face(nodes_.corners(beside[0], beside[1], beside[2])) == (face ^ 1);
    return cell;
}

void CellVertices::find_cells() {
    const std::size_t rows = nodes_.rows();
    ranks_.reserve(rows, nodes_.words());
    row_first_.assign(rows + 1, 0);
    base::in_pieces(rows, 64, [&](const base::Piece& some) {
        for (std::size_t row = some.begin(); row < some.end(); ++row)
            for (std::size_t w = 0; w < nodes_.words(); ++w) {
                ranks_.of(row, w) = row_first_[row + 1];
                row_first_[row + 1] += static_cast<std::uint32_t>(std::popcount(nodes_.mixed(row, w)));
            }
    });
    for (std::size_t row = 0; row < rows; ++row) row_first_[row + 1] += row_first_[row];
    cells_.resize(row_first_[rows]);
    base::in_pieces(rows, 16, [&](const base::Piece& some) {
        for (std::size_t row = some.begin(); row < some.end(); ++row) {
            std::uint32_t number = row_first_[row];
            if (number == row_first_[row + 1]) continue;
            for (std::size_t w = 0; w < nodes_.words(); ++w)
                for (std::uint64_t mask = nodes_.mixed(row, w); mask != 0; mask &= mask - 1)
                    cells_[number++] =
                        describe(static_cast<int>(64 * w) + std::countr_zero(mask), nodes_.j(row), nodes_.k(row));
        }
    });
    std::uint32_t first = 0;
    for (Cell& cell : cells_) {
        cell.first = first;
        first += sheets(cell.corners, cell.joined).count;
    }
    vertices_.resize(first);
}

void CellVertices::place(const Lattice& lattice, const Crossings& crossings, double tolerance) {
    base::in_pieces(nodes_.rows(), 16, [&](const base::Piece& some) {
        for (std::size_t row = some.begin(); row < some.end(); ++row) {
            std::uint32_t number = row_first_[row];
            if (number == row_first_[row + 1]) continue;
            for (std::size_t w = 0; w < nodes_.words(); ++w)
                for (std::uint64_t mask = nodes_.mixed(row, w); mask != 0; mask &= mask - 1) {
                    const int i = static_cast<int>(64 * w) + std::countr_zero(mask);
                    const Cell& cell = cells_[number++];
                    const CellFit fit(lattice, nodes_, crossings, i, nodes_.j(row), nodes_.k(row));
                    const Sheets& s = sheets(cell.corners, cell.joined);
                    for (std::uint8_t n = 0; n < s.count; ++n) {
                        bool rough = false;
                        vertices_[cell.first + n] = fit.vertex(s, n, tolerance, rough);
                        if (rough) rough_[cell.first + n] = 1;
                    }
                }
        }
    });
}

std::uint32_t CellVertices::vertex(int i, int j, int k, int edge) const {
    const std::size_t row = nodes_.row(j, k), w = static_cast<std::size_t>(i) / 64;
    const std::uint32_t number =
        row_first_[row] + ranks_.at(row, w, nodes_.mixed(row, w), static_cast<unsigned>(i) % 64);
    const Cell& cell = cells_[number];
    return cell.first + sheets(cell.corners, cell.joined).of_edge[static_cast<std::size_t>(edge)];
}

}  // namespace obrys::sim::milling
