#pragma once
/// What is found of a tool that is not used as it cuts: the same on mills and on a lathe's axis.

#include "check/result.hpp"

namespace obrys::check {

/// Of a revolution's way: F is rounded, and threads in inch are programmed in mm.
inline constexpr double pitch_tolerance = 0.01;

/// The end that does not cut comes straight down upon material. `removed`: mm3.
[[nodiscard]] Finding plunges(bool tap, double removed);
/// A thread is tapped, `way` mm a revolution, with another tool.
[[nodiscard]] Finding is_no_tap(double way);
/// Coupled to the spindle a tap comes out as it went in: nothing where it does. mm a revolution.
[[nodiscard]] std::optional<Finding> comes_out_otherwise(double out, double in);
/// A tap leaves its thread by a rapid, or with the spindle standing or turning on.
[[nodiscard]] Finding drawn_out(bool rapid, bool stands);
/// With M3 (`sense` 1) or M4 (-1), which is not that of the tool. `standing`: it does not turn, the workpiece does.
[[nodiscard]] Finding turns_wrong(int sense, bool left_hand, bool standing);
[[nodiscard]] Finding cuts_other_hand(bool left_thread, bool left_tap);
[[nodiscard]] Finding driven_in();

/// How a tap goes in.
struct TapWay {
    double per_rev = NAN;  ///< mm
    double speed_rpm = NAN;
    bool coupled = false;  ///< to the spindle
};
[[nodiscard]] std::optional<Finding> wrong_pitch(const TapWay& way, double pitch);

}  // namespace obrys::check
