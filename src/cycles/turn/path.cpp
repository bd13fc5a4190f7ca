#include "cycles/turn/path.hpp"

#include <cmath>

namespace obrys::cycles {

void TurningPath::thread(geom::Vec2 to, double pitch, double start) {
    course_.add(cl::Thread{.to = place(to), .pitch = pitch, .rigid_tap = false, .start = start});
    course_.moved_to(place(to));
}

void TurningPath::arc(geom::Vec2 to, geom::Vec2 centre, int turn) {
    const geom::Vec2 a = at() - centre, b = to - centre;
    double sweep = std::atan2(geom::cross(a, b), geom::dot(a, b));
    if (turn > 0 && sweep <= 0) sweep += 2 * geom::pi;
    if (turn < 0 && sweep >= 0) sweep -= 2 * geom::pi;
    course_.add(cl::Arc{.to = place(to), .centre = place(centre), .normal = {0, 0, 1}, .sweep = sweep});
    course_.moved_to(place(to));
}

void TurningPath::element(const TurningElement& e, geom::Vec2 shift, bool finishing) {
    if (finishing && e.feed) course_.add(*e.feed);
    const geom::Vec2 to = e.to + shift;
    if (e.turn != 0)
        arc(to, e.centre + shift, e.turn);
    else
        e.rapid ? rapid(to) : feed(to);
}

Ends ends_of(Course& c, const Said& target_u, const Said& target_v, const Situation& s) {
    Ends e;
    e.start = {c.known(s.at.x, "the tool's position"), c.known(s.at.y, "the tool's position")};
    e.target = {target_u.value_or(e.start.x), target_v.value_or(e.start.y)};
    return e;
}

double whole_passes(Course& c, Role role, const Said& said, double otherwise) {
    constexpr double most = 10'000;
    const double n = std::floor(said.value_or(otherwise));
    if (n > most) c.fault(role, "the number of passes is too large");
    return n;
}

}  // namespace obrys::cycles
