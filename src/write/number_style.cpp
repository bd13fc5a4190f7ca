#include "write/number_style.hpp"

#include <algorithm>
#include <cmath>

#include "base/number.hpp"

namespace obrys::write {

double as_written(double value, const NumberStyle& style) {
    const double steps = std::pow(10.0, style.decimals) * style.factor;
    return std::round(value * steps) / steps;
}

bool append_number(std::string& out, double value, const NumberStyle& style) {
    if (std::isinf(value) && value > 0 && !style.at_rapid.empty()) {
        out += style.at_rapid;
        return true;
    }
    const double written = value * style.factor;
    if (!(std::abs(written) <= style.most)) return false;
    if (style.exact) {
        double scale = 1;
        for (int i = 0; i < style.decimals; ++i) scale *= 10;
        constexpr double noise = 1e-6;  // of the last digit
        if (std::abs(written * scale - std::round(written * scale)) > noise) return false;
    }
    const std::size_t begin = out.size();
    if (style.plus && !(written < 0)) out += '+';
    base::append_fixed(out, written, style.decimals);
    if (style.decimals > 0) {
        for (int left = style.decimals; left > style.least && out.back() == '0'; --left) out.pop_back();
        if (out.back() == '.' && !style.point) out.pop_back();
    } else if (style.point) {
        out += '.';
    }
    const std::size_t first = begin + (out[begin] == '-' || out[begin] == '+' ? 1 : 0);
    const std::size_t end = std::min(out.find('.', first), out.size());
    if (static_cast<std::size_t>(style.digits) > end - first)
        out.insert(first, static_cast<std::size_t>(style.digits) - (end - first), '0');
    // A small negative number may have become 0, which append_fixed writes without its sign.
    if (style.plus && out[begin] != '+' && out[begin] != '-') out.insert(begin, 1, '+');
    return true;
}

}  // namespace obrys::write
