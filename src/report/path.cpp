#include "report/path.hpp"

#include <cmath>

#include "base/number.hpp"
#include "base/whole.hpp"

namespace obrys::report {

namespace {

constexpr double largest_arc = 2.0;  ///< radians in one `A`: well below a half turn, where its centre is well defined

/// An arc from the pen to `p` with `sweep` radians about a circle of this radius, split where it is long.
void append_arc(std::string& out, geom::Vec2 from, geom::Vec2 p, geom::Vec2 centre, double sweep,
                const Projection& to) {
    const int parts = base::clipped<int>(std::ceil(std::abs(sweep) / largest_arc), 1, 1'000'000);
    const double radius = geom::distance(from, centre);
    for (int i = 1; i <= parts; ++i) {
        const double turn = sweep * i / parts, c = std::cos(turn), s = std::sin(turn);
        const geom::Vec2 d = from - centre;
        const geom::Vec2 end = i == parts ? p : centre + geom::Vec2{c * d.x - s * d.y, s * d.x + c * d.y};
        const std::string r = number(radius * to.scale, to.decimals);
        // Counter-clockwise stays counter-clockwise to the eye, which SVG calls the negative direction.
        out += "A" + r + " " + r + " 0 0 " + (sweep > 0 ? "0 " : "1 ");
        append_point(out, to(end), to.decimals);
    }
}

}  // namespace

std::string number(double value, int decimals) {
    std::string text = base::fixed(value, decimals);
    if (text.find('.') == std::string::npos) return text;
    text.erase(text.find_last_not_of('0') + 1);
    if (text.ends_with('.')) text.pop_back();
    return text == "-0" ? "0" : text;
}

void append_point(std::string& out, geom::Vec2 p, int decimals) {
    out += number(p.x, decimals) + " " + number(p.y, decimals);
}

std::string path_of(const geom::Contour& contour, const Projection& to) {
    std::string out;
    const auto& v = contour.vertices;
    if (v.empty()) return out;
    out += "M";
    append_point(out, to(v[0].p), to.decimals);
    for (std::size_t i = 0; i < v.size(); ++i) {
        if (i + 1 == v.size() && !contour.closed) break;
        const geom::Vec2 a = v[i].p, b = v[(i + 1) % v.size()].p;
        const double bulge = v[i].bulge;
        if (bulge != 0) {
            const geom::Vec2 centre = 0.5 * (a + b) + ((1 - bulge * bulge) / (4 * bulge)) * geom::left_of(b - a);
            append_arc(out, a, b, centre, 4 * std::atan(bulge), to);
        } else if (i + 1 < v.size()) {
            out += "L";
            append_point(out, to(b), to.decimals);
        }
    }
    if (contour.closed) out += "Z";
    return out;
}

std::string path_of(const geom::Region& region, const Projection& to) {
    std::string out;
    for (const geom::Contour& c : region.contours) out += path_of(c, to);
    return out;
}

void MovePath::add(const check::MoveTrace& m) {
    if (!std::isfinite(m.from.x + m.from.y + m.to.x + m.to.y)) return;
    if (!(pen_ == m.from)) {
        data_ += "M";
        append_point(data_, to_(m.from), to_.decimals);
    }
    if (m.sweep != 0) {
        append_arc(data_, m.from, m.to, m.centre, m.sweep, to_);
    } else {
        for (const geom::Vec2& p : m.via) {
            data_ += "L";
            append_point(data_, to_(p), to_.decimals);
        }
        data_ += "L";
        append_point(data_, to_(m.to), to_.decimals);
    }
    pen_ = m.to;
}

std::string escaped(std::string_view text) {
    std::string out;
    for (const char c : text) {
        switch (c) {
            case '&': out += "&amp;"; break;
            case '<': out += "&lt;"; break;
            case '>': out += "&gt;"; break;
            case '"': out += "&quot;"; break;
            default: out += c;
        }
    }
    return out;
}

}  // namespace obrys::report
