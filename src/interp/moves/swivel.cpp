/// Rotary axes of 3+2 machines: where a tilted plane puts them, and where the tip then is.
/// Source: iTNC 530 User's Manual (DIN/ISO, 2010), 12.2 "The PLANE function", positioning behaviour; table of positions
/// for SEQ on page 404.

#include "base/codes.hpp"
#include "interp/moves/moves.hpp"
#include "interp/setup/tilted_axes.hpp"
#include "shop/kinematics.hpp"

namespace obrys::interp {

namespace codes = base::codes;
using geom::Vec3;

Vec3 on_workpiece(const Reckoning& run) {
    const Rotary now = rotary(run);
    return counted_as(run, run.position, now, {now.values, true});
}

geom::Vec3 along_machine(const Reckoning& run) {
    const Rotary now = rotary(run);
    return counted_as(run, run.position, now, {now.values, false});
}

geom::Vec3 from_along_machine(const Reckoning& run, const geom::Vec3& position) {
    const Rotary now = rotary(run);
    return counted_as(run, position, {now.values, false}, now);
}

void tell_rotary(Telling& run, const Vec3& axis_before) {
    const shop::Machine& m = run.env.machine;
    for (const std::size_t i : m.chain) {
        const auto at = run.extra_axes.find(m.axes[i].name);
        if (m.axes[i].rotary && at != run.extra_axes.end())
            take_along(run, axis_end(at->first, at->second, true, tilted(run)));
    }
    if (run.tool_axis == axis_before) return;
    emit_frame(run);
    emit(run, cl::Linear{run.position, run.tool_axis, true});
}

void swivel(Moving& run, bool keeps_tip, const Vec3& tip, const base::Span& where) {
    if (run.aimed_at.empty()) {
        unchecked(run, codes::unsupported, where,
                  "the positions of the rotary axes that PLANE ... MOVE or TURN goes to depend on the machine's "
                  "kinematics, which are not known: they are not followed",
                  "name a machine with its rotary axes (chain, docs/machine-file.md)");
        return;
    }
    begin_motion(run);
    const Rotary before = rotary(run);
    const shop::Chain chain = shop::chain_of(run.env.machine);
    for (std::size_t i = 0; i < chain.joints.size(); ++i) {
        const shop::Joint& j = chain.joints[i];
        if (!j.rotary) continue;
        const double to = in_degrees(run.aimed_at[i]);
        run.extra_axes[j.name] = to;
        take_along(run, axis_end(j.name, to, true, tilted(run)));
    }
    if (keeps_tip)
        stand_at(run, tip);
    else
        recount(run, before);
    // Else nobody could tell both where the place is not known.
    if (keeps_tip) emit(run, cl::MachinePlace{cl::PlaceKind::frame, 1, {true, true, true}, run.programmed_position});
    emit(run, cl::Linear{run.position, run.tool_axis, !run.block.has(Code::feed)});
}

}  // namespace obrys::interp
