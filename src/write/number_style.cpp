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
        std::size_t size = out.size();
        for (int left = style.decimals; left > style.least && out[size - 1] == '0'; --left) --size;
        if (out[size - 1] == '.' && !style.point) --size;
        out.resize(size);
    } else if (style.point) {
        out += '.';
    }
    if (style.digits > 1) {
        const std::size_t first = begin + (out[begin] == '-' || out[begin] == '+' ? 1 : 0);
        const std::size_t end = std::min(out.find('.', first), out.size());
        if (static_cast<std::size_t>(style.digits) > end - first)
            out.insert(first, static_cast<std::size_t>(style.digits) - (end - first), '0');
    }
    // A small negative number may have become 0, which append_fixed writes without its sign.
    if (style.plus && out[begin] != '+' && out[begin] != '-') out.insert(begin, 1, '+');
    return true;
}

Usual usual_style(Value v) {
    switch (v) {
        case Value::feed:
        case Value::own_feed: return Usual::feed;
        case Value::speed:
        case Value::limit: return Usual::speed;
        case Value::seconds: return Usual::seconds;
        case Value::sweep:
        case Value::held:
        case Value::rotary:
        case Value::purpose_angle:
        case Value::axis:
        case Value::angle:
        case Value::angle_x:
        case Value::angle_y:
        case Value::angle_z:
        case Value::euler_1:
        case Value::euler_2:
        case Value::euler_3: return Usual::angle;
        case Value::factor_x:
        case Value::factor_y:
        case Value::factor_z: return Usual::factor;
        case Value::turns:
        case Value::more_turns:
        case Value::number:
        case Value::edge:
        case Value::turret:
        case Value::offset:
        case Value::place:
        case Value::approach:
        case Value::entry:
        case Value::filter:
        case Value::side:
        case Value::turn_side:
        case Value::table_turns:
        case Value::purpose:
        case Value::way:
        case Value::revolutions:
        case Value::block:
        case Value::passes: return Usual::whole;
        default: return Usual::length;
    }
}

Usual usual_style(cl::CycleRole role) {
    const std::string_view name = cl::spelling(role);
    const auto begins = [&](std::string_view word) { return name.starts_with(word); };
    const auto holds = [&](std::string_view word) { return name.find(word) != std::string_view::npos; };
    if (begins("feed-factor") || begins("rpm-factor") || name == "factor" || name == "overlap") return Usual::factor;
    if (begins("feed-reference")) return Usual::whole;
    if (begins("feed")) return Usual::feed;
    if (holds("spindle-speed")) return Usual::speed;
    if (begins("dwell") && name != "dwell-depth") return Usual::seconds;
    if (holds("angle") || name == "rotation") return Usual::angle;
    for (const std::string_view counted :
         {"direction", "count", "columns", "rows", "passes", "operation", "plunge", "strategy", "approach",
          "compensation", "traverse", "move-at-clearance", "breaks-before-retract", "countersink-order",
          "threads-per-step", "datum-number", "preset-number", "tolerance-mode"})
        if (name == counted || name.ends_with(std::string("-") + std::string(counted))) return Usual::whole;
    return Usual::length;
}

}  // namespace obrys::write
