#include "make/order.hpp"

namespace obrys::make {

Vec2 Placing::on_machine(Vec2 p) const {
    const double u = turned ? -p.x : p.x;
    switch (surface) {
        case Surface::outside: return {u, p.y};
        case Surface::inside: return {u, -p.y};
        case Surface::face: return {p.y, -u};
        case Surface::counter_face: return {-p.y, -u};
    }
    return p;
}

Vec2 Placing::in_groove(Vec2 p) const {
    Vec2 uv = p;
    switch (surface) {
        case Surface::outside: break;
        case Surface::inside: uv = {p.x, -p.y}; break;
        case Surface::face: uv = {-p.y, p.x}; break;
        case Surface::counter_face: uv = {-p.y, -p.x}; break;
    }
    return {turned ? -uv.x : uv.x, uv.y};
}

bool Placing::mirrors() const { return (surface == Surface::inside || surface == Surface::counter_face) != turned; }

double Placing::slope(double drawn) const {
    const bool against = surface == Surface::inside || surface == Surface::face;
    return against != turned ? -drawn : drawn;
}

}  // namespace obrys::make
