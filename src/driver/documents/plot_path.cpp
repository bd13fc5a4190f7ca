#include "driver/documents/plot_path.hpp"

#include <algorithm>
#include <cmath>

#include "base/whole.hpp"
#include "cl/path_element.hpp"
#include "cl/spline.hpp"
#include "cl/totals.hpp"

namespace obrys::driver {

namespace {

constexpr double chord = 0.005;    ///< mm a drawn curve may leave the true one
constexpr double drawable = 1e9;   ///< mm; what lies farther out is no place on a machine
constexpr int chords = 256;        ///< of one move, at most
constexpr double near_units = 12;  ///< half the side of the square that the detail shows, in basic length units
constexpr std::size_t near_points = 2000;

const char* kind_of(const cl::Step& step) {
    if (std::holds_alternative<cl::Arc>(step)) return "arc";
    if (std::holds_alternative<cl::Spline>(step)) return "spline";
    return std::holds_alternative<cl::Thread>(step) ? "thread" : "linear";
}

/// Keeps the largest excursion to either side of each piece of an element.
class Sides {
public:
    Sides(geom::Vec3 start, report::PlotPlane plane, geom::Vec3 shift, report::PlotMove& out, int pieces)
        : ideal_(start), plane_(plane), shift_(shift), out_(out), pieces_(pieces) {}

    void add(const geom::GridStep& s) {
        const geom::Vec2 off = report::project(plane_, s.at - s.ideal);
        const geom::Vec2 way = report::project(plane_, s.ideal - ideal_);
        if (way.x != 0 || way.y != 0) along_ = way;
        ideal_ = s.ideal;
        const int piece = base::clipped<int>(s.u * pieces_, 0, pieces_);
        const bool left = geom::cross(along_, off) > 0;
        Last& last = left ? left_ : right_;
        auto& chain = left ? out_.left : out_.right;
        const double size = geom::length(off);
        if (last.piece == piece && size <= last.size) return;
        if (last.piece != piece) chain.emplace_back();
        last = {piece, size};
        chain.back() = {report::project(plane_, s.ideal + shift_), off};
    }

private:
    struct Last {
        int piece = -1;
        double size = 0;
    };
    geom::Vec3 ideal_;  ///< of the last step
    geom::Vec2 along_;
    report::PlotPlane plane_;
    geom::Vec3 shift_;
    report::PlotMove& out_;
    int pieces_;
    Last left_, right_;
};

}  // namespace

PathPlotter::PathPlotter(const PlotOptions& options, Rows rows) : options_(options), rows_(rows) {
    plot_.plane = options.plane;
    sums_.unit = options.unit;
}

void PathPlotter::operator()(const cl::Record& record) {
    const auto step = cursor_.take(record);
    if (const auto* element = std::get_if<cl::Programmed>(&record.step)) programmed(*element);
    if (!step) return;
    const double length = cl::move_length(step->from, record.step);
    if (std::isfinite(length)) (step->rapid ? plot_.rapid_length : plot_.feed_length) += length;
    const bool drawn = draw(*step);
    if (options_.unit > 0) {
        if (step->rapid)
            ++sums_.rapids;
        else
            interpolate(*step, drawn ? &plot_.moves.back() : nullptr);
    }
    plot_.all_moves = cursor_.moves();
}

/// The contour where the tool's path is another one.
void PathPlotter::programmed(const cl::Programmed& element) {
    if (!shown_ || element.rapid || plot_.contour.size() >= options_.keep_moves) return;
    const geom::Vec3 by = cursor_.position().to_stock(), from = element.from, to = element.to;
    if (!geom::is_finite(from + by) || !geom::is_finite(to + by) || geom::length(from) + geom::length(to) > drawable)
        return;
    report::PlotMove m;
    m.points.push_back(from + by);
    if (element.sweep != 0)
        cl::points_between(from, cl::Arc{to, element.centre, element.normal, element.sweep}, chord, chords,
                           [&](geom::Vec3 p) { m.points.push_back(p + by); });
    m.points.push_back(to + by);
    plot_.contour.push_back(std::move(m));
}

/// True where the move is in the picture.
bool PathPlotter::draw(const motion::Step& step) {
    if (!shown_ || plot_.moves.size() + plot_.unplaced_moves >= options_.keep_moves) return false;
    report::PlotMove m;
    m.rapid = step.rapid;
    const geom::Vec3 by = step.to_stock, from = step.from, to = step.to;
    const geom::Vec2 first = report::project(options_.plane, from + by),
                     last = report::project(options_.plane, to + by);
    const double far = std::abs(first.x) + std::abs(first.y) + std::abs(last.x) + std::abs(last.y);
    if (!(far < drawable)) {  // NaN neither
        ++plot_.unplaced_moves;
        return false;
    }
    m.points.push_back(from + by);
    cl::points_between(from, step.record.step, chord, chords, [&](geom::Vec3 p) { m.points.push_back(p + by); });
    m.points.push_back(to + by);
    plot_.moves.push_back(std::move(m));
    return true;
}

void PathPlotter::interpolate(const motion::Step& step, report::PlotMove* drawn) {
    const cl::Record& record = step.record;
    report::InterpolatedMove row{
        step.index, record.from, kind_of(record.step), cl::move_length(step.from, record.step), {}};
    const auto element = cl::element_of(step.from, record.step);
    if (element) {
        const int pieces = plot_.moves.size() < 1000 ? 128 : 12;
        report::PlotMove unused;
        Sides sides(geom::point_at(*element, 0), options_.plane, step.to_stock, drawn != nullptr ? *drawn : unused,
                    pieces);
        const auto add = [&](const geom::GridStep& s) {
            if (drawn != nullptr) sides.add(s);
        };
        row.figures = geom::staircase(*element, options_.unit, add, options_.most_steps - steps_run_);
    }
    const geom::Staircase& f = row.figures;
    steps_run_ += f.steps;
    switch (f.end_reason) {
        case geom::StaircaseEnd::not_known: ++sums_.not_known; break;
        case geom::StaircaseEnd::too_long: ++sums_.not_run; break;
        case geom::StaircaseEnd::reached:
            ++sums_.moves;
            sums_.steps += f.steps;
            sums_.sum += f.mean * static_cast<double>(f.steps + 1);
            sums_.length += row.length;
            sums_.largest = std::max(sums_.largest, f.largest);
            // Of moves that differ by rounding only, the first one is shown.
            if (sums_.moves == 1 || f.largest > sums_.worst.figures.largest + 1e-6 * options_.unit) {
                sums_.worst = row;
                worst_ = *element;
                worst_shift_ = step.to_stock;
            }
            break;
    }
    rows_(row);
}

/// The staircase next to the largest deviation, by running its element once more.
void PathPlotter::look_closer() {
    const geom::Staircase& f = sums_.worst.figures;
    const auto flat = [&](geom::Vec3 p) { return report::project(options_.plane, p + worst_shift_); };
    sums_.place = flat(f.worst.at);
    if (!std::isfinite(sums_.place.x + sums_.place.y)) return;
    const double half = near_units * options_.unit;
    const auto is_near = [&](geom::Vec2 p) {
        return std::abs(p.x - sums_.place.x) <= half && std::abs(p.y - sums_.place.y) <= half;
    };
    double low = 0, high = 0;  // parameters of the chain in work
    std::size_t points = 0;
    bool inside = false;
    const auto end_chain = [&] {
        if (!inside) return;
        sums_.ideal.emplace_back();
        for (int i = 0; i <= 100; ++i)
            sums_.ideal.back().push_back(flat(geom::point_at(worst_, low + (high - low) * i / 100)));
        inside = false;
    };
    const auto add = [&](geom::Vec3 at, double u) {
        const geom::Vec2 p = flat(at);
        if (!is_near(p) || points == near_points) return end_chain();
        if (!inside) {
            sums_.stairs.emplace_back();
            low = u;
        }
        inside = true;
        high = u;
        sums_.stairs.back().push_back(p);
        ++points;
    };
    add(f.start, 0);
    static_cast<void>(geom::staircase(worst_, options_.unit, [&](const geom::GridStep& s) { add(s.at, s.u); }));
    end_chain();
}

report::PathPlot PathPlotter::finish() {
    if (options_.unit > 0) {
        if (sums_.moves > 0) look_closer();
        plot_.interpolation = std::move(sums_);
    }
    return std::move(plot_);
}

}  // namespace obrys::driver
