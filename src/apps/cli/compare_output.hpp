#pragma once
/// What a comparison says, as text and as JSON (docs/command-line.md).

#include <string>

#include "compare/compare.hpp"
#include "driver/compare_stock.hpp"
#include "driver/session.hpp"

namespace obrys::cli {

/// Both sessions stay: places lie in their texts.
struct Compared {
    const driver::Session &a, &b;
    compare::Result moves;
    driver::StockComparison stock;
    bool is_full = true;                               ///< both were understood and run as a whole
    std::size_t block_stops_a = 0, block_stops_b = 0;  ///< G9, which nobody compares
};

/// The machine does the same, as far as that was compared.
[[nodiscard]] bool does_the_same(const Compared& c);

[[nodiscard]] std::string compared_text(const Compared& c);
[[nodiscard]] std::string compared_json(const Compared& c);

}  // namespace obrys::cli
