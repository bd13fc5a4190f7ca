#pragma once
/// What every family of cycles uses: reads the parameters of a demand, complains, and writes the steps of the tool.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "cycles/cycle.hpp"

namespace obrys::cycles {

using Kind = cl::CycleKind;
using Role = cl::CycleRole;

inline constexpr double largest_input = 1e7;        ///< beyond every control's input range
inline constexpr double most_helix_turns = 10'000;  ///< of one helix; more are a complaint

/// One expansion in the making. A parameter that is missing, out of its range or not known is complained of once; the
/// family asks `ready()` before it makes the first step.
class Course {
public:
    Course(const Demand& demand, const Situation& situation);
    /// `anywhere`: the cycle goes to its place by itself, where it comes from need not be known.
    Course(const Demand& demand, const Situation& situation, bool anywhere);

    // Parameters.
    /// Must be written, finite and known.
    double need(Role role);
    /// Not written: `otherwise`; written, it must be finite and known.
    double maybe(Role role, double otherwise);
    /// Not written: `otherwise`; written, one of the whole numbers from `least` to `most`. `what` names it in the
    /// message.
    int whole(Role role, int otherwise, int least, int most, const char* what);
    double at_least(Role role, double least);  ///< need, and not below
    double positive(Role role);                ///< need, and above 0
    /// A size whose sign only says that it goes down: not 0; the sign is left out.
    double step(Role role);
    double maybe_at_least(Role role, double least, double otherwise);
    /// Feed in mm/min, above 0; infinity is rapid traverse (pre-positioning and retraction only).
    double feed(Role role);
    /// 0 and not written: `otherwise`.
    double feed_or(Role role, double otherwise);
    /// 0 and not written: the feed programmed last, which must be known.
    double feed_or_programmed(Role role, double programmed);
    /// `need` for the depth: positive is a complaint; 0 is one that is not fatal and makes `ready` false: the control
    /// does not execute the cycle.
    double depth(Role role = Role::depth);
    /// Something of the situation; NaN is complained of as `what`.
    double known(double value, const std::string& what);
    double tool_radius(const Situation& situation);    ///< not negative
    double spindle_speed(const Situation& situation);  ///< not negative

    void fault(Role role, std::string text, std::string remedy = {});
    void fault(std::string text, std::string remedy = {});
    /// Of an element of the contour.
    void fault_at(std::size_t element, std::string text, std::string remedy = {});
    /// The control passes over the cycle because this is 0; whatever else is wrong with the call does not matter then.
    void not_executed(Role role);
    /// Something worth saying that changes nothing.
    void remark(Role role, std::string text);
    void remark(std::string text, std::string remedy = {});
    /// The control runs it, and hardly anybody means it so.
    void doubt(Role role, std::string text, std::string remedy);
    void not_simulated(std::string text, std::string remedy = {});
    /// The path is not documented in this point and was chosen: see Expansion::assumption.
    void assume(std::string_view text) { out_.assumption = text; }
    [[nodiscard]] bool ready() const { return ready_; }

    // Steps.
    void rapid(geom::Vec3 to);
    /// At `feed` mm/min; infinity: rapid. A move without length is left out.
    void move(geom::Vec3 to, double feed);
    /// At the feed in force or at rapid traverse; kept also where it has no length.
    void straight(geom::Vec3 to, bool rapid);
    void rapid_w(double w) { rapid({at_.x, at_.y, w}); }
    void move_w(double w, double feed) { move({at_.x, at_.y, w}, feed); }
    /// About a centre in the plane; `sweep` in radians, counter-clockwise positive; ends at height `w`.
    void arc(geom::Vec2 centre, double sweep, double w, double feed);
    void dwell(double seconds);
    void spindle(double speed, int direction);
    void thread_w(double w, double pitch, bool rigid);
    void add(cl::Step step);
    /// The steps so far only lead to the place where the cycle begins.
    void over_place() { out_.leads = out_.steps.size(); }
    /// After a move that was written with `add`.
    void moved_to(geom::Vec3 to) { at_ = to; }
    [[nodiscard]] geom::Vec3 at() const { return at_; }
    /// False once the number of steps is over `most_steps`.
    [[nodiscard]] bool room();

    [[nodiscard]] Expansion finish();

private:
    void set_feed(double value);
    double checked(Role role, double value);

    const Demand& demand_;
    Expansion out_;
    geom::Vec3 at_;
    double feed_ = unknown;
    bool ready_ = true, full_ = false;
    std::optional<Complaint> skipped_;  ///< why the control passes over the cycle
};

/// Heights of a hole, absolute w: what nearly every cycle begins with.
struct Heights {
    double surface = 0, clearance = 0, bottom = 0, end = 0;  ///< end: where the tool stands after the cycle
};
/// From surface, clearance, depth and second clearance; complaints are in the course.
[[nodiscard]] Heights read_heights(Course& course);

/// Expands the kinds that a room's door sends it.
using Family = void (*)(Course&, const Demand&, const Situation&);
/// What the family makes of the demand; without a family it is not simulated. `anywhere` as of Course.
[[nodiscard]] Expansion expand_by(Family family, const Demand& demand, const Situation& situation, bool anywhere);

}  // namespace obrys::cycles
