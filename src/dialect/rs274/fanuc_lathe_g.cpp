/// G codes of lathes in the systems A, B and C. Sources: FANUC series 16i/18i-T and 0i-T operator's manuals, list of G
/// codes; Haas lathes have those of system A.

#include <array>

#include "dialect/rs274/fanuc.hpp"

namespace obrys::dialect::rs274 {

using enum FanucUse;
using program::Modal;
using Special = FanucSpecial;

namespace {

constexpr LatheG row(int a, int b, int c, FanucUse use, Modal m, Order order, int number = 0, Special s = Special::none,
                     std::string_view says = {}) {
    return {static_cast<std::int16_t>(a),
            static_cast<std::int16_t>(b),
            static_cast<std::int16_t>(c),
            {0, use, m, static_cast<std::int16_t>(number), order, s, says}};
}
constexpr LatheG word(int code, Modal m, Order order, int number = 0) {
    return row(code, code, code, modal, m, order, number);
}
constexpr LatheG more(int code, Special s, Order order, Modal m, int number = 0) {
    return row(code, code, code, special, m, order, number, s);
}
constexpr LatheG no_effect(int code, std::string_view says, std::string_view letters = {}) {
    LatheG g = row(code, code, code, accepted, Modal::linear, Order::motion, 0, Special::none, says);
    g.meaning.letters = letters;
    return g;
}
constexpr LatheG not_run(int code, std::string_view says) {
    return row(code, code, code, refused, Modal::linear, Order::motion, 0, Special::none, says);
}
/// In force for the blocks behind it until another motion.
constexpr LatheG motion_not_run(int code, std::string_view says) {
    return row(code, code, code, refused, Modal::canned, Order::motion, 0, Special::none, says);
}
constexpr LatheG cycle(int a, int b, int c, Special s, std::string_view says, int number) {
    return row(a, b, c, special, Modal::turning_cycle, Order::special, number, s, says);
}

constexpr std::array lathe{
    word(0, Modal::rapid, Order::motion),
    word(10, Modal::linear, Order::motion),
    word(20, Modal::arc_cw, Order::motion),
    word(30, Modal::arc_ccw, Order::motion),
    more(40, Special::dwell, Order::dwell, Modal::dwell),
    no_effect(50, "high-speed machining", "P"),
    no_effect(51, "look-ahead control of contours", "QR"),
    not_run(70, "interpolation with a hypothetical axis"),
    more(71, Special::cylinder_face, Order::special, Modal::cylinder_face),
    more(1070, Special::cylinder_face, Order::special, Modal::cylinder_face),
    no_effect(80, "look-ahead control", "P"),
    word(90, Modal::exact_stop_block, Order::path_control),
    more(100, Special::set_data, Order::special, Modal::set_data),
    no_effect(110, "end of data setting"),
    more(121, Special::polar_face, Order::special, Modal::polar_face),
    more(1120, Special::polar_face, Order::special, Modal::polar_face),
    more(131, Special::interpolation_off, Order::special, Modal::interpolation_off),
    more(1130, Special::interpolation_off, Order::special, Modal::interpolation_off),
    word(170, Modal::plane_xy, Order::plane),
    word(180, Modal::plane_zx, Order::plane),
    word(190, Modal::plane_yz, Order::plane),
    row(200, 200, 700, modal, Modal::inch_all, Order::units),
    row(210, 210, 710, modal, Modal::metric_all, Order::units),
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
    row(320, 330, 330, special, Modal::thread, Order::motion, 0, Special::thread),
    motion_not_run(340, "thread with a variable lead"),
    motion_not_run(350, "circular thread"),
    not_run(360, "automatic measuring of the tool offset along X"),
    not_run(370, "automatic measuring of the tool offset along Z"),
    not_run(390, "corner arc of the compensation"),
    word(400, Modal::compensation_off, Order::compensation),
    word(410, Modal::compensation_left, Order::compensation),
    word(420, Modal::compensation_right, Order::compensation),
    word(490, Modal::tool_length_off, Order::tool_length),
    row(500, 920, 920, special, Modal::position_becomes, Order::special, 0, Special::position),
    row(503, 921, 921, modal, Modal::position_reset, Order::special),
    row(502, 502, 502, accepted, Modal::linear, Order::motion, 0, Special::none, "polygon turning off"),
    row(2500, 2500, 2500, accepted, Modal::linear, Order::motion, 0, Special::none, "polygon turning off"),
    not_run(512, "polygon turning"),
    not_run(2510, "polygon turning"),
    word(520, Modal::local_shift, Order::special),
    word(530, Modal::suppress_all, Order::suppress),
    word(540, Modal::datum, Order::datum, 54),
    word(550, Modal::datum, Order::datum, 55),
    word(560, Modal::datum, Order::datum, 56),
    word(570, Modal::datum, Order::datum, 57),
    word(580, Modal::datum, Order::datum, 58),
    word(590, Modal::datum, Order::datum, 59),
    more(541, Special::datum_number, Order::datum, Modal::datum),
    word(610, Modal::path_exact, Order::path_control),
    word(640, Modal::path_blend, Order::path_control),
    more(650, Special::macro_call, Order::special, Modal::linear),
    more(660, Special::macro_modal, Order::special, Modal::linear),
    not_run(661, "a macro called by every block"),
    more(670, Special::macro_end, Order::special, Modal::linear),
    not_run(680, "mirror image for double turrets"),
    no_effect(690, "mirror image for double turrets off"),
    cycle(700, 700, 720, Special::repetitive, "finishing cycle", 700),
    cycle(710, 710, 730, Special::repetitive, "stock removal along Z", 710),
    cycle(720, 720, 740, Special::repetitive, "stock removal along X", 720),
    cycle(730, 730, 750, Special::repetitive, "pattern repeating", 730),
    cycle(740, 740, 760, Special::repetitive, "peck drilling in the face", 740),
    cycle(750, 750, 770, Special::repetitive, "grooving with chip breaking", 750),
    cycle(760, 760, 780, Special::repetitive, "thread in several passes", 760),
    word(800, Modal::canned_off, Order::retract),
    cycle(830, 830, 830, Special::turning_cycle, "hole cycle along Z", 830),
    cycle(840, 840, 840, Special::turning_cycle, "hole cycle along Z", 840),
    cycle(850, 850, 850, Special::turning_cycle, "hole cycle along Z", 850),
    cycle(870, 870, 870, Special::turning_cycle, "hole cycle along X", 870),
    cycle(880, 880, 880, Special::turning_cycle, "hole cycle along X", 880),
    cycle(890, 890, 890, Special::turning_cycle, "hole cycle along X", 890),
    cycle(900, 770, 200, Special::turning_cycle, "turning cycle", 900),
    cycle(920, 780, 210, Special::turning_cycle, "threading cycle", 920),
    cycle(940, 790, 240, Special::turning_cycle, "facing cycle", 940),
    row(-1, 900, 900, modal, Modal::absolute, Order::distance),
    row(-1, 910, 910, modal, Modal::incremental, Order::distance),
    row(980, 940, 940, modal, Modal::feed_per_minute, Order::feed_mode),
    row(990, 950, 950, modal, Modal::feed_per_rev, Order::feed_mode),
    word(960, Modal::surface_speed_on, Order::feed_mode, 96),
    word(970, Modal::surface_speed_off, Order::feed_mode, 97),
    row(-1, 980, 980, modal, Modal::retract_initial, Order::retract),
    row(-1, 990, 990, modal, Modal::retract_clearance, Order::retract),
};

/// Haas: lathe operator's manual, canned cycles [-].
constexpr FanucG haas_hole(int code) {
    return {
        static_cast<std::int16_t>(code), special, Modal::turning_cycle, static_cast<std::int16_t>(code), Order::special,
        Special::turning_cycle,          {}};
}
constexpr FanucG haas_not_run(int code, std::string_view says) {
    return {static_cast<std::int16_t>(code), refused, Modal::linear, 0, Order::motion, Special::none, says};
}
constexpr FanucG haas_motion_not_run(int code, std::string_view says) {
    return {static_cast<std::int16_t>(code), refused, Modal::canned, 0, Order::motion, Special::none, says};
}
constexpr std::string_view haas_foreign = "not a G code of this control";

constexpr std::array haas_lathe{
    haas_motion_not_run(50, "fine motion of the spindle together with the axes"),
    haas_not_run(51, haas_foreign),
    haas_not_run(71, haas_foreign),
    haas_not_run(80, haas_foreign),
    haas_not_run(110, haas_foreign),
    haas_hole(810),
    haas_hole(820),
    haas_motion_not_run(860, "boring with a stop of the spindle"),
    haas_motion_not_run(870, "boring with a way back by hand"),
    haas_motion_not_run(880, "boring with a way back by hand"),
    haas_hole(890),
    haas_not_run(1070, "cylindrical mapping"),
    haas_not_run(1120, "polar coordinate interpolation"),
    FanucG{1130, accepted, Modal::linear, 0, Order::motion, Special::none, "end of polar coordinate interpolation"},
    haas_not_run(121, haas_foreign),
    haas_not_run(131, haas_foreign),
    haas_not_run(220, haas_foreign),
    haas_not_run(230, haas_foreign),
    haas_not_run(250, haas_foreign),
    haas_not_run(260, haas_foreign),
    haas_not_run(502, haas_foreign),
    haas_not_run(690, haas_foreign),
    haas_not_run(2500, haas_foreign),
    haas_not_run(1950, "tapping with a driven tool"),
    haas_not_run(1960, "tapping with a driven tool, to the left"),
    haas_motion_not_run(2410, "drilling along X with a driven tool"),
    haas_motion_not_run(2420, "drilling along X with a driven tool"),
    haas_motion_not_run(2430, "drilling along X with a driven tool"),
    haas_motion_not_run(2450, "boring along X with a driven tool"),
};

}  // namespace

std::span<const LatheG> lathe_g_table() { return lathe; }
std::span<const FanucG> haas_lathe_g_table() { return haas_lathe; }

}  // namespace obrys::dialect::rs274
