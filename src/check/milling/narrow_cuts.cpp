// Cuts that lie between all rays: a broken edge, a fine engraving. No ray has met the tool; the surface has its faces.

#include <algorithm>
#include <cmath>
#include <vector>

#include "check/milling/milling.hpp"
#include "check/milling_tool.hpp"

namespace obrys::check {

namespace milling = sim::milling;

/// Moves at feed that met nothing on a ray.
static bool is_unseen(const MilledMove& m) { return !m.rapid && m.contact_length_mm == 0 && m.volume_mm3 == 0; }

/// A move that must not cut as it is made: `judge_use` and `say_stopped` find it.
bool Milling::may_not_cut(const MilledMove& m) const {
    if (m.spindle == 0) return true;
    const auto listed = m.tool > 0 ? out_.result().tools[m.tool - 1].listed : std::nullopt;
    if (!listed) return false;
    const shop::Tool& tool = setup_.tools[*listed];
    return m.spindle == (tool.left_hand ? 1 : -1) ||
           (cuts_along_axis_only(tool.kind) && std::abs(m.sinking) <= along_axis);
}

/// Whether it matters if moves that met no ray have cut: none did meet one, or one of them that reaches into the
/// stock's box must not cut.
bool Milling::asks_for_narrow_cuts(const std::vector<MilledMove>& moves) const {
    if (out_.result().stats.feed_moves == 0) return false;
    if (figures_.contact_length_mm == 0 && complete_) return true;
    if (std::none_of(moves.begin(), moves.end(), [&](const MilledMove& m) { return is_unseen(m) && may_not_cut(m); }))
        return false;
    const std::vector<std::uint32_t> cuts = simulation_->cuts_in(milling::box_of(setup_.milling->stock));
    return std::any_of(cuts.begin(), cuts.end(), [&](std::uint32_t cut) {
        const MilledMove& m = moves[move_of_pass_[simulation_->pass_of(cut)]];
        return is_unseen(m) && may_not_cut(m);
    });
}

/// By the faces that are theirs on the surface; what later cuts have taken away again is not known of.
void Milling::judge_narrow_cuts(const Milled& milled) {
    std::vector<char> faces(milled.moves.size() + 1);
    for (const std::uint32_t tag : milled.surface.tags) faces[tag] = 1;
    std::vector<std::size_t> cuts;
    for (std::size_t i = 0; i < milled.moves.size(); ++i)
        if (const MilledMove& m = milled.moves[i]; !m.rapid && (!is_unseen(m) || faces[i + 1] != 0)) cuts.push_back(i);
    const auto stands = [&](std::size_t k) { return milled.moves[cuts[k]].spindle == 0; };
    for (std::size_t k = 0; k < cuts.size(); ++k) {
        const MilledMove& m = milled.moves[cuts[k]];
        if (is_unseen(m)) judge_use(m);
        if (!stands(k) || (k > 0 && stands(k - 1))) continue;
        // Once while it stands: not where a cut that rays have met is said.
        std::size_t end = k;
        while (end < cuts.size() && stands(end) && is_unseen(milled.moves[cuts[end]])) ++end;
        if (end > k && (end == cuts.size() || !stands(end))) say_stopped(m);
    }
    if (cuts.empty() && complete_ && out_.result().stats.feed_moves > 0) judge_no_contact(milled);
}

}  // namespace obrys::check
