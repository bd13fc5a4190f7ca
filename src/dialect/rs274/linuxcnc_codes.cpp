#include "dialect/rs274/linuxcnc.hpp"

namespace obrys::dialect::rs274 {

namespace {

using program::Modal;
using enum Order;

/// A modal word without coordinates of its own.
constexpr GCode plain(std::uint16_t number, std::uint8_t group, Order order, Modal modal, std::uint16_t n = 0) {
    return {number, group, Use::modal, order, modal, n, Axes::none, {}};
}
constexpr GCode move(std::uint16_t number, Modal modal, Axes axes, std::uint16_t n = 0) {
    return {number, 1, Use::modal, motion, modal, n, axes, {}};
}
constexpr GCode cycle(std::uint16_t number) {
    return {number, 1, Use::canned, motion, Modal::canned, 0, Axes::required, {}};
}
constexpr GCode turning(std::uint16_t number, Axes axes) {
    return {number, 1, Use::modal, motion, Modal::turning_cycle, number, axes, {}};
}
constexpr GCode group0(std::uint16_t number, Modal modal, std::uint16_t n, Axes axes) {
    return {number, 0, Use::modal, special, modal, n, axes, {}};
}
constexpr GCode refused(std::uint16_t number, std::uint8_t group, Order order, std::string_view reason) {
    return {number, group, Use::unsupported, order, Modal::rapid, 0, Axes::none, reason};
}

constexpr std::string_view auxiliary_plane = "a plane of the axes U V W";

constexpr std::array g_codes{
    move(0, Modal::rapid, Axes::allowed),
    move(10, Modal::linear, Axes::allowed),
    move(20, Modal::arc_cw, Axes::allowed),
    move(30, Modal::arc_ccw, Axes::allowed),
    plain(40, 0, dwell, Modal::dwell),
    move(50, Modal::spline_cubic, Axes::required),
    move(51, Modal::spline_quadratic, Axes::required),
    move(52, Modal::nurbs, Axes::allowed),
    move(53, Modal::nurbs_end, Axes::none),
    move(62, Modal::nurbs, Axes::allowed, 62),
    refused(63, 1, motion, "a word without function"),
    plain(70, 15, diameter, Modal::diameter_on),
    plain(80, 15, diameter, Modal::diameter_off),
    group0(100, Modal::set_data, 0, Axes::own),
    plain(170, 2, plane, Modal::plane_xy),
    refused(171, 2, plane, auxiliary_plane),
    plain(180, 2, plane, Modal::plane_zx),
    refused(181, 2, plane, auxiliary_plane),
    plain(190, 2, plane, Modal::plane_yz),
    refused(191, 2, plane, auxiliary_plane),
    plain(200, 6, units, Modal::inch_all),
    plain(210, 6, units, Modal::metric_all),
    group0(280, Modal::home, 1, Axes::own),
    group0(281, Modal::home_store, 1, Axes::none),
    group0(300, Modal::home, 2, Axes::own),
    group0(301, Modal::home_store, 2, Axes::none),
    move(330, Modal::thread, Axes::required),
    move(331, Modal::rigid_tap, Axes::required),
    move(382, Modal::probe, Axes::required, 2),
    move(383, Modal::probe, Axes::required, 3),
    move(384, Modal::probe, Axes::required, 4),
    move(385, Modal::probe, Axes::required, 5),
    plain(400, 7, compensation, Modal::compensation_off),
    plain(410, 7, compensation, Modal::compensation_left),
    plain(411, 7, compensation, Modal::compensation_left_by),
    plain(420, 7, compensation, Modal::compensation_right),
    plain(421, 7, compensation, Modal::compensation_right_by),
    plain(430, 8, tool_length, Modal::tool_length),
    GCode{431, 8, Use::modal, tool_length, Modal::tool_length_by_axes, 0, Axes::own, {}},
    plain(432, 8, tool_length, Modal::tool_length_added),
    plain(490, 8, tool_length, Modal::tool_length_off),
    group0(520, Modal::local_shift, 0, Axes::own_required),
    plain(530, 0, suppress, Modal::suppress_all),
    plain(540, 12, datum, Modal::datum, 54),
    plain(550, 12, datum, Modal::datum, 55),
    plain(560, 12, datum, Modal::datum, 56),
    plain(570, 12, datum, Modal::datum, 57),
    plain(580, 12, datum, Modal::datum, 58),
    plain(590, 12, datum, Modal::datum, 59),
    plain(591, 12, datum, Modal::datum, 591),
    plain(592, 12, datum, Modal::datum, 592),
    plain(593, 12, datum, Modal::datum, 593),
    plain(610, 13, path_control, Modal::path_exact),
    plain(611, 13, path_control, Modal::path_stop),
    plain(640, 13, path_control, Modal::path_blend),
    turning(700, Axes::allowed),
    turning(710, Axes::allowed),
    turning(711, Axes::allowed),
    turning(712, Axes::allowed),
    turning(720, Axes::allowed),
    turning(721, Axes::allowed),
    turning(722, Axes::allowed),
    cycle(730),
    cycle(740),
    turning(760, Axes::required),
    move(800, Modal::canned_off, Axes::forbidden),
    cycle(810),
    cycle(820),
    cycle(830),
    cycle(840),
    cycle(850),
    cycle(860),
    cycle(870),
    cycle(880),
    cycle(890),
    plain(900, 3, distance, Modal::absolute),
    plain(901, 4, arc_centre, Modal::arc_centre_absolute),
    plain(910, 3, distance, Modal::incremental),
    plain(911, 4, arc_centre, Modal::arc_centre_incremental),
    group0(920, Modal::position_becomes, 0, Axes::own_required),
    group0(921, Modal::position_reset, 0, Axes::none),
    group0(922, Modal::position_suspend, 0, Axes::none),
    group0(923, Modal::position_restore, 0, Axes::none),
    plain(930, 5, feed_mode, Modal::feed_inverse_time),
    plain(940, 5, feed_mode, Modal::feed_per_minute),
    plain(950, 5, feed_mode, Modal::feed_per_rev),
    plain(960, 14, surface_speed, Modal::surface_speed_on, 96),
    plain(970, 14, surface_speed, Modal::surface_speed_off, 97),
    plain(980, 10, retract, Modal::retract_initial),
    plain(990, 10, retract, Modal::retract_clearance),
};

constexpr MCode m(std::uint16_t first, std::uint16_t last, std::uint8_t group, Order order,
                  std::string_view letters = {}) {
    return {first, last, group, Use::m_word, order, letters, Modal::rapid, {}};
}
constexpr MCode state_m(std::uint16_t number, Modal modal) {
    return {number, number, 7, Use::modal, state, {}, modal, {}};
}

constexpr std::array m_codes{
    m(0, 2, 4, m_stop),
    m(3, 5, 7, m_spindle),
    m(6, 6, 6, m_tool),
    m(7, 9, 8, m_coolant),
    m(19, 19, 7, m_spindle, "RQP"),
    m(30, 30, 4, m_stop),
    m(48, 49, 9, m_override),
    m(50, 53, 9, m_override, "P"),
    m(60, 60, 4, m_stop),
    m(61, 61, 6, m_tool, "Q"),
    m(62, 65, 5, m_output, "P"),
    m(66, 66, 5, m_output, "PELQ"),
    m(67, 68, 5, m_output, "EQ"),
    state_m(70, Modal::save_modal),
    state_m(71, Modal::forget_saved_modal),
    state_m(72, Modal::restore_modal),
    state_m(73, Modal::save_modal_for_call),
    MCode{98, 98, no_group, Use::call, m_user, "PL", Modal::rapid, {}},
    MCode{99, 99, no_group, Use::return_, m_stop, "", Modal::rapid, {}},
    m(100, 199, 10, m_user, "PQ"),
};

}  // namespace

const MCode* find_m(const Dialect& d, std::int32_t number) {
    for (const MCode& code : d.m)
        if (number >= code.first && number <= code.last) return &code;
    return nullptr;
}

const std::span<const GCode> linuxcnc_g = g_codes;
constexpr GIndex g_places = make_g_index(g_codes);
const GIndex linuxcnc_g_index = g_places;
const std::span<const MCode> linuxcnc_m = m_codes;

}  // namespace obrys::dialect::rs274
