#include "dialect/rs274/acramatic.hpp"

#include <array>

namespace obrys::dialect::rs274 {

namespace {

using cl::CycleKind;
using cl::CycleRole;
using cl::CycleValue;
using program::CannedCycle;
using program::CannedWord;
using program::Code;
using program::Modal;
using enum Order;

constexpr GCode plain(std::uint16_t number, std::uint8_t group, Order order, Modal modal, std::uint16_t n = 0) {
    return {number, group, Use::modal, order, modal, n, Axes::none, {}};
}
constexpr GCode move(std::uint16_t number, Modal modal, Axes axes) {
    return {number, 1, Use::modal, motion, modal, 0, axes, {}};
}
constexpr GCode cycle(std::uint16_t number) {
    return {number, 1, Use::canned, motion, Modal::canned, 0, Axes::required, {}};
}
constexpr GCode refused(std::uint16_t number, std::uint8_t group, std::string_view reason) {
    return {number, group, Use::unsupported, motion, Modal::rapid, 0, Axes::none, reason};
}

constexpr std::string_view probes = "a probing or tool setting cycle";
constexpr std::string_view open = "a hole cycle of which only the name is known";
constexpr std::string_view radius = "radius compensation, of which it is not known where its radius comes from";

constexpr std::array g_codes{
    move(0, Modal::rapid, Axes::allowed),
    move(10, Modal::linear, Axes::allowed),
    move(20, Modal::arc_cw, Axes::allowed),
    move(30, Modal::arc_ccw, Axes::allowed),
    plain(40, 0, dwell, Modal::dwell),
    plain(170, 2, plane, Modal::plane_xy),
    plain(180, 2, plane, Modal::plane_zx),
    plain(190, 2, plane, Modal::plane_yz),
    plain(400, 7, compensation, Modal::compensation_off),
    refused(410, 7, radius),
    refused(420, 7, radius),
    refused(510, 1, probes),
    refused(680, 1, probes),
    refused(690, 1, probes),
    plain(700, 6, units, Modal::inch_all),
    plain(710, 6, units, Modal::metric_all),
    refused(740, 1, open),
    refused(750, 1, probes),
    refused(760, 1, probes),
    refused(770, 1, probes),
    refused(780, 1, probes),
    refused(790, 1, probes),
    move(800, Modal::canned_off, Axes::forbidden),
    cycle(810),
    cycle(820),
    cycle(830),
    cycle(840),
    cycle(841),
    refused(850, 1, open),
    refused(860, 1, open),
    refused(870, 1, open),
    refused(880, 1, open),
    refused(890, 1, open),
    plain(900, 3, distance, Modal::absolute),
    plain(910, 3, distance, Modal::incremental),
    plain(930, 5, feed_mode, Modal::feed_inverse_time),
    plain(940, 5, feed_mode, Modal::feed_per_minute),
    plain(950, 5, feed_mode, Modal::feed_per_rev),
    refused(960, 14, "constant cutting speed, whose words are not known"),
    plain(970, 14, surface_speed, Modal::surface_speed_off, 97),
};
constexpr GIndex g_places = make_g_index(g_codes);

constexpr MCode m(std::uint16_t first, std::uint16_t last, std::uint8_t group, Order order) {
    return {first, last, group, Use::m_word, order, {}, Modal::rapid, {}};
}
constexpr MCode refused_m(std::uint16_t number, std::string_view reason) {
    return {number, number, no_group, Use::unsupported, m_user, {}, Modal::rapid, reason};
}

constexpr std::array m_codes{
    m(0, 2, 4, m_stop),
    m(3, 5, 7, m_spindle),
    m(6, 6, 6, m_tool),
    m(7, 9, 8, m_coolant),
    MCode{10, 11, 9, Use::ignored, m_user, {}, Modal::rapid, {}},  // the fourth axis free, clamped
    refused_m(19, "an oriented spindle, whose angle is not known"),
    MCode{26, 26, no_group, Use::modal, special, {}, Modal::reference_point, {}},
    m(27, 27, 8, m_coolant),
    m(30, 30, 4, m_stop),
    MCode{50, 51, 9, Use::ignored, m_user, {}, Modal::rapid, {}},  // the fifth axis free, clamped
};

// The reader gives the cycles letters of its own for what the table of cycle parameters says; the letters of the
// program are W (here E), J, K and P.
constexpr CannedWord gage{Code::q, CycleRole::clearance, false, 1};
constexpr CannedWord out{Code::e, CycleRole::return_level, true, 1};
constexpr CannedWord infeed{Code::k, CycleRole::infeed, true, 1};
constexpr CannedWord first{Code::i, CycleRole::first_infeed, true, 1};
constexpr CannedWord second{Code::j, CycleRole::second_infeed, true, 1};
constexpr CannedWord faster{Code::j, CycleRole::rpm_factor, false, 1};

constexpr std::array drill_words{gage, out};
constexpr std::array counterbore_words{gage, out, CannedWord{Code::p, CycleRole::dwell_bottom, false, 1},
                                       CannedWord{Code::i, CycleRole::finish_infeed, false, 1},
                                       CannedWord{Code::j, CycleRole::feed_factor, false, 1}};
constexpr std::array break_words{gage,  out,    infeed,
                                 first, second, CannedWord{Code::offset_d, CycleRole::chip_break_distance, false, 1}};
constexpr std::array peck_words{gage,  out,    infeed,
                                first, second, CannedWord{Code::offset_d, CycleRole::stop_distance_first, false, 1}};
constexpr std::array tap_words{gage, out, faster, CannedWord{Code::p, CycleRole::dwell_bottom, false, 1}};
constexpr std::array rigid_words{gage,
                                 out,
                                 infeed,
                                 faster,
                                 CannedWord{Code::p, CycleRole::chip_break_turns, false, 1},
                                 CannedWord{Code::i, CycleRole::dwell, false, 1}};
constexpr std::array to_surface{CycleValue{CycleRole::peck_to_surface, 1}};

/// In the order of AcramaticCycle.
constexpr std::array canned{
    CannedCycle{810, CycleKind::canned_drill, "G81", drill_words, {}},
    CannedCycle{820, CycleKind::canned_drill, "G82", counterbore_words, {}},
    CannedCycle{830, CycleKind::canned_chip_break, "G83", break_words, {}},
    CannedCycle{830, CycleKind::canned_peck, "G83", peck_words, to_surface},
    CannedCycle{830, CycleKind::canned_peck, "G83", peck_words, {}},
    CannedCycle{840, CycleKind::canned_tap_floating, "G84", tap_words, {}},
    CannedCycle{841, CycleKind::canned_tap_rigid, "G84.1", rigid_words, {}},
};

constexpr std::array<std::int16_t, 5> own_functions{10, 11, 27, 50, 51};

using enum AcramaticParameter;
constexpr std::array parameters{
    AcramaticParameterName{
        gage_height, "GAGE_HT_MM",
        "a cycle whose gage height the program does not say: write [$CYCLE_PARAMS(2)GAGE_HT_MM]=..."},
    AcramaticParameterName{dwell_82, "G82_DWELL", {}},
    AcramaticParameterName{finish_depth_82, "G82_FIN_DPTH", {}},
    AcramaticParameterName{feed_factor_82, "G82_FEED_FAC", {}},
    AcramaticParameterName{retract_83, "G83_RET_DIST",
                           "a cycle whose way back for chip breaking the program does not say: write "
                           "[$CYCLE_PARAMS(2)G83_RET_DIST]=..."},
    AcramaticParameterName{short_retract_83, "G83_SHRT_RET", {}},
    AcramaticParameterName{relief_83, "G83_RELIEF",
                           "a cycle whose relief above the cut the program does not say: write "
                           "[$CYCLE_PARAMS(2)G83_RELIEF]=..."},
    AcramaticParameterName{dwell_84, "G84_DWELL", {}},
    AcramaticParameterName{chip_break_84, "G84_CHIP_BRK",
                           "a cycle whose turns back for chip breaking the program does not say: write P or "
                           "[$CYCLE_PARAMS(2)G84_CHIP_BRK]=..."},
};
static_assert(parameters.size() == static_cast<std::size_t>(AcramaticParameter::count));

}  // namespace

std::optional<AcramaticCycle> acramatic_cycle(int tenths, int j) {
    using enum AcramaticCycle;
    switch (tenths) {
        case 810: return drill;
        case 820: return counterbore;
        case 840: return tap_floating;
        case 841: return tap_rigid;
        default: break;
    }
    switch (j) {
        case 1:
        case 11: return chip_break;
        case 2:
        case 12: return short_peck;
        case 3:
        case 13: return peck;
        default: return std::nullopt;
    }
}

std::span<const AcramaticParameterName> acramatic_parameters() { return parameters; }

const program::Traits acramatic_traits{
    .end_stops_all = true,
    .text_may_end = true,
    .may_end_anywhere = true,
    .datum = {.prefix = "H",
              .article = "the fixture offset ",
              .key = "H",
              .first = 53,
              .none = "no H",
              .none_key = "H0",
              .none_is_machine_zero = false},
    .machine_words_are_gauge_point = true,
    .stops_before_motion = true,
    .changes_on_m6 = true,
    .dwell_in_feed_words = false,
    .tool_change_stops_spindle = true,
    .feed_mode_ends_surface_speed = false,
    .own_functions = own_functions,
    .passed_functions = own_functions,
    .radius_at_start = true,
    .hole_depth_from_top = true,
    .helix_lead_across = true,
    .clearance_at_start = true,
    .canned = canned,
};

const Dialect acramatic{
    .control = "Acramatic 2100",
    .traits = &acramatic_traits,
    .g = g_codes,
    .g_index = &g_places,
    .m = m_codes,
    .operators = {},
    .functions = {},
    .predefined = {},
    .read_only = {},
    .letters = {},
    .named_parameters = false,
    .o_words = false,
    .active_comments = false,
    .percent_needs_begin = false,
    .whole_lists = false,
    .end_is_due = false,
};

}  // namespace obrys::dialect::rs274
