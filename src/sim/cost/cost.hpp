#pragma once
/// What a piece costs: wages N_mAC and the machine N_pSAC over the time t of a piece and the machine's utilisation,
/// material N_m, and what a price from the cycle alone leaves out. Money of the table's currency.
///
///     N = t / k (M / 60) (1 + R / 100) + t / k N_h / 60 + N_m,        a year: N d
///
/// with t in minutes, utilisation k, wage M and machine N_h an hour, overhead R in %, pieces d.

#include <optional>
#include <string>
#include <vector>

#include "shop/cost.hpp"

namespace obrys::sim::cost {

struct Item {
    std::string name;  ///< "wages", "machine", "material", "set-up", "loading", "tools", "fixture", …
    double money = 0;  ///< a piece
};

struct Cost {
    std::vector<Item> items;          ///< of a good piece; they add up to `exact`
    double exact = 0;                 ///< a piece, as it is computed
    double per_piece = 0;             ///< rounded, where the table says so
    std::optional<double> per_batch;  ///< nothing: the table does not say how many pieces a batch has
    std::optional<double> per_year;
    std::vector<std::string> tools_left_out;  ///< whose time of cutting is not known
};

/// `seconds`: of the cycle of a piece.
[[nodiscard]] Cost cost_of(const shop::CostTable& table, double seconds);

}  // namespace obrys::sim::cost
