#pragma once
/// LinuxCNC 2.9's RS-274: codes, groups and order from its manual ("G-codes", "M-codes", "G-code overview") and its
/// interpreter, checked against `rs274`.

#include "dialect/rs274/tables.hpp"

namespace obrys::dialect::rs274 {

extern const program::Traits linuxcnc_traits;
extern const Dialect linuxcnc;

// Parts of it, one file each.
extern const std::span<const GCode> linuxcnc_g;
extern const GIndex linuxcnc_g_index;
extern const std::span<const MCode> linuxcnc_m;
extern const std::span<const OperatorName> linuxcnc_operators;
extern const std::span<const FunctionName> linuxcnc_functions;
extern const std::span<const PredefinedName> linuxcnc_predefined;
extern const std::span<const NumberRange> linuxcnc_read_only;
extern const std::span<const LetterUse> linuxcnc_letters;

}  // namespace obrys::dialect::rs274
