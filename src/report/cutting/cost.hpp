#pragma once
/// What pieces cost, variants beside each other, as text and JSON.

#include <optional>
#include <string>
#include <vector>

#include "shop/cost.hpp"
#include "sim/cost/cost.hpp"

namespace obrys::report::cutting {

struct CostColumn {
    shop::CostVariant variant;
    std::optional<double> seconds;        ///< nothing: not known
    std::string time_from;                ///< "given", or the program that takes it
    std::vector<std::string> not_whole;   ///< why the time, and so the cost, is more; empty: it is all
    std::optional<sim::cost::Cost> cost;  ///< nothing: the time is not known
    [[nodiscard]] bool is_whole() const { return cost && not_whole.empty() && cost->tools_left_out.empty(); }
};

[[nodiscard]] std::string as_text(const std::vector<CostColumn>& variants);
[[nodiscard]] std::string as_json(const std::vector<CostColumn>& variants);

}  // namespace obrys::report::cutting
