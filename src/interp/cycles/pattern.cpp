/// PATTERN DEF and SEL PATTERN: the points at which CYCL CALL PAT calls.

#include "cycles/pattern.hpp"

#include <cmath>

#include "base/codes.hpp"
#include "base/text.hpp"
#include "base/whole.hpp"
#include "interp/cycles/cycles.hpp"
#include "shop/files/heidenhain/views.hpp"

namespace obrys::interp {

namespace codes = base::codes;
using program::FigureRole;

namespace {

using Figure = cycles::Figure;

Figure::Kind kind_of(program::FigureKind k) {
    switch (k) {
        case program::FigureKind::position: return Figure::Kind::position;
        case program::FigureKind::row: return Figure::Kind::row;
        case program::FigureKind::grid: return Figure::Kind::grid;
        case program::FigureKind::frame: return Figure::Kind::frame;
        case program::FigureKind::circle: return Figure::Kind::circle;
        case program::FigureKind::arc: return Figure::Kind::arc;
    }
    return Figure::Kind::position;
}

/// 0, which no pattern may have, for what is no number of points.
int count_of(double v) { return base::whole<int>(v, 1, cycles::most_positions).value_or(0); }

struct Read {
    Figure figure;
    double z = 0;
};

Read read(Reckoning& run, const program::PatternFigure& f, geom::Vec2 before) {
    const double unit = length_unit(run.modal);
    Read r;
    Figure& out = r.figure;
    out.kind = kind_of(f.kind);
    for (const program::FigureSetting& s : f.settings) {
        const double v = number(run, s.value);
        switch (s.role) {
            case FigureRole::x: out.start.x = v * unit + (s.incremental ? before.x : 0); break;
            case FigureRole::y: out.start.y = v * unit + (s.incremental ? before.y : 0); break;
            case FigureRole::z: r.z = v * unit; break;
            case FigureRole::spacing:
            case FigureRole::spacing_x: out.spacing.x = v * unit; break;
            case FigureRole::spacing_y: out.spacing.y = v * unit; break;
            case FigureRole::diameter: out.diameter = v * unit; break;
            case FigureRole::count:
            case FigureRole::columns: out.columns = count_of(v); break;
            case FigureRole::rows: out.rows = count_of(v); break;
            case FigureRole::rotation: out.rotation = v; break;
            case FigureRole::rotation_x: out.rotation_u = v; break;
            case FigureRole::rotation_y: out.rotation_v = v; break;
            case FigureRole::start_angle: out.start_angle = v; break;
            case FigureRole::angle_step: out.angle_step = v; break;
        }
    }
    return r;
}

void add_figures(Cycling& run, const program::Pattern& p) {
    geom::Vec2 before;
    for (const program::PatternFigure& f : p.figures) {
        const Read r = read(run, f, before);
        if (run.stopped) return;
        before = r.figure.start;
        const cycles::Positions positions = cycles::figure_positions(r.figure);
        for (const cycles::Complaint& k : positions.complaints)
            unchecked(run, codes::value_range, f.where, k.text + ": this figure of the pattern is left out");
        if (run.pattern.points.size() + positions.at.size() > cycles::most_positions) {
            alarm(run, codes::value_range, f.where, "the pattern has too many positions");
            return;
        }
        for (const geom::Vec2& at : positions.at) run.pattern.points.push_back({{at.x, at.y, r.z}, NAN});
    }
}

std::string file_name(std::string_view written) {
    std::string name = base::to_upper(base::trim(written));
    if (const auto slash = name.find_last_of("/\\:"); slash != std::string::npos) name.erase(0, slash + 1);
    return name.find('.') == std::string::npos ? name + ".PNT" : name;
}

void add_table(Cycling& run, const std::string& name, const base::Span& where) {
    if (const auto known = run.point_tables.find(name); known != run.point_tables.end()) {
        run.pattern.points = known->second;
        return;
    }
    const shop::HeidenhainTable* table = run.env.files == nullptr ? nullptr : run.env.files->table(name);
    if (table == nullptr) {
        unchecked(run, codes::unknown_value, where,
                  "the point table " + name + " was not found: no cycle is called at its points",
                  "put it beside the program or name its folder with --search");
        return;
    }
    std::vector<CallPattern::Point>& points = run.point_tables[name];
    for (const shop::PatternPoint& p : shop::points_of(*table, *run.diagnostics)) {
        if (p.hidden) continue;
        geom::Vec3 at = p.position;
        if (std::isnan(at.z)) at.z = 0;
        if (std::isnan(at.x) || std::isnan(at.y))
            unchecked(run, codes::unknown_value, p.where, "this point has no place in the plane: it is left out");
        else
            points.push_back({at, p.clearance});
    }
    run.pattern.points = points;
}

}  // namespace

void define_pattern(Cycling& run, const program::Pattern& p) {
    run.pattern = {};
    run.pattern.where = p.where;
    if (p.table != program::no_expr) {
        const Value name = evaluate(run, p.table);
        if (run.stopped) return;
        run.pattern.defined = true;
        add_table(run, file_name(printed(name)), p.where);
        return;
    }
    run.pattern.defined = true;
    if (run.modal.plane != 17) {
        unchecked(run, codes::unsupported, p.where, "PATTERN DEF is for tool axis Z: its points are left out");
        return;
    }
    add_figures(run, p);
}

}  // namespace obrys::interp
