#include "solid.hpp"

#include <numbers>
#include <sstream>
#include <stdexcept>
#include <string>

namespace exact {

namespace {

constexpr double fine = 5e-7;  ///< mm: sagitta to which arcs are divided

/// Signed distance in the half plane through the axis, with the direction in which it grows.
struct Flat {
    double d = 0, out_r = 0, out_z = 0;
};

Flat from_segment(double r, double z, double ar, double az, double br, double bz) {
    const double dr = br - ar, dz = bz - az, size = dr * dr + dz * dz;
    const double t = size > 0 ? std::clamp(((r - ar) * dr + (z - az) * dz) / size, 0.0, 1.0) : 0;
    const double er = r - ar - t * dr, ez = z - az - t * dz, d = std::sqrt(er * er + ez * ez);
    if (d < 1e-300) return {0, 1, 0};
    return {d, er / d, ez / d};
}

/// Of a body, from a place at a distance r from its axis and a height z.
Flat from_body(const Body& b, double r, double z) {
    const double dr = b.r1 - b.r0, dz = b.z1 - b.z0, size = std::sqrt(dr * dr + dz * dz);
    Flat best;
    const double over = size > 0 ? ((r - b.r0) * dz - (z - b.z0) * dr) / size : 1;  // beyond the flank
    if (z > b.z0 && z < b.z1 && over < 0) {
        best = {over, dz / size, -dr / size};
        if (b.z0 - z > best.d) best = {b.z0 - z, 0, -1};
        if (z - b.z1 > best.d) best = {z - b.z1, 0, 1};
    } else {
        best = from_segment(r, z, b.r0, b.z0, b.r1, b.z1);
        for (const auto& [radius, height] : {std::pair{b.r0, b.z0}, std::pair{b.r1, b.z1}}) {
            const Flat f = from_segment(r, z, 0, height, radius, height);
            if (f.d < best.d) best = f;
        }
    }
    best.d -= b.rounding;
    return best;
}

Signed from_standing(const Body& body, V axis, V p) {
    const double z = dot(p, axis);
    const V aside = p - z * axis;
    const double r = norm(aside);
    const Flat f = from_body(body, r, z);
    return {f.d, f.out_r * (r > 1e-12 ? (1 / r) * aside : across(axis)) + f.out_z * axis};
}

/// A place of a convex function along a straight piece, 0 … 1, and how fast it grows there.
struct Slope {
    double t = 0;
    Signed at;
    double grows = 0;
};
/// What the tangents at both ends leave possible in between.
double below(const Slope& a, const Slope& b) {
    if (a.grows >= 0) return a.at.d;
    if (b.grows <= 0) return b.at.d;
    const double t = (b.at.d - a.at.d + a.grows * a.t - b.grows * b.t) / (a.grows - b.grows);
    return a.at.d + a.grows * (t - a.t);
}

/// The least along a straight way from a to b.
Signed along_line(const Body& body, V axis, V a, V b, V p) {
    const V way = b - a;
    const double rise = dot(way, axis), size = dot(way, way);
    const auto at = [&](double t) {
        const Signed s = from_standing(body, axis, p - a - t * way);
        return Slope{t, s, -dot(s.out, way)};
    };
    if (size == 0) return at(0).at;
    if (std::abs(rise) < 1e-12 * std::sqrt(size))  // level: it grows with the distance from the axis
        return at(std::clamp(dot(p - a, way) / size, 0.0, 1.0)).at;
    Slope low = at(0), high = at(1);
    Signed best = low.at.d < high.at.d ? low.at : high.at;
    constexpr double exactly = 1e-9;
    for (int i = 0; i < 200 && below(low, high) < best.d - exactly; ++i) {
        const double cut = (high.at.d - low.at.d + low.grows * low.t - high.grows * high.t) / (low.grows - high.grows);
        const double width = high.t - low.t;
        const bool halve = i % 2 == 1 || !(cut > low.t + 1e-3 * width && cut < high.t - 1e-3 * width);
        const Slope middle = at(halve ? low.t + width / 2 : cut);
        if (middle.at.d < best.d) best = middle.at;
        (middle.grows < 0 ? low : high) = middle;
    }
    return best;
}

/// The least along a part of an arc, chords where they leave out less than would change it.
void along_arc(const Body& body, const Move& m, double t0, double t1, V p, Signed& best) {
    const V a = at(m, t0), b = at(m, t1);
    const V out = m.from - m.centre;
    const double radius = norm(out - dot(out, m.normal) * m.normal), angle = std::abs(m.sweep) * (t1 - t0);
    const auto look = [&](double t, V c) {
        const Signed s = from_standing(body, m.axis, p - c);
        if (s.d < best.d) best = s;
        return Slope{t, s, -dot(s.out, b - a)};
    };
    if (angle < 1) {
        const double sagitta = radius * (1 - std::cos(angle / 2));
        if (below(look(0, a), look(1, b)) - sagitta >= best.d - fine) return;
        if (angle < 1e-7) return;
    }
    const double middle = (t0 + t1) / 2;
    const bool first = norm(p - a) < norm(p - b);
    along_arc(body, m, first ? t0 : middle, first ? middle : t1, p, best);
    along_arc(body, m, first ? middle : t0, first ? t1 : middle, p, best);
}

/// A level circle about the tool's axis: where it comes nearest to that of the tool.
double nearest_on_circle(const Move& m, V p) {
    const V u = unit(m.from - m.centre), v = cross(m.normal, u);
    const V q = p - m.centre;
    double angle = std::atan2(dot(q, v), dot(q, u));
    if (m.sweep < 0) angle = -angle;
    const double whole = std::abs(m.sweep), turn = 2 * std::numbers::pi;
    while (angle < 0) angle += turn;
    if (angle <= whole) return angle / whole;
    return angle - whole < turn - angle ? 1 : 0;
}

Box box_of(const Move& m, const Tool& tool) {
    Box box;
    const int pieces = m.arc ? 64 : 1;
    for (int i = 0; i <= pieces; ++i) {
        const V c = at(m, static_cast<double>(i) / pieces);
        for (const Body& b : tool)
            for (const auto& [r, z] : {std::pair{b.r0, b.z0}, std::pair{b.r1, b.z1}}) {
                const V middle = c + z * m.axis;
                V half;
                half.x = r * std::sqrt(std::max(0.0, 1 - m.axis.x * m.axis.x)) + b.rounding;
                half.y = r * std::sqrt(std::max(0.0, 1 - m.axis.y * m.axis.y)) + b.rounding;
                half.z = r * std::sqrt(std::max(0.0, 1 - m.axis.z * m.axis.z)) + b.rounding;
                box.add(middle - half), box.add(middle + half);
            }
    }
    if (m.arc) {
        const double more = norm(m.from - m.centre) * (1 - std::cos(std::abs(m.sweep) / pieces / 2));
        box.lo = box.lo - V{more, more, more}, box.hi = box.hi + V{more, more, more};
    }
    return box;
}

V read_vector(std::istream& in) {
    V v;
    if (!(in >> v.x >> v.y >> v.z)) throw std::runtime_error("three numbers expected");
    return v;
}

}  // namespace

V at(const Move& m, double t) {
    if (!m.arc) return m.from + t * (m.to - m.from);
    const V out = m.from - m.centre;
    const double a = m.sweep * t, rise = dot(m.to - m.from, m.normal);
    const V level = out - dot(out, m.normal) * m.normal;
    return m.from - level + std::cos(a) * level + std::sin(a) * cross(m.normal, level) + t * rise * m.normal;
}

Solid::Solid(std::istream& scene) {
    std::string line;
    while (std::getline(scene, line)) {
        std::istringstream in(line);
        std::string word;
        if (!(in >> word)) continue;
        if (word == "box") {
            stock_box_.add(read_vector(in)), stock_box_.add(read_vector(in));
        } else if (word == "cylinder") {
            round_ = true;
            foot_ = read_vector(in);
            const V top = read_vector(in);
            in >> radius_;
            length_ = norm(top - foot_), along_ = unit(top - foot_);
            const V r{radius_, radius_, radius_};
            for (const V& p : {foot_, top}) stock_box_.add(p - r), stock_box_.add(p + r);
        } else if (word == "tool") {
            tools_.emplace_back();
        } else if (word == "body" && !tools_.empty()) {
            Body b;
            in >> b.r0 >> b.z0 >> b.r1 >> b.z1 >> b.rounding;
            tools_.back().push_back(b);
        } else if (word == "line" || word == "arc") {
            Move m;
            in >> m.tool;
            if (m.tool >= tools_.size()) throw std::runtime_error("no such tool: " + line);
            m.axis = unit(read_vector(in)), m.from = read_vector(in), m.to = read_vector(in);
            if (word == "arc") m.arc = true, m.centre = read_vector(in), m.normal = unit(read_vector(in)), in >> m.sweep;
            moves_.push_back(m);
        } else {
            throw std::runtime_error("not known: " + line);
        }
        if (!in) throw std::runtime_error("too few numbers: " + line);
    }
    for (Move& m : moves_) m.box = box_of(m, tools_[m.tool]);
}

Signed Solid::stock(V p) const {
    if (round_) return from_standing({radius_, 0, radius_, length_, 0}, along_, p - foot_);
    const V c = 0.5 * (stock_box_.lo + stock_box_.hi), half = 0.5 * (stock_box_.hi - stock_box_.lo);
    const V q = p - c;
    const V over{std::abs(q.x) - half.x, std::abs(q.y) - half.y, std::abs(q.z) - half.z};
    const V sign{q.x < 0 ? -1.0 : 1.0, q.y < 0 ? -1.0 : 1.0, q.z < 0 ? -1.0 : 1.0};
    const V out{std::max(over.x, 0.0), std::max(over.y, 0.0), std::max(over.z, 0.0)};
    if (const double d = norm(out); d > 0) return {d, {sign.x * out.x / d, sign.y * out.y / d, sign.z * out.z / d}};
    if (over.x >= over.y && over.x >= over.z) return {over.x, {sign.x, 0, 0}};
    if (over.y >= over.z) return {over.y, {0, sign.y, 0}};
    return {over.z, {0, 0, sign.z}};
}

Signed Solid::swept(const Move& m, V p, double most) const {
    Signed best{most, {0, 0, 1}};
    const bool level = m.arc && std::abs(std::abs(dot(m.normal, m.axis)) - 1) < 1e-12 &&
                       std::abs(dot(m.to - m.from, m.normal)) < 1e-12;
    for (const Body& body : tools_[m.tool]) {
        if (level) {
            const Signed s = from_standing(body, m.axis, p - at(m, nearest_on_circle(m, p)));
            if (s.d < best.d) best = s;
        } else if (m.arc) {
            along_arc(body, m, 0, 1, p, best);
        } else if (const Signed s = along_line(body, m.axis, m.from, m.to, p); s.d < best.d) {
            best = s;
        }
    }
    return best;
}

Signed Solid::constraint(std::size_t i, V p) const {
    if (i == 0) return stock(p);
    const Signed s = swept(moves_[i - 1], p);
    return {-s.d, -1.0 * s.out};
}

double Solid::value(V p) const {
    const double beside = stock(p).d;
    if (beside > 1) return beside;  // far outside it does not matter what was cut
    double nearest = 1e300;
    for (const bool arcs : {false, true})  // what is quickly known first
        for (const Move& m : moves_)
            if (m.arc == arcs && m.box.distance(p) < nearest) nearest = std::min(nearest, swept(m, p, nearest).d);
    return std::max(beside, -nearest);
}

std::size_t Solid::foremost(V p) const {
    double most = stock(p).d;
    std::size_t which = 0;
    for (std::size_t i = 0; i < moves_.size(); ++i)
        if (-moves_[i].box.distance(p) > most || moves_[i].box.distance(p) == 0)
            if (const double d = -swept(moves_[i], p).d; d > most) most = d, which = i + 1;
    return which;
}

std::vector<std::size_t> Solid::near(V p, double reach) const {
    std::vector<std::pair<double, std::size_t>> found;
    if (const double d = std::abs(stock(p).d); d < reach) found.emplace_back(d, 0);
    for (std::size_t i = 0; i < moves_.size(); ++i) {
        if (moves_[i].box.distance(p) > reach) continue;
        if (const double d = std::abs(swept(moves_[i], p).d); d < reach) found.emplace_back(d, i + 1);
    }
    std::sort(found.begin(), found.end());
    std::vector<std::size_t> out;
    for (const auto& f : found) out.push_back(f.second);
    return out;
}

}  // namespace exact
