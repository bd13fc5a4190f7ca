#pragma once
/// Records of the stream that hold others: cycles, parts of the program, compensation, approaches. They are annotation:
/// who skips them gets the right moves. mm, radians, workpiece frame. Meaning: docs/cl-stream.md.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "base/shared_value.hpp"
#include "cl/cycle.hpp"
#include "cl/moves.hpp"
#include "geom/frame.hpp"
#include "geom/vec.hpp"

namespace obrys::cl {

struct CycleParameter {
    std::string name;
    double value = 0;
    bool operator==(const CycleParameter&) const = default;
};
/// What a cycle does, the same at all its places.
struct Cycle {
    CycleKind kind = CycleKind::drill;
    geom::Frame plane;                    ///< (u, v, w) of the working plane -> frame of the stream
    std::vector<CycleValue> values;       ///< each role at most once; counted in `plane`
    std::string name;                     ///< a remark: as the source spells it
    std::vector<CycleParameter> written;  ///< a remark: its parameters there, in the source's own units
    bool operator==(const Cycle&) const = default;
};

enum class CycleCall : std::uint8_t {
    single,   ///< where it stands in the program
    modal,    ///< by every block that positions, until it is cancelled (G81, M89)
    pattern,  ///< at the points of a pattern
};
/// The records up to the matching CycleEnd are this cycle at one place; brackets may lie one in another (the points of
/// a pattern). What lies inside: docs/cl-stream.md.
struct CycleBegin {
    base::SharedValue<Cycle> cycle;
    geom::Vec3 place;  ///< where the tool stands
    CycleCall call = CycleCall::single;
    std::uint64_t pass = 1;    ///< of a pattern's points, of the holes that one block makes
    std::uint64_t passes = 1;  ///< of them all
    bool operator==(const CycleBegin&) const = default;
};
struct CycleEnd {
    bool operator==(const CycleEnd&) const = default;
};

enum class CompensationSide : std::uint8_t {
    left,
    right
};  ///< of the contour, seen along it against the plane's normal
/// How the tool comes to the contour.
enum class Approach : std::uint8_t {
    normal,  ///< to the point square to the contour's start (NORM)
    around,  ///< the same, about the start where it lies behind it (KONT)
    smooth,  ///< by a line or an arc that ends along the contour (APPR, G147)
};
/// Radius compensation is in force for the records up to the matching CompensationEnd. Their points are the tool's
/// path; Programmed tells the contour.
struct CompensationBegin {
    CompensationSide side = CompensationSide::left;
    double radius = 0;         ///< mm; negative: the other side
    std::uint32_t offset = 0;  ///< D, or the tool's edge; 0: none
    Approach approach = Approach::normal;
    bool sharp = false;          ///< outer corners go out to the crossing of the parallels (G451); else arcs
    geom::Vec3 normal{0, 0, 1};  ///< of the plane in which it acts
    bool given = false;          ///< the program itself says the radius (G41.1 D), and no tool or offset
    std::uint32_t nose = 0;  ///< of a given radius: where the tip lies on it, as LinuxCNC counts (L); 0: in its centre
    bool operator==(const CompensationBegin&) const = default;
};
struct CompensationEnd {
    bool operator==(const CompensationEnd&) const = default;
};

enum class Corner : std::uint8_t {
    none,
    chamfer,      ///< by its length (CHF)
    chamfer_leg,  ///< by its legs (CHR, ,C)
    rounding,     ///< by its radius (RND, ,R)
};
/// An element of the contour as it is programmed, where compensation or a corner makes another path of it: the moves
/// with its source up to the next Programmed. Straight where `sweep` is 0, else as Arc.
struct Programmed {
    geom::Vec3 from, to;
    geom::Vec3 centre, normal{0, 0, 1};
    double sweep = 0;
    bool rapid = false;
    Corner corner = Corner::none;  ///< at its end
    double size = 0;               ///< of that, mm in the programmed frame
    double corner_feed = 0;        ///< of that alone (FRC, RND F), as Feed counts it; 0: none of its own
    AxisEnds ends{};
    bool operator==(const Programmed&) const = default;
};

enum class LeadKind : std::uint8_t {
    tangent_line,  ///< along the contour's tangent (APPR LT)
    normal_line,   ///< square to the contour (APPR LN)
    tangent_arc,   ///< on an arc that ends along the contour (APPR CT)
    arc_and_line,  ///< the same, with a line that is tangential to the arc (APPR LCT)
};
/// The records up to the matching LeadEnd are the control's own way onto a contour or off it.
struct LeadBegin {
    LeadKind kind = LeadKind::tangent_line;
    bool onto = true;  ///< the contour; else off it
    geom::Vec3 at;     ///< onto: the contour's first point; off by arc_and_line: the point to go to; else where it ends
    double length = 0;  ///< of the line, mm
    double radius = 0;  ///< of the arc that the tool's centre runs, mm; negative: on the other side
    double angle = 0;   ///< of the arc, radians
    bool rapid = false;
    double feed = 0;  ///< of it alone, as Feed counts it; 0: none of its own
    bool operator==(const LeadBegin&) const = default;
};
struct LeadEnd {
    bool operator==(const LeadEnd&) const = default;
};

enum class PartKind : std::uint8_t {
    call,        ///< of a program
    label,       ///< of a section of the same program (CALL LBL)
    repetition,  ///< of a section that has been run before (REP, REPEAT): its further passes
};
/// What a called program is given, as it names it: a parameter's name ("DEPTH", "#1") and its value.
struct PartArgument {
    std::string name;
    double value = 0;                   ///< in the program's own units; NaN: not known, or no number
    std::optional<std::string> text{};  ///< where it is one
    bool operator==(const PartArgument&) const = default;
};
/// The records up to the matching PartEnd come from a part of the program that is called or repeated; parts lie one in
/// another. A Stop that ends the program ends them all.
struct PartBegin {
    PartKind kind = PartKind::call;
    std::string name;                       ///< of the program or label, as the control names it; empty: it has none
    std::uint64_t pass = 1;                 ///< of a call that is repeated, from 1; of a repetition from 2
    std::uint64_t passes = 1;               ///< of them all
    std::vector<PartArgument> arguments{};  ///< of a call, those that it gives; a remark: the moves have them
    bool operator==(const PartBegin&) const = default;
};
struct PartEnd {
    bool operator==(const PartEnd&) const = default;
};

}  // namespace obrys::cl
