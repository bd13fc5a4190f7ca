#pragma once
/// What the families of turning cycles share: the tool's moves in (Z, X), and the families.

#include "cycles/turn/contours.hpp"
#include "cycles/turn/cuts.hpp"
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
[[nodiscard]] Ends ends_of(Course& course, const Said& target_u, const Said& target_v, const Situation& situation);
/// The number of passes in a value; far too many are a fault.
[[nodiscard]] double whole_passes(Course& course, Role role, const Said& said, double otherwise);

void write_steps(TurningPath&, const OffsetFinishing&, const TurningDemand&);
void write_steps(TurningPath&, const RoughingAlong&, const TurningDemand&);
void write_steps(TurningPath&, const RoughingAcross&, const TurningDemand&);
void write_steps(TurningPath&, const ContourFinishing&, const TurningDemand&);
void write_steps(TurningPath&, const RemovalAlong&, const TurningDemand&);
void write_steps(TurningPath&, const RemovalAcross&, const TurningDemand&);
void write_steps(TurningPath&, const PatternRepeating&, const TurningDemand&);
void write_steps(TurningPath&, const PecksAlong&, const TurningDemand&);
void write_steps(TurningPath&, const PecksAcross&, const TurningDemand&);
void write_steps(TurningPath&, const BoxAlong&, const TurningDemand&);
void write_steps(TurningPath&, const BoxAcross&, const TurningDemand&);
void write_steps(TurningPath&, const BoxThread&, const TurningDemand&);
void write_steps(TurningPath&, const ThreadPasses&, const TurningDemand&);
void write_steps(TurningPath&, const DegressiveThread&, const TurningDemand&);

}  // namespace obrys::cycles
