#include "report/drawing/cairo.hpp"

#include "base/library/shared_library.hpp"

namespace obrys::report::drawing {

namespace {

Functions load() {
    const base::library::SharedLibrary library(OBRYS_CAIRO_LIBRARY);
    Functions out;
// NOLINTNEXTLINE(cppcoreguidelines-macro-usage): a name for each of the header's
#define OBRYS_CAIRO_FUNCTION(name) library.find(out.name, "cairo_" #name);
    OBRYS_CAIRO_FUNCTIONS(OBRYS_CAIRO_FUNCTION)
#undef OBRYS_CAIRO_FUNCTION
    return out;
}

}  // namespace

const Functions& cairo() {
    static const Functions loaded = load();
    return loaded;
}

}  // namespace obrys::report::drawing
