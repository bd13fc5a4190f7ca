#include "program/traits.hpp"

#include <algorithm>

#include "base/number.hpp"

namespace obrys::program {

std::string parameter_name(const Traits& t, std::uint32_t number) {
    std::uint32_t rest = number;
    for (const ParameterBank& b : t.banks) {
        if (rest < b.count) return std::string(b.letters) + std::to_string(rest);
        rest -= b.count;
    }
    return std::string(t.banks[0].letters) + std::to_string(number);
}

std::uint32_t find_parameter(const Traits& t, std::string_view upper) {
    std::uint32_t first = 0;
    for (const ParameterBank& b : t.banks) {
        const bool letters = !b.letters.empty() && upper.starts_with(b.letters);
        const auto n = letters ? base::parse_integer(upper.substr(b.letters.size())) : std::nullopt;
        if (n && *n >= 0 && *n < b.count) return first + static_cast<std::uint32_t>(*n);
        first += b.count;
    }
    return parameter_count(t);
}

namespace {

constexpr std::uint32_t axes = 9;  ///< X Y Z A B C U V W

bool within(std::uint32_t n, std::uint32_t first, std::uint32_t count) {
    return first != 0 && n >= first && n - first < count;
}

bool holds_offset(const OffsetParameters& o, std::uint32_t n) {
    return within(n, o.datum_first, o.datum_step * o.datum_count) || within(n, o.active_datum, 1) ||
           within(n, o.shift_first, axes) || within(n, o.shift_active, 1) || within(n, o.home_first, axes) ||
           within(n, o.home_second, axes) || within(n, o.external_first, axes) ||
           within(n, o.extended_first, o.datum_step * o.extended_count);
}

}  // namespace

bool is_of_control(const Traits& t, std::uint32_t number) {
    const auto is_number = [&](const ControlParameter& p) { return p.number == number; };
    const auto shows = [&](const LiveParameters& l) { return within(number, l.first, l.count); };
    const auto acts = [&](const KeptParameters& k) { return k.acts && number >= k.first && number <= k.last; };
    return holds_offset(t.offsets, number) ||
           std::any_of(t.set_by_control.begin(), t.set_by_control.end(), is_number) ||
           std::any_of(t.live.begin(), t.live.end(), shows) || std::any_of(t.kept.begin(), t.kept.end(), acts);
}

namespace {

/// "G59.1", "G54.1 P3"; empty where the number is written as it is.
std::string name_by_decimals(const Traits& t, std::uint32_t number) {
    if (!t.datum.more_by_decimals) return {};
    if (number >= 591 && number <= 593) return "G59." + std::to_string(number - 590);
    if (number > 5400 && number <= 5700) return "G54.1 P" + std::to_string(number - 5400);
    return {};
}

}  // namespace

std::string datum_name(const Traits& t, std::uint32_t number) {
    if (number == no_datum) return std::string(t.datum.none);
    if (std::string name = name_by_decimals(t, number); !name.empty()) return name;
    return std::string(t.datum.prefix) + std::to_string(number - t.datum.first);
}

std::string datum_phrase(const Traits& t, std::uint32_t number) {
    return std::string(t.datum.article) + datum_name(t, number);
}

std::string datum_key(const Traits& t, std::uint32_t number) {
    if (number == no_datum) return std::string(t.datum.none_key);
    if (const std::string name = name_by_decimals(t, number); !name.empty()) return '"' + name + '"';
    return std::string(t.datum.key) + std::to_string(number - t.datum.first);
}

}  // namespace obrys::program
