#pragma once
/// The numbers of a milling page as base64 of little-endian arrays: a browser turns them into typed arrays at once.

#include <string>

#include "report/milling_page.hpp"

namespace obrys::report {

/// Moves and points of the path that fit each other; the surface's triangles whose corners exist.
struct PageCounts {
    std::size_t moves = 0, points = 0, triangles = 0;
};
[[nodiscard]] PageCounts usable(const MillingPage& page);

/// Script elements of a type no browser runs, one an array: <script type="text/plain" id="array-points">…</script>.
/// By point: points (f32 x y z), moveOfPoint (u32). By move: kind (u8, 1: rapid), file (u16), line (u32), tool (u16,
/// index in the page's tools), axes (f32 x y z), seconds and lengths at its end (f64). Of the surface: vertices (f32 x
/// y z), indices (u32), moveOf (u32 a triangle), deviation (f32 a triangle). 0xFFFF and 0xFFFFFFFF: none.
[[nodiscard]] std::string page_arrays(const MillingPage& page);

}  // namespace obrys::report
