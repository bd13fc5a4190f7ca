#include "driver/program_blank.hpp"

#include "base/codes.hpp"
#include "base/number.hpp"

namespace obrys::driver {

namespace {

shop::Stock round_stock(const program::Blank& b, double mm) {
    const program::BlankCylinder& c = *b.cylinder;
    shop::SolidCylinder bar;
    bar.axis = b.tool_axis;
    bar.radius = c.radius * mm;
    bar.max = c.top * mm;
    bar.min = (c.top - c.length) * mm;
    return {bar, b.where};
}

}  // namespace

std::optional<shop::Stock> program_blank(const program::Unit& unit, base::Diagnostics& diagnostics) {
    if (!unit.blank) return std::nullopt;
    const program::Blank& b = *unit.blank;
    const double mm = unit.inch ? 25.4 : 1;
    base::Diagnostic d;
    d.where = b.where;
    if (b.cylinder) {
        const shop::Stock stock = round_stock(b, mm);
        const auto& bar = std::get<shop::SolidCylinder>(stock.solid);
        const std::string axis(1, "XYZ"[b.tool_axis]);
        d.severity = base::Severity::note;
        d.code = base::codes::assumption;
        d.text = "the job names no stock: the program's blank is taken, a cylinder about " + axis + " from " + axis +
                 base::fixed(bar.min, 3) + " to " + axis + base::fixed(bar.max, 3) + " mm";
        diagnostics.add(std::move(d));
        return stock;
    }
    bool box = true;
    for (std::size_t i = 0; i < 3; ++i) box = box && b.min[i] < b.max[i];  // false where one is not said
    if (!box) {
        d.severity = base::Severity::warning;
        d.code = base::codes::unknown_value;
        d.text = "the blank is no box: its second corner must lie above the first one in X, Y and Z";
        d.remedy = "correct it, or name the stock in the job";
        diagnostics.add(std::move(d));
        return std::nullopt;
    }
    d.severity = base::Severity::note;
    d.code = base::codes::assumption;
    d.text = "the job names no stock: the program's blank is taken";
    diagnostics.add(std::move(d));
    return shop::Stock{
        shop::SolidBox{{b.min[0] * mm, b.min[1] * mm, b.min[2] * mm}, {b.max[0] * mm, b.max[1] * mm, b.max[2] * mm}},
        b.where};
}

}  // namespace obrys::driver
