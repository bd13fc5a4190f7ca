#include "report/engagement_table.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>

#include "base/number.hpp"
#include "base/text.hpp"
#include "check/engagement.hpp"

namespace obrys::report {

namespace {

constexpr int table_decimals = 6;

/// The figures of a row, in the order of `names`.
constexpr std::array figure_names{"seconds",           "speed_rpm",       "feed_mm_per_min", "volume_mm3", "contact_mm",
                                  "axial_depth_mm",    "reach_mm",        "radial_depth_mm", "from_deg",   "to_deg",
                                  "feed_per_tooth_mm", "chip_largest_mm", "chip_mean_mm"};
using Figures = std::array<double, figure_names.size()>;

Figures figures_of(const check::MilledMove& m, const check::EdgeEngagement& e) {
    return {m.seconds,        m.speed_rpm,    m.feed_mm_per_min, m.volume_mm3,          m.contact_length_mm,
            m.axial_depth_mm, m.reach_mm,     e.radial_depth,    geom::degrees(e.from), geom::degrees(e.to),
            e.feed_per_tooth, e.chip_largest, e.chip_mean};
}

/// Where a move comes from; runs of moves come from the same place.
struct RowPlace {
    base::Span span = check::nowhere;
    std::string file;
    std::uint32_t line = 0;
    std::optional<std::uint32_t> block;
};

/// Goes through the moves; a tool's edges are made once.
class Rows {
public:
    explicit Rows(const Subject& s) : subject_(s) {
        const geom::Vec3 step = s.result.milled->figures.step;
        rays_ = std::max({step.x, step.y, step.z});
        for (const check::ToolUse& t : s.result.tools)
            edges_.emplace_back(t.listed ? s.setup.tools[*t.listed] : shop::Tool{});
    }
    [[nodiscard]] Figures figures(const check::MilledMove& m) const {
        return figures_of(m, check::engagement_of(m, m.tool > 0 ? edges_[m.tool - 1] : no_edges_, rays_));
    }
    [[nodiscard]] const RowPlace& place(const check::MilledMove& m) {
        if (place_.span == m.where) return place_;
        if (place_.span.file != m.where.file) place_.file = base::as_utf8(subject_.sources[m.where.file].name);
        place_.span = m.where;
        place_.line = subject_.sources.position(m.where).line;
        place_.block = subject_.sources.block_number(m.where.file, m.where.begin);
        return place_;
    }
    [[nodiscard]] const check::ToolUse* tool(const check::MilledMove& m) const {
        return m.tool > 0 ? &subject_.result.tools[m.tool - 1] : nullptr;
    }

private:
    const Subject& subject_;
    double rays_ = 0;
    std::vector<check::CuttingEdges> edges_;  ///< by Result::tools
    check::CuttingEdges no_edges_{shop::Tool{}};
    RowPlace place_;
};

const char* kind_of(const check::MilledMove& m) { return m.rapid ? "rapid" : "feed"; }
const char* spindle_of(const check::MilledMove& m) { return m.spindle > 0 ? "cw" : m.spindle < 0 ? "ccw" : "stopped"; }

}  // namespace

void engagement_csv(const Subject& subject, TextSink out) {
    std::string row = "move,file,line,block,tool,edge,kind,spindle";
    for (const char* name : figure_names) (row += ',') += name;
    out(row += '\n');
    Rows rows(subject);
    for (const check::MilledMove& m : subject.result.milled->moves) {
        const RowPlace& p = rows.place(m);
        const check::ToolUse* tool = rows.tool(m);
        row = std::to_string(m.index);
        ((row += ',') += base::csv_field(p.file)) += ',';
        (row += std::to_string(p.line)) += ',';
        if (p.block) row += std::to_string(*p.block);
        row += ',';
        if (tool != nullptr) row += std::to_string(tool->number);
        row += ',';
        if (tool != nullptr) row += std::to_string(tool->edge);
        (((row += ',') += kind_of(m)) += ',') += spindle_of(m);
        for (const double figure : rows.figures(m)) {
            row += ',';
            if (std::isfinite(figure)) base::append_fixed(row, figure, table_decimals);
        }
        out(row += '\n');
    }
}

void engagement_json(const Subject& subject, TextSink out) {
    const check::MillingFigures& f = subject.result.milled->figures;
    out("{\"format\": \"obrys-engagement\", \"version\": 1, \"tolerance_mm\": " + base::shortest(f.tolerance_mm) +
        ", \"step_mm\": [" + base::shortest(f.step.x) + ", " + base::shortest(f.step.y) + ", " +
        base::shortest(f.step.z) + "], \"moves\": [");
    Rows rows(subject);
    const char* before = "\n";
    std::string row;
    for (const check::MilledMove& m : subject.result.milled->moves) {
        const RowPlace& p = rows.place(m);
        const check::ToolUse* tool = rows.tool(m);
        const auto number = [](const auto& value) { return value ? std::to_string(*value) : std::string("null"); };
        row = before;
        row += "{\"move\": " + std::to_string(m.index) + ", \"file\": " + nlohmann::json(p.file).dump() +
               ", \"line\": " + std::to_string(p.line) + ", \"block\": " + number(p.block) +
               ", \"tool\": " + (tool != nullptr ? std::to_string(tool->number) : "null") +
               ", \"edge\": " + (tool != nullptr ? std::to_string(tool->edge) : "null") + ", \"kind\": \"" +
               kind_of(m) + "\", \"spindle\": \"" + spindle_of(m) + "\"";
        const Figures figures = rows.figures(m);
        for (std::size_t i = 0; i < figure_names.size(); ++i) {
            ((row += ", \"") += figure_names[i]) += "\": ";
            if (std::isfinite(figures[i]))
                base::append_fixed(row, figures[i], table_decimals);
            else
                row += "null";
        }
        out(row += '}');
        before = ",\n";
    }
    out("\n]}\n");
}

}  // namespace obrys::report
