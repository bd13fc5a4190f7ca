#include "check/touching/touch.hpp"

#include <algorithm>
#include <cmath>

namespace obrys::check {

using geom::Vec2;
using geom::Vec3;

namespace {

constexpr int stops = 4;         ///< pieces of a way between places
constexpr int directions = 8;    ///< about the axis, from the way's own on
constexpr double inside = 1e-9;  ///< mm
constexpr double noise = 1e-6;   ///< of a way along the axis, seen along it

double radius_at(const std::vector<Vec2>& profile, double height) {
    for (std::size_t i = 1; i < profile.size(); ++i) {
        const Vec2 low = profile[i - 1], high = profile[i];
        if (height < low.y || height > high.y) continue;
        const double rise = high.y - low.y;
        return rise > 0 ? low.x + (high.x - low.x) * (height - low.y) / rise : std::max(low.x, high.x);
    }
    return 0;
}

class Look {
public:
    Look(Cleared& left, const Touching& body) : left_(left), body_(body) {
        const sim::milling::Orientation frame = sim::milling::orientation_of(body.axis);
        across_ = frame.x;
    }
    void all_along() {
        for (int i = 0; i <= stops; ++i) {
            const double t = static_cast<double>(i) / stops;
            const Vec3 tip = geom::point_at(body_.path, t);
            const Vec3 beside = geom::point_at(body_.path, i < stops ? t + 1e-3 : t - 1e-3) - tip;
            const Vec3 flat = beside - geom::dot(beside, body_.axis) * body_.axis;
            const double size = geom::length(flat);
            about(tip, size > noise * geom::length(beside) ? (1 / size) * flat : across_);
        }
    }
    [[nodiscard]] Touched found() const { return best_; }

private:
    void about(Vec3 tip, Vec3 ahead) {
        const Vec3 left = geom::cross(body_.axis, ahead);
        const double up = geom::dot(tip, body_.axis);
        for (const std::vector<Vec2>& profile : body_.profiles) {
            const double low = std::max(profile.front().y, body_.heights.low - up);
            const double high = std::min(profile.back().y, body_.heights.high - up);
            if (!(low <= high)) continue;
            for (const double height : {low + inside, 0.5 * (low + high), high - inside}) {
                const double r = radius_at(profile, height);
                const Vec3 middle = tip + height * body_.axis;
                look(middle);
                for (int k = 0; k < directions; ++k) {
                    const double a = 2 * geom::pi * k / directions;
                    look(middle + (r * std::cos(a)) * ahead + (r * std::sin(a)) * left);
                }
            }
        }
    }
    void look(Vec3 p) {
        if (best_.depth >= body_.enough) return;
        const double depth = left_.depth_at(p, body_.enough);
        if (depth > best_.depth) best_ = {depth, p};
    }

    Cleared& left_;
    const Touching& body_;
    Vec3 across_;
    Touched best_;
};

}  // namespace

Touched touch(Cleared& left, const Touching& body) {
    Look look(left, body);
    look.all_along();
    return look.found();
}

}  // namespace obrys::check
