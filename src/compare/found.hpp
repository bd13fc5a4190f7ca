#pragma once
/// The first difference of each aspect, in the order in which they are found.

#include <algorithm>
#include <cmath>
#include <string>

#include "base/number.hpp"
#include "cl/text.hpp"
#include "compare/compare.hpp"

namespace obrys::compare {

class Found {
public:
    [[nodiscard]] bool has(Aspect aspect) const {
        return std::any_of(all.begin(), all.end(), [&](const Difference& d) { return d.aspect == aspect; });
    }
    /// Those of which none is here yet.
    void add(const Found& others) {
        for (const Difference& d : others.all)
            if (!has(d.aspect)) all.push_back(d);
    }
    /// `a` and `b`: moves or items; null: the stream has none.
    template <class T>
    void add(Aspect aspect, const T* a, const T* b, std::size_t move, std::string what) {
        if (has(aspect)) return;
        Difference d{aspect, is_done(aspect), std::move(what), move, 0, {}, {}, 0, 0};
        if (a != nullptr) d.in_a = a->from, d.stack_a = a->stack;
        if (b != nullptr) d.in_b = b->from, d.stack_b = b->stack;
        all.push_back(std::move(d));
    }

    std::vector<Difference> all;
};

/// A record in the words of the stream's text form, without its place and the lines of axes before it.
inline std::string words(const cl::Step& step) {
    std::string out = cl::to_text({step, {}, 0});
    out.erase(0, out.rfind('\n') + 1);
    return out.substr(0, out.rfind(" @"));
}
/// A zero as a message names it: the ledger calls zeros by the same numbers.
inline std::string words(const cl::Datum& datum) {
    constexpr std::uint32_t none_selected = 500;
    const bool none = datum.number == 0 || datum.number == none_selected;
    std::string out = none ? "the zero that is active without a word" : "zero " + std::to_string(datum.number);
    const geom::Vec3& p = datum.origin;
    if (std::isnan(p.x) && std::isnan(p.y) && std::isnan(p.z)) return none ? out : out + ", whose place is not known";
    const auto coordinate = [](const char* axis, double v) {
        return axis + (std::isnan(v) ? std::string("unknown") : base::shortest(v) + " mm");
    };
    return out + " at" + coordinate(" X ", p.x) + coordinate(" Y ", p.y) + coordinate(" Z ", p.z) + " of the machine";
}

}  // namespace obrys::compare
