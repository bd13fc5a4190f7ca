#pragma once
/// One drawing of a part in a picture: a frame with scales, stock, contours, tool path and numbered findings.

#include <string>
#include <vector>

#include "check/words.hpp"
#include "report/path.hpp"
#include "report/subject.hpp"

namespace obrys::report {

/// Findings that share a mark: groups whose worst is one move. Numbers count from 1 in the order of the program.
struct Mark {
    std::string label;      ///< "3" or "3-5"
    geom::Vec2 at;          ///< (z, x)
    std::size_t first = 0;  ///< number of its first finding
};
[[nodiscard]] std::vector<Mark> marks_of(const check::Result& result);

/// What stands at the scales; `axis` draws the line where the upward coordinate is 0, the axis of rotation of a lathe.
struct Scales {
    std::string right = "Z mm →", up = "↑ X mm (radius)";
    bool axis = true;
};

class Window {
public:
    /// Shows `box` in a frame at (left, top) with equal scale, as large as `width` and `height` allow.
    /// The box' z runs to the right and its x upwards, whatever the scales call them.
    Window(std::string name, const check::Box& box, double left, double top, double width, double height,
           Scales scales = {});

    /// Frame and scales with this content clipped to the frame.
    [[nodiscard]] std::string frame(const std::string& content) const;
    [[nodiscard]] std::string draw(const Subject& subject, const std::vector<Mark>& marks) const;
    [[nodiscard]] const Projection& projection() const { return to_; }
    [[nodiscard]] double left() const { return left_; }
    [[nodiscard]] double right() const { return left_ + width_; }
    [[nodiscard]] double bottom() const { return top_ + height_; }

private:
    void axes(std::string& out) const;
    void regions(std::string& out, const Subject& subject) const;
    void marks(std::string& out, const std::vector<Mark>& marks) const;

    std::string name_;
    check::Box box_;
    double left_, top_, width_, height_;
    Projection to_;
    Scales scales_;
};

namespace svg {
// How a picture is laid out, in its units.
inline constexpr double margin = 62, margin_right = 26, top_of_window = 78, axis_room = 46, legend_room = 30;
inline constexpr double most_height = 640;  ///< of a drawing
inline constexpr double detail_width = 300, detail_gap = 70;
/// A step of 1, 2 or 5 times a power of ten, not less than `least`.
[[nodiscard]] double round_step(double least);
/// The document round a content drawn with the classes of the house's style, `width` wide.
[[nodiscard]] std::string document(double width, double height, const std::string& content);
[[nodiscard]] std::string line(const char* cls, double x1, double y1, double x2, double y2);
[[nodiscard]] std::string text(const char* cls, double x, double y, const std::string& content,
                               const char* anchor = "start");
}  // namespace svg

}  // namespace obrys::report
