/// A contour at a distance, and finishing passes along it (LinuxCNC G70).

#include <algorithm>
#include <cmath>

#include "cycles/turn/path.hpp"
#include "cycles/turn/profile.hpp"
#include "cycles/turn/rough.hpp"

namespace obrys::cycles {

using geom::Vec2;

namespace {

using Pieces = std::vector<Piece>;

constexpr int most_rounds = 10'000;           ///< of shifting
constexpr std::size_t most_joints = 200'000;  ///< over all pieces and rounds
const char* const vanished = "the contour vanishes at this distance";

/// Arcs where the shifted pieces have moved apart.
void fill_gaps(Pieces& v, double step, int turn) {
    for (std::size_t i = 0; i + 1 < v.size(); ++i) {
        if (v[i].to.x - v[i + 1].from.x <= profile::gap) continue;
        Piece a = v[i], b = v[i + 1];
        shift_sideways(a, -step);
        shift_sideways(b, -step);
        const Piece arc{v[i].to, v[i + 1].from, 0.5 * (a.to + b.from), turn, Corner::none, 0};
        v.insert(v.begin() + std::ptrdiff_t(i) + 1, arc);
        ++i;
    }
}

/// Joins neighbours; pieces that turned round or shrank to nothing are dropped, and it begins anew as the control does:
/// after a dropped short piece with the second one.
Fault join_all(Pieces& v) {
    std::size_t joints = 0;
    for (std::size_t i = 0; i + 1 < v.size(); ++i) {
        if (++joints > most_joints) return "the contour cannot be joined at this distance";
        if (!falls(v[i])) {
            if (i == 0) return vanished;
            const std::size_t out = extent(v[i]) < extent(v[i - 1]) ? i : i - 1;
            v.erase(v.begin() + std::ptrdiff_t(out));
            i = 0;
            if (v.size() < 2) return vanished;
        }
        if (extent(v[i]) < profile::slack) {
            v.erase(v.begin() + std::ptrdiff_t(i));
            i = 0;
        } else if (const Fault f = join(v[i], v[i + 1])) {
            return f;
        }
    }
    return std::nullopt;
}

/// One step of shifting; less than half of the smallest extent, so that no arc turns inside out.
Fault shift_all(Pieces& v, double step, int turn) {
    for (Piece& piece : v) shift_sideways(piece, step);
    v.erase(std::remove_if(v.begin(), v.end(), [](const Piece& q) { return extent(q) < profile::slack; }), v.end());
    if (v.empty()) return vanished;
    fill_gaps(v, step, turn);
    return join_all(v);
}

Fault shift_contour(Pieces& v, double distance) {
    double done = 0;
    for (int round = 0; done != distance; ++round) {
        if (round > most_rounds || v.size() > most_joints / 10) return vanished;
        double step = std::abs(distance - done);
        for (const Piece& piece : v) step = std::min(step, extent(piece) / 2);
        if (distance < 0) step = -step;
        if (const Fault f = shift_all(v, step, distance > 0 ? 1 : -1)) return f;
        done += step;
    }
    return std::nullopt;
}

bool finite(const Piece& p) {
    return std::isfinite(p.from.x + p.from.y + p.to.x + p.to.y + (p.turn != 0 ? p.centre.x + p.centre.y : 0));
}

}  // namespace

Fault keep_distance(Profile& p, double distance) {
    Pieces& v = p.pieces;
    if (v.size() < 2) return vanished;
    Piece first = v.front();
    if (geom::cross(v.back().from - first.from, first.to - first.from) < 0) distance = -distance;
    v.erase(v.begin());
    if (const Fault f = shift_contour(v, distance)) return f;
    for (std::size_t i = 0; i + 1 < v.size(); ++i) v[i].to = v[i + 1].from = 0.5 * (v[i].to + v[i + 1].from);
    first.to = v.front().from;
    v.insert(v.begin(), first);
    if (!std::all_of(v.begin(), v.end(), finite)) return vanished;
    return std::nullopt;
}

namespace {

/// Lays the contour for finishing: a quarter turn where it does not run in one direction along the axis.
Fault lay_for_finishing(Profile& p) {
    Profile alone = p;
    alone.pieces.erase(alone.pieces.begin());
    if (alone.pieces.empty()) return vanished;
    alone.lay();
    if (!std::all_of(alone.pieces.begin(), alone.pieces.end(), falls)) {
        alone.turn_quarter();
        alone.lay();
    }
    if (const Fault f = check_falling(alone)) return f;
    if (alone.quarter_turn) p.turn_quarter();
    p.lay();
    if (const Fault f = finish_corners(p)) return f;
    return check_falling(p);
}

}  // namespace

void write_steps(TurningPath& path, const OffsetFinishing& d, const TurningDemand& demand) {
    Course& c = path.course();
    const ContourStart start = start_of(path, d, demand);
    const double first = d.allowance_first.value_or(0) / start.unit;
    const double last = d.allowance_last.value_or(0) / start.unit;
    const double passes = whole_passes(c, Role::passes, d.passes, 1);
    if (!c.ready()) return;
    path.rapid(start.at);
    Profile p = profile_of(demand.contour, start.at, start.unit);
    if (p.pieces.size() <= 1) return;
    if (const Fault f = lay_for_finishing(p)) return c.fault(*f);
    ProfilePath out(path, p, start.unit);
    const double count = d.passes.value_or(1);
    for (double pass = passes; pass > 0 && c.room(); pass -= 1) {
        Profile now = p;
        if (const Fault f = keep_distance(now, (pass - 1) * (first - last) / count + last)) return c.fault(*f);
        out.rapid(now.pieces.front().from);
        out.rapid(now.pieces.front().to);
        for (std::size_t i = 1; i < now.pieces.size(); ++i) out.along(now.pieces[i]);
    }
}

}  // namespace obrys::cycles
