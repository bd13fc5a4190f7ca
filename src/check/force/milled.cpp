#include "check/force/milled.hpp"

#include <algorithm>

#include "base/parallel.hpp"
#include "base/text.hpp"
#include "check/engagement.hpp"
#include "check/force/rings.hpp"
#include "sim/cutting/law.hpp"
#include "sim/force/deflection.hpp"
#include "sim/force/processes.hpp"

namespace obrys::check::force {

namespace cutting = sim::cutting;
using geom::pi;

namespace {

constexpr int places = 120;  ///< of a revolution: figures within 1 % of those at thousands
constexpr double newton_metres = 1e-3, minute = 60, metres = 1e-3;
constexpr double high_speed_steel = 210e3, carbide = 600e3;  ///< N/mm2

/// As tool lists and tool tables name the edge's material.
std::optional<double> elasticity_of(const shop::Tool& t, const shop::CuttingJob& job) {
    if (const auto* use = find_use(job, t.number); use != nullptr && use->elasticity) return use->elasticity;
    const std::string name = base::to_upper(t.cutter_material);
    if (name.starts_with("HSS")) return high_speed_steel;
    if (name == "HM" || name == "VHM" || name == "CARBIDE" || name.starts_with("HARTMETALL")) return carbide;
    return std::nullopt;
}

/// From the holder to the tip.
std::optional<double> stick_out(const shop::Tool& t, const shop::CuttingJob& job) {
    if (const auto* use = find_use(job, t.number); use != nullptr && use->stick_out) return use->stick_out;
    if (!t.shank.empty() && t.cutting_length) return *t.cutting_length + shop::height_of(t.shank);
    if (!t.holder.empty() && t.length >= shop::least_gauge_length) {
        const double rest = t.length - shop::height_of(t.holder);
        if (rest > 0) return rest;
    }
    return std::nullopt;
}

/// N/mm at the tip; NaN: not known.
double stiffness_of(const shop::Tool& t, const shop::CuttingJob& job) {
    const auto length = stick_out(t, job);
    const auto elasticity = elasticity_of(t, job);
    if (!length || !elasticity || !(t.radius > 0)) return NAN;
    sim::force::ToolBeam beam;
    beam.diameter = 2 * t.radius;
    beam.flutes = std::min(shop::cutting_height(t).value_or(*length), *length);
    beam.shank = *length - beam.flutes;
    beam.elasticity = *elasticity;
    return sim::force::stiffness(beam);
}

bool drills(shop::ToolKind kind) {
    return kind == shop::ToolKind::drill || kind == shop::ToolKind::centre_drill ||
           kind == shop::ToolKind::countersink || kind == shop::ToolKind::reamer;
}

/// The tool, with as many teeth as its list or the job says.
shop::Tool toothed(const shop::Tool* t, const shop::CuttingJob& job) {
    if (t == nullptr) return {};
    shop::Tool tool = *t;
    if (const auto* use = find_use(job, tool.number); use != nullptr && use->teeth) tool.teeth = *use->teeth;
    return tool;
}

double helix_of(const shop::Tool& t, const shop::CuttingJob& job) {
    const auto* use = find_use(job, t.number);
    return use != nullptr ? geom::radians(use->helix.value_or(0)) : 0;
}

/// A tool as forces need it.
struct Knife {
    bool listed = false;
    shop::Tool tool;
    CuttingEdges edges;
    Edges shape;
    double stiffness = NAN;
    Knife(const shop::Tool* t, const shop::CuttingJob& job)
        : listed(t != nullptr),
          tool(toothed(t, job)),
          edges(tool),
          shape(listed ? edges_of(tool, helix_of(tool, job)) : Edges{}),
          stiffness(listed ? stiffness_of(tool, job) : NAN) {}
};

class Computer {
public:
    Computer(const Result& result, const Setup& setup, const shop::CuttingJob& job, const shop::WorkMaterial* material)
        : milled_(*result.milled), material_(material) {
        const geom::Vec3 step = milled_.figures.step;
        rays_ = std::max({step.x, step.y, step.z});
        for (const ToolUse& use : result.tools)
            knives_.emplace_back(use.listed ? &setup.tools[*use.listed] : nullptr, job);
    }

    [[nodiscard]] MoveForce of(std::size_t index, double planned) const {
        const MilledMove& m = milled_.moves[index];
        MoveForce f;
        f.move = index;
        f.gap = gap_of(m);
        if (f.gap != Gap::none) return f;
        const Knife& k = knives_[m.tool - 1];
        const EdgeEngagement e = engagement_of(m, k.edges, rays_);
        f.programmed_per_tooth = e.feed_per_tooth;
        f.feed_per_tooth = e.feed_per_tooth * planned;
        const bool all_round = std::abs(m.sinking) > 1 - 1e-9;
        if (k.tool.kind == shop::ToolKind::tap)
            tap(f, m, k.tool);
        else if (all_round && drills(k.tool.kind))
            drill(f, m, k.tool);
        else
            mill(f, m, k, e, all_round);
        return f;
    }

private:
    [[nodiscard]] Gap gap_of(const MilledMove& m) const {
        if (material_ == nullptr) return Gap::material;
        if (m.tool == 0 || !knives_[m.tool - 1].listed || knives_[m.tool - 1].shape.shape.pieces.empty())
            return Gap::tool;
        if (knives_[m.tool - 1].tool.teeth <= 0) return Gap::teeth;
        if (!(m.speed_rpm > 0)) return Gap::spindle;
        if (!(m.feed_per_rev_mm > 0)) return Gap::feed;
        return Gap::none;
    }
    void set_power(MoveForce& f, const MilledMove& m, double torque) const {
        f.torque = newton_metres * torque;
        f.power = f.torque * 2 * pi * m.speed_rpm / minute;
    }
    [[nodiscard]] cutting::Law law_of(MoveForce& f, double chip) const {
        cutting::Law law = cutting::law_for(*material_, chip);
        f.by_kienzle = law.ratios_assumed;
        f.extrapolated = chip < law.thinnest || chip > law.thickest;
        return law;
    }

    /// Both flanks of a thread hold each other: a torque alone.
    void tap(MoveForce& f, const MilledMove& m, const shop::Tool& t) const {
        const double pitch = t.pitch.value_or(m.feed_per_rev_mm);
        constexpr double usual_chip = 0.05;
        set_power(f, m, sim::force::tapping_torque(law_of(f, usual_chip), 2 * t.radius, pitch, t.teeth));
        f.cutting_speed = metres * 2 * pi * t.radius * m.speed_rpm;
    }

    void drill(MoveForce& f, const MilledMove& m, const shop::Tool& t) const {
        const double point = geom::radians(t.point_angle.value_or(180));
        f.chip = f.mean_chip = f.feed_per_tooth * std::sin(point / 2);
        // What is there already is not drilled again.
        const double whole = pi * t.radius * t.radius * m.contact_length_mm;
        const double share = whole > 0 ? std::min(1.0, m.volume_mm3 / whole) : 1;
        const auto d = sim::force::drilling(law_of(f, f.chip), 2 * t.radius, t.teeth, f.feed_per_tooth, point);
        set_power(f, m, share * d.torque);
        f.mean = share * d.thrust;
        f.peak = d.thrust;
        f.cutting_speed = metres * 2 * pi * t.radius * m.speed_rpm;
    }

    void mill(MoveForce& f, const MilledMove& m, const Knife& k, const EdgeEngagement& e, bool all_round) const {
        if (!std::isfinite(e.from)) {
            f.gap = Gap::engagement;
            return;
        }
        const double radius = k.edges.radius(m.reach_mm);
        Met met;
        met.high = m.reach_mm;
        met.low = std::max(0.0, m.reach_mm - m.axial_depth_mm);
        const bool mirrored = m.spindle < 0;  // turns the other way: seen in a mirror
        met.right = radius * std::sin(mirrored ? -e.to : e.from);
        met.left = radius * std::sin(mirrored ? -e.from : e.to);
        if (m.contact_length_mm > 0) met.section = m.volume_mm3 / m.contact_length_mm;
        met.all_round = all_round;
        met.way = {all_round ? 0 : std::sqrt(std::max(0.0, 1 - m.sinking * m.sinking)), m.sinking};
        const Engaged in = engaged(k.shape, met);
        const sim::force::Feed feed{f.feed_per_tooth * met.way.side, f.feed_per_tooth * met.way.down};
        const cutting::Law law = law_of(f, f.feed_per_tooth * e.chip_mean / e.feed_per_tooth);
        const sim::force::Forces sum = sim::force::forces(in.rings, k.tool.teeth, feed, law, places);
        if (!(sum.engaged > 0)) {
            f.gap = Gap::engagement;
            return;
        }
        set_power(f, m, in.share * sum.mean_torque);
        f.mean = in.share * sum.mean_resultant;
        f.peak = sum.peak;
        f.deflection = sum.peak_side / k.stiffness;
        f.chip = sum.largest_chip;
        f.mean_chip = sum.mean_chip;
        f.edge_part = sum.edge_part;
        f.cutting_speed = metres * 2 * pi * radius * m.speed_rpm;
    }

    const Milled& milled_;
    const shop::WorkMaterial* material_;
    double rays_ = 0;
    std::vector<Knife> knives_;
};

}  // namespace

std::string_view text_of(Gap gap) {
    switch (gap) {
        case Gap::material: return "the material of the workpiece is not known ('material' of the job, or --material)";
        case Gap::tool: return "the tool is not listed, or its dimensions make no shape";
        case Gap::teeth:
            return "how many teeth (flutes) it has is not known ('teeth' of the tool, or of its [[cutting]])";
        case Gap::spindle: return "the spindle's speed is not known, or it stands";
        case Gap::feed: return "the feed is not known";
        case Gap::engagement:
            return "how the tool was engaged is not known: it removed less than the simulation measures";
        case Gap::none: break;
    }
    return "";
}

std::string deflection_gap(const shop::Tool& t, const shop::CuttingJob& job) {
    if (!stick_out(t, job)) return "stick_out (how far it stands out of its holder)";
    if (!elasticity_of(t, job)) return "elasticity (HSS 210000, carbide 600000 N/mm2)";
    return "";
}

ForceResult forces_of(const Result& result, const Setup& setup, const shop::CuttingJob& job,
                      const shop::WorkMaterial* material, const std::vector<double>& planned) {
    ForceResult out;
    const Computer computer(result, setup, job, material);
    const std::vector<MilledMove>& moves = result.milled->moves;
    std::vector<std::size_t> cuts;
    for (std::size_t i = 0; i < moves.size(); ++i)
        if (!moves[i].rapid && moves[i].volume_mm3 > 0) cuts.push_back(i);
    out.moves.resize(cuts.size());
    constexpr std::size_t together = 256;
    base::one_by_one((cuts.size() + together - 1) / together, [&](std::size_t block) {
        for (std::size_t i = block * together; i < std::min(cuts.size(), (block + 1) * together); ++i)
            out.moves[i] = computer.of(cuts[i], planned[cuts[i]]);
    });
    if (material == nullptr) return out;
    const auto used = [&](bool kienzle) {
        return std::any_of(out.moves.begin(), out.moves.end(),
                           [&](const MoveForce& f) { return f.gap == Gap::none && f.by_kienzle == kienzle; });
    };
    const auto say = [&](const cutting::Law& law) {
        out.laws.push_back(law.name + " (" + law.source + ")");
        out.ratios_assumed = out.ratios_assumed || law.ratios_assumed;
    };
    if (material->kienzle && used(true)) say(cutting::kienzle_law(*material->kienzle));
    if (material->linear && used(false)) say(cutting::linear_law(*material->linear));
    return out;
}

}  // namespace obrys::check::force
