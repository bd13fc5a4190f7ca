#include "check/use_findings.hpp"

#include <cmath>

#include "base/codes.hpp"
#include "check/words.hpp"

namespace obrys::check {

namespace codes = base::codes;

namespace {

std::string hand(bool left) { return left ? "left-hand" : "right-hand"; }

Finding finding(std::string_view code, std::string text, std::string remedy) {
    Finding f;
    f.code = code;
    f.text = std::move(text);
    f.remedy = std::move(remedy);
    return f;
}

}  // namespace

Finding plunges(bool tap, double removed) {
    Finding f = finding(codes::plunging_cut,
                        tap ? "the core of the tap meets material: its hole is too narrow, not deep enough or missing"
                            : "the tool plunges into the material, but it does not cut at its centre",
                        tap ? "drill before, wide and deep enough" : "enter by a ramp or a helix, or drill before");
    f.amounts = {{"volume_mm3", removed}};
    return f;
}

Finding is_no_tap(double way) {
    Finding f =
        finding(codes::tap_pitch, "a thread is tapped here, " + mm(way) + " a revolution, and the tool is no tap",
                "call the tap, or correct its kind in the tool list");
    f.amounts = {{"way_mm", way}};
    return f;
}

std::optional<Finding> comes_out_otherwise(double out, double in) {
    if (!std::isfinite(out) || !std::isfinite(in) || std::abs(out - in) <= pitch_tolerance * in) return std::nullopt;
    Finding f = finding(codes::tap_pitch, "the tap comes out " + mm(out) + " a revolution, it went in " + mm(in),
                        "program the same pitch both ways");
    f.amounts = {{"way_mm", out}, {"pitch_mm", in}};
    return f;
}

Finding drawn_out(bool rapid, bool stands) {
    return finding(
        codes::wrong_rotation,
        std::string("the tap is drawn out of its thread ") + (rapid    ? "by a rapid move"
                                                              : stands ? "while the spindle stands"
                                                                       : "while the spindle turns on as it cut"),
        "reverse the spindle at the bottom and feed it out, or take the control's tapping cycle");
}

Finding turns_wrong(int sense, bool left_hand, bool standing) {
    const std::string right = left_hand ? "M4" : "M3";
    return finding(
        codes::wrong_rotation,
        std::string("the tool cuts with ") + (sense < 0 ? "M4" : "M3") + ", but it is " + hand(left_hand) +
            (standing ? " and stands: the workpiece must turn with " + right : ""),
        "program " + right + (left_hand ? "" : "; a left-hand tool has rotation = \"left\" in its [[tool]]"));
}

Finding cuts_other_hand(bool left_thread, bool left_tap) {
    return finding(codes::wrong_rotation, "the thread is " + hand(left_thread) + ", the tap is " + hand(left_tap),
                   "take the other tap or change the sense of the thread; a left-hand tap has rotation = \"left\" in "
                   "its [[tool]]");
}

Finding driven_in() {
    return finding(codes::spindle_stopped, "the tap is driven in while the spindle stands",
                   "start the spindle with M3 or M4 and a speed S");
}

std::optional<Finding> wrong_pitch(const TapWay& way, double pitch) {
    if (std::abs(way.per_rev - pitch) <= pitch_tolerance * pitch) return std::nullopt;
    Finding f =
        finding(codes::tap_pitch, "the tap goes " + mm(way.per_rev) + " a revolution, its pitch is " + mm(pitch),
                way.coupled ? "program the pitch of the tap, or take the tap of this pitch"
                            : "program a feed of speed x pitch: " + plain(way.speed_rpm * pitch) + " mm/min at " +
                                  plain(way.speed_rpm) + " 1/min");
    f.amounts = {{"way_mm", way.per_rev}, {"pitch_mm", pitch}};
    return f;
}

}  // namespace obrys::check
