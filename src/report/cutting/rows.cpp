#include "report/cutting/rows.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "base/number.hpp"
#include "base/whole.hpp"

namespace obrys::report::cutting {

namespace {

/// Digits before the point; below 0 for noughts behind it. Of what is not 0.
int places_before(double value) {
    constexpr int most = 400;
    return base::clipped<int>(std::floor(std::log10(std::abs(value))), -most, most) + 1;
}

}  // namespace

std::string figure(double value, int digits) {
    if (!std::isfinite(value)) return "?";
    if (value == 0) return "0";
    const int before = places_before(value);
    std::string text = base::fixed(value, std::clamp(digits - before, 0, 9));
    if (text.find('.') == std::string::npos) return text;
    while (text.back() == '0') text.pop_back();
    if (text.back() == '.') text.pop_back();
    return text;
}

std::string padded(std::string text, std::size_t width, bool right) {
    std::size_t shown = 0;  // a letter of several bytes is one on paper
    for (const char c : text) shown += (static_cast<unsigned char>(c) & 0xC0U) == 0x80U ? 0 : 1;
    if (shown >= width) return text;
    const std::string blanks(width - shown, ' ');
    return right ? blanks + text : text + blanks;
}

std::string row(const std::string& name, const std::string& value, const std::string& unit, const std::string& remark) {
    constexpr std::size_t names = 24, values = 12, units = 10;
    std::string line = "  " + padded(name, names) + padded(value, values, true) + " " + padded(unit, units) + remark;
    line.erase(line.find_last_not_of(' ') + 1);
    return line + "\n";
}

nlohmann::ordered_json number(double value) {
    if (!std::isfinite(value)) return nullptr;
    if (value == 0) return 0.0;
    constexpr int digits = 12;  // the rest is how a sum was made
    const double unit = std::pow(10.0, digits - places_before(value));
    return std::isfinite(unit) && unit > 0 ? std::round(value * unit) / unit : value;
}

}  // namespace obrys::report::cutting
