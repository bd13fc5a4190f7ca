/// G codes of mills. Sources: FANUC series 16i/18i-M and 0i-M operator's manuals, list of G codes; Haas mill operator's
/// manual 96-8000, G codes.

#include <array>

#include "dialect/rs274/fanuc.hpp"

namespace obrys::dialect::rs274 {

using enum FanucUse;
using program::Modal;
using Special = FanucSpecial;

namespace {

constexpr FanucG word(int code, Modal m, Order order, int number = 0) {
    return {static_cast<std::int16_t>(code), modal, m, static_cast<std::int16_t>(number), order, Special::none, {}};
}
constexpr FanucG more(int code, Special s, Order order, Modal m = Modal::linear, int number = 0) {
    return {static_cast<std::int16_t>(code), special, m, static_cast<std::int16_t>(number), order, s, {}};
}
constexpr FanucG hole(int code) { return more(code, Special::canned, Order::motion, Modal::canned, code); }
constexpr FanucG no_effect(int code, std::string_view says, std::string_view letters = {}) {
    return {static_cast<std::int16_t>(code), accepted, Modal::linear, 0, Order::motion, Special::none, says, letters};
}
constexpr FanucG not_run(int code, std::string_view says) {
    return {static_cast<std::int16_t>(code), refused, Modal::linear, 0, Order::motion, Special::none, says};
}
/// Not run, and in force for the blocks behind it until another motion or G80.
constexpr FanucG motion_not_run(int code, std::string_view says) {
    return {static_cast<std::int16_t>(code), refused, Modal::canned, 0, Order::motion, Special::none, says};
}
/// Not run, but the block ends where its coordinates say.
constexpr FanucG not_applied(int code, std::string_view says) {
    return {static_cast<std::int16_t>(code), refused, Modal::linear, 0, Order::tool_length, Special::none, says};
}

constexpr std::array mill{
    word(0, Modal::rapid, Order::motion),
    word(10, Modal::linear, Order::motion),
    word(20, Modal::arc_cw, Order::motion),
    word(30, Modal::arc_ccw, Order::motion),
    motion_not_run(22, "involute interpolation"),
    motion_not_run(32, "involute interpolation"),
    motion_not_run(23, "exponential interpolation"),
    motion_not_run(33, "exponential interpolation"),
    more(40, Special::dwell, Order::dwell, Modal::dwell),
    no_effect(50, "high-speed machining", "P"),
    no_effect(51, "look-ahead control of contours", "QR"),
    no_effect(54, "high-speed machining", "Q"),
    motion_not_run(62, "NURBS interpolation"),
    not_run(70, "interpolation with a hypothetical axis"),
    not_run(71, "cylindrical interpolation"),
    not_run(1070, "cylindrical interpolation"),
    no_effect(80, "look-ahead control", "P"),
    word(90, Modal::exact_stop_block, Order::path_control),
    more(100, Special::set_data, Order::special, Modal::set_data),
    not_run(106, "retract and recovery of the tool"),
    no_effect(110, "end of data setting"),
    not_run(121, "polar coordinate interpolation"),
    not_run(1120, "polar coordinate interpolation"),
    no_effect(131, "end of polar coordinate interpolation"),
    no_effect(1130, "end of polar coordinate interpolation"),
    more(150, Special::polar_off, Order::special),
    more(160, Special::polar, Order::special),
    word(170, Modal::plane_xy, Order::plane),
    word(180, Modal::plane_zx, Order::plane),
    word(190, Modal::plane_yz, Order::plane),
    word(200, Modal::inch_all, Order::units),
    word(210, Modal::metric_all, Order::units),
    no_effect(220, "stored stroke check on", "XYZIJK"),
    no_effect(230, "stored stroke check off"),
    no_effect(250, "watching of the spindle speed off"),
    no_effect(260, "watching of the spindle speed on", "PQRI"),
    not_run(270, "check of the reference position"),
    more(280, Special::home, Order::special, Modal::home, 1),
    not_run(290, "way back from the reference position"),
    more(300, Special::home, Order::special, Modal::home, 2),
    not_run(301, "return to the floating reference position"),
    more(310, Special::probe, Order::motion, Modal::probe, 1),
    more(330, Special::thread, Order::motion, Modal::thread),
    not_run(370, "automatic measuring of the tool length"),
    not_run(390, "corner arc of the compensation"),
    word(400, Modal::compensation_off, Order::compensation),
    word(410, Modal::compensation_left, Order::compensation),
    word(420, Modal::compensation_right, Order::compensation),
    no_effect(401, "normal direction control off"),
    no_effect(1500, "normal direction control off"),
    not_applied(411, "normal direction control"),
    not_applied(421, "normal direction control"),
    word(430, Modal::tool_length, Order::tool_length),
    word(440, Modal::tool_length_negative, Order::tool_length),
    not_applied(431, "tool length along a tilted axis"),
    not_applied(434, "tool centre point control"),
    not_applied(435, "tool centre point control"),
    not_run(450, "extension of a way by the tool offset"),
    not_run(460, "shortening of a way by the tool offset"),
    not_run(470, "extension of a way by twice the tool offset"),
    not_run(480, "shortening of a way by twice the tool offset"),
    word(490, Modal::tool_length_off, Order::tool_length),
    word(491, Modal::tool_length_off, Order::tool_length),
    more(500, Special::scaling_off, Order::special),
    more(510, Special::scaling, Order::special),
    more(501, Special::mirror_off, Order::special),
    more(511, Special::mirror, Order::special),
    word(520, Modal::local_shift, Order::special),
    word(530, Modal::suppress_all, Order::suppress),
    more(531, Special::take_up_tilt, Order::special),
    not_run(536, "tool axis direction control that keeps the place of the tool's tip"),
    word(540, Modal::datum, Order::datum, 54),
    word(550, Modal::datum, Order::datum, 55),
    word(560, Modal::datum, Order::datum, 56),
    word(570, Modal::datum, Order::datum, 57),
    word(580, Modal::datum, Order::datum, 58),
    word(590, Modal::datum, Order::datum, 59),
    more(541, Special::datum_number, Order::datum, Modal::datum),
    not_run(542, "dynamic fixture offset of a rotary table"),
    not_applied(600, "positioning from one side: the overrun is a parameter of the machine"),
    word(610, Modal::path_exact, Order::path_control),
    no_effect(620, "corner override"),
    no_effect(630, "tapping mode"),
    word(640, Modal::path_blend, Order::path_control),
    more(650, Special::macro_call, Order::special),
    more(660, Special::macro_modal, Order::special),
    not_run(661, "a macro called by every block"),
    more(670, Special::macro_end, Order::special),
    more(680, Special::rotation, Order::special),
    more(682, Special::tilt, Order::special),
    not_run(683, "tilted working plane by the tool's direction"),
    not_run(684, "tilted working plane within another one"),
    more(690, Special::rotation_off, Order::special),
    hole(730),
    hole(740),
    hole(760),
    word(800, Modal::canned_off, Order::retract),
    hole(810),
    not_run(811, "chopping"),
    no_effect(801, "chopping off"),
    hole(820),
    hole(830),
    hole(840),
    motion_not_run(842, "rigid tapping, old form"),
    motion_not_run(843, "rigid tapping to the left, old form"),
    hole(850),
    hole(860),
    hole(870),
    hole(880),
    hole(890),
    word(900, Modal::absolute, Order::distance),
    word(910, Modal::incremental, Order::distance),
    more(920, Special::position, Order::special, Modal::position_becomes),
    word(921, Modal::position_reset, Order::special),
    word(930, Modal::feed_inverse_time, Order::feed_mode),
    word(940, Modal::feed_per_minute, Order::feed_mode),
    word(950, Modal::feed_per_rev, Order::feed_mode),
    word(960, Modal::surface_speed_on, Order::feed_mode, 96),
    word(970, Modal::surface_speed_off, Order::feed_mode, 97),
    word(980, Modal::retract_initial, Order::retract),
    word(990, Modal::retract_clearance, Order::retract),
};

/// G110 … G129 are G154 P1 … P20.
constexpr FanucG zero(int number) {
    return more((109 + number) * 10, Special::datum_number, Order::datum, Modal::datum, number);
}

constexpr std::string_view foreign = "not a G code of this control";

constexpr std::array haas{
    word(120, Modal::circle_pocket, Order::special, 0),
    word(130, Modal::circle_pocket, Order::special, 1),
    not_run(50, "rigid tapping along the tool axis"),
    not_run(51, foreign),
    not_run(54, foreign),
    not_run(80, foreign),
    not_run(110, foreign),
    not_run(131, foreign),
    not_run(150, foreign),
    not_run(160, foreign),
    not_run(220, foreign),
    not_run(230, foreign),
    not_run(250, foreign),
    not_run(260, foreign),
    not_run(350, "automatic measuring of the tool diameter"),
    not_run(360, "automatic measuring of the work offset"),
    not_run(370, "automatic measuring of the tool length"),
    not_run(401, foreign),
    not_run(470, "text engraving: the manual does not have the form of its letters"),
    not_applied(600, "positioning from one side: the overrun is a parameter of the machine"),
    not_run(531, foreign),
    not_run(536, foreign),
    not_run(620, foreign),
    not_run(630, foreign),
    not_run(682, foreign),
    not_run(683, foreign),
    not_run(684, foreign),
    more(700, Special::local_pattern, Order::motion),
    more(710, Special::local_pattern, Order::motion),
    not_run(720, "holes along a line: the manual does not say whether the first one is made at the start"),
    hole(770),
    not_run(801, foreign),
    more(1000, Special::mirror_off, Order::special),
    more(1010, Special::mirror, Order::special),
    no_effect(1020, "output of the positions"),
    no_effect(1030, "limit of the look-ahead", "P"),
    not_run(1070, "cylindrical mapping"),
    zero(1),
    zero(2),
    zero(3),
    zero(4),
    zero(5),
    zero(6),
    zero(7),
    zero(8),
    zero(9),
    zero(10),
    zero(11),
    zero(12),
    zero(13),
    zero(14),
    zero(15),
    zero(16),
    zero(17),
    zero(18),
    zero(19),
    zero(20),
    not_run(1360, "automatic measuring of the work offset's centre"),
    not_applied(1410, "compensation of the cutter in space"),
    not_applied(1430, "tool length along five axes"),
    not_run(1500, "general purpose pocket milling: the manual does not have the order of its rows"),
    motion_not_run(1530, "high-speed peck drilling along five axes"),
    more(1540, Special::datum_number, Order::datum, Modal::datum),
    motion_not_run(1550, "left-hand tapping along five axes"),
    motion_not_run(1610, "drilling along five axes"),
    motion_not_run(1620, "spot drilling along five axes"),
    motion_not_run(1630, "peck drilling along five axes"),
    motion_not_run(1640, "tapping along five axes"),
    motion_not_run(1650, "boring along five axes"),
    motion_not_run(1660, "boring along five axes"),
    motion_not_run(1690, "boring along five axes"),
    not_run(1740, "rigid tapping along any line"),
    not_run(1840, "rigid tapping along any line"),
    word(1870, Modal::path_blend, Order::path_control, 187),  // 96-8000: E is the largest rounding of corners
    not_applied(2340, "tool centre point control"),
    more(2530, Special::take_up_tilt, Order::special),
    more(2540, Special::tilt_by_axes, Order::special),
    more(2550, Special::tilt_off, Order::special, Modal::linear, 2550),
    more(2680, Special::tilt_spatial, Order::special),
    more(2690, Special::tilt_off, Order::special, Modal::linear, 2690),
};

}  // namespace

std::span<const FanucG> mill_g_table() { return mill; }
std::span<const FanucG> haas_mill_g_table() { return haas; }

}  // namespace obrys::dialect::rs274
