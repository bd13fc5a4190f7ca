#pragma once
/// What tests ask a result for.

#include <algorithm>
#include <cmath>
#include <string_view>

#include "check/result.hpp"

namespace obrys::check::testing {

/// NaN where the finding has no such amount.
inline double amount(const Finding& f, std::string_view key) {
    for (const Amount& a : f.amounts)
        if (a.key == key) return a.value;
    return NAN;
}

/// Whether something that was not checked is told in these words.
inline bool says(const Result& r, std::string_view words) {
    return std::any_of(r.unchecked.begin(), r.unchecked.end(),
                       [words](const Note& n) { return n.text.find(words) != std::string::npos; });
}

}  // namespace obrys::check::testing
