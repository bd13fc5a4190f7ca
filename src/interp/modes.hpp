#pragma once
/// What stays in force from block to block. Lengths in mm, angles in degrees. Private to interp.

#include <array>
#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "cl/record.hpp"
#include "geom/frame.hpp"
#include "interp/heard.hpp"
#include "program/word.hpp"

namespace obrys::interp {

using program::Modal;

enum class DiameterMode : std::uint8_t { off, on, absolute_only };

/// Coordinate transformations that are set one by one; they act in the order in which they were set.
enum class TransformKind : std::uint8_t { shift, mirror, rotation, scaling, axis_scaling, plane, call_place };
struct Transform {
    TransformKind kind = TransformKind::shift;
    geom::Frame frame;
    int axis = -1;         ///< of mirror images that each axis has of its own (centred.cpp)
    cl::PlaneTurn turn{};  ///< of tilted planes
};

/// What a tilted plane still wants of the rotary axes.
enum class PlaneWait : std::uint8_t {
    none,
    for_axes,  ///< a word of its own is to turn them to it (G53.1)
    ended,     ///< none is in force any more: how they count from here on goes with the next move
    lost       ///< the plane was not run
};

/// What stays in force from block to block; SAVE brings it back at the end of a subprogram.
struct ModalState {
    Modal motion = Modal::linear;
    int plane = 17;
    bool plane_said = false;  ///< by the program
    bool absolute = true;
    bool inch_geometry = false, inch_feed = false;
    bool unit_said = false;  ///< by the program
    DiameterMode diameter = DiameterMode::off;
    cl::FeedMode feed_mode = cl::FeedMode::per_minute;
    /// Of FZ where it stays until the next F (Traits::tooth_feed_stays), in the program's unit of feed.
    std::optional<double> tooth_feed{};
    int tooth_feed_teeth = 0;  ///< of the tool that it was last reckoned for; 0: not known
    bool surface_speed = false;
    int speed_word = 0;        ///< 96, 97, 961 … where it was the last of its G group
    bool metric_feed = false;  ///< G710 rather than G71
    Modal compensation = Modal::compensation_off;
    base::Span compensation_word;  ///< that switched it on
    Modal approach = Modal::approach_normal;
    Modal corner = Modal::corner_arc;
    int look_ahead = 0;  ///< contour elements that compensation looks ahead (M120 LA)
    Modal feed_reference = Modal::feed_at_contour;
    double plunge_part = 1;  ///< of F, at most along the tool axis into the material (M103)
    std::uint32_t datum = 500;
    bool datum_said = false;  ///< by a word of the program
    /// Where the datum before lies in the machine: axes that the selected one leaves as they are; NaN: not known.
    geom::Vec3 datum_before{std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN(),
                            std::numeric_limits<double>::quiet_NaN()};
    geom::Vec3 datum_offset;  ///< of a datum that the program sets itself (FN 25), in the selected one, mm
    geom::Frame programmed;   ///< TRANS, ROT, SCALE, MIRROR; product of `transforms` where there are any
    std::vector<Transform> transforms;
    PlaneWait plane_waits = PlaneWait::none;
    geom::Vec3 tip_before_end;  ///< on the workpiece, where the last plane has ended
    std::pair<std::uint32_t, std::string> tool_before_plane{0, {}};
    geom::Vec3 axis_before_plane{0, 0, 1};  ///< of the tool, before the last tilted plane or its end
    Modal last_sense = Modal::linear;       ///< of the last arc; linear: none yet
    bool cartesian_path = false;        ///< the path function in force takes no polar coordinates (DIN/ISO G00 … G06)
    Modal paraxial = Modal::paraxial;   ///< G43, G44 of DIN/ISO: paraxial_longer, paraxial_shorter; paraxial: neither
    Modal before_cycle = Modal::rapid;  ///< motion that the hole cycle in force took the place of
    bool rapid_by_cancel = false;       ///< … and G80 left rapid in its place
    int motion_number = 0;              ///< which canned cycle, which kind of probing
    bool clear_to_retract_plane = false;  ///< G99
    bool centre_absolute = false;         ///< G90.1
    double blend = 0, merge = 0;          ///< G64 P Q, mm
    bool blend_free = false;              ///< G64 without P (Traits::blends_without_limit)
    Modal path_mode = Modal::path_blend;
    double compensation_radius = std::numeric_limits<double>::quiet_NaN();  ///< G41 D, G41.1; NaN: of the tool, mm
    /// D programmed last (Traits::offset_numbers_stay); NaN: none yet.
    double offset_d = std::numeric_limits<double>::quiet_NaN();
    bool compensation_given = false;     ///< G41.1: that radius stands in the program
    int compensation_orientation = -1;   ///< G41.1 L: where the tip lies on the nose; -1: of the tool
    bool feed_by_word = false;           ///< feed_mode was chosen by a word of its own (FU) until the next F
    double round_modal = 0;              ///< RNDM, mm
    double tolerance_cycle = 0;          ///< mm that CYCLE832 or CYCL DEF 32 allows the path; 0: off
    std::string_view tolerance_by{};     ///< which of them
    bool compensation_in_frame = false;  ///< CUT2DF
    bool compressor = false;             ///< COMPON, COMPCURV, COMPCAD
    int smoothing = 0;                   ///< 64, 641 … 645; 0: exact stop
    double rounding_distance = 0, rounding_distance_rapid = 0;  ///< ADIS, ADISPOS, mm
    /// CTOL, mm; NaN: that of the machine's data.
    double contour_tolerance = std::numeric_limits<double>::quiet_NaN();
    double corner_overshoot = 0;   ///< DISC, per cent
    double contour_allowance = 0;  ///< OFFN, mm
    double corner_feed_modal = 0;  ///< FRCM
    geom::Vec3 pole;               ///< workpiece coordinates
    bool pole_set = false;         ///< the program has set it
    int pole_plane = 0;            ///< 17, 18, 19: of its coordinates, where that is not the working plane; else 0
    // What nobody has said is not as a control begins: it holds what the program before has left.
    std::uint32_t groups_said = 0;  ///< bit per program::ModalGroup of which the program has said a word
    bool feed_said = false, mist_said = false, flood_said = false;  ///< F; M7, M8 or M9
    /// Last RP (mm) and AP (degrees, NaN after a new pole or plane); NaN: none yet.
    double polar_radius = std::numeric_limits<double>::quiet_NaN();
    double polar_angle = std::numeric_limits<double>::quiet_NaN();
};
/// mm of a length of 1 in the program.
[[nodiscard]] inline double length_unit(const ModalState& m) { return m.inch_geometry ? 25.4 : 1; }
inline void forget_polar_angle(ModalState& m) { m.polar_angle = std::numeric_limits<double>::quiet_NaN(); }

struct SpindleState {
    double speed = 0;           ///< S as programmed
    double limit = 0;           ///< LIMS
    double surface = 0;         ///< cutting speed of the last G96, m/min
    bool mode_changed = false;  ///< by the block being run: G96 or G97
    int direction = 0;
    int last = 0;                ///< the last direction in which it turned
    std::optional<double> held;  ///< degrees at which it stands; NaN: the machine knows
    double orientation = std::numeric_limits<double>::quiet_NaN();  ///< degrees, of M19 where the program sets them
    bool speed_known = false;      ///< the program has said S; what the control held before is not 0
    bool direction_known = false;  ///< … M3, M4 or M5
    /// A stop of the program that may have stopped it stands before here (Traits::spindle_stops, STOP).
    bool doubtful = false;
};

/// Spindles besides the one that S and M3 are for (spindles.cpp).
struct OtherSpindles {
    int master = 1;  ///< the number of that one
    struct Other {
        double speed = 0;
        int direction = 0;
    };
    std::map<int, Other> others{};
};

/// X Y Z A B C U V W; mm or degrees.
[[nodiscard]] inline std::string axis_name(std::size_t axis) { return std::string(1, "XYZABCUVW"[axis]); }

/// Offsets that the control keeps in parameters (Traits::offsets) and those laid over them.
struct Offsets {
    Axes datum{};         ///< of the active zero offset, in the machine
    double rotation = 0;  ///< of it about Z, degrees
    Axes shift{};         ///< G92, G52
    Axes tool{};          ///< tool length compensation in force
    Axes tip{};           ///< of the tool that is in the spindle, as far as it is known
    bool tip_known = false;
    bool compensates = false;  ///< the program uses tool length compensation at all
    /// Whose length compensation is in force.
    enum class Length : std::uint8_t { none, of_tool, by_values };
    Length length = Length::none;
    std::uint32_t length_tool = 0;  ///< number of that tool
    std::uint32_t said_for = 0;     ///< the tool that was in the spindle when that number was programmed
    /// H programmed last (Traits::offset_numbers_stay); NaN: none yet.
    double number = std::numeric_limits<double>::quiet_NaN();
    bool subtracts = false;          ///< G44 rather than G43
    bool is_not_given = false;       ///< how long that is nobody has said
    bool lost = false;               ///< the axes have been at a home position whose place is not known
    std::uint32_t from_unknown = 0;  ///< bit per axis that G92 has shifted from a place not known
    bool length_judged = false;      ///< for this tool, zero and compensation
    bool length_said = false;        ///< … a rapid move has: it is not known
    /// Zeros by the first tool that cut by them, or with which the program set them.
    struct TouchedOff {
        std::uint32_t tool = 0;
        Axes offset{};             ///< what compensating it means; Z 0: not known
        bool compensated = false;  ///< a compensated one was: the zero counts from the gauge point
    };
    std::map<std::uint32_t, TouchedOff> zeros{};  ///< by datum
    Axes reference{};                             ///< what the stream's coordinates are counted from, in the machine
    /// Job, file or program said where that lies, before the first move: by axis, and how it is turned about Z.
    std::array<bool, 10> given{};
    std::array<bool, 9> external_given{};  ///< the same of what is added to every zero offset
    bool shift_said = false;               ///< the program itself has said which shift holds (not only moved it by G92)
    Axes total{};                          ///< programmed -> stream, of A … W (3 … 8)
};

/// Overrides that the program allows (M48 … M53).
struct Overrides {
    bool feed = true, speed = true, hold = true;
};

/// What M70 and M73 keep (saved_modes.cpp).
struct SavedModes {
    ModalState modal;
    double feed = 0;
    bool feed_valid = false;
    double feed_number = 0;  ///< as F wrote it
    SpindleState spindle;
    bool mist = false, flood = false;
    Axes tool_offset{};
    Offsets::Length length = Offsets::Length::none;
    std::uint32_t length_tool = 0;
    Overrides overrides;
};

}  // namespace obrys::interp
