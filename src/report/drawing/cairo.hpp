#pragma once
/// Cairo's functions by the names of its header without `cairo_`: `cairo().move_to(context, x, y)`. The library is
/// loaded with the first call (base/library/shared_library.hpp); std::runtime_error where it is not there.

#include <cairo-pdf.h>
#include <cairo-svg.h>
#include <cairo.h>

namespace obrys::report::drawing {

#define OBRYS_CAIRO_FUNCTIONS(X)     \
    X(arc)                           \
    X(clip)                          \
    X(create)                        \
    X(destroy)                       \
    X(fill)                          \
    X(get_source)                    \
    X(image_surface_create)          \
    X(image_surface_get_data)        \
    X(image_surface_get_stride)      \
    X(line_to)                       \
    X(move_to)                       \
    X(paint)                         \
    X(pattern_set_filter)            \
    X(pdf_surface_create_for_stream) \
    X(rectangle)                     \
    X(restore)                       \
    X(rotate)                        \
    X(save)                          \
    X(select_font_face)              \
    X(set_dash)                      \
    X(set_font_size)                 \
    X(set_line_join)                 \
    X(set_line_width)                \
    X(set_source_rgb)                \
    X(set_source_rgba)               \
    X(set_source_surface)            \
    X(show_page)                     \
    X(show_text)                     \
    X(status)                        \
    X(stroke)                        \
    X(stroke_preserve)               \
    X(surface_destroy)               \
    X(surface_finish)                \
    X(surface_flush)                 \
    X(surface_mark_dirty)            \
    X(surface_status)                \
    X(surface_write_to_png_stream)   \
    X(svg_surface_create_for_stream) \
    X(svg_surface_set_document_unit) \
    X(text_extents)                  \
    X(text_path)                     \
    X(translate)

struct Functions {
// NOLINTNEXTLINE(cppcoreguidelines-macro-usage): a name for each of the header's
#define OBRYS_CAIRO_FUNCTION(name) decltype(&::cairo_##name) name = nullptr;
    OBRYS_CAIRO_FUNCTIONS(OBRYS_CAIRO_FUNCTION)
#undef OBRYS_CAIRO_FUNCTION
};

/// The same ones for the whole process, from any thread.
[[nodiscard]] const Functions& cairo();

}  // namespace obrys::report::drawing
