#include "sim/cutting/data.hpp"

#include <algorithm>

#include "geom/vec.hpp"
#include "sim/cutting/form.hpp"
#include "sim/cutting/law.hpp"

namespace obrys::sim::cutting {

namespace {

using geom::pi;

constexpr double usual_point_angle = 118 * pi / 180;
constexpr double agreement = 0.01;  ///< given values may differ by what rounding in a workshop makes of them

bool known(double v) { return std::isfinite(v); }

MillForm form_of(const Asked& asked, double diameter) {
    return {diameter, asked.ball ? diameter / 2 : asked.corner_radius, asked.tilt};
}

double effective_of(const Asked& asked, const Data& d, double diameter) {
    if (asked.process != Process::milling || (!asked.ball && asked.corner_radius == 0)) return diameter;
    return known(d[Value::depth]) ? effective_diameter(form_of(asked, diameter), d[Value::depth]) : NAN;
}

/// Where an increasing function of a size reaches a value; NaN: nowhere between the ends.
template <typename Function>
double root(Function value, double wanted, double low, double high) {
    constexpr int halvings = 200;
    if (!(value(low) <= wanted) || !(value(high) >= wanted)) return NAN;
    for (int i = 0; i < halvings; ++i) {
        const double middle = (low + high) / 2;
        (value(middle) < wanted ? low : high) = middle;
    }
    return (low + high) / 2;
}

/// The angle over which a tooth is engaged.
double engaged(const Data& d) {
    const double across = d[Value::effective_diameter], width = d[Value::width];
    if (!known(across) || !known(width) || width > across * (1 + 1e-9)) return NAN;
    return std::acos(std::clamp(1 - 2 * width / across, -1.0, 1.0));
}

/// Mean thickness of the chip of a feed per tooth of 1; NaN: not known.
double chip_ratio(const Asked& asked, const Data& d) {
    switch (asked.process) {
        case Process::turning: return std::sin(known(asked.entering_angle) ? asked.entering_angle : pi / 2);
        case Process::drilling: return std::sin((known(asked.point_angle) ? asked.point_angle : usual_point_angle) / 2);
        case Process::milling: break;
    }
    const double angle = engaged(d);
    if (!known(angle) || angle == 0) return NAN;
    const bool round = asked.ball || asked.corner_radius > 0;
    if (round && !known(d[Value::depth])) return NAN;
    const double lean = round ? mean_lean(form_of(asked, d[Value::diameter]), d[Value::depth]) : 1;
    return (1 - std::cos(angle)) / angle * lean;
}

/// A product of some values, each to the power 1 or -1, times a factor, is 1: the one that is not known follows.
struct Product {
    struct Part {
        Value value;
        int power;
    };
    std::vector<Part> parts;
    double factor = 1;
};

double product_without(const Product& p, const Data& d, Value left_out) {
    double product = p.factor;
    for (const Product::Part& part : p.parts)
        if (part.value != left_out) product *= part.power > 0 ? d[part.value] : 1 / d[part.value];
    return product;
}

double follows(const Product& p, const Data& d, const Product::Part& wanted) {
    const double rest = product_without(p, d, wanted.value);
    return wanted.power > 0 ? 1 / rest : rest;
}

std::vector<Product> products(const Asked& asked, const Data& d) {
    std::vector<Product> all{
        {{{Value::cutting_speed, -1}, {Value::effective_diameter, 1}, {Value::speed, 1}}, pi / 1000},
        {{{Value::feed, -1}, {Value::teeth, 1}, {Value::speed, 1}, {Value::feed_per_tooth, 1}}, 1}};
    if (const double ratio = chip_ratio(asked, d); known(ratio))
        all.push_back({{{Value::chip, -1}, {Value::feed_per_tooth, 1}}, ratio});
    switch (asked.process) {
        case Process::milling:
            all.push_back({{{Value::removal, -1}, {Value::depth, 1}, {Value::width, 1}, {Value::feed, 1}}, 1e-3});
            break;
        case Process::turning:  // along the surface that is cut, cm3/min
            all.push_back(
                {{{Value::removal, -1}, {Value::depth, 1}, {Value::feed_per_tooth, 1}, {Value::cutting_speed, 1}}, 1});
            break;
        case Process::drilling:
            all.push_back(
                {{{Value::removal, -1}, {Value::diameter, 1}, {Value::diameter, 1}, {Value::feed, 1}}, pi / 4e3});
            break;
    }
    return all;
}

/// One value of a relation, where it alone is not known. True: it follows now.
bool complete(const Product& p, Data& d) {
    const Product::Part* missing = nullptr;
    for (const Product::Part& part : p.parts) {
        if (known(d[part.value])) continue;
        if (missing != nullptr) return false;
        missing = &part;
    }
    if (missing == nullptr) return false;
    const double value = follows(p, d, *missing);
    if (!known(value) || !(value > 0)) return false;
    d[missing->value] = value;
    return true;
}

/// Diameter and effective diameter from each other; the depth, where both are known.
bool complete_sizes(const Asked& asked, Data& d) {
    double &diameter = d[Value::diameter], &effective = d[Value::effective_diameter], &depth = d[Value::depth];
    if (known(diameter) && !known(effective)) return known(effective = effective_of(asked, d, diameter));
    if (!known(diameter) && known(effective)) {
        constexpr double largest = 1e5;
        const double least = std::max({effective, 2 * asked.corner_radius, asked.ball && known(depth) ? depth : 0.0});
        const bool flat = asked.process != Process::milling || (!asked.ball && asked.corner_radius == 0);
        diameter = flat ? effective
                        : root([&](double size) { return effective_of(asked, d, size); }, effective, least, largest);
        return known(diameter);
    }
    if (known(diameter) && known(effective) && !known(depth) && asked.process == Process::milling) {
        const MillForm form = form_of(asked, diameter);
        if (form.corner_radius == 0) return false;
        depth = root([&](double v) { return effective_diameter(form, v); }, effective, 0, form.corner_radius);
        return known(depth);
    }
    return false;
}

void complete(const Asked& asked, Data& d) {
    if (asked.process == Process::turning) d[Value::teeth] = 1;
    bool more = true;
    while (more) {
        more = complete_sizes(asked, d);
        for (const Product& p : products(asked, d)) more = complete(p, d) || more;
    }
}

bool agree(double a, double b) { return std::abs(a - b) <= agreement * std::max(std::abs(a), std::abs(b)); }

/// The values that were given and follow from the others, too, as something else.
std::vector<Difference> differences(const Asked& asked, const Data& d) {
    std::vector<Difference> all;
    for (const Product& p : products(asked, d)) {
        const Product::Part& result = p.parts.front();
        const bool whole = std::all_of(p.parts.begin(), p.parts.end(),
                                       [&](const Product::Part& part) { return known(d[part.value]); });
        if (!whole) continue;
        const double computed = follows(p, d, result);
        if (!agree(d[result.value], computed)) all.push_back({result.value, d[result.value], computed});
    }
    if (known(asked[Value::effective_diameter]) && known(asked[Value::diameter]))
        if (const double computed = effective_of(asked, d, d[Value::diameter]);
            known(computed) && !agree(computed, d[Value::effective_diameter]))
            all.push_back({Value::effective_diameter, d[Value::effective_diameter], computed});
    return all;
}

/// mm a tooth, of turning a revolution; the same limits as of programs (`feed-implausible`). High-feed mills take 2 mm,
/// and no more than a tenth of their diameter.
double most_of_a_tooth(const Asked& asked, const Data& d) {
    constexpr double turned = 5, drilled = 0.5, milled = 4;
    const double diameter = d[Value::diameter];
    switch (asked.process) {
        case Process::turning: return turned;
        case Process::drilling: return known(diameter) ? std::max(drilled, diameter / 8) : milled;
        case Process::milling: break;
    }
    return known(diameter) ? std::min(milled, std::max(drilled, diameter / 5)) : milled;
}

/// Torque and power of the force along the cut.
void add_power(const Asked& asked, Data& d) {
    const double chip = d[Value::chip], removal = d[Value::removal];
    if (asked.material == nullptr || !known(chip) || !known(removal)) return;
    const Law law = law_for(*asked.material, chip);
    d.law = law.name + " (" + law.source + ")";
    d.extrapolated = chip < law.thinnest || chip > law.thickest;
    d.specific_force = force(law, chip).tangential / chip;
    d.power = d.specific_force * removal / 60;  // N/mm2 cm3/min = 1/60 W
    if (known(d[Value::speed])) d.torque = d.power / (2 * pi * d[Value::speed] / 60);
}

/// Marks that the tool's form and its feed leave.
void add_marks(const Asked& asked, Data& d) {
    double radius = NAN, distance = NAN;
    if (asked.process == Process::turning) {
        radius = asked.nose_radius;
        distance = d[Value::feed_per_tooth];
    } else if (asked.process == Process::milling && known(d[Value::diameter])) {
        const double corner = form_of(asked, d[Value::diameter]).corner_radius;
        // Of a round the rows beside each other; of an end mill what its teeth leave at a wall.
        radius = corner > 0 ? corner : d[Value::diameter] / 2;
        distance = corner > 0 ? d[Value::width] : d[Value::feed_per_tooth];
    }
    if (!known(radius) || !known(distance)) return;
    constexpr double micrometres = 1000;
    d.rz = micrometres * ridge(radius, distance);
    d.ra = mean_deviation(d.rz);
}

Data solve_freely(const Asked& asked) {
    Data d;
    d.values = asked.given;
    complete(asked, d);
    d.differences = differences(asked, d);
    if (const double f = d[Value::feed_per_tooth]; known(f)) {
        const double angle = engaged(d);
        if (asked.process != Process::milling)
            d.thickest_chip = f * chip_ratio(asked, d);
        else if (known(angle))
            d.thickest_chip = f * std::sin(std::min(angle, pi / 2));
    }
    d.feed_implausible = d[Value::feed_per_tooth] > most_of_a_tooth(asked, d);
    add_power(asked, d);
    add_marks(asked, d);
    return d;
}

/// The same with another speed, at the same feed per tooth.
Data at_speed(const Asked& asked, const Data& d, double speed) {
    Asked slower = asked;
    slower[Value::speed] = speed;
    slower[Value::cutting_speed] = slower[Value::removal] = NAN;
    for (const Value kept : {Value::diameter, Value::teeth, Value::feed_per_tooth, Value::depth, Value::width})
        slower[kept] = d[kept];
    slower[Value::effective_diameter] = NAN;
    if (known(d[Value::feed_per_tooth])) slower[Value::feed] = NAN;
    return solve_freely(slower);
}

Data at_feed(const Asked& asked, const Data& d, double feed) {
    Asked slower = asked;
    for (const Value kept : {Value::diameter, Value::teeth, Value::speed, Value::depth, Value::width})
        slower[kept] = d[kept];
    slower[Value::feed] = feed;
    slower[Value::feed_per_tooth] = slower[Value::chip] = slower[Value::removal] = NAN;
    slower[Value::effective_diameter] = slower[Value::cutting_speed] = NAN;
    return solve_freely(slower);
}

}  // namespace

Data solve(const Asked& asked, const MachineLimits& limits) {
    Data d = solve_freely(asked);
    std::vector<Difference> differences = d.differences;
    std::vector<std::string> by;
    if (d[Value::speed] > limits.most_speed) {
        d = at_speed(asked, d, limits.most_speed);
        by.emplace_back("spindle.max");
    } else if (d[Value::speed] < limits.least_speed) {
        d = at_speed(asked, d, limits.least_speed);
        by.emplace_back("spindle.min");
    }
    if (d[Value::feed] > limits.most_feed) {
        d = at_feed(asked, d, limits.most_feed);
        by.emplace_back("max_feed");
    }
    bool impossible = false;
    if (d.power > limits.most_power && d[Value::speed] > 0) {
        const double speed = d[Value::speed] * limits.most_power / d.power;
        impossible = speed < limits.least_speed;
        d = at_speed(asked, d, std::max(speed, limits.least_speed));
        by.emplace_back("spindle.power");
    }
    d.clamped_by = std::move(by);
    d.differences = std::move(differences);
    d.impossible = impossible;
    return d;
}

}  // namespace obrys::sim::cutting
