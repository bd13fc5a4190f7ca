#pragma once
/// What the families of turning cycles share: the tool's moves in (Z, X), and the families.

#include "cycles/course.hpp"
#include "cycles/turn/turning.hpp"

namespace obrys::cycles {

/// Writes steps in the plane of the lathe; w stays as it was.
class TurningPath {
public:
    explicit TurningPath(Course& course) : course_(course) {}
    [[nodiscard]] geom::Vec2 at() const { return {course_.at().x, course_.at().y}; }
    [[nodiscard]] Course& course() { return course_; }

    void rapid(geom::Vec2 to) { course_.straight(place(to), true); }
    void feed(geom::Vec2 to) { course_.straight(place(to), false); }
    /// `start`: degrees of the spindle.
    void thread(geom::Vec2 to, double pitch, double start = 0);
    void arc(geom::Vec2 to, geom::Vec2 centre, int turn);
    /// As the element says, shifted; its feed too where `finishing`.
    void element(const TurningElement& e, geom::Vec2 shift, bool finishing);

private:
    [[nodiscard]] geom::Vec3 place(geom::Vec2 p) const { return {p.x, p.y, course_.at().z}; }
    Course& course_;
};

/// The end of the cut and where the tool stands, which must be known.
struct Ends {
    geom::Vec2 start, target;
};
[[nodiscard]] Ends read_ends(Course& course, const Situation& situation);

void lathe_offset_passes(TurningPath& path, const TurningDemand& demand);
void lathe_rough(TurningPath& path, const TurningDemand& demand);
void lathe_thread(TurningPath& path, const TurningDemand& demand);
void lathe_removal(TurningPath& path, const TurningDemand& demand);
void lathe_simple(TurningPath& path, const TurningDemand& demand);

}  // namespace obrys::cycles
