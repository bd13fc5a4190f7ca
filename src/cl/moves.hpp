#pragma once
/// Records of the stream that move the tool. Lengths in mm, angles in radians, workpiece frame, tool tip; on lathes x
/// is a radius; NaN: not known. Meaning: docs/cl-stream.md.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <string_view>
#include <vector>

#include "geom/vec.hpp"

namespace obrys::cl {

/// What a probe looks for on its way: the move ends there, or at `to` at the latest.
enum class Seek : std::uint8_t {
    nothing,         ///< no probe
    contact,         ///< the control stops where it finds none (G38.2)
    contact_or_end,  ///< the program goes on all the same (G38.3, G31)
    release,         ///< of what the probe touches (G38.4)
    release_or_end,  ///< G38.5
};

/// Where an additional axis stands at the end of a move (rotary: degrees; linear: mm).
struct AxisEnd {
    std::array<char, 8> name{};  ///< as the control names it ("C", "C2"), zero-padded
    double to = 0;
    bool rotary = false;
    /// The control counts where this rotary axis stands (tilted working plane): points stay in the workpiece frame.
    /// Else points are in the machine's directions, as though the axis stood at 0.
    bool counted = false;
    bool operator==(const AxisEnd&) const = default;
};
[[nodiscard]] inline std::string_view name_of(const std::array<char, 8>& axis) {
    return {axis.data(), static_cast<std::size_t>(std::find(axis.begin(), axis.end(), '\0') - axis.begin())};
}
/// Of those axes that a move takes along; the others stand where they stood.
using AxisEnds = std::vector<AxisEnd>;

/// Straight move; `axis` is the unit vector along the tool, from the tip into the holder.
struct Linear {
    geom::Vec3 to;
    geom::Vec3 axis{0, 0, 1};
    bool rapid = false;
    Seek seek = Seek::nothing;
    AxisEnds ends{};
    bool operator==(const Linear&) const = default;
};

/// Circular or helical move about `normal` through `centre`; `sweep` positive counter-clockwise seen against `normal`.
/// `to - from` along `normal` is the helix' rise. |sweep| may exceed a full turn.
struct Arc {
    geom::Vec3 to;
    geom::Vec3 centre;
    geom::Vec3 normal{0, 0, 1};
    double sweep = 0;
    bool rapid = false;
    geom::Vec3 axis{0, 0, 1};  ///< as of Linear, at the end
    AxisEnds ends{};
    bool operator==(const Arc&) const = default;
};

/// One additional axis on a Spline: ((k3 t + k2) t + k1) t + to, degrees where rotary, else mm.
struct SplineAxis {
    std::array<char, 8> name{};  ///< as the control names it ("A", "C2"), zero-padded
    double to = 0, k1 = 0, k2 = 0, k3 = 0;
    bool rotary = true;
    bool operator==(const SplineAxis&) const = default;
};

/// Cubic move: x, y and z are ((k3 t + k2) t + k1) t + to, the parameter t runs from 1 at the start to 0 at the end.
/// Where the move starts follows from the record itself; cl/spline.hpp says how far that is from where the tool stands.
struct Spline {
    geom::Vec3 to;
    geom::Vec3 k1, k2, k3;
    geom::Vec3 axis{0, 0, 1};      ///< as of Linear, at the end
    std::vector<SplineAxis> axes;  ///< at most two
    AxisEnds ends{};               ///< of further ones
    bool operator==(const Spline&) const = default;
};

/// Synchronised thread pass: moves like Linear, spindle and axis coupled.
struct Thread {
    geom::Vec3 to;
    double pitch = 0;  ///< mm per revolution along the move; negative = left hand
    bool rigid_tap = false;
    double start = 0;   ///< degrees of the spindle at which the pass begins (SF, Q of G32): starts of several threads
    double change = 0;  ///< of the pitch with every revolution, mm (G34, G35 of SINUMERIK; K of FANUC's)
    geom::Vec3 axis{0, 0, 1};  ///< as of Linear
    AxisEnds ends{};
    bool operator==(const Thread&) const = default;
};

enum class PlaceKind : std::uint8_t {
    coordinates,  ///< as the program says them (G53, SUPA, M91)
    home,         ///< a reference point (G28, G74)
    fixed,        ///< another place that the machine keeps (G75)
    frame,        ///< none of the machine: what the program has said in the frame in force
};
/// The next move leads to a place of the machine along these axes, however the workpiece lies. Of kind `frame`: to
/// coordinates of the frame in force; the point on the workpiece does not tell which of them the program has said.
struct MachinePlace {
    PlaceKind kind = PlaceKind::coordinates;
    std::uint8_t number = 1;       ///< of reference points and fixed ones: which
    std::array<bool, 3> axes{};    ///< X, Y, Z go there
    geom::Vec3 to{NAN, NAN, NAN};  ///< coordinates as the control counts them, mm; NaN: not known
    /// Of coordinates: the tip of the tool goes there, by its compensated length (SUPA under D1); else what holds it
    /// does (G53, M91), or the tool has no length along these axes.
    bool tip = false;
    bool operator==(const MachinePlace&) const = default;
};

}  // namespace obrys::cl
