#include <algorithm>
#include <array>

#include "dialect/sinumerik/tables.hpp"

namespace obrys::dialect::sinumerik {

namespace {

using program::Modal;

constexpr GCode run(std::uint16_t code, Modal m) { return {code, Use::modal, m, {}}; }
constexpr GCode accept(std::uint16_t code) { return {code, Use::ignored, Modal::rapid, {}}; }
constexpr GCode refuse(std::uint16_t code, std::string_view reason) {
    return {code, Use::unsupported, Modal::rapid, reason};
}
constexpr GCode refuse_block(std::uint16_t code, std::string_view reason) {
    return {code, Use::unsupported_block, Modal::rapid, reason};
}

constexpr std::string_view limits = "working area or spindle limits set by the program";
constexpr std::string_view fine_shift = "programmable offset by axis";
constexpr std::string_view approach = "smooth approach and retract";
constexpr std::string_view corner_feed = "automatic corner deceleration";
constexpr std::string_view oem = "function of the machine builder";
constexpr std::string_view oblique = "oblique plunge-cutting";

constexpr std::string_view strategy = "approach strategy of the compensation";
constexpr std::string_view arc_thread = "thread along an arc";

// clang-format off
constexpr std::array g_codes{
    run(0, Modal::rapid), run(1, Modal::linear), run(2, Modal::arc_cw), run(3, Modal::arc_ccw), run(4, Modal::dwell),
    refuse_block(5, oblique), refuse_block(7, oblique), run(9, Modal::exact_stop_block),
    run(17, Modal::plane_xy), run(18, Modal::plane_zx), run(19, Modal::plane_yz),
    refuse_block(25, limits), refuse_block(26, limits),
    run(33, Modal::thread), run(34, Modal::thread_rising), run(35, Modal::thread_falling),
    run(40, Modal::compensation_off), run(41, Modal::compensation_left), run(42, Modal::compensation_right),
    run(53, Modal::suppress_frames), run(54, Modal::datum), run(55, Modal::datum), run(56, Modal::datum),
    run(57, Modal::datum), refuse_block(58, fine_shift), refuse_block(59, fine_shift),
    run(60, Modal::exact_stop), refuse(62, corner_feed), refuse_block(63, "tapping with compensating chuck"),
    run(64, Modal::continuous), run(70, Modal::inch_geometry), run(71, Modal::metric_geometry),
    run(74, Modal::reference_point), run(75, Modal::fixed_point), run(90, Modal::absolute), run(91, Modal::incremental),
    run(93, Modal::feed_inverse_time), run(94, Modal::feed_per_minute), run(95, Modal::feed_per_rev),
    run(96, Modal::surface_speed_on), run(97, Modal::surface_speed_off),
    run(110, Modal::pole_from_position), run(111, Modal::pole_from_zero), run(112, Modal::pole_from_pole),
    accept(140), refuse(141, approach), refuse(142, approach), refuse(143, approach),
    refuse_block(147, approach), refuse_block(148, approach), run(153, Modal::suppress_all),
    refuse_block(247, approach), refuse_block(248, approach), accept(290), refuse(291, "ISO dialect mode"),
    run(331, Modal::tap), run(332, Modal::tap_retract), refuse_block(335, arc_thread), refuse_block(336, arc_thread),
    accept(340), refuse(341, approach), refuse_block(347, approach), refuse_block(348, approach),
    run(450, Modal::corner_arc), run(451, Modal::corner_intersection),
    accept(460), refuse(461, strategy), refuse(462, strategy),
    run(500, Modal::datum), run(601, Modal::exact_window), run(602, Modal::exact_window), run(603, Modal::exact_window),
    refuse(621, corner_feed), run(641, Modal::continuous), run(642, Modal::continuous), run(643, Modal::continuous),
    run(644, Modal::continuous), run(645, Modal::continuous), run(700, Modal::inch_all), run(710, Modal::metric_all),
    refuse_block(751, "fixed point by way of an intermediate point"),
    refuse(810, oem), refuse(811, oem), refuse(812, oem), refuse(813, oem), refuse(814, oem), refuse(815, oem),
    refuse(816, oem), refuse(817, oem), refuse(818, oem), refuse(819, oem), refuse(820, oem), refuse(821, oem),
    refuse(822, oem), refuse(823, oem), refuse(824, oem), refuse(825, oem), refuse(826, oem), refuse(827, oem),
    refuse(828, oem), refuse(829, oem), refuse(931, "feed by travel time"), refuse(942, "frozen linear feed"),
    refuse(952, "frozen feed per revolution"),
    run(961, Modal::surface_speed_on), run(962, Modal::surface_speed_on), run(971, Modal::surface_speed_off),
    run(972, Modal::surface_speed_off), run(973, Modal::surface_speed_off),
};
// clang-format on
static_assert(std::is_sorted(g_codes.begin(), g_codes.end(),
                             [](const GCode& a, const GCode& b) { return a.code < b.code; }));

}  // namespace

std::optional<GCode> find_g(int number) {
    if (number >= 505 && number <= 599) return run(static_cast<std::uint16_t>(number), Modal::datum);
    const auto found =
        std::lower_bound(g_codes.begin(), g_codes.end(), number, [](const GCode& g, int n) { return int{g.code} < n; });
    if (found == g_codes.end() || int{found->code} != number) return std::nullopt;
    return *found;
}

program::Code address_code(char letter) {
    using program::Code;
    switch (letter) {
        case 'X': return Code::x;
        case 'Y': return Code::y;
        case 'Z': return Code::z;
        case 'A': return Code::a;
        case 'B': return Code::b;
        case 'C': return Code::c;
        case 'U': return Code::u;
        case 'V': return Code::v;
        case 'W': return Code::w;
        case 'I': return Code::i;
        case 'J': return Code::j;
        case 'K': return Code::k;
        case 'F': return Code::feed;
        case 'S': return Code::spindle;
        case 'T': return Code::tool;
        case 'D': return Code::edge;
        case 'M': return Code::m;
        case 'H': return Code::h;
        default: return Code::unknown;
    }
}

}  // namespace obrys::dialect::sinumerik
