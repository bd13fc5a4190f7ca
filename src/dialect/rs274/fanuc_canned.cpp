/// Hole cycles of mills. What the machine's parameters say is taken as follows, since programs do not: chip breaking
/// goes back by 1 mm (parameter 5114; Haas setting 22), pecking goes down to 1 mm above the last depth (5115; setting
/// 52), oriented tools are shifted by Q towards X+ (5101; setting 27).

#include <array>

#include "dialect/rs274/fanuc.hpp"

namespace obrys::dialect::rs274 {

namespace {

using cl::CycleKind;
using cl::CycleRole;
using cl::CycleValue;
using program::CannedCycle;
using program::CannedWord;
using program::Code;

constexpr CannedWord dwell{Code::p, CycleRole::dwell_bottom, false, 1};
constexpr CannedWord infeed{Code::q, CycleRole::infeed, true, 1};

/// Words that a cycle itself does not look at: they hold for the next one of the series (Traits::canned_words_stay). J
/// of Haas says how fast a tap comes back: the hole is the same.
constexpr CannedWord kept_p{Code::p, CycleRole::kept, false, 1};
constexpr CannedWord kept_q{Code::q, CycleRole::kept, true, 1};
constexpr CannedWord kept_j{Code::j, CycleRole::kept, false, 1};

constexpr std::array plain{kept_p, kept_q};
constexpr std::array dwells{dwell, kept_q};
/// Q of a rigid tap: with bit PCP of parameter 5200 at 0 it goes back by parameter 5213 after each step.
constexpr std::array rigid{infeed, dwell};
constexpr std::array haas_taps{dwell, kept_q, kept_j};
constexpr std::array pecks{infeed, dwell};
/// Q of an oriented tool: its sign is ignored (B-63324EN, G76).
constexpr CannedWord shift_by_q{Code::q, CycleRole::shift_u, true, 1, false, true};
constexpr std::array shifts{shift_by_q, dwell};
/// Z and R of back boring change places in the reader: R is the bottom, Z the end of the counterbore.
constexpr std::array back{shift_by_q, CannedWord{Code::e, CycleRole::counterbore_top, true, 1},
                          CannedWord{Code::p, CycleRole::dwell, false, 1}};
constexpr std::array haas_pecks{infeed, dwell, CannedWord{Code::i, CycleRole::infeed, true, 1},
                                CannedWord{Code::j, CycleRole::decrement, true, 1},
                                CannedWord{Code::k, CycleRole::min_infeed, true, 1}};
/// K of G73 beside Q: out to R whenever the infeeds have come to as much (Haas mill operator's manual, G73).
constexpr CannedWord::Beside out_by_k{Code::q, Code::i, CycleRole::retract_every};
constexpr std::array haas_chip_words{infeed, dwell, CannedWord{Code::i, CycleRole::infeed, true, 1},
                                     CannedWord{Code::j, CycleRole::decrement, true, 1},
                                     CannedWord{Code::k, CycleRole::min_infeed, true, 1, false, false, &out_by_k}};
constexpr std::array haas_shifts{shift_by_q, dwell, CannedWord{Code::i, CycleRole::shift_u, true, 1},
                                 CannedWord{Code::j, CycleRole::shift_v, true, 1}};

constexpr std::array unshifted{CycleValue{CycleRole::shift_u, 0}, CycleValue{CycleRole::shift_v, 0}};  ///< but by Q
constexpr std::array chip_break{CycleValue{CycleRole::chip_break_distance, 1}};
constexpr std::array haas_chip_break{CycleValue{CycleRole::chip_break_distance, 1},
                                     CycleValue{CycleRole::stop_distance_first, 1}};
constexpr std::array stop_above{CycleValue{CycleRole::stop_distance_first, 1}};
constexpr std::array by_hand{CycleValue{CycleRole::manual_retract, 1}};
constexpr std::array right{CycleValue{CycleRole::spindle_direction, 1}, CycleValue{CycleRole::starts_spindle, 1}};
constexpr std::array left{CycleValue{CycleRole::spindle_direction, -1}, CycleValue{CycleRole::starts_spindle, 1}};

/// Without M29 the program turns the spindle on before the cycle, and taps with a floating holder; with it the cycle
/// turns it, coupled to the axis ("rigid tapping"). Haas always taps so.
constexpr std::array turned_right{CycleValue{CycleRole::spindle_direction, 1},
                                  CycleValue{CycleRole::starts_spindle, 2}};
constexpr std::array turned_left{CycleValue{CycleRole::spindle_direction, -1},
                                 CycleValue{CycleRole::starts_spindle, 2}};

/// Of two with one number the last one is that behind M29.
constexpr std::array mill{
    CannedCycle{730, CycleKind::canned_chip_break, "G73", pecks, chip_break},
    CannedCycle{740, CycleKind::canned_tap_floating, "G74", dwells, turned_left},
    CannedCycle{760, CycleKind::canned_bore_orient, "G76", shifts, unshifted},
    CannedCycle{810, CycleKind::canned_drill, "G81", plain, {}},
    CannedCycle{820, CycleKind::canned_drill, "G82", dwells, {}},
    CannedCycle{830, CycleKind::canned_peck, "G83", pecks, stop_above},
    CannedCycle{840, CycleKind::canned_tap_floating, "G84", dwells, turned_right},
    CannedCycle{850, CycleKind::canned_bore_feed, "G85", plain, {}},
    CannedCycle{860, CycleKind::canned_bore_stop, "G86", plain, {}},
    CannedCycle{870, CycleKind::canned_back_bore, "G87", back, unshifted},
    CannedCycle{880, CycleKind::canned_bore_manual, "G88", dwells, by_hand},
    CannedCycle{890, CycleKind::canned_bore_feed, "G89", dwells, {}},
    CannedCycle{740, CycleKind::canned_tap_rigid, "G74", rigid, left},
    CannedCycle{840, CycleKind::canned_tap_rigid, "G84", rigid, right},
};
/// Haas G77 is FANUC's G87; its G86, G87 and G88 stop the spindle at the bottom.
constexpr std::array haas{
    CannedCycle{730, CycleKind::canned_chip_break, "G73", haas_chip_words, haas_chip_break},
    CannedCycle{740, CycleKind::canned_tap_rigid, "G74", haas_taps, left},
    CannedCycle{760, CycleKind::canned_bore_orient, "G76", haas_shifts, unshifted},
    CannedCycle{810, CycleKind::canned_drill, "G81", plain, {}},
    CannedCycle{820, CycleKind::canned_drill, "G82", dwells, {}},
    CannedCycle{830, CycleKind::canned_peck, "G83", haas_pecks, stop_above},
    CannedCycle{840, CycleKind::canned_tap_rigid, "G84", haas_taps, right},
    CannedCycle{850, CycleKind::canned_bore_feed, "G85", plain, {}},
    CannedCycle{860, CycleKind::canned_bore_stop, "G86", plain, {}},
    CannedCycle{880, CycleKind::canned_bore_manual, "G88", dwells, by_hand},
    CannedCycle{890, CycleKind::canned_bore_feed, "G89", dwells, {}},
};

}  // namespace

std::span<const CannedCycle> fanuc_mill_cycles() { return mill; }
std::span<const CannedCycle> haas_mill_cycles() { return haas; }

}  // namespace obrys::dialect::rs274
