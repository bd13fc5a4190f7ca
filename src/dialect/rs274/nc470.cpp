#include "dialect/rs274/nc470.hpp"

#include <array>

namespace obrys::dialect::rs274 {

namespace {

using program::Modal;
using enum Order;

constexpr std::array g_codes{
    GCode{0, 1, Use::modal, motion, Modal::rapid, 0, Axes::allowed, {}},
    GCode{10, 1, Use::modal, motion, Modal::linear, 0, Axes::allowed, {}},
    GCode{40, 0, Use::modal, dwell, Modal::dwell, 0, Axes::none, {}},
};
constexpr GIndex g_places = make_g_index(g_codes);

constexpr MCode m(std::uint16_t first, std::uint16_t last, std::uint8_t group, Order order) {
    return {first, last, group, Use::m_word, order, {}, Modal::rapid, {}};
}
constexpr std::array m_codes{
    m(0, 2, 4, m_stop),
    m(3, 5, 7, m_spindle),
    m(6, 6, 6, m_tool),
    m(7, 9, 8, m_coolant),
    m(30, 30, 4, m_stop),
    m(10, 16, no_group, m_user),  // the machine's; M17, M19, M98 and M99 mean more on other controls
    m(20, 29, no_group, m_user),
    m(31, 97, no_group, m_user),
    m(100, 999, no_group, m_user),
};

}  // namespace

const program::Traits nc470_traits{
    .end_stops_all = true,
    .text_may_end = true,
    .may_end_anywhere = true,
    .datum = {.none = "no zero of its own", .none_is_machine_zero = false},
    .stops_before_motion = true,
    .changes_on_m6 = true,
    .dwell_in_feed_words = false,
    .tool_change_stops_spindle = true,
    .radius_at_start = true,
};

const Dialect nc470{
    .control = "NC 470",
    .traits = &nc470_traits,
    .g = g_codes,
    .g_index = &g_places,
    .m = m_codes,
    .operators = {},
    .functions = {},
    .predefined = {},
    .read_only = {},
    .letters = {},
    .named_parameters = false,
    .semicolon_comment = false,
    .o_words = false,
    .active_comments = false,
    .percent_needs_begin = false,
    .whole_lists = false,
    .end_is_due = false,
};

}  // namespace obrys::dialect::rs274
