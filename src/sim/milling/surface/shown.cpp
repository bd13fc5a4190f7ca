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
/// Of the tolerance: the same of sharp lines, which are looked at all along, and the way within which a line is taken
/// to be as far as its ends; the same of what is left.
constexpr double wanted_sharp = 0.85, wanted_size = 0.1, left_sharp = 0.98, left_size = 0.02;
constexpr std::size_t some_parts = 150;     ///< of a triangle: what is harder to show to be right is halved
constexpr std::size_t many_parts = 20'000;  ///< of one that could not be halved
/// Tolerances by which the bottom of a groove of a tool's point may be filled in, and listed: no rest material is lost
/// there, and gouges are found by the tool itself.
constexpr double points_left = 2;
constexpr double within_left = 1;  ///< tolerances: how deep a place may lie that could not be halved, unsaid
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

/// A mesh where places are asked for.
mesh::Distance mesh_about(const mesh::Mesh& whole, const std::vector<Vec3>& places, const Lattice& lattice) {
    return mesh::Distance(part_near(whole, Around(lattice, places)));
}

Unshown unshown_at(const mesh::Distance& mesh, Vec3 p, const mesh::Nearest& nearest) {
    if (!std::isfinite(nearest.distance)) return {p, p, {p, p, p}};
    return {p, nearest.at, mesh::corners(mesh.mesh(), nearest.triangle)};
}

std::vector<Unshown> unshown(const mesh::Distance& mesh, const std::vector<Vec3>& places, double allowed) {
    std::vector<mesh::Nearest> nearest(places.size());
    base::in_pieces(places.size(), 256, [&](const base::Piece& some) {
        for (std::size_t i = some.begin(); i < some.end(); ++i) nearest[i] = mesh.nearest(places[i]);
    });
    std::vector<Unshown> found;
    for (std::size_t i = 0; i < places.size(); ++i)
        if (!(nearest[i].distance <= allowed)) found.push_back(unshown_at(mesh, places[i], nearest[i]));
    return found;
}

/// Places of sharp lines that a mesh does not show, all along the lines: a line's distance from one triangle is convex,
/// and from the mesh it changes no faster than the way. Else the part is halved.
class SharpSearch {
public:
    SharpSearch(const mesh::Distance& mesh, const Exact& exact, double tolerance, double allowed, double smallest)
        : mesh_(mesh), exact_(exact), tolerance_(tolerance), allowed_(allowed), smallest_(smallest) {}

    void find(const SharpPart& part, std::vector<Unshown>& out) {
        if (!part.joined) last_ = mesh_.nearest(part.from.at);
        const mesh::Nearest from = last_;
        last_ = mesh_.nearest(part.to.at);
        const std::size_t before = out.size();
        if (!(from.distance <= allowed_) && part.from.on_surface && !part.joined) add(part.from.at, from, out);
        if (!(last_.distance <= allowed_) && part.to.on_surface) add(part.to.at, last_, out);
        found_ = out.size() > before;
        halve(part, {part.from.at, from}, {part.to.at, last_}, out);
    }

private:
    struct End {
        Vec3 at;
        mesh::Nearest nearest;
    };
    void add(Vec3 p, const mesh::Nearest& nearest, std::vector<Unshown>& out) const {
        out.push_back(unshown_at(mesh_, p, nearest));
    }
    [[nodiscard]] double from_triangle(Vec3 p, const mesh::Nearest& of) const {
        return mesh::nearest_on_triangle(p, mesh::corners(mesh_.mesh(), of.triangle)).distance;
    }
    [[nodiscard]] bool is_shown(const SharpPart& part, const End& a, const End& b, double way) const {
        const double bend = part.bend(a.at, b.at), first = a.nearest.distance, last = b.nearest.distance;
        if (first + last + way + 2 * bend <= 2 * allowed_) return true;
        if (first + bend <= allowed_ && from_triangle(b.at, a.nearest) + bend <= allowed_) return true;
        return last + bend <= allowed_ && from_triangle(a.at, b.nearest) + bend <= allowed_;
    }
    void halve(const SharpPart& part, const End& a, const End& b, std::vector<Unshown>& out) {
        const double way = geom::distance(a.at, b.at);
        if (!(way > (found_ ? tolerance_ : smallest_)) || is_shown(part, a, b, way)) return;
        End middle{part.middle(a.at, b.at), {}};
        middle.nearest = mesh_.nearest(middle.at);
        if (!(middle.nearest.distance <= allowed_) && is_sharp_place(exact_, part.cell, middle.at, tolerance_))
            add(middle.at, middle.nearest, out), found_ = true;
        halve(part, a, middle, out);
        halve(part, middle, b, out);
    }

    const mesh::Distance& mesh_;
    const Exact& exact_;
    double tolerance_ = 0, allowed_ = 0, smallest_ = 0;
    mesh::Nearest last_;
    bool found_ = false;  ///< what halving begins with, if anything, is found: no finer than the tolerance is looked
};

std::vector<Unshown> unshown(const mesh::Distance& mesh, const std::vector<SharpPart>& parts, const Exact& exact,
                             double tolerance, double allowed, double smallest) {
    // Lines are not cut apart where they join.
    constexpr std::size_t many = 64;
    std::vector<std::size_t> first{0};
    for (std::size_t i = 1; i < parts.size(); ++i)
        if (i - first.back() >= many && !parts[i].joined) first.push_back(i);
    std::vector<std::vector<Unshown>> found(first.size());
    base::for_all(parts.empty() ? 0 : first.size(), [&](std::size_t n) {
        SharpSearch search(mesh, exact, tolerance, allowed, smallest);
        const std::size_t end = n + 1 < first.size() ? first[n + 1] : parts.size();
        for (std::size_t i = first[n]; i < end; ++i) search.find(parts[i], found[n]);
    });
    std::vector<Unshown> all;
    for (const std::vector<Unshown>& f : found) all.insert(all.end(), f.begin(), f.end());
    return all;
}

std::vector<Vec3> with_ends(std::vector<Vec3> places, const std::vector<SharpPart>& parts) {
    for (const SharpPart& p : parts) {
        if (!p.joined) places.push_back(p.from.at);
        places.push_back(p.to.at);
    }
    return places;
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
    const std::vector<SharpPart> rim_lines = rims(simulation, exact, nodes, Sharp::rims),
                                 point_lines = rims(simulation, exact, nodes, Sharp::points);
    const auto sharp = [&](const mesh::Distance& now, const std::vector<SharpPart>& lines, double share, double size) {
        return unshown(now, lines, exact, tolerance, share * tolerance, size * tolerance);
    };
    std::vector<Vec3> places;
    KeyMap known;
    std::vector<Place> cells = mixed_cells(nodes);
    WithinMaterial within(exact);
    for (int round = 0; round < most_rounds; ++round) {
        if (stop && stop()) return;
        if (round > 0) cells = new_cells(fine, known);
        const Edges edges = edges_in(cells, exact, tolerance, round == 0 ? together : fine_together, round == 0);
        places.insert(places.end(), edges.places.begin(), edges.places.end());
        std::vector<Unshown> unjudged;
        for (const Vec3& p : edges.unjudged) unjudged.push_back({p, p, {p, p, p}});
        // Smaller cells have fewer faces about them.
        if (round == 0) unjudged = fine.show(unjudged);
        for (const Unshown& u : unjudged) fine.leave_open(u.at);
        const mesh::Mesh now = mesh();
        const mesh::Distance about = mesh_about(now, with_ends(with_ends(places, rim_lines), point_lines), lattice);
        std::vector<Unshown> wrong = unshown(about, places, wanted * tolerance);
        for (const auto* lines : {&rim_lines, &point_lines})
            for (const Unshown& u : sharp(about, *lines, wanted_sharp, wanted_size)) wrong.push_back(u);
        for (const WithinMaterial::Deep& d : within.places(now, wanted_within * tolerance, some_parts))
            wrong.push_back({d.at, d.at, d.triangle});
        if (wrong.empty() && (round > 0 || fine.cells().empty())) return;
        const std::vector<Unshown> left = fine.show(wrong);
        if (!wrong.empty() && left.size() == wrong.size()) break;
    }
    const mesh::Mesh now = mesh();
    const mesh::Distance about = mesh_about(now, with_ends(with_ends(places, rim_lines), point_lines), lattice);
    for (const Unshown& u : unshown(about, places, tolerance)) fine.leave_open(u.at);
    for (const Unshown& u : sharp(about, rim_lines, left_sharp, left_size)) fine.leave_open(u.at);
    for (const Unshown& u : sharp(about, point_lines, left_sharp, left_size))
        if (geom::distance(u.at, u.nearest) > points_left * tolerance)
            fine.leave_open(u.at);
        else
            fine.leave_filled(u.at);
    for (const WithinMaterial::Deep& d : within.places(now, within_left * tolerance, many_parts)) fine.leave_open(d.at);
}

}  // namespace obrys::sim::milling
