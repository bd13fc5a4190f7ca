#pragma once
/// The surface where a lattice is too coarse for it: cells are halved until what lies in them is within a tolerance.
///
/// The cells about an edge that belongs to no shorter one are joined by triangles as in a lattice (Ju, Losasso,
/// Schaefer, Warren: "Dual Contouring of Hermite Data", 2002, section 4). A cell's vertices are the pieces of surface
/// that pass through its faces, one each: where a face or an edge is divided by its neighbours, so are the traces on
/// it, and what they connect is one piece. So the mesh is closed whatever cells lie side by side.

#include <cstddef>
#include <vector>

#include "mesh/mesh.hpp"
#include "sim/milling/exact/exact.hpp"
#include "sim/milling/surface/cell_vertices.hpp"
#include "sim/milling/surface/qef.hpp"
#include "sim/milling/surface/surface.hpp"

namespace obrys::sim::milling {

/// A place of the exact surface that a mesh does not show.
struct Unshown {
    geom::Vec3 at, nearest;  ///< `nearest`: on the mesh
    Corners triangle;        ///< the mesh's own there
};

class Fine {
public:
    /// `coarse`: vertices of the lattice's own cells.
    Fine(Exact& exact, double tolerance, const Lattice& lattice, const NodeBits& nodes, const Crossings& crossings,
         const CellVertices& cells, const std::vector<geom::Vec3>& coarse, const Stop& stop);

    /// Halves cells of the lattice, and these again where that is needed.
    void refine(const std::vector<Place>& cells);
    /// Halves what lies about places of the exact surface that the mesh does not show, each with the mesh's place
    /// nearest to it. Places about which nothing could be halved are left.
    [[nodiscard]] std::vector<Unshown> show(const std::vector<Unshown>& places);
    /// A place that could not be made right.
    void leave_open(geom::Vec3 p);
    /// The bottom of a groove here is filled by more than the tolerance, up to twice that.
    void leave_filled(geom::Vec3 p);
    /// Of what could not be made right, keeps what is not right now. To be called once nothing is halved any more.
    void settle();
    /// The cells of which `is_fine` is true.
    [[nodiscard]] const std::vector<Place>& cells() const { return all_; }
    /// True for the cells that are halved and those that share an edge with one: triangles about their edges come from
    /// here.
    [[nodiscard]] bool is_fine(int i, int j, int k) const {
        return fine_cells_.find(key_of({i, j, k})) != KeyMap::none;
    }
    /// Triangles by numbers that count the coarse vertices first; the vertices without these.
    [[nodiscard]] mesh::Mesh mesh() const;
    [[nodiscard]] Refined figures() const;

private:
    /// An edge that the surface crosses.
    struct Edge {
        ShortEdge edge;
        std::array<Leaf, 4> around{};
        Crossing crossing;
        bool leaves = false;  ///< material lies at the lower end
    };
    /// What is known of an edge of a leaf.
    struct Known {
        Crossing crossing;
        std::int32_t size = 0;
        bool narrow = false;  ///< more ends than its nodes tell
    };
    using Near = Exact::Near;
    /// What lies near the cell that was asked for last.
    struct NearCell {
        Place cell{-1, -1, -1};
        Near near;
    };

    void halve(std::vector<Leaf> next);
    [[nodiscard]] Box3 box_of(const Leaf& leaf) const;
    [[nodiscard]] bool is_small(std::int32_t size) const;
    void find_fine_cells();
    void find_changed();
    void find_surface(const std::vector<Place>& cells);
    [[nodiscard]] bool is_placed(const Leaf& leaf) const;
    void find_signs();
    void find_known();
    void find_edges(const std::vector<Place>& cells);
    void join();
    /// An edge on a face's rim that the surface crosses.
    struct Crossed {
        std::uint32_t edge = 0;
        bool enters = false;  ///< material, on the way round
    };
    /// A face's rim, kept for its memory.
    struct Rim {
        std::vector<ShortEdge> all, part;
        std::vector<Crossed> crossed;
    };
    void join_face(std::size_t edge, std::size_t side, Rim& rim);
    [[nodiscard]] bool is_joined(const Leaf& small, const Place& low, std::size_t normal) const;
    void place_vertices();
    /// Crossings of one piece of surface in a leaf: from `first` up to `last` in `slots`.
    struct Piece {
        const std::vector<std::uint32_t>& slots;
        std::size_t first = 0, last = 0;
        Leaf leaf;
    };
    [[nodiscard]] geom::Vec3 vertex_of(const Piece& piece, NearCell& near) const;
    [[nodiscard]] PlaneFit planes_of(const Piece& piece) const;
    [[nodiscard]] PlaneFit planes_at(const Piece& piece, geom::Vec3 p) const;
    void add_leaf(geom::Vec3 p, std::vector<Leaf>& out) const;
    void add_leaves_at_corners(const Unshown& u, std::vector<Leaf>& out) const;
    void add_leaves_beside(geom::Vec3 p, const Leaf& leaf, std::vector<Leaf>& out) const;
    [[nodiscard]] bool leaf_of(geom::Vec3 p, Leaf& leaf) const;
    [[nodiscard]] std::vector<Leaf> leaves_to_split();
    [[nodiscard]] bool is_full() const;
    [[nodiscard]] bool has_room_for(std::size_t leaves) const;
    [[nodiscard]] bool needs_split(const Near& near, const Leaf& leaf) const;
    [[nodiscard]] bool is_off(const Near& here, const Corners& t, double allowed, double in_material) const;
    [[nodiscard]] bool is_off(const Place& cell, std::size_t edge, double allowed, double in_material) const;

    [[nodiscard]] bool is_material(const Place& p) const;
    [[nodiscard]] bool is_outermost(const Place& p) const;
    [[nodiscard]] bool is_special(const Leaf& leaf) const;
    [[nodiscard]] const Known* known(const ShortEdge& e) const;
    [[nodiscard]] bool is_far(const Near& near, const Leaf& leaf) const;
    [[nodiscard]] Known look(const Near& near, const ShortEdge& e) const;
    [[nodiscard]] bool is_narrow(const std::vector<LineEnd>& ends, const ShortEdge& e) const;
    [[nodiscard]] std::uint32_t likeness(std::size_t edge) const;
    [[nodiscard]] bool is_plain(const Near& near, const Leaf& leaf) const;
    [[nodiscard]] bool is_covered(const Near& near, const Leaf& leaf) const;
    [[nodiscard]] std::uint32_t root(std::uint32_t slot);
    void unite(std::uint32_t a, std::uint32_t b);
    [[nodiscard]] std::uint32_t vertex(std::size_t edge, std::size_t quadrant) const;
    [[nodiscard]] geom::Vec3 position(std::uint32_t vertex) const;
    [[nodiscard]] geom::Vec3 point_of(const Edge& e) const;
    void each_edge_of(const Leaf& leaf, base::FunctionRef<void(const ShortEdge&)> take) const;

    const Lattice& lattice_;
    const NodeBits& nodes_;
    const Crossings& crossings_;
    const CellVertices& cells_;
    const std::vector<geom::Vec3>& coarse_;
    double tolerance_;
    const Stop& stop_;
    Leaves leaves_;
    std::int32_t usual_;     ///< size down to which leaves are halved, whatever is asked of them
    std::int32_t smallest_;  ///< the same, but about places looked for
    Exact& exact_;
    KeyMap signs_;                    ///< 1: material
    std::array<KeyMap, 3> known_of_;  ///< number in `known_`, by axis and node
    std::vector<Known> known_;
    std::uint32_t round_ = 0;
    std::size_t halved_ = 0, known_before_ = 0;  ///< leaves in this round, and edges known before it
    std::array<KeyMap, 3> tested_;  ///< what triangles about an edge were like when they were found to be right
    std::vector<Place> dirty_;      ///< cells of the lattice in which something was split last
    std::vector<Place> all_;        ///< those in `fine_cells_`
    std::vector<Place> changed_;    ///< of them those whose edges and vertices the last halving may have changed
    KeyMap placed_;                 ///< cells whose vertices are asked for; empty: all
    KeyMap fine_cells_;
    std::vector<Edge> edges_;
    std::array<KeyMap, 3> edge_of_;      ///< number in `edges_`, by axis and node
    std::vector<std::uint32_t> parent_;  ///< of slots: 4 * edge + quadrant
    std::vector<std::uint32_t> mate_;    ///< of sides: the other side of the same trace
    std::vector<std::uint32_t> vertex_;  ///< of slots, counted from the coarse vertices on
    std::vector<geom::Vec3> vertices_;
    std::vector<Leaf> given_up_;  ///< smallest ones whose triangles were off
    std::vector<Box3> filled_;
    std::vector<Box3> open_;  ///< what could not be made fine enough
};

}  // namespace obrys::sim::milling
