#pragma once
/// Where a machine's reference points lie.

#include <string_view>

#include "shop/machine.hpp"

namespace obrys::shop {

struct Home {
    double at = std::numeric_limits<double>::quiet_NaN();  ///< machine coordinate; NaN: not known
    bool is_assumed = false;                               ///< nobody has given it
};

/// The reference point of an axis ("X"). `at_zero`: where the machine's file gives none, 0 is taken for it, as most
/// machines have it (FANUC parameter 1240 and MD34100 REFP_SET_POS are delivered so); not where travels are given of
/// which 0 is no end, for there the machine's zero lies elsewhere.
[[nodiscard]] Home home_of(const Machine& machine, std::string_view axis, bool at_zero);

}  // namespace obrys::shop
