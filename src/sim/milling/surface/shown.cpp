#include "sim/milling/surface/shown.hpp"

#include <algorithm>
#include <cmath>

#include "base/parallel.hpp"
#include "base/whole.hpp"
#include "mesh/distance.hpp"
#include "sim/milling/exact/within.hpp"
#include "sim/milling/surface/unseen.hpp"

namespace obrys::sim::milling {

namespace {

using geom::Vec3;

constexpr double wanted = 0.7;  ///< of the tolerance: how far from the mesh places looked at may lie, for those between
/// Of the tolerance: how deep in the material the mesh may lie; it is proved to 1.03 times that.
constexpr double wanted_within = 0.95;
constexpr std::size_t some_parts = 150;     ///< of a triangle: what is harder to show to be right is halved
constexpr std::size_t many_parts = 20'000;  ///< of one that could not be halved
/// Tolerances by which the bottom of a groove of a tool's point may be filled in, and listed: no rest material is lost
/// there, and gouges are found by the tool itself.
constexpr double points_left = 2;
constexpr double within_left = 1.25;  ///< tolerances: how deep a place may lie that could not be halved, unsaid
constexpr int most_rounds = 24;

/// The cells that places lie in, and those around them.
class Around {
public:
    Around(const Lattice& lattice, const std::vector<Vec3>& places) : lattice_(lattice) {
        for (const Vec3& p : places) {
            const Place c = cell_of(p);
            if (!is_new(c)) continue;
            for (int dz = -1; dz <= 1; ++dz)
                for (int dy = -1; dy <= 1; ++dy)
                    for (int dx = -1; dx <= 1; ++dx) all_.add(key_of({c[0] + dx, c[1] + dy, c[2] + dz}), 1);
        }
    }
    [[nodiscard]] bool has(Vec3 p) const { return all_.find(key_of(cell_of(p))) != KeyMap::none; }
    [[nodiscard]] Place cell_of(Vec3 p) const {
        Place c{};
        for (int a = 0; a < 3; ++a)  // one aside, so that what lies around has a number
            c[static_cast<std::size_t>(a)] = base::clipped<std::int32_t>(
                std::floor((component(p, a) - component(lattice_.origin, a)) / component(lattice_.step, a)) + 2, 1,
                2'000'000);
        return c;
    }

private:
    [[nodiscard]] bool is_new(const Place& c) {
        const std::size_t before = done_.size();
        done_.add(key_of(c), 1);
        return done_.size() > before;
    }
    const Lattice& lattice_;
    KeyMap done_, all_;
};

/// Of a mesh what lies near places, without vertices that are not needed.
mesh::Mesh part_near(const mesh::Mesh& whole, const Around& around) {
    mesh::Mesh part;
    part.vertices = whole.vertices;
    for (const mesh::Triangle& t : whole.triangles)
        if (around.has(whole.vertices[t[0]]) || around.has(whole.vertices[t[1]]) || around.has(whole.vertices[t[2]]))
            part.triangles.push_back(t);
    return part;
}

std::vector<Unshown> unshown(const mesh::Mesh& whole, const std::vector<Vec3>& places, const Lattice& lattice,
                             double allowed) {
    const Around around(lattice, places);
    const mesh::Distance mesh(part_near(whole, around));
    std::vector<mesh::Nearest> nearest(places.size());
    base::in_pieces(places.size(), 256, [&](const base::Piece& some) {
        for (std::size_t i = some.begin(); i < some.end(); ++i) nearest[i] = mesh.nearest(places[i]);
    });
    std::vector<Unshown> found;
    for (std::size_t i = 0; i < places.size(); ++i)
        if (!(nearest[i].distance <= allowed))
            found.push_back({places[i], std::isfinite(nearest[i].distance) ? nearest[i].at : places[i]});
    return found;
}

/// Cells that were not looked through as fine ones.
std::vector<Place> new_cells(const Fine& fine, KeyMap& known) {
    std::vector<Place> cells;
    for (const Place& c : fine.cells()) {
        const std::size_t before = known.size();
        known.add(key_of(c), 1);
        if (known.size() > before) cells.push_back(c);
    }
    return cells;
}

}  // namespace

void show_all(const Simulation& simulation, const NodeBits& nodes, Exact& exact, Fine& fine,
              base::FunctionRef<mesh::Mesh()> mesh, const Stop& stop) {
    constexpr std::int32_t together = 4, fine_together = 2;  // cells, along each axis
    const double tolerance = simulation.tolerance();
    const Lattice& lattice = exact.lattice();
    std::vector<Vec3> places = rims(simulation, exact, nodes, Sharp::rims);
    const std::vector<Vec3> points = rims(simulation, exact, nodes, Sharp::points);
    KeyMap known;
    std::vector<Place> cells = mixed_cells(nodes);
    WithinMaterial within(exact);
    for (int round = 0; round < most_rounds; ++round) {
        if (stop && stop()) return;
        if (round > 0) cells = new_cells(fine, known);
        const Edges edges = edges_in(cells, exact, tolerance, round == 0 ? together : fine_together, round == 0);
        places.insert(places.end(), edges.places.begin(), edges.places.end());
        std::vector<Unshown> unjudged;
        for (const Vec3& p : edges.unjudged) unjudged.push_back({p, p});
        // Smaller cells have fewer faces about them.
        if (round == 0) unjudged = fine.show(unjudged);
        for (const Unshown& u : unjudged) fine.leave_open(u.at);
        const mesh::Mesh now = mesh();
        std::vector<Unshown> wrong = unshown(now, places, lattice, wanted * tolerance);
        for (const Unshown& u : unshown(now, points, lattice, wanted * tolerance)) wrong.push_back(u);
        for (const Vec3& p : within.places(now, wanted_within * tolerance, some_parts)) wrong.push_back({p, p});
        if (wrong.empty() && (round > 0 || fine.cells().empty())) return;
        const std::vector<Unshown> left = fine.show(wrong);
        if (!wrong.empty() && left.size() == wrong.size()) break;
    }
    const mesh::Mesh now = mesh();
    for (const Unshown& u : unshown(now, places, lattice, tolerance)) fine.leave_open(u.at);
    std::vector<Vec3> filled;
    for (const Unshown& u : unshown(now, points, lattice, tolerance)) filled.push_back(u.at);
    const std::vector<Unshown> beyond = unshown(now, filled, lattice, points_left * tolerance);
    for (const Unshown& u : beyond) fine.leave_open(u.at);
    if (filled.size() > beyond.size())
        for (const Vec3& p : filled) fine.leave_filled(p);
    for (const Vec3& p : within.places(now, within_left * tolerance, many_parts)) fine.leave_open(p);
}

}  // namespace obrys::sim::milling
