/// What the end of a tool that does not cut at its centre comes down upon.

#include <cmath>

#include "base/codes.hpp"
#include "check/milling/milling.hpp"
#include "check/words.hpp"

namespace obrys::check {

namespace codes = base::codes;
namespace milling = sim::milling;

/// What the end that does not cut comes down upon, in passes of its own ahead of those that cut.
void Milling::queue_core(const geom::PathElement& element, bool feed, bool straight_down) {
    CorePiece piece;
    piece.move = static_cast<std::uint32_t>(moves_.size() - 1);
    piece.tool = tool_parts_.core;
    piece.radius = tool_parts_.core_radius;
    piece.leaves = !feed;
    if (piece.leaves && !core_pieces_.empty() && core_pieces_.back().leaves) return;
    const milling::Orientation frame = milling::orientation_of(axis_);
    bool down = false;
    for (std::size_t i = 0; i < piece.points.size(); ++i) {
        piece.points[i] = frame.to_tool(geom::point_at(element, static_cast<double>(i) / 4));
        down = down || (i > 0 && piece.points[i].z < piece.points[i - 1].z);
    }
    if (feed && down && !straight_down) {  // straight down: judge_plunge
        require(simulation_->add({element, axis_, tool_parts_.core, milling::Part::cutting, false}));
        piece.probe = passes_++;
        move_of_pass_.push_back(piece.move);
    }
    piece.pass = passes_;
    piece.axis = axis_;
    core_pieces_.push_back(piece);
}

/// Whether what stayed under the core all the way was material before that: at points, from what was cut before.
bool Milling::meets_core(const CoreDescent::Steep& steep, geom::Vec3 axis) const {
    const milling::Orientation frame = milling::orientation_of(axis);
    const auto place = [&](double x, double y, double z) { return x * frame.x + y * frame.y + z * frame.z; };
    constexpr int levels = 5, round = 8;
    for (int level = 0; level < levels; ++level)
        for (int i = 0; i <= 2 * round; ++i) {
            const double r = i == 0 ? 0 : (i <= round ? 0.45 : 0.9) * steep.radius, turn = 2 * geom::pi * i / round;
            const geom::Vec3 p = place(steep.middle.x + r * std::cos(turn), steep.middle.y + r * std::sin(turn),
                                       steep.bottom + (steep.top - steep.bottom) * (level + 0.5) / levels);
            const geom::Vec3 around{1e-6, 1e-6, 1e-6};
            const milling::Air air = simulation_->air_in({p - around, p + around});
            bool taken = false;
            for (std::size_t body = 0; body < air.bodies() && !taken; ++body)
                taken = (body == 0 || simulation_->pass_of(air.cut(body)) < steep.first) && air.outside(body, p) < 0;
            if (!taken) return true;
        }
    return false;
}

void Milling::judge_cores() {
    for (const CorePiece& piece : core_pieces_) {
        if (piece.tool != core_tool_) core_descent_.begin(piece.radius, setup_.milling->tolerance);
        core_tool_ = piece.tool;
        if (piece.leaves) core_descent_.leave();
        if (piece.leaves) continue;
        const bool met = piece.probe && simulation_->engagements()[*piece.probe].touched;
        if (!core_descent_.take(piece.points, met, piece.pass) || core_found_ == piece.move + 1) continue;
        const CoreDescent::Steep steep = core_descent_.steep();
        if (!meets_core(steep, piece.axis)) continue;
        core_found_ = piece.move + 1;
        Finding f;
        f.code = codes::plunging_cut;
        f.text = "the tool goes down " + mm(steep.down) + " in the material while it moves " + mm(steep.aside) +
                 " aside: it does not cut at its centre";
        f.remedy = "enter by a flatter ramp or a wider helix, or drill before";
        f.amounts = {{"down_mm", steep.down}, {"aside_mm", steep.aside}};
        found(moves_[piece.move], std::move(f));
    }
    core_pieces_.clear();
}

}  // namespace obrys::check
