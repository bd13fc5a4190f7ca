#include "write/canon/calls.hpp"

#include <array>
#include <cmath>
#include <system_error>

#include "base/float_chars.hpp"

namespace obrys::write {

std::string decimals(double v, int digits) {
    std::array<char, 400> buffer;  // 1e308 with 6 decimals needs 316
    const auto [end, error] =
        base::to_chars(buffer.data(), buffer.data() + buffer.size(), v, base::CharsFormat::fixed, digits);
    return error == std::errc{} ? std::string(buffer.data(), end) : "nan";
}

std::string listed(std::initializer_list<double> values) {
    std::string out;
    for (const double v : values) out += (out.empty() ? "" : ", ") + decimals(v);
    return out;
}

double restored(double v) {
    if (!(std::abs(v) < 1e6)) return std::isnan(v) ? 0 : v;
    const double r = std::round(v * 1e10) / 1e10;
    return r == 0 ? 0 : r;
}

std::string canon_axes(std::span<const double> values, std::size_t from, double unit, std::string_view between) {
    std::string out;
    for (std::size_t k = 0; k < values.size(); ++k) {
        const bool rotary = from + k >= 3 && from + k < 6;
        out += (k > 0 ? std::string(between) : "") + decimals(restored(values[k] / (rotary ? 1 : unit)));
    }
    return out;
}

void CanonCalls::set_number(const std::string& n) {
    prefix_ = n.empty() ? "N..... " : "N" + n + (n.size() < 6 ? std::string(6 - n.size(), ' ') : "");
}

void CanonCalls::call(const std::string& what) {
    const std::string n = std::to_string(++lines_);
    out_((n.size() < 5 ? std::string(5 - n.size(), ' ') : "") + n + " " + prefix_ + what + "\n");
}

}  // namespace obrys::write
