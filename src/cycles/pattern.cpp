#include "cycles/pattern.hpp"

#include <cmath>
#include <string>
#include <utility>

#include "base/whole.hpp"
#include "cycles/course.hpp"
#include "cycles/names.hpp"

namespace obrys::cycles {

namespace {

using geom::Vec2;

/// Exact for quarter turns.
Vec2 direction(double degrees) {
    const double quarters = std::remainder(degrees, 360) / 90;
    if (quarters == std::round(quarters)) {
        constexpr Vec2 axes[4] = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}};
        return axes[(base::clipped<int>(quarters, -2, 2) + 4) % 4];
    }
    const double a = geom::radians(degrees);
    return {std::cos(a), std::sin(a)};
}

void complain(Positions& p, std::string text, std::optional<Role> role = {}) {
    p.complaints.push_back({true, std::move(text), {}, role});
}

double read(const Demand& d, Role role, Positions& p) {
    const double value = d.get(role);
    if (!std::isfinite(value))
        complain(p, std::string(name(role)) + (d.find(role) ? " is not known" : " is not given"), role);
    return value;
}

double maybe(const Demand& d, Role role, double otherwise, Positions& p) {
    return d.find(role) ? read(d, role, p) : otherwise;
}

int read_number(const Demand& d, Role role, Positions& p) {
    const double value = read(d, role, p);
    if (const auto n = base::whole<int>(value, 1, most_positions)) return *n;
    if (std::isfinite(value)) complain(p, std::string(name(role)) + " must be a whole number from 1 on", role);
    return 0;
}

/// Lines of points, every second one backwards.
void add_grid(Positions& p, Vec2 start, Vec2 along, Vec2 across, int columns, int rows) {
    for (int r = 0; r < rows; ++r)
        for (int k = 0; k < columns; ++k) {
            const int column = r % 2 == 0 ? k : columns - 1 - k;
            p.at.push_back(start + double(column) * along + double(r) * across);
        }
}

void add_circle(Positions& p, Vec2 centre, double radius, double first, double step, int count) {
    for (int k = 0; k < count; ++k) p.at.push_back(centre + radius * direction(first + k * step));
}

bool too_many(int columns, int rows) { return std::int64_t(columns) * rows > most_positions; }

Positions on_circle(const Demand& d) {
    Positions p;
    p.centre = {read(d, Role::centre_u, p), read(d, Role::centre_v, p)};
    const double diameter = read(d, Role::pitch_circle, p);
    if (diameter < 0) complain(p, "the pitch circle diameter must not be negative", Role::pitch_circle);
    const double first = read(d, Role::start_angle, p);
    const int count = read_number(d, Role::count, p);
    double step = maybe(d, Role::angle_step, 0, p);
    if (step == 0) {
        const double range = read(d, Role::end_angle, p) - first;
        const double turns = range / 360;
        const bool full = range != 0 && std::abs(turns - std::round(turns)) < 1e-9;
        if (range == 0 && count > 1)
            complain(p, "starting and stopping angle are equal", Role::end_angle);
        else
            step = full ? range / count : range / std::max(1, count - 1);
    }
    if (p.ok()) add_circle(p, p.centre, diameter / 2, first, step, count);
    return p;
}

Positions on_lines(const Demand& d) {
    Positions p;
    const Vec2 start{read(d, Role::start_u, p), read(d, Role::start_v, p)};
    const double along = read(d, Role::spacing_u, p), across = read(d, Role::spacing_v, p);
    const int columns = read_number(d, Role::columns, p), rows = read_number(d, Role::rows, p);
    const Vec2 u = direction(maybe(d, Role::rotation, 0, p));
    if (too_many(columns, rows)) complain(p, "the pattern has too many positions", Role::columns);
    if (p.ok()) add_grid(p, start, along * u, across * geom::left_of(u), columns, rows);
    return p;
}

/// Round the border of a grid, counter-clockwise from its first point.
void add_frame(Positions& p, Vec2 start, Vec2 along, Vec2 across, int columns, int rows) {
    const auto point = [&](int c, int r) { return start + double(c) * along + double(r) * across; };
    for (int c = 0; c < columns; ++c) p.at.push_back(point(c, 0));
    for (int r = 1; r < rows; ++r) p.at.push_back(point(columns - 1, r));
    if (rows > 1)
        for (int c = columns - 2; c >= 0; --c) p.at.push_back(point(c, rows - 1));
    if (columns > 1)
        for (int r = rows - 2; r > 0; --r) p.at.push_back(point(0, r));
}

bool known(const Figure& f) {
    return std::isfinite(f.start.x + f.start.y + f.spacing.x + f.spacing.y + f.diameter + f.rotation + f.rotation_u +
                         f.rotation_v + f.start_angle + f.angle_step);
}

}  // namespace

bool Positions::ok() const {
    for (const Complaint& c : complaints)
        if (c.fatal) return false;
    return true;
}

Positions pattern_positions(const Demand& demand) {
    Positions p = demand.kind == cl::CycleKind::pattern_circle ? on_circle(demand) : on_lines(demand);
    p.at_second_clearance = demand.get(Role::move_at_clearance, 1) != 0;
    p.along_circle = demand.kind == cl::CycleKind::pattern_circle && demand.get(Role::traverse, 0) == 1;
    return p;
}

Positions figure_positions(const Figure& f) {
    Positions p;
    p.centre = f.start;
    if (!known(f)) complain(p, "a value of the pattern is not known");
    if (f.columns < 1 || f.rows < 1 || too_many(f.columns, f.rows))
        complain(p, "the number of positions must be a whole number from 1 on, and not too large");
    if (!p.ok()) return p;
    const Vec2 along = f.spacing.x * direction(f.rotation + f.rotation_u);
    const Vec2 across = f.spacing.y * geom::left_of(direction(f.rotation + f.rotation_v));
    switch (f.kind) {
        case Figure::Kind::position: p.at.push_back(f.start); break;
        case Figure::Kind::row: add_grid(p, f.start, along, {}, f.columns, 1); break;
        case Figure::Kind::grid: add_grid(p, f.start, along, across, f.columns, f.rows); break;
        case Figure::Kind::frame: add_frame(p, f.start, along, across, f.columns, f.rows); break;
        case Figure::Kind::circle:
            add_circle(p, f.start, f.diameter / 2, f.start_angle, 360.0 / f.columns, f.columns);
            break;
        case Figure::Kind::arc: add_circle(p, f.start, f.diameter / 2, f.start_angle, f.angle_step, f.columns); break;
    }
    return p;
}

}  // namespace obrys::cycles
