#include "milled.hpp"

#include <cmath>
#include <cstdio>

#include "driver/files.hpp"
#include "mesh/export.hpp"
#include "mesh/merge_flat.hpp"
#include "mesh/package/three_mf.hpp"
#include "mesh/stl.hpp"
#include "report/clamp_bodies.hpp"
#include "report/engagement_table.hpp"
#include "report/picture/deviation_legend.hpp"
#include "report/picture/milling_picture.hpp"
#include "sim/milling/stock.hpp"

namespace obrys::cli {

bool deliver(const std::string& path, driver::OutputFile& file) {
    if (file.finish()) return true;
    const std::string name = driver::is_standard_output(path) ? "standard output" : path;
    std::fprintf(stderr, "obrys: %s cannot be written: %s\n", name.c_str(), file.error().c_str());
    return false;
}

bool deliver(const std::string& path, std::string_view text) {
    driver::OutputFile file(path);
    file.write(text);
    return deliver(path, file);
}

static bool wants_pictures(const Arguments& a) {
    return !a.plan_view.empty() || !a.projections.empty() || !a.picture.empty();
}

bool wants_surface(const Arguments& a) {
    return !a.stl.empty() || !a.three_mf.empty() || !a.gltf.empty() || wants_pictures(a);
}

bool draws_milling(const Arguments& a, const driver::Checked& checked) {
    const auto& milled = checked.result.milled;
    return !a.svg.empty() && milled != nullptr && !milled->surface.empty();
}

namespace {

constexpr double full_deviation = 20;  ///< tolerances at which a deviation has its deepest colour

/// The first colour is that of faces that no tool has cut.
constexpr mesh::Colour tool_colours[] = {{168, 172, 178}, {86, 156, 214}, {220, 160, 70}, {120, 180, 110},
                                         {190, 110, 160}, {90, 180, 180}, {200, 110, 90}, {150, 150, 90}};
constexpr std::uint32_t tool_colour_count = sizeof(tool_colours) / sizeof(tool_colours[0]);

/// By deviation where there is a part, else by the tool that cut last.
mesh::DeviationColours colour(const check::Milled& milled, mesh::Mesh& surface, double tolerance) {
    mesh::DeviationColours c;
    if (milled.comparison && !milled.at_move) {
        mesh::CompareOptions allowed;
        allowed.gouge = allowed.excess = tolerance;
        c = mesh::deviation_colours(milled.comparison->deviation, allowed, full_deviation * tolerance);
    } else {
        c.palette.assign(std::begin(tool_colours), std::end(tool_colours));
        for (const std::uint32_t tag : surface.tags) {
            const std::uint32_t tool = tag == 0 ? 0 : milled.moves[tag - 1].tool;
            c.tags.push_back(tool == 0 ? 0 : 1 + (tool - 1) % (tool_colour_count - 1));
        }
    }
    surface.tags = c.tags;
    return c;
}

/// What the colours mean.
std::vector<report::picture::PictureLegend> legend_of(const check::Result& result,
                                                      const mesh::DeviationColours& colours) {
    if (result.milled->comparison && !result.milled->at_move) {
        const double allowed = result.milled->figures.tolerance_mm;
        return report::picture::deviation_legend(colours, allowed, full_deviation * allowed);
    }
    std::vector<report::picture::PictureLegend> out;
    out.push_back({tool_colours[0], "not cut"});
    for (std::size_t k = 0; k < result.tools.size(); ++k) {
        const check::ToolUse& tool = result.tools[k];
        const std::string text = "T" + std::to_string(tool.number) + (tool.name.empty() ? "" : " " + tool.name);
        const std::size_t index = 1 + k % (tool_colour_count - 1);
        if (index < out.size())
            out[index].text += ", " + text;
        else
            out.push_back({tool_colours[index], text});
    }
    return out;
}

/// `surface` has indices of `colours.palette` as its tags.
bool write_pictures(const Arguments& a, driver::Session& s, const driver::Checked& checked, const mesh::Mesh& surface,
                    const mesh::DeviationColours& colours) {
    const std::vector<report::picture::PictureLegend> legend = legend_of(checked.result, colours);
    std::vector<report::picture::PictureMark> marks;
    const std::vector<check::Group> groups = check::groups_of(checked.result);
    for (std::size_t k = 0; k < groups.size(); ++k)
        if (const check::Finding& f = checked.result.findings[groups[k].worst];
            f.place && (!a.milling.at || (f.move && *f.move <= *a.milling.at)))
            marks.push_back({std::to_string(k + 1), *f.place});
    report::picture::MillingScene scene{surface};
    if (checked.setup.milling) {
        const auto box = sim::milling::box_of(checked.setup.milling->stock);
        scene.stock.add(box.min);
        scene.stock.add(box.max);
        report::ClampBodies clamps = report::clamp_bodies(*checked.setup.milling);
        scene.clamps = std::move(clamps.mesh);
        scene.clamp_name = std::move(clamps.name);
    }
    scene.palette = colours.palette;
    scene.legend = legend;
    scene.marks = marks;
    scene.title = s.program + (a.milling.at ? ", after move " + std::to_string(*a.milling.at) : "");
    const std::string svg = draws_milling(a, checked) ? a.svg : "";
    const struct {
        const std::string& file;
        report::picture::MillingView view;
    } pictures[] = {{svg, report::picture::MillingView::projections},
                    {a.plan_view, report::picture::MillingView::plan},
                    {a.projections, report::picture::MillingView::projections},
                    {a.picture, report::picture::MillingView::solid}};
    bool written = true;
    for (const auto& [file, view] : pictures)
        if (!file.empty())
            written =
                deliver(file, &file == &svg || file.ends_with(".svg") ? report::picture::milling_svg(view, scene)
                                                                      : report::picture::milling_png(view, scene)) &&
                written;
    return written;
}

}  // namespace

bool write_surface(const Arguments& a, driver::Session& s, const driver::Checked& checked) {
    if (!wants_surface(a) && !draws_milling(a, checked)) return true;
    const auto& milled = checked.result.milled;
    if (milled == nullptr || milled->surface.empty()) {
        std::fputs("obrys: there is no machined surface to write: the job has no milling stock that was simulated\n",
                   stderr);
        return false;
    }
    if (a.milling.at && *a.milling.at >= checked.result.stats.moves) {
        std::fprintf(stderr, "obrys: --at %llu: the program makes %llu moves, numbered from 0\n",
                     static_cast<unsigned long long>(*a.milling.at),
                     static_cast<unsigned long long>(checked.result.stats.moves));
        return false;
    }
    const double flat = check::flat_share * milled->figures.tolerance_mm;
    const mesh::Mesh& machined = milled->at_move ? *milled->at_move : milled->surface;
    bool written = true;
    if (!a.stl.empty()) {
        const mesh::Mesh plain{machined.vertices, machined.triangles, {}};
        written = deliver(a.stl, mesh::write_stl(mesh::merge_flat(plain, flat)));
    }
    const bool draws = wants_pictures(a) || draws_milling(a, checked);
    if (a.three_mf.empty() && a.gltf.empty() && !draws) return written;
    mesh::Mesh surface = machined;
    const mesh::DeviationColours colours = colour(*milled, surface, milled->figures.tolerance_mm);
    if (draws) written = write_pictures(a, s, checked, surface, colours) && written;
    if (a.three_mf.empty() && a.gltf.empty()) return written;
    surface = mesh::merge_flat(surface, flat);
    if (!a.three_mf.empty())
        written = deliver(a.three_mf, mesh::package::write_3mf(surface, colours.palette)) && written;
    if (a.gltf.empty()) return written;
    const auto glb = mesh::write_glb(surface, colours.palette);
    if (glb) return deliver(a.gltf, *glb) && written;
    std::fputs("obrys: the surface is too large for a glTF file; take a coarser --tolerance\n", stderr);
    return false;
}

bool write_engagement(const Arguments& a, const report::Subject& subject) {
    if (a.engagement.empty()) return true;
    if (subject.result.milled == nullptr) {
        std::fputs("obrys: there is no engagement to write: the job has no milling stock that was simulated\n", stderr);
        return false;
    }
    driver::OutputFile file(a.engagement);
    const auto write = [&](std::string_view text) { file.write(text); };
    if (a.engagement.ends_with(".json"))
        report::engagement_json(subject, write);
    else
        report::engagement_csv(subject, write);
    return deliver(a.engagement, file);
}

}  // namespace obrys::cli
