/// Rotary axes of 3+2 machines: where a tilted plane puts them, and where the tip then is.
/// Source: iTNC 530 User's Manual (DIN/ISO, 2010), 12.2 "The PLANE function", positioning behaviour; table of positions
/// for SEQ on page 404.

#include <cmath>

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

void take_rotary_along(Telling& run, std::string_view without) {
    const shop::Machine& m = run.env.machine;
    for (const std::size_t i : m.chain) {
        const auto at = run.extra_axes.find(m.axes[i].name);
        if (m.axes[i].name.size() == 1 && without.find(m.axes[i].name[0]) != std::string_view::npos) continue;
        if (m.axes[i].rotary && at != run.extra_axes.end())
            take_along(run, axis_end(at->first, at->second, true, tilted(run)));
    }
}

namespace {

/// Nobody knows any more where it stands, and the stream has not said so yet.
bool is_lost(const Telling& run) {
    const auto nowhere = [](const Vec3& p) { return std::isnan(p.x) && std::isnan(p.y) && std::isnan(p.z); };
    return nowhere(run.position) && !nowhere(run.sent);
}

}  // namespace

void tell_rotary(Telling& run, const Vec3& axis_before) {
    take_rotary_along(run, {});
    if (run.tool_axis == axis_before && !is_lost(run)) return;
    emit_frame(run);
    emit(run, cl::Linear{run.position, run.tool_axis, true});
}

Vec3 axis_of_tool(const Reckoning& run) {
    const shop::Chain chain = shop::chain_of(run.env.machine);
    const Vec3 in_table = geom::apply_direction(shop::spindle_frame(chain, rotary(run).values), {0, 0, 1});
    const auto turn = run.env.machine.datum_rotations.find(run.reference_datum);
    if (turn == run.env.machine.datum_rotations.end()) return in_table;
    return geom::apply_direction(geom::Frame::rotation(2, -turn->second), in_table);
}

namespace {

/// What lies DIST before the tip stays where it is on the workpiece. Source: TNC 620 User's Manual (Conversational,
/// 10/2017), "Dist. tool tip - center of rot. (incremental)": DIST shifts the center of rotation relative to the tip; a
/// tool at this distance from the workpiece is at the same place of it afterwards.
Vec3 turned_about(const BeforeSwivel& before, const Vec3& axis) {
    if (before.distance == 0) return before.tip;
    return before.tip + before.distance * (axis - before.axis);
}

}  // namespace

void swivel(Moving& run, bool keeps_tip, bool rapid, const BeforeSwivel& was, const base::Span& where) {
    // By its moves the program says where the tool goes on; what nobody knows is where its tip is in between.
    if (run.aimed_at.empty() && tilted(run) && !keeps_tip) {
        mark_turned_by_control(run);
        update_frame(run);
        begin_motion(run);
        stand_at(run, {unknown_number, unknown_number, unknown_number});
        emit(run, cl::Linear{run.position, run.tool_axis, true});
        return assume(run, where,
                      "the positions to which the rotary axes go for this plane depend on the machine's kinematics, "
                      "which are not known: the tool is taken to stand on it",
                      "name a machine with its rotary axes (chain, docs/machine-file.md)");
    }
    if (run.aimed_at.empty()) {
        unchecked(run, codes::unsupported, where,
                  "the positions to which the rotary axes go for this plane depend on the machine's "
                  "kinematics, which are not known: they are not followed",
                  "name a machine with its rotary axes (chain, docs/machine-file.md)");
        if (keeps_tip) stand_at(run, was.tip);
        if (is_lost(run)) tell_rotary(run, run.tool_axis);
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
        stand_at(run, turned_about(was, axis_of_tool(run)));
    else
        recount(run, before);
    // Else nobody could tell both where the place is not known.
    if (keeps_tip) emit(run, cl::MachinePlace{cl::PlaceKind::frame, 1, {true, true, true}, run.programmed_position});
    emit(run, cl::Linear{run.position, run.tool_axis, rapid});
}

}  // namespace obrys::interp
