/// Words of the multiple repetitive cycles of lathes and what they say. Two blocks: FANUC series 0i-T, 16i/18i-T,
/// 30i-T. One block: series 10T/11T and their tape format on later series; Haas lathes (G71 … G76; G73 and G76: Haas
/// classic control lathe operator's manual, online edition). What a control's own data hold is not known here.

#include <array>

#include "dialect/rs274/fanuc.hpp"

namespace obrys::dialect::rs274 {

namespace {

using cl::CycleKind;
using program::CycleDefault;
using enum cl::CycleRole;
using Number = TurningNumber;
using Word = TurningWord;

constexpr Word allowance_x{'U', allowance_v, Number::length, true}, allowance_z{'W', allowance_u, Number::length};

constexpr std::array along_data{Word{'U', infeed, Number::length}, Word{'R', escape, Number::length}};
constexpr std::array across_data{Word{'W', infeed, Number::length}, Word{'R', escape, Number::length}};
constexpr std::array removal_call{allowance_x, allowance_z};
/// Later series pass over I and K of this format; on Haas they are what the cuts leave for a pass along the contour.
constexpr std::array removal_single{Word{'D', infeed, Number::depth}, allowance_x, allowance_z};
constexpr std::array removal_haas{Word{'D', infeed, Number::depth},
                                  Word{'I', relief_v, Number::length},
                                  Word{'K', relief_u, Number::length},
                                  Word{'R', pockets, Number::plain},
                                  allowance_x,
                                  allowance_z};
constexpr std::array pattern_data{Word{'U', relief_v, Number::length}, Word{'W', relief_u, Number::length},
                                  Word{'R', passes, Number::plain}};
constexpr std::array pattern_single{Word{'I', relief_v, Number::length}, Word{'K', relief_u, Number::length},
                                    Word{'D', passes, Number::plain}, allowance_x, allowance_z};
constexpr std::array peck_data{Word{'R', escape, Number::length}};
constexpr std::array along_pecks{Word{'P', stepover, Number::increments}, Word{'Q', infeed, Number::increments},
                                 Word{'R', relief, Number::length},       Word{'I', stepover, Number::length},
                                 Word{'K', infeed, Number::length},       Word{'D', relief, Number::depth}};
constexpr std::array across_pecks{Word{'P', infeed, Number::increments}, Word{'Q', stepover, Number::increments},
                                  Word{'R', relief, Number::length},     Word{'I', infeed, Number::length},
                                  Word{'K', stepover, Number::length},   Word{'D', relief, Number::depth}};
/// P of the first block is three numbers of two digits, which the reader takes apart.
constexpr std::array thread_data{Word{'Q', min_infeed, Number::increments},
                                 Word{'R', finish_allowance, Number::length}};
constexpr std::array thread_call{Word{'P', thread_depth, Number::increments},
                                 Word{'Q', first_depth, Number::increments}, Word{'R', taper_v, Number::length},
                                 Word{'F', pitch, Number::lead}};
constexpr std::array thread_single{Word{'K', thread_depth, Number::length}, Word{'D', first_depth, Number::depth},
                                   Word{'I', taper_v, Number::length},      Word{'A', infeed_angle, Number::half_angle},
                                   Word{'P', infeed_method, Number::plain}, Word{'F', pitch, Number::lead},
                                   Word{'Q', spindle_angle, Number::angle}};

constexpr std::array removal_parameters{
    CycleDefault{infeed, 1, infeed, "the depth of cut is not programmed: 1 mm is taken for what parameter 5132 holds"},
    CycleDefault{escape, 0.5, escape, "the escape is not programmed: 0.5 mm is taken for what parameter 5133 holds"}};
constexpr std::array removal_settings{
    CycleDefault{infeed, 2.54, infeed, "the depth of cut D is not programmed: 0.1 inch is taken for setting 72"},
    CycleDefault{escape, 1.27, escape, "after a cut the tool goes away by 0.05 inch, taken for setting 73"}};
constexpr std::string_view no_relief =
    "relief and number of passes that are not programmed are taken as 0 and 1 (parameters 5135 to 5137)";
constexpr std::array pattern_parameters{CycleDefault{relief_v, 0, relief_v, no_relief},
                                        CycleDefault{relief_u, 0, relief_u, no_relief},
                                        CycleDefault{passes, 1, passes, no_relief}};
constexpr std::string_view no_relief_haas = "relief and number of passes that are not programmed are taken as 0 and 1";
constexpr std::array pattern_settings{CycleDefault{relief_v, 0, relief_v, no_relief_haas},
                                      CycleDefault{relief_u, 0, relief_u, no_relief_haas},
                                      CycleDefault{passes, 1, passes, no_relief_haas}};
constexpr std::array peck_parameters{
    CycleDefault{escape, 1, infeed, "after a peck the tool goes back by 1 mm, taken for what parameter 5139 holds"}};
constexpr std::array peck_settings{
    CycleDefault{escape, 1, infeed, "after a peck the tool goes back by 1 mm, taken for setting 22"}};
constexpr std::string_view plain_thread =
    "what is not programmed is taken as: one finishing pass, no allowance for it, no least depth, no run-out, infeed "
    "at "
    "right angles (parameters 5130, 5140 to 5143)";
constexpr std::array thread_parameters{CycleDefault{finish_passes, 1, finish_passes, plain_thread},
                                       CycleDefault{runout_leads, 0, runout_leads, plain_thread},
                                       CycleDefault{infeed_angle, 0, infeed_angle, plain_thread},
                                       CycleDefault{min_infeed, 0, min_infeed, plain_thread},
                                       CycleDefault{finish_allowance, 0, finish_allowance, plain_thread}};
constexpr std::string_view haas_thread =
    "taken for settings 86, 95, 96 and 99: no allowance for the last pass, a run-out of one lead at 45 degrees, no "
    "least "
    "depth";
constexpr std::array thread_settings{CycleDefault{runout_leads, 1, runout_leads, haas_thread}};

constexpr std::array cycles{
    FanucTurningCycle{700, CycleKind::lathe_finish, 0, {}, {}, {}, {}, {}, {}},
    FanucTurningCycle{710, CycleKind::lathe_remove_along, 1, along_data, removal_call, removal_single, removal_haas,
                      removal_parameters, removal_settings},
    FanucTurningCycle{720, CycleKind::lathe_remove_across, 1, across_data, removal_call, removal_single, removal_haas,
                      removal_parameters, removal_settings},
    FanucTurningCycle{730, CycleKind::lathe_repeat_pattern, 2, pattern_data, removal_call, pattern_single,
                      pattern_single, pattern_parameters, pattern_settings},
    FanucTurningCycle{740, CycleKind::lathe_peck_along, 3, peck_data, along_pecks, along_pecks, along_pecks,
                      peck_parameters, peck_settings},
    FanucTurningCycle{750, CycleKind::lathe_peck_across, 3, peck_data, across_pecks, across_pecks, across_pecks,
                      peck_parameters, peck_settings},
    FanucTurningCycle{760, CycleKind::lathe_thread_passes, 4, thread_data, thread_call, thread_single, thread_single,
                      thread_parameters, thread_settings},
};

}  // namespace

const FanucTurningCycle* find_turning_cycle(int number) {
    for (const FanucTurningCycle& c : cycles)
        if (c.number == number) return &c;
    return nullptr;
}

}  // namespace obrys::dialect::rs274
