#include "program/traits.hpp"

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

std::string datum_name(const Traits& t, std::uint32_t number) {
    if (number == no_datum) return std::string(t.datum.none);
    return std::string(t.datum.prefix) + std::to_string(number - t.datum.first);
}

std::string datum_phrase(const Traits& t, std::uint32_t number) {
    return std::string(t.datum.article) + datum_name(t, number);
}

std::string datum_key(const Traits& t, std::uint32_t number) {
    if (number == no_datum) return std::string(t.datum.none_key);
    return std::string(t.datum.key) + std::to_string(number - t.datum.first);
}

}  // namespace obrys::program
