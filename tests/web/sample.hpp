#pragma once
/// A page of made-up data for the browser test: a block with a milled pocket and a wavy floor, finished in lines with a
/// ball.

#include "report/milling_page.hpp"

namespace obrys::web_test {

/// `rows` lines of `columns` moves finish the floor; the surface has about 2 * cells * cells triangles.
struct Size {
    int rows = 200, columns = 250, cells = 500;
};
[[nodiscard]] report::MillingPage sample(const Size& size);
/// A run that ended before its first move: no path, no surface, one finding without a place.
[[nodiscard]] report::MillingPage nothing();

}  // namespace obrys::web_test
