#include "report/picture/sheet.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <new>

#include "report/drawing/cairo.hpp"

namespace obrys::report::picture {

using drawing::cairo;
using geom::Vec2;

namespace {

constexpr double furthest_px = 30'000;  ///< px; cairo's coordinates are fixed point with 24 bits before the point

cairo_status_t append(void* to, const unsigned char* bytes, unsigned int count) {
    static_cast<std::string*>(to)->append(bytes, bytes + count);
    return CAIRO_STATUS_SUCCESS;
}

void use(cairo_t* c, mesh::Colour colour) {
    cairo().set_source_rgb(c, colour.red / 255.0, colour.green / 255.0, colour.blue / 255.0);
}

void use(cairo_t* c, const Pen& pen) {
    use(c, pen.colour);
    cairo().set_line_width(c, pen.width);
    cairo().set_dash(c, pen.dashes.data(), static_cast<int>(pen.dashes.size()), 0);
}

void follow(cairo_t* c, const std::vector<Vec2>& points) {
    for (const Vec2 p : points)
        if (std::isfinite(p.x) && std::isfinite(p.y))
            cairo().line_to(c, std::clamp(p.x, -furthest_px, furthest_px), std::clamp(p.y, -furthest_px, furthest_px));
}

/// How many bytes of a letter follow its first one; 0 … 3, or -1 where it can be none.
int followers(unsigned char first) {
    if (first < 0x80) return 0;
    if (first >= 0xc2 && first < 0xe0) return 1;
    if (first >= 0xe0 && first < 0xf0) return 2;
    return first >= 0xf0 && first < 0xf5 ? 3 : -1;
}

/// Cairo draws nothing any more after a text that is no UTF-8.
std::string readable(const std::string& text) {
    std::string out;
    for (std::size_t i = 0; i < text.size();) {
        const auto byte = [&](std::size_t k) { return static_cast<unsigned char>(text[k]); };
        const int more = followers(byte(i));
        std::size_t end = i + 1;
        while (more > 0 && end <= i + static_cast<std::size_t>(more) && end < text.size() && (byte(end) & 0xc0) == 0x80)
            ++end;
        const bool whole = more >= 0 && end == i + 1 + static_cast<std::size_t>(more);
        const bool surrogate = whole && more == 2 && byte(i) == 0xed && byte(i + 1) >= 0xa0;
        const bool longer =
            whole && ((byte(i) == 0xe0 && byte(i + 1) < 0xa0) || (byte(i) == 0xf0 && byte(i + 1) < 0x90) ||
                      (byte(i) == 0xf4 && byte(i + 1) > 0x8f));
        const bool shown = whole && !surrogate && !longer && byte(i) >= 0x20;
        out += shown ? text.substr(i, end - i) : "?";
        i = shown ? end : i + 1;
    }
    return out;
}

/// Cairo numbers the elements of all its SVG documents in one row (surface5, image9), so that the same drawing would
/// not give the same bytes twice: here they are numbered anew. Image data hold neither '#' nor quotes.
std::string renumbered(const std::string& svg) {
    std::map<std::string, std::string> names;
    std::string out;
    for (std::size_t i = 0; i < svg.size();) {
        const bool defined = svg.compare(i, 4, "id=\"") == 0;
        if (!defined && svg[i] != '#') {
            const std::size_t next = svg.find_first_of("#i", i + 1);
            out.append(svg, i, next - i);
            i = std::min(next, svg.size());
            continue;
        }
        const std::size_t begin = i + (defined ? 4 : 1), end = svg.find_first_of("\")", begin);
        std::string name = svg.substr(begin, end - begin);
        if (name.starts_with("surface") || name.starts_with("image") || name.starts_with("source")) {
            const auto number = std::to_string(names.size());
            const std::string stem = name.substr(0, name.find_first_of("0123456789"));
            name = names.try_emplace(name, stem + "-" + number).first->second;
        }
        out.append(svg, i, begin - i).append(name);
        i = std::min(end, svg.size());
    }
    return out;
}

}  // namespace

struct Sheet::Inside {
    struct SurfaceEnd {
        void operator()(cairo_surface_t* s) const { cairo().surface_destroy(s); }
    };
    struct ContextEnd {
        void operator()(cairo_t* c) const { cairo().destroy(c); }
    };
    using Surface = std::unique_ptr<cairo_surface_t, SurfaceEnd>;
    using Context = std::unique_ptr<cairo_t, ContextEnd>;

    SheetFormat format;
    std::string bytes;
    Surface surface;
    Context context;
};

Sheet::Sheet(SheetFormat format, int width, int height) : inside_(new Inside{format, {}, nullptr, nullptr}) {
    width = std::max(width, 1);
    height = std::max(height, 1);
    if (format == SheetFormat::svg) {
        inside_->surface.reset(cairo().svg_surface_create_for_stream(append, &inside_->bytes, width, height));
        if (cairo().surface_status(inside_->surface.get()) == CAIRO_STATUS_SUCCESS)
            cairo().svg_surface_set_document_unit(inside_->surface.get(), CAIRO_SVG_UNIT_PX);
    } else {
        inside_->surface.reset(cairo().image_surface_create(CAIRO_FORMAT_RGB24, width, height));
    }
    inside_->context.reset(cairo().create(inside_->surface.get()));
    cairo().set_source_rgb(inside_->context.get(), 1, 1, 1);
    cairo().paint(inside_->context.get());
}

Sheet::~Sheet() = default;

void Sheet::line(const std::vector<Vec2>& points, const Pen& pen) {
    cairo_t* c = inside_->context.get();
    use(c, pen);
    follow(c, points);
    cairo().stroke(c);
}

void Sheet::area(const std::vector<Vec2>& points, mesh::Colour colour) {
    cairo_t* c = inside_->context.get();
    use(c, colour);
    follow(c, points);
    cairo().fill(c);
}

void Sheet::disc(Vec2 centre, double radius, mesh::Colour colour) {
    cairo_t* c = inside_->context.get();
    if (!std::isfinite(centre.x) || !std::isfinite(centre.y)) return;
    use(c, colour);
    cairo().arc(c, centre.x, centre.y, radius, 0, 2 * geom::pi);
    cairo().fill(c);
}

void Sheet::circle(Vec2 centre, double radius, const Pen& pen) {
    cairo_t* c = inside_->context.get();
    if (!std::isfinite(centre.x) || !std::isfinite(centre.y)) return;
    use(c, pen);
    cairo().arc(c, centre.x, centre.y, radius, 0, 2 * geom::pi);
    cairo().stroke(c);
}

void Sheet::image(Vec2 corner, const Image& image) {
    if (image.width <= 0 || image.height <= 0) return;
    const Inside::Surface pixels(cairo().image_surface_create(CAIRO_FORMAT_ARGB32, image.width, image.height));
    if (cairo().surface_status(pixels.get()) != CAIRO_STATUS_SUCCESS) throw std::bad_alloc();
    cairo().surface_flush(pixels.get());
    unsigned char* const data = cairo().image_surface_get_data(pixels.get());
    const int stride = cairo().image_surface_get_stride(pixels.get());
    const std::size_t width = static_cast<std::size_t>(image.width);
    for (int j = 0; j < image.height; ++j) {
        const auto* row = image.pixels.data() + static_cast<std::size_t>(j) * width;
        const auto* bytes = reinterpret_cast<const unsigned char*>(row);
        std::copy(bytes, bytes + 4 * width, data + std::ptrdiff_t{j} * stride);
    }
    cairo().surface_mark_dirty(pixels.get());
    cairo_t* c = inside_->context.get();
    cairo().set_source_surface(c, pixels.get(), corner.x, corner.y);
    cairo().pattern_set_filter(cairo().get_source(c), CAIRO_FILTER_NEAREST);
    cairo().paint(c);
}

void Sheet::clip(Vec2 corner, Vec2 size) {
    cairo_t* c = inside_->context.get();
    cairo().save(c);
    cairo().rectangle(c, corner.x, corner.y, size.x, size.y);
    cairo().clip(c);
}

void Sheet::unclip() { cairo().restore(inside_->context.get()); }

void Sheet::text(Vec2 at, const std::string& content, const Words& words) {
    // A context of its own: an error of the font's must not end the drawing.
    const Inside::Context own(cairo().create(inside_->surface.get()));
    cairo_t* c = own.get();
    const std::string shown = readable(content);
    cairo().select_font_face(c, "sans-serif", CAIRO_FONT_SLANT_NORMAL,
                             words.bold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
    cairo().set_font_size(c, words.size);
    cairo_text_extents_t extents{};
    cairo().text_extents(c, shown.c_str(), &extents);
    cairo().translate(c, at.x, at.y);
    if (words.upward) cairo().rotate(c, -geom::pi / 2);
    cairo().move_to(c, -words.share * extents.x_advance, 0);
    if (words.halo) {
        cairo().text_path(c, shown.c_str());
        cairo().set_source_rgba(c, 1, 1, 1, 0.85);
        cairo().set_line_width(c, 4);
        cairo().set_line_join(c, CAIRO_LINE_JOIN_ROUND);
        cairo().stroke_preserve(c);
        use(c, words.colour);
        cairo().fill(c);
        return;
    }
    use(c, words.colour);
    cairo().show_text(c, shown.c_str());
}

std::string Sheet::finish() {
    cairo_surface_t* const surface = inside_->surface.get();
    inside_->context.reset();
    cairo().surface_flush(surface);
    std::string bytes;
    if (inside_->format == SheetFormat::svg) {
        cairo().surface_finish(surface);
        if (cairo().surface_status(surface) != CAIRO_STATUS_SUCCESS) throw std::bad_alloc();
        bytes = renumbered(inside_->bytes);
    } else if (cairo().surface_write_to_png_stream(surface, append, &bytes) != CAIRO_STATUS_SUCCESS) {
        throw std::bad_alloc();
    }
    return bytes;
}

}  // namespace obrys::report::picture
