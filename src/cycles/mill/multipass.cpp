/// Surfaces in passes. Source: HEIDENHAIN iTNC 530 cycle programming, multipass milling (230, 231, 232); 231 also TNC
/// 410 ISO programming, 8.8; 232 also TNC 640 cycle programming, 10.4. How the passes lie across the width the texts do
/// not say: the edges of the tool advance in equal steps, the last one reaches the surface's edge
/// (Expansion::assumption).

#include <algorithm>
#include <cmath>

#include "base/whole.hpp"

#include "cycles/mill/families.hpp"

namespace obrys::cycles {

namespace {

using geom::Vec3;

constexpr int most_surface_passes = 20'000;

double sign(double value) { return value < 0 ? -1 : 1; }

/// A whole number of cuts from 1 on.
int cuts_of(Course& c, double cuts) {
    if (cuts < 1 || cuts > most_surface_passes || (std::isfinite(cuts) && cuts != std::floor(cuts)))
        c.fault(Role::passes, "the number of cuts must be a whole number from 1 on");
    return c.ready() ? base::clipped<int>(cuts, 0, most_surface_passes) : 0;
}

struct Face {
    Vec3 start;
    double length = 0, width = 0;
    double floor = 0;  ///< absolute w of the last level
    double rough = 0;  ///< absolute w of the last roughing level
    double infeed = 0, feed = 0, finish = 0, positioning = 0;
    double clearance = 0, second = 0, side = 0;
    double radius = 0;  ///< of the tool
    int strategy = 0, passes = 1;

    /// v of a pass; its far edge advances by equal steps.
    [[nodiscard]] double v(int i) const { return start.y + width * (i + 1) / passes - sign(width) * radius; }
    [[nodiscard]] double outside(bool far) const {
        const double over = sign(length) * (radius + side);
        return far ? start.x + length + over : start.x - over;
    }
    [[nodiscard]] double inside(bool far) const {
        if (std::abs(length) < 2 * radius) return start.x + length / 2;  // the tool covers the whole length
        const double in = sign(length) * radius;
        return far ? start.x + length - in : start.x + in;
    }
};

void take_passes(Course& c, Face& f, double overlap, double corner_radius) {
    if (overlap >= 2) c.fault(Role::overlap, "the path overlap factor must be below 2");
    const double flat = f.radius - corner_radius;
    if (flat <= 0) c.fault("face milling needs a tool with a flat front");
    const double passes = std::ceil(std::abs(f.width) / (overlap * flat) - 1e-9);
    if (passes > most_surface_passes) c.fault(Role::overlap, "the path overlap is too small for the width");
    if (c.ready()) f.passes = base::clipped<int>(passes, 1, most_surface_passes);
}

Face face_of(Course& c, const FaceMilling& d, const Situation& s) {
    Face f;
    f.start = {d.start_u, d.start_v, d.start_w};
    f.length = d.length;
    f.width = d.width;
    f.floor = d.end_surface;
    const double allowance = d.allowance_floor.value_or(0);
    f.rough = f.floor + allowance;
    f.infeed = d.infeed;
    f.feed = d.feed_mill;
    f.finish = allowance > 0 ? asked(c, d, &FaceMilling::feed_finish, Must::be_feed) : f.feed;
    f.positioning = d.feed_position;
    f.clearance = d.clearance;
    f.second = f.start.z + std::max(f.clearance, d.second_clearance.value_or(0));
    f.side = d.side_clearance.value_or(0);
    if (d.strategy != 0 && d.strategy != 1 && d.strategy != 2)
        c.fault(Role::strategy, "the strategy must be 0, 1 or 2");
    f.radius = c.tool_radius(s);
    c.known(s.at.z, "the tool's height");
    const double corner = c.known(s.tool_corner_radius, "the tool's corner radius");
    if (f.start.z < f.floor) c.fault(Role::end_surface, "the end point lies above the starting point in the tool axis");
    if (f.start.z == f.floor) c.not_executed(Role::end_surface);
    if (c.ready()) f.strategy = base::clipped<int>(d.strategy, 0, 2);
    if (c.ready()) take_passes(c, f, d.overlap, corner);
    return f;
}

/// Levels from the start down to the floor: equal roughing infeeds, then the allowance.
std::vector<double> face_levels(Course& c, const Face& f) {
    std::vector<double> levels;
    const double height = std::max(0.0, f.start.z - f.rough);
    const double count = std::ceil(height / f.infeed - 1e-9);
    if (count * f.passes > double(most_steps) / 4) {
        c.fault(Role::infeed, "the infeed is too small for the height");
        return levels;
    }
    const int last = base::clipped<int>(count, 0, most_steps);
    for (int i = 1; i <= last; ++i) levels.push_back(i == last ? f.rough : f.start.z - height * i / count);
    if (f.rough > f.floor) levels.push_back(f.floor);
    return levels;
}

/// Back and forth; `far` is the side where the tool stands. Strategy 1 stays within the surface between the passes.
void meander(Course& c, const Face& f, double w, double feed, bool backwards, bool& far) {
    for (int i = 0; i < f.passes; ++i) {
        const double v = f.v(backwards ? f.passes - 1 - i : i);
        if (i > 0) c.move({c.at().x, v, w}, f.strategy == 1 ? feed : f.positioning);
        far = !far;
        const bool last = i + 1 == f.passes;
        c.move({f.strategy == 1 && !last ? f.inside(far) : f.outside(far), v, w}, feed);
    }
}

/// All passes in one direction, lifted in between.
void one_way(Course& c, const Face& f, double w, double feed) {
    for (int i = 0; i < f.passes; ++i) {
        if (i > 0 || c.at().x != f.outside(false)) {
            c.move_w(w + f.clearance, f.positioning);
            c.move({f.outside(false), f.v(i), w + f.clearance}, f.positioning);
        }
        c.move_w(w, f.positioning);
        c.move({f.outside(true), f.v(i), w}, feed);
    }
}

}  // namespace

void write_steps(Course& c, const Multipass& d, const Situation& s) {
    const Vec3 start{d.start_u, d.start_v, d.start_w};
    const double length = d.length, width = d.width, r = c.tool_radius(s);
    c.known(s.at.z, "the tool's height");
    const int cuts = cuts_of(c, d.passes);
    if (!c.ready()) return;
    c.assume("the passes across the width: equal steps from edge to edge of the surface");
    const double above = start.z + d.clearance, su = sign(length), sv = sign(width);
    const double near = start.x - su * r, far = start.x + length + su * r;
    // The tool's edge lies on the surface's edge in the first and in the last pass.
    const double across = std::abs(width) > 2 * r && cuts > 1 ? (width - sv * 2 * r) / (cuts - 1) : 0;
    const auto pass_v = [&](int i) { return start.y + sv * r + i * across; };
    c.rapid_w(std::max(above, s.at.z));
    c.rapid({near, pass_v(0), c.at().z});
    c.rapid_w(above);
    c.move_w(start.z, d.feed_plunge);
    for (int i = 0; i < cuts; ++i) {
        if (i > 0) c.move({c.at().x, pass_v(i), start.z}, d.feed_step);
        c.move({i % 2 == 0 ? far : near, c.at().y, start.z}, d.feed_mill);
    }
    c.rapid_w(above);
}

void write_steps(Course& c, const RuledSurface& d, const Situation& s) {
    const Vec3 p1{d.start_u, d.start_v, d.start_w}, p2{d.second_u, d.second_v, d.second_w};
    const Vec3 p3{d.third_u, d.third_v, d.third_w}, p4{d.fourth_u, d.fourth_v, d.fourth_w};
    const double mill = d.feed_mill, diameter = 2 * c.tool_radius(s);
    c.known(s.at.z, "the tool's height");
    const int cuts = cuts_of(c, d.passes);
    if (!c.ready()) return;
    const double highest = std::max({p1.z, p2.z, p3.z, p4.z});
    c.move(p1, mill);
    for (int i = 0; i < cuts; ++i) {
        const double t = cuts > 1 ? double(i) / (cuts - 1) : 0;
        const Vec3 from = p1 + t * (p4 - p1), to = p2 + t * (p3 - p2);
        c.move(from, mill);
        c.move(to, i == 0 && std::isfinite(mill) ? mill / 2 : mill);  // the first pass at half the feed
        if (i + 1 == cuts) break;
        c.rapid_w(std::max(to.z, from.z) + diameter);
        c.rapid({from.x, from.y, c.at().z});
        c.rapid(from);
    }
    c.rapid_w(highest + diameter);
}

void write_steps(Course& c, const FaceMilling& d, const Situation& s) {
    const Face f = face_of(c, d, s);
    if (!c.ready()) return;
    const auto levels = face_levels(c, f);
    if (!c.ready()) return;
    if (f.passes > 1) c.assume("the passes across the width: equal steps up to the surface's edge");
    c.rapid_w(std::max(s.at.z, f.second));
    c.rapid({f.outside(false), f.v(0), c.at().z});
    c.rapid_w(f.second);
    bool far = false, backwards = false;
    for (const double w : levels) {
        const double feed = f.rough > f.floor && w == f.floor ? f.finish : f.feed;
        if (f.strategy == 2) {
            one_way(c, f, w, feed);
            continue;
        }
        c.move_w(w, f.positioning);
        meander(c, f, w, feed, backwards, far);
        backwards = !backwards;
    }
    c.rapid_w(f.second);
}

}  // namespace obrys::cycles
