#include "sample.hpp"

#include <algorithm>
#include <cmath>

#include "base/number.hpp"

namespace obrys::web_test {

namespace {

using report::MillingPage;
using report::PageMove;

constexpr double side = 100, border = 8, ball = 3, feed_mm_s = 40, rapid_mm_s = 150;
constexpr double inside = side - 2 * border;
constexpr int contour_levels = 3;

double floor_at(double x, double y) {
    const double u = 2 * geom::pi * x / side;
    const double v = 2 * geom::pi * y / side;
    return -6 + 1.6 * std::sin(u) * std::cos(1.5 * v) + 1.1 * std::cos(2 * u + v);
}

/// Writes program and path at once, as a run would make them.
class Program {
public:
    Program(MillingPage& page, std::size_t text) : page_(page), text_(static_cast<std::uint32_t>(text)) {}

    void line(const std::string& text) {
        page_.texts[text_].text += text + "\n";
        ++lines_;
    }
    void move(const char* word, geom::Vec3 to, std::int32_t tool) {
        const bool rapid = word[1] == '0';
        line(std::string(word) + " X" + base::fixed(to.x, 3) + " Y" + base::fixed(to.y, 3) + " Z" +
             base::fixed(to.z, 3));
        add(to, rapid, tool, lines_);
    }
    void add(geom::Vec3 to, bool rapid, std::int32_t tool, std::uint32_t at_line) {
        const double length = geom::length(to - at_);
        mm_ += length;
        seconds_ += length / (rapid ? rapid_mm_s : feed_mm_s);
        page_.path.moves.push_back(PageMove{rapid, {text_, at_line}, tool, seconds_, mm_, page_.path.moves.size()});
        if (page_.path.points.empty()) point(at_);
        point(to);
        at_ = to;
    }
    [[nodiscard]] std::uint32_t count() const { return static_cast<std::uint32_t>(page_.path.moves.size()); }
    [[nodiscard]] std::uint32_t lines() const { return lines_; }

private:
    void point(geom::Vec3 p) {
        for (const double c : {p.x, p.y, p.z}) page_.path.points.push_back(static_cast<float>(c));
        page_.path.move_of_point.push_back(count() - 1);
    }

    MillingPage& page_;
    std::uint32_t text_, lines_ = 0;
    geom::Vec3 at_{0, 0, 50};
    double mm_ = 0, seconds_ = 0;
};

/// The pocket's wall, from above down. One line of the program goes round all levels, as a subprogram would.
std::uint32_t wall(Program& p) {
    constexpr std::int32_t tool = 1;
    constexpr double r = 5;
    p.line("T1 M6 (END MILL D10)");
    p.move("G0", {border + r, border + r, 5}, tool);
    const std::uint32_t first = p.count();
    const std::uint32_t first_line = p.lines() + 1;
    for (const char* text : {"G1 Z-#1", "X87", "Y87", "X13", "Y13"}) p.line(text);
    for (int level = 1; level <= contour_levels; ++level) {
        const double z = -3.0 * level;
        const double low = border + r;
        const double high = side - border - r;
        p.add({low, low, z}, false, tool, first_line);
        p.add({high, low, z}, false, tool, first_line + 1);
        p.add({high, high, z}, false, tool, first_line + 2);
        p.add({low, high, z}, false, tool, first_line + 3);
        p.add({low, low, z}, false, tool, first_line + 4);
    }
    p.move("G0", {border + r, border + r, 50}, tool);
    return first;
}

struct Raster {
    std::uint32_t first = 0;
    int rows = 0, columns = 0;
    [[nodiscard]] double y(int row) const { return border + inside * (row + 0.5) / rows; }
    [[nodiscard]] double x(int row, int column) const {
        const double t = static_cast<double>(column) / (columns - 1);
        return border + ball + (inside - 2 * ball) * (row % 2 == 0 ? t : 1 - t);
    }
    [[nodiscard]] int row_at(double at) const {
        return std::clamp(static_cast<int>((at - border) / inside * rows), 0, rows - 1);
    }
    /// The move that goes over a place.
    [[nodiscard]] std::uint32_t move_at(double at_x, double at_y) const {
        const int row = row_at(at_y);
        double t = std::clamp((at_x - border - ball) / (inside - 2 * ball), 0.0, 1.0);
        if (row % 2 != 0) t = 1 - t;
        return first + static_cast<std::uint32_t>(row * columns + static_cast<int>(std::ceil(t * (columns - 1))));
    }
};

Raster raster(Program& p, const Size& size) {
    constexpr std::int32_t tool = 2;
    p.line("T2 M6 (BALL D6)");
    Raster r{0, size.rows, size.columns};
    p.move("G0", {r.x(0, 0), r.y(0), 5}, tool);
    r.first = p.count();
    for (int row = 0; row < size.rows; ++row)
        for (int column = 0; column < size.columns; ++column)
            p.move("G1", {r.x(row, column), r.y(row), floor_at(r.x(row, column), r.y(row))}, tool);
    p.move("G0", {r.x(size.rows - 1, size.columns - 1), r.y(size.rows - 1), 50}, tool);
    p.line("M30");
    return r;
}

/// The block's top with pocket and floor over a lattice, its sides and its bottom.
class Surface {
public:
    Surface(MillingPage& page, const Raster& raster, std::uint32_t wall, int cells)
        : s_(page.surface), raster_(raster), wall_(wall), cells_(cells) {}

    void make() {
        for (int j = 0; j <= cells_; ++j)
            for (int i = 0; i <= cells_; ++i)
                vertex({coordinate(i), coordinate(j), height(coordinate(i), coordinate(j))});
        for (int j = 0; j < cells_; ++j)
            for (int i = 0; i < cells_; ++i) cell(i, j);
        const std::uint32_t low = count();
        for (const geom::Vec3 p : {geom::Vec3{0, 0, -20}, {side, 0, -20}, {side, side, -20}, {0, side, -20}}) vertex(p);
        const std::uint32_t n = static_cast<std::uint32_t>(cells_);
        const std::uint32_t top[4] = {0, n, n * (n + 1) + n, n * (n + 1)};
        for (std::uint32_t k = 0; k < 4; ++k) {
            const std::uint32_t next = (k + 1) % 4;
            triangle(low + k, low + next, top[next], report::page_none, 0);
            triangle(low + k, top[next], top[k], report::page_none, 0);
        }
        triangle(low, low + 2, low + 1, report::page_none, 0);
        triangle(low, low + 3, low + 2, report::page_none, 0);
    }

private:
    [[nodiscard]] static bool in_pocket(double x, double y) {
        return x > border && y > border && x < side - border && y < side - border;
    }
    [[nodiscard]] double coordinate(int i) const { return side * i / cells_; }
    [[nodiscard]] double height(double x, double y) const {
        if (!in_pocket(x, y)) return 0;
        const double off = y - raster_.y(raster_.row_at(y));
        return floor_at(x, y) + off * off / (2 * ball);
    }
    [[nodiscard]] std::uint32_t count() const { return static_cast<std::uint32_t>(s_.vertices.size() / 3); }
    void vertex(geom::Vec3 p) {
        for (const double c : {p.x, p.y, p.z}) s_.vertices.push_back(static_cast<float>(c));
    }
    void triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t move, double deviation) {
        for (const std::uint32_t v : {a, b, c}) s_.indices.push_back(v);
        s_.move_of.push_back(move);
        s_.deviation.push_back(static_cast<float>(deviation));
    }
    void cell(int i, int j) {
        const std::uint32_t row = static_cast<std::uint32_t>(cells_ + 1);
        const std::uint32_t a = static_cast<std::uint32_t>(j) * row + static_cast<std::uint32_t>(i);
        int corners_in = 0;
        for (const int dj : {0, 1})
            for (const int di : {0, 1}) corners_in += in_pocket(coordinate(i + di), coordinate(j + dj)) ? 1 : 0;
        const double x = coordinate(i) + 0.5 * side / cells_;
        const double y = coordinate(j) + 0.5 * side / cells_;
        std::uint32_t move = report::page_none;
        double deviation = 0;
        if (corners_in == 4) {
            move = raster_.move_at(x, y);
            const double off = std::hypot(x - 62, y - 40);
            deviation = off < 9 ? -0.04 * (1 - off / 9) : 0.012 * std::sin(x / 5) * std::sin(y / 7);
        } else if (corners_in > 0) {
            move = wall_ + static_cast<std::uint32_t>(5 * (contour_levels - 1) + (y < border + 1          ? 1
                                                                                  : x > side - border - 1 ? 2
                                                                                  : y > side - border - 1 ? 3
                                                                                                          : 4));
        }
        triangle(a, a + 1, a + row + 1, move, deviation);
        triangle(a, a + row + 1, a + row, move, deviation);
    }

    report::PageSurface& s_;
    const Raster& raster_;
    std::uint32_t wall_;
    int cells_;
};

void add_tools(MillingPage& page) {
    report::PageTool end_mill;
    end_mill.number = 1;
    end_mill.name = "END_MILL_D10";
    end_mill.kind = "end mill, diameter 10 mm";
    end_mill.radius = 5;
    end_mill.cutting_length = 22;
    end_mill.bodies = {{22, 40, 5, 5, false}, {40, 52, 12, 16, true}, {52, 80, 20, 20, true}};
    end_mill.moves = 17;
    end_mill.feed_mm = 900;
    end_mill.rapid_mm = 120;
    end_mill.volume_mm3 = 31000;
    report::PageTool finisher;
    finisher.number = 2;
    finisher.name = "BALL_D6";
    finisher.kind = "ball end mill, diameter 6 mm";
    finisher.radius = ball;
    finisher.corner_radius = ball;
    finisher.cutting_length = 12;
    finisher.bodies = {{12, 34, 3, 3, false}, {34, 46, 10, 14, true}, {46, 70, 20, 20, true}};
    finisher.moves = page.path.moves.size() - 17;
    page.tools = {end_mill, finisher};
}

report::PageFinding finding(const MillingPage& page, const char* code, const char* text, std::uint32_t move) {
    report::PageFinding f;
    f.code = code;
    f.text = text;
    f.move = move;
    f.where = page.path.moves[move].where;
    const float* at = &page.path.points[3 * (static_cast<std::size_t>(move) + 1)];
    f.place = geom::Vec3{at[0], at[1], at[2]};
    return f;
}

void add_findings(MillingPage& page, const Raster& raster) {
    const std::uint32_t gouging = raster.move_at(62, 40);
    page.findings.push_back(
        finding(page, "rapid-in-stock", "rapid move goes through the stock: 2.100 mm deep", raster.first - 1));
    page.findings.back().amounts = {{"depth", "2.100", "mm"}};
    page.findings.back().remedy = "retract to the clearance height first";
    page.findings.push_back(
        finding(page, "gouge", "cuts into the finished part: 0.040 mm normal to the surface", gouging));
    page.findings.back().amounts = {{"depth", "0.040", "mm"}};
    page.findings.back().moves = {gouging, gouging + 1};
    page.findings.back().passes = "2 passes, worst 0.040 mm, first move " + std::to_string(gouging);
    page.findings.push_back(
        finding(page, "holder-in-stock", "<b>holder</b> touches the stock </script>", raster.first + 40));
    page.findings.back().severity = base::Severity::warning;
}

}  // namespace

report::MillingPage sample(const Size& size) {
    MillingPage page;
    page.title = "FINISH.NC";
    page.control = "linuxcnc";
    page.machine = "mill-generic";
    page.version = "0.1.0";
    page.verdict = check::Verdict::findings;
    page.verdict_line = "3 findings";
    page.texts = {{"programs/FINISH.NC", ""},
                  {"programs/NOTES.NC", "( </script><script>window.broken = true</script> )\n(nothing here moves)\n"}};
    Program program(page, 0);
    program.line("%");
    program.line("(</script><script>window.broken = true</script> <!-- )");
    program.line("G90 G21 G17 F2400 S12000 M3");
    const std::uint32_t first_of_wall = wall(program);
    const Raster lines = raster(program, size);
    Surface(page, lines, first_of_wall, size.cells).make();
    add_tools(page);
    add_findings(page, lines);
    page.stock = report::PageBox{{0, 0, -20}, {side, side, 0}, "stock"};
    page.clamps = {{{-18, 35, -20}, {-1, 65, -4}, "jaw 1"}, {{side + 1, 35, -20}, {side + 18, 65, -4}, "jaw 2"}};
    page.tolerance = 0.01;
    page.deviation_limit = 0.05;
    page.figures = {{"moves", std::to_string(page.path.moves.size()), ""}, {"removed", "51.300", "cm3"}};
    return page;
}

report::MillingPage nothing() {
    MillingPage page;
    page.title = "EMPTY.NC";
    page.verdict_line = "not fully checked: 1 thing was not checked; 1 finding";
    page.texts = {{"EMPTY.NC", "G1 X1"}};
    page.unchecked = {{"tool 9 is not in the tool list", "add it", {0, 1}}};
    page.findings.resize(1);
    page.findings[0].code = "alarm";
    page.findings[0].text = "no feed";
    page.findings[0].where = {0, 1};
    return page;
}

}  // namespace obrys::web_test
