#pragma once
/// The strategies: a groove in, the path of its blade out, or the guard that refuses it.

#include <span>
#include <variant>

#include "cycles/groove/path.hpp"

namespace obrys::cycles::groove {

enum class Strategy : std::uint8_t {
    side_stepping,
    side_stepping_high,  ///< from the higher edge of a cone
    stepwise,
    cycle93,
    single,
    layers,
    multiple,
    plunge_turning,
    ramping,
    finishing,
};
struct Named {
    Strategy strategy;
    std::string_view word;   ///< of the command line
    std::string_view title;  ///< of tables
};
[[nodiscard]] std::span<const Named> strategies();
[[nodiscard]] const Named& named(Strategy strategy);

struct Path {
    std::vector<Move> moves;
    Doings does;
};

/// As the caller's contours say; `finishing` begins with what roughing leaves, the others with the full stock.
[[nodiscard]] std::variant<Path, Refusal> path_of(const Request& request, const Contours& contours, Strategy strategy);

/// The stock before roughing, and what an ideal roughing leaves.
[[nodiscard]] Skyline full_stock(const Request& request, const Contours& contours);
[[nodiscard]] Skyline roughed_stock(const Request& request, const Contours& contours);

/// Of what roughing leaves: what the insert's corners and their columns cannot reach, beside `lift` of plunge turning.
[[nodiscard]] double rest_bound(const Request& request, Strategy strategy);

// The families; the blade is in no place yet.
void side_stepping(Blade& blade, Side start);
void stepwise(Blade& blade);
void pecked_columns(Blade& blade, bool only_first);
[[nodiscard]] std::optional<Refusal> multiple(Blade& blade);
void layer_by_layer(Blade& blade);
[[nodiscard]] std::optional<Refusal> plunge_turning(Blade& blade);
[[nodiscard]] std::optional<Refusal> ramping(Blade& blade);
void finishing(Blade& blade);

/// Left edges over the flat bottom, equally spaced, at most `step` apart.
[[nodiscard]] std::vector<double> columns(double begin, double end, double step);

}  // namespace obrys::cycles::groove
