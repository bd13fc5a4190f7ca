// Cuts that lie between all rays: a broken edge, a fine engraving. No ray has met the tool; the surface has its faces.

#include <algorithm>
#include <vector>

#include "check/milling.hpp"
#include "check/milling_tool.hpp"

namespace obrys::check {

namespace milling = sim::milling;

/// Moves at feed that met nothing on a ray.
static bool is_unseen(const MilledMove& m) { return !m.rapid && m.contact_length_mm == 0 && m.volume_mm3 == 0; }

/// Cutting so it would be found.
bool Milling::may_not_cut(const MilledMove& m) const {
    if (m.spindle == 0) return true;
    const auto listed = m.tool > 0 ? out_.result().tools[m.tool - 1].listed : std::nullopt;
    if (!listed) return false;
    const shop::Tool& tool = setup_.tools[*listed];
    return m.spindle == (tool.left_hand ? 1 : -1) || cuts_along_axis_only(tool.kind);
}

/// Whether it matters if moves that met no ray have cut: none did meet one, or one of them that reaches into the
/// stock's box must not cut.
bool Milling::asks_for_narrow_cuts(const std::vector<MilledMove>& moves) const {
    if (out_.result().stats.feed_moves == 0) return false;
    if (figures_.contact_length_mm == 0) return complete_;
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
    bool any = false, said = false;
    for (std::size_t i = 0; i < milled.moves.size(); ++i) {
        const MilledMove& m = milled.moves[i];
        if (m.rapid) continue;
        const bool unseen = is_unseen(m) && faces[i + 1] != 0;
        if (!unseen && is_unseen(m)) continue;
        any = true;
        if (unseen && m.spindle == 0 && !said) say_stopped(m);
        if (unseen) judge_use(m);
        said = m.spindle == 0;
    }
    if (!any && complete_ && out_.result().stats.feed_moves > 0) judge_no_contact(milled);
}

}  // namespace obrys::check
