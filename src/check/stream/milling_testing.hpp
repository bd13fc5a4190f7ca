#pragma once
/// A block on a mill, and findings by their code, for the tests of milling.

#include <string_view>
#include <vector>

#include "check/stream/check.hpp"

namespace obrys::check::testing {

/// X 0 to 60, Y 0 to 40, Z -40 to 0, for an end mill of 20 mm.
inline Setup face_setup() {
    Setup s;
    s.machine.kind = shop::MachineKind::mill;
    shop::Tool t;
    t.number = 1;
    t.kind = shop::ToolKind::end_mill;
    t.radius = 10;
    t.cutting_length = 30;
    s.tools = {t};
    s.tools_given = true;
    s.milling.emplace();
    s.milling->stock = sim::milling::Box3{{0, 0, -40}, {60, 40, 0}};
    s.milling->tolerance = 0.02;
    return s;
}

inline std::vector<const Finding*> of(const Result& r, std::string_view code) {
    std::vector<const Finding*> found;
    for (const Finding& f : r.findings)
        if (f.code == code) found.push_back(&f);
    return found;
}

}  // namespace obrys::check::testing
