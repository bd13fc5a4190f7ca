#pragma once
/// A blade while it is finished, as text and JSON.

#include <string>

#include "shop/blade.hpp"
#include "sim/beam/blade.hpp"

namespace obrys::report::cutting {

struct BladeSubject {
    std::string name;
    shop::Blade blade;
    sim::beam::BladeResult result;
};
[[nodiscard]] std::string as_text(const BladeSubject& subject);
[[nodiscard]] std::string as_json(const BladeSubject& subject);

/// A stage rings at the speed that was asked for.
[[nodiscard]] bool any_rings(const sim::beam::BladeResult& result);
/// A side of the blank lies under the chord from its root to its tip: it loses part of what a thick root is for.
[[nodiscard]] bool is_hollow(const shop::BladeForm& form);

}  // namespace obrys::report::cutting
