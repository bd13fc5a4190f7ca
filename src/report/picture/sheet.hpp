#pragma once
/// A sheet of paper to draw a picture on: lines, areas, pixels and words, as PNG or SVG. Pixels from the upper left
/// corner, y downwards. Cairo does the drawing and stays in sheet.cpp.

#include <memory>
#include <string>
#include <vector>

#include "geom/vec.hpp"
#include "mesh/colour.hpp"
#include "report/picture/relief.hpp"

namespace obrys::report::picture {

enum class SheetFormat : std::uint8_t { png, svg };

struct Pen {
    mesh::Colour colour{0, 0, 0};
    double width = 1;  ///< px
    std::vector<double> dashes = {};
};

struct Words {
    double size = 13;  ///< px
    mesh::Colour colour{30, 34, 40};
    double share = 0;     ///< of the text's length that lies before its place: 0 it begins there, 0.5 is centred
    bool upward = false;  ///< turned a quarter to the left
    bool halo = false;    ///< white round the letters, for words on a picture
    bool bold = false;
};

class Sheet {
public:
    /// White; both sides at least one pixel.
    Sheet(SheetFormat format, int width, int height);
    ~Sheet();
    Sheet(const Sheet&) = delete;
    Sheet& operator=(const Sheet&) = delete;

    /// Points that are not finite are left out.
    void line(const std::vector<geom::Vec2>& points, const Pen& pen);
    void area(const std::vector<geom::Vec2>& points, mesh::Colour colour);
    void disc(geom::Vec2 centre, double radius, mesh::Colour colour);
    void circle(geom::Vec2 centre, double radius, const Pen& pen);
    void image(geom::Vec2 corner, const Image& image);
    /// What is drawn from here to `unclip` shows within this rectangle only.
    void clip(geom::Vec2 corner, geom::Vec2 size);
    void unclip();
    /// UTF-8; `at` is on the base line. A machine that cannot draw it leaves the picture without it. Where bytes are no
    /// UTF-8 they are replaced by question marks.
    void text(geom::Vec2 at, const std::string& content, const Words& words = {});

    /// The bytes of the file, the same for the same drawing; nothing can be drawn any more. Throws where memory ends.
    [[nodiscard]] std::string finish();

private:
    struct Inside;
    std::unique_ptr<Inside> inside_;
};

}  // namespace obrys::report::picture
