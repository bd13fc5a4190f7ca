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

/// What a call may leave out: nothing where it is not written; NaN: it is, and not known.
using Said = std::optional<double>;

/// What a value must be beyond finite and known; else it is complained of.
enum class Must : std::uint8_t {
    be_known,
    be_at_least_0,
    be_above_0,
    be_other_than_0,
    be_feed,       ///< mm/min, above 0; infinity is rapid traverse (pre-positioning and retraction only)
    be_feed_or_0,  ///< as above; 0 is as if it were not written
    go_down,       ///< a depth: not above 0
    go_deep,       ///< a depth: not above 0; where it is 0 the control does not execute the cycle
    be_asked_for,  ///< nothing: another value makes it matter, and the cycle asks for it then
};

/// One expansion in the making. A parameter that is missing, out of its range or not known is complained of once; the
/// family asks `ready()` before it makes the first step.
class Course {
public:
    Course(const Demand& demand, const Situation& situation);
    /// `anywhere`: the cycle goes to its place by itself, where it comes from need not be known.
    Course(const Demand& demand, const Situation& situation, bool anywhere);

    // Parameters.
    /// The value; below `least` it is a fault.
    double not_below(Role role, double value, double least);
    /// What is written for a role as it must be; not written is a fault.
    double taken(Role role, const Said& written, Must must);
    /// Must be written, finite and known.
    double need(Role role);
    /// Not written: `otherwise`; written, it must be finite and known.
    double maybe(Role role, double otherwise);
    /// Not written: `otherwise`; written, one of the whole numbers from `least` to `most`. `what` names it in the
    /// message.
    int whole(Role role, int otherwise, int least, int most, const char* what);
    /// The same of what was read.
    int whole(Role role, const Said& said, int otherwise, int least, int most, const char* what);
    double at_least(Role role, double least);  ///< need, and not below
    double positive(Role role);                ///< need, and above 0
    /// A size whose sign only says that it goes down: not 0; the sign is left out.
    double step(Role role);
    double maybe_at_least(Role role, double least, double otherwise);
    /// Feed in mm/min, above 0; infinity is rapid traverse (pre-positioning and retraction only).
    double feed(Role role);
    /// 0 and not written: `otherwise`.
    double feed_or(Role role, double otherwise);
    /// 0 and not said: the feed programmed last, which must be known.
    double feed_in_force_or(const Said& said, Role role, double programmed);
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

/// Expands the kinds that a room's door sends it.
using Family = void (*)(Course&, const Demand&, const Situation&);
/// What the family makes of the demand; without a family it is not simulated. `anywhere` as of Course.
[[nodiscard]] Expansion expand_by(Family family, const Demand& demand, const Situation& situation, bool anywhere);

}  // namespace obrys::cycles
