#include "driver/program_blank.hpp"

#include "base/codes.hpp"

namespace obrys::driver {

std::optional<shop::Stock> program_blank(const program::Unit& unit, base::Diagnostics& diagnostics) {
    if (!unit.blank) return std::nullopt;
    const program::Blank& b = *unit.blank;
    const double mm = unit.inch ? 25.4 : 1;
    base::Diagnostic d;
    d.where = b.where;
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
