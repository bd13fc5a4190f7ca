#pragma once
/// Tools of the shop as the milling simulation takes them.

#include "shop/tool.hpp"
#include "sim/milling/cutter.hpp"

namespace obrys::check {

/// mm: cutting edges, or a body, as long as any cut, where nothing is said.
inline constexpr double unknown_height = 1000;

/// What cuts, the shank above it and the holder; of a tool whose length is known, up to its gauge plane as wide as the
/// last of these, and above it the nose of the spindle (of the holder the last body); dimensions that are not known are
/// what ordinary tools have (docs/job-file.md). `rub`: mm by which a body that is assumed stands out of the hole that
/// its edges drill.
[[nodiscard]] sim::milling::Cutter cutter_of(const shop::Tool& tool, double rub = 0);
/// Whether its length says where the nose of the spindle stands.
[[nodiscard]] bool stands_in_spindle(const shop::Tool& tool);
/// The length of the edges is known and no shank is: what stands above them is taken to be as thick as they are.
[[nodiscard]] bool has_assumed_body(const shop::Tool& tool);

/// Boring bars are listed as reamers, or as mills that do not cut at their centre (docs/job-file.md).
[[nodiscard]] bool may_bore(const shop::Tool& tool);

/// Radius within which the tool's end does not cut, mm: what it meets there it cannot go straight down into. 0 where it
/// may plunge anywhere. Of a tap the core of its thread, of a reamer four fifths: holes are made before; a flat tip or
/// the beginning of a profile; of other mills that do not cut at their centre half the radius.
[[nodiscard]] double blind_radius(const shop::Tool& tool);
/// Of a tap: pitch of the coarse thread of its diameter, mm. ISO 261.
[[nodiscard]] double coarse_pitch(const shop::Tool& tap);
/// The same on ramps and helices: of a T-slot cutter its neck, and of mills that do not cut at their centre, but do not
/// say how wide that is, a fifth of the radius, since a wrong guess would forbid what works.
[[nodiscard]] double core_on_slant(const shop::Tool& tool);
/// Of a tap: radius of its thread's core, by its pitch, or that of the coarse thread where it is not said. ISO 68-1.
[[nodiscard]] double core_radius(const shop::Tool& tap);
/// Of a tap: radius of the widest hole that its thread may be cut or formed in.
[[nodiscard]] double widest_hole_radius(const shop::Tool& tap);

inline constexpr double along_axis = 1 - 1e-6;  ///< MilledMove::sinking of a way along the axis
[[nodiscard]] constexpr bool cuts_along_axis_only(shop::ToolKind kind) {
    return kind == shop::ToolKind::drill || kind == shop::ToolKind::tap || kind == shop::ToolKind::reamer;
}

}  // namespace obrys::check
