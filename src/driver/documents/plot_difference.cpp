#include "driver/documents/plot_difference.hpp"

#include "driver/compare_programs.hpp"
#include "driver/documents/plot_path.hpp"

namespace obrys::driver {

namespace {

constexpr std::size_t shown_around = 40;  // moves

/// The drawn moves of one program around its move of that number, as moves are compared; `at`: where that one ends.
report::PathPlot plot_of(const ComparedSide& side, std::size_t number, report::PlotPlane plane, double same_place,
                         std::optional<geom::Vec3>& at) {
    PlotOptions options;
    options.plane = plane;
    PathPlotter plotter(options, [](const report::InterpolatedMove&) {});
    compare::Path path(same_place);
    motion::Cursor cursor;
    static_cast<void>(run_anew(side.session, side.request, [&](const cl::Record& record) {
        path.take(record);
        const std::size_t count = path.moves.size();
        path.forget(count - std::min<std::size_t>(count, 1), path.all_items());
        plotter.show(count + shown_around > number && count <= number + shown_around);
        plotter(record);
        const auto step = cursor.take(record);
        if (step && count == number + 1) at = step->to + step->to_stock;
    }));
    return plotter.finish();
}

std::string line_of(const Session& session, const std::optional<base::Span>& at) {
    const std::string name = fs::path(session.program).filename().string();
    if (!at || at->file >= session.sources.size()) return name;
    return fs::path(session.sources[at->file].name).filename().string() + ":" +
           std::to_string(session.sources.position(*at).line);
}

}  // namespace

std::optional<report::PathPlot> plot_difference(const ComparedSide& a, const ComparedSide& b,
                                                const compare::Result& moves, double same_place) {
    const compare::Difference* first = moves.of(compare::Aspect::motion);
    if (first == nullptr) return std::nullopt;
    const bool lathe = a.session.job.machine.kind == shop::MachineKind::lathe;
    const report::PlotPlane plane = lathe ? report::PlotPlane::zx : report::PlotPlane::xy;
    std::optional<geom::Vec3> at_a, at_b;
    report::PathPlot plot = plot_of(a, first->move, plane, same_place, at_a);
    plot.other = plot_of(b, first->move_b, plane, same_place, at_b).moves;
    plot.contour.clear();
    plot.parting = at_a ? at_a : at_b.value_or(geom::Vec3{NAN, NAN, NAN});
    plot.program = line_of(a.session, first->in_a) + " and " + line_of(b.session, first->in_b) +
                   ": the first move that differs, with up to " + std::to_string(shown_around) +
                   " before and behind it";
    plot.difference = "Move " + std::to_string(first->move) + ": " + first->what + ". All figures in mm" +
                      (lathe ? ", X is a radius." : ".");
    return plot;
}

}  // namespace obrys::driver
