#include "shop/files/dropped.hpp"

#include <algorithm>

#include "base/codes.hpp"

namespace obrys::shop {

void Dropped::add(const std::string& name, const base::Span& where) {
    Entry& e = names_[name];
    if (e.count++ == 0) e.first = where;
}

void Dropped::report(base::Diagnostics& diagnostics) const {
    constexpr std::size_t most = 60;
    if (names_.empty()) return;
    base::Diagnostic d;
    d.severity = base::Severity::note;
    d.code = base::codes::no_effect;
    d.where = names_.begin()->second.first;
    std::size_t written = 0;
    for (const auto& [name, e] : names_) {
        if (e.first.begin < d.where.begin) d.where = e.first;
        if (written++ < most)
            d.text +=
                (d.text.empty() ? "not taken from this file: " : ", ") + name + " (" + std::to_string(e.count) + ")";
    }
    if (written > most) d.text += " and " + std::to_string(written - most) + " more";
    diagnostics.add(std::move(d));
}

void assume(std::string& assumed, std::string_view what) {
    if (!assumed.empty()) assumed += ", ";
    assumed += what;
}

}  // namespace obrys::shop
