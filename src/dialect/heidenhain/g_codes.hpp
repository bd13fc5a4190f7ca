#pragma once
/// G codes of the iTNC 530's DIN/ISO programs, each with what stands for it in Klartext. Sources: thesis 2010 on the FV
/// 25 CNC A, appendix 1 (the control's list, in Czech); iTNC 530 User's Manual DIN/ISO Programming (340 49x, 606 42x).

#include <span>

#include "dialect/heidenhain/use.hpp"

namespace obrys::dialect::heidenhain {

struct GCode {
    int number = 0;
    bool block_only = false;  ///< acts in its block only (a star in the control's list)
    Use use = Use::run;
    int cycle = 0;              ///< the cycle it defines (dialect/heidenhain/cycles.hpp); 0: none
    std::string_view klartext;  ///< "L … FMAX", "CYCL DEF 200"
    std::string_view text;
    bool listed = true;  ///< stands in appendix 1 of the thesis; else in the manual only
};

[[nodiscard]] const GCode* find_g(int number);
/// Sorted by number.
[[nodiscard]] std::span<const GCode> all_g();

}  // namespace obrys::dialect::heidenhain
