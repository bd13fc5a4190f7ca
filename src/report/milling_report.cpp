#include "report/milling_report.hpp"

#include <algorithm>
#include <map>

#include "base/number.hpp"
#include "check/milling_tool.hpp"
#include "mesh/merge_flat.hpp"
#include "report/report.hpp"

namespace obrys::report {

namespace {

/// The program texts of the page, each once, in the order in which places name them.
class Texts {
public:
    explicit Texts(const base::Sources& sources) : sources_(sources) {}

    PageSite site(const base::Span& where) {
        if (!check::is_placed(where) || where.file >= sources_.size()) return {};
        const auto [it, is_new] = index_.try_emplace(where.file, static_cast<std::uint32_t>(files_.size()));
        if (is_new) files_.push_back(where.file);
        return {it->second, sources_.position(where.file, where.begin).line};
    }
    [[nodiscard]] std::vector<PageText> take() const {
        std::vector<PageText> all;
        for (const std::uint32_t f : files_) {
            sources_.fetch(f);
            all.push_back({sources_[f].name, std::string(sources_[f].text)});
        }
        return all;
    }

private:
    const base::Sources& sources_;
    std::map<std::uint32_t, std::uint32_t> index_;
    std::vector<std::uint32_t> files_;
};

void add_findings(MillingPage& page, const Subject& s, Texts& texts,
                  const std::map<std::uint64_t, std::uint32_t>& moves) {
    const std::vector<check::Group> groups = check::groups_of(s.result);
    for (const std::size_t i : by_danger(s.result, groups)) {
        const check::Finding& f = s.result.findings[groups[i].worst];
        PageFinding p;
        p.code = f.code;
        p.text = f.text;
        p.remedy = f.remedy;
        p.severity = f.severity;
        p.where = texts.site(f.where);
        if (f.move)
            if (const auto at = moves.find(*f.move); at != moves.end()) p.move = at->second;
        for (const std::size_t k : groups[i].members)
            if (const auto& m = s.result.findings[k].move; m && moves.contains(*m)) p.moves.push_back(moves.at(*m));
        p.passes = passes_line(s, groups[i]);
        p.place = f.place;
        for (const check::Amount& a : f.amounts) {
            if (a.key == "x_mm" || a.key == "y_mm" || a.key == "z_mm") continue;  // the place says it
            const AmountWords w = amount_words(a.key);
            // Of milling there is no contour to be normal to.
            p.amounts.push_back({a.key == "depth_mm" ? "depth" : w.label, base::fixed(a.value, 3), w.unit});
        }
        page.findings.push_back(std::move(p));
    }
    page.findings_dropped = s.result.findings_dropped;
    for (const check::Note& n : s.result.unchecked) page.unchecked.push_back({n.text, n.remedy, texts.site(n.where)});
    for (const check::Note& n : s.result.assumptions)
        page.assumptions.push_back({n.text, n.remedy, texts.site(n.where)});
}

std::int32_t number_of(const Subject& s, std::uint32_t use) {
    return use == 0 ? 0 : static_cast<std::int32_t>(s.result.tools[use - 1].number);
}

void add_path(MillingPage& page, const Subject& s, Texts& texts) {
    const check::Milled& m = *s.result.milled;
    double seconds = 0, way = 0;
    std::size_t point = 0;
    for (std::size_t i = 0; i < m.moves_with_points; ++i) {
        const check::MilledMove& move = m.moves[i];
        for (; point < move.points_end; ++point) {
            const geom::Vec3& p = m.points[point];
            if (point > 0 && geom::is_finite(p) && geom::is_finite(m.points[point - 1]))
                way += geom::distance(p, m.points[point - 1]);
            for (const double c : {p.x, p.y, p.z}) page.path.points.push_back(static_cast<float>(c));
            page.path.move_of_point.push_back(static_cast<std::uint32_t>(i));
        }
        seconds += move.seconds;
        page.path.moves.push_back(
            {move.rapid, texts.site(move.where), number_of(s, move.tool), seconds, way, move.index});
    }
    page.moves_all = s.result.stats.moves;
    page.moves_left_out = m.moves.size() - m.moves_with_points;
}

void add_tools(MillingPage& page, const Subject& s) {
    for (const check::ToolUse& use : s.result.tools) {
        PageTool t;
        t.number = static_cast<std::int32_t>(use.number);
        t.name = use.name;
        t.volume_mm3 = use.volume_mm3;
        t.moves = use.moves;
        t.feed_mm = use.feed_length_mm;
        t.rapid_mm = use.rapid_length_mm;
        if (use.listed) {
            const shop::Tool& tool = s.setup.tools[*use.listed];
            const sim::milling::Cutter c = check::cutter_of(tool);
            t.kind = shop::kind_word(shop::assumed_kind(tool));
            t.radius = c.diameter / 2;
            t.corner_radius = c.corner_radius;
            t.cutting_length = std::min(c.cutting_length, 10 * c.diameter);
            double from = t.cutting_length;
            for (const bool holder : {false, true})
                for (const sim::milling::Body& b : holder ? c.holder : c.shank) {
                    t.bodies.push_back({from, from + b.length, b.lower_diameter / 2, b.upper_diameter / 2, holder});
                    from += b.length;
                }
        }
        page.tools.push_back(std::move(t));
    }
}

/// Deviations stand at the vertices, so that a compared surface keeps all of them.
void add_surface(MillingPage& page, const check::Milled& m) {
    const mesh::Mesh merged =
        m.comparison ? mesh::Mesh{} : mesh::merge_flat(m.surface, check::flat_share * m.figures.tolerance_mm);
    const mesh::Mesh& surface = m.comparison ? m.surface : merged;
    for (const geom::Vec3& v : surface.vertices)
        for (const double c : {v.x, v.y, v.z}) page.surface.vertices.push_back(static_cast<float>(c));
    for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
        for (const std::uint32_t corner : surface.triangles[t]) page.surface.indices.push_back(corner);
        const std::uint32_t tag = surface.tag(t);
        page.surface.move_of.push_back(tag == 0 || tag > m.moves_with_points ? page_none : tag - 1);
    }
    if (!m.comparison) return;
    for (const double d : m.comparison->deviation) page.surface.deviation.push_back(static_cast<float>(d));
}

void add_figures(MillingPage& page, const Subject& s) {
    const check::MillingFigures& f = s.result.milled->figures;
    const auto row = [&](std::string label, double value, int decimals, std::string unit) {
        page.figures.push_back({std::move(label), base::fixed(value, decimals), std::move(unit)});
    };
    row("removed", (f.before_mm3 - f.after_mm3) / 1000, 3, "cm3");
    row("stock before", f.before_mm3 / 1000, 3, "cm3");
    row("feed", s.result.stats.feed_length_mm, 1, "mm");
    row("of it in the material", f.contact_length_mm, 1, "mm");
    row("rapid", s.result.stats.rapid_length_mm, 1, "mm");
    row("rays apart", f.step.x, 3, "mm");
}

}  // namespace

MillingPage milling_page_of(const Subject& s) {
    const check::Milled& m = *s.result.milled;
    MillingPage page;
    page.title = s.program;
    page.control = s.control;
    page.machine = s.setup.machine.name;
    page.date = s.date;
    page.version = s.version;
    page.verdict = s.result.verdict;
    page.verdict_line = verdict_line(s.result);
    Texts texts(s.sources);
    std::map<std::uint64_t, std::uint32_t> moves;  // of the check -> of the page
    for (std::size_t i = 0; i < m.moves_with_points; ++i) moves[m.moves[i].index] = static_cast<std::uint32_t>(i);
    add_path(page, s, texts);
    add_findings(page, s, texts, moves);
    page.texts = texts.take();
    add_tools(page, s);
    add_surface(page, m);
    if (s.setup.milling) {
        const sim::milling::Box3 box = sim::milling::box_of(s.setup.milling->stock);
        page.stock = PageBox{box.min, box.max, "stock"};
        for (const check::Clamp& c : s.setup.milling->clamps) {
            const sim::milling::Box3 b = sim::milling::box_of(c.body);
            page.clamps.push_back({b.min, b.max, c.name});
        }
    }
    page.tolerance = m.figures.tolerance_mm;
    add_figures(page, s);
    return page;
}

std::string page(const Subject& subject) {
    if (subject.result.milled != nullptr && milling_page_available()) return milling_page(milling_page_of(subject));
    return to_html(subject);
}

}  // namespace obrys::report
