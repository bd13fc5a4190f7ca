#pragma once
/// Records of the stream about the zero of its coordinates and the frames in which they are programmed: mm, radians,
/// machine or workpiece coordinates as said; NaN: not known. Meaning: docs/cl-stream.md.

#include <cmath>
#include <cstdint>
#include <optional>
#include <vector>

#include "geom/frame.hpp"
#include "geom/vec.hpp"

namespace obrys::cl {

/// Zero of the workpiece frame in machine coordinates, from here on, as the program selects it or as it is set anew;
/// NaN where it is not known: along such an axis it is taken to lie where the zero before lay.
struct Datum {
    std::uint32_t number = 0;  ///< 54, 505; 500: none selected; 1000 …: presets 0 …; 0 = machine frame itself
    geom::Vec3 origin;
    bool selected = false;  ///< of 500: by a word of its own (G500)
    bool operator==(const Datum&) const = default;
};

/// What the program itself says a zero is (G10 L2); Datum tells what follows for the moves.
struct DatumData {
    std::uint32_t number = 0;          ///< 0: what is added to all of them
    geom::Vec3 origin{NAN, NAN, NAN};  ///< machine coordinates, mm; NaN: stays as it is, or is not known
    std::optional<double> turn{};      ///< radians about Z
    bool added = false;                ///< `origin` is added to where it lay (G91 G10)
    bool operator==(const DatumData&) const = default;
};

enum class FrameKind : std::uint8_t {
    datum,       ///< what the selected zero has besides its place: a turn
    shift,       ///< G52, G92, TRANS, cycle 7
    rotation,    ///< G68, ROT, cycle 10
    mirror,      ///< G51.1, MIRROR, cycle 8
    scaling,     ///< G51, SCALE, cycle 11; of all axes or of each
    plane,       ///< a tilted working plane
    programmed,  ///< several of these, which the control keeps as one frame
};
/// Which of the positions of the rotary axes a tilted plane takes, where the program says that.
struct PlaneTurn {
    std::int8_t side = 0;      ///< SEQ: the sign of the master axis; 0: the control chooses
    bool table_turns = false;  ///< TABLE ROT: a table turns where turning the coordinates alone would do
    /// The control turns the rotary axes to it, and where they then stand only the machine knows: no move tells it.
    bool by_control = false;
    bool operator==(const PlaneTurn&) const = default;
};
struct FramePart {
    FrameKind kind = FrameKind::shift;
    geom::Frame frame;
    PlaneTurn turn{};  ///< of planes
    bool operator==(const FramePart&) const = default;
};
/// How coordinates are programmed from here on: the product of the parts, the first the outermost, takes them into the
/// workpiece frame, where the points of the stream are all the same. No part: they are programmed there.
struct Frame {
    std::vector<FramePart> parts;
    bool operator==(const Frame&) const = default;
};

}  // namespace obrys::cl
