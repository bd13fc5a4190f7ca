#pragma once
/// A groove made by a strategy: its path on the machine, what it does, and what the exact simulation says of it.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "cl/record.hpp"
#include "make/order.hpp"
#include "make/proof.hpp"

namespace obrys::make {

struct Made {
    groove::Strategy strategy = groove::Strategy::side_stepping;
    std::optional<groove::Refusal> refusal;
    groove::Request request;
    std::optional<groove::Contours> contours;
    groove::Path path;
    Proof proof;
    double feed_time = 0, rapid_time = 0;  ///< s
};

[[nodiscard]] Made make_groove(const Order& order, groove::Strategy strategy);

/// Nothing cuts into the part, no rapid meets stock; more than is meant may be left, as by the first slot alone.
[[nodiscard]] bool is_safe(const Made& made);
/// "clean", "findings" or "refused".
[[nodiscard]] std::string_view verdict_of(const Made& made);
/// 0, or 1 where there is something to mend.
[[nodiscard]] int exit_code_of(const Made& made);

[[nodiscard]] std::vector<cl::Record> stream_of(const Order& order, const Made& made);
/// Stock, part and tool as a job file for `program`; nothing where a job cannot say them yet: blades of bores and
/// faces.
[[nodiscard]] std::optional<std::string> job_of(const Order& order, const Made& made, const std::string& program,
                                                const std::string& control);

[[nodiscard]] std::string as_text(const Order& order, const Made& made);
[[nodiscard]] std::string as_json(const Order& order, const Made& made);

/// All strategies on one groove.
[[nodiscard]] std::vector<Made> compare_strategies(const Order& order);
[[nodiscard]] std::string table_as_text(const Order& order, const std::vector<Made>& all);
[[nodiscard]] std::string table_as_csv(const std::vector<Made>& all);
[[nodiscard]] std::string table_as_json(const Order& order, const std::vector<Made>& all);

}  // namespace obrys::make
