// The smallest program that uses the installed library: both spellings of a header, code that needs linking.
#include <cstdio>

#include "base/number.hpp"
#include "obrys/geom/vec.hpp"

int main() {
    const obrys::geom::Vec2 a{1.5, 0}, b{1.5, 2.5};
    std::puts(obrys::base::fixed(obrys::geom::distance(a, b), 3).c_str());
}
