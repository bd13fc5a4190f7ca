#pragma once
/// Streams for controls that move one axis at a time: slopes and arcs as staircases along the axes. mm.

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "cl/record.hpp"
#include "motion/cursor.hpp"
#include "write/staircase_form.hpp"
#include "write/walls.hpp"

namespace obrys::write {

/// What has become of slopes and arcs.
struct StaircaseSums {
    std::uint64_t slopes = 0, arcs = 0;
    std::uint64_t rapids = 0;    ///< along several axes: axis by axis
    std::uint64_t moves = 0;     ///< along one axis each, in their place
    std::uint64_t touching = 0;  ///< places at which the tool touches the contour
    double ridge = 0;            ///< highest that is left on a contour whose side is known
    double beside = 0;           ///< farthest from the path, away from the part
    double either = 0;           ///< the same where the side is not known
    double into = 0;   ///< deepest into another part of the contour, where it is narrower than staircases need
    double above = 0;  ///< highest above a path that rises or falls
};

/// For people: what was made of how many, and how far it is off; empty where nothing was.
[[nodiscard]] std::string text_of(const StaircaseSums& sums, const StaircaseForm& form);

/// Takes the stream of a program and hands on one whose moves run along one axis each. Compensation, which acts on
/// slopes and arcs, becomes the tool's path. What cannot be done is said, and its move left out.
class Staircase {
public:
    struct Output {
        std::function<void(const cl::Record&)> record;
        std::function<void(const cl::Record&of, std::string what)> lost, expanded;
    };
    Staircase(const StaircaseForm& form, Output output) : form_(form), output_(std::move(output)) {}

    void take(const cl::Record& record);
    /// What waits for the end of a contour is handed on.
    void finish();
    [[nodiscard]] const StaircaseSums& sums() const { return sums_; }
    /// Along which axes the move goes that is being handed on: the others need no word. Nothing: nobody knows.
    [[nodiscard]] const std::optional<std::array<bool, 3>>& said() const { return said_; }

private:
    /// On which side of its path the tool is, along the move: the part is on the other one.
    struct Side {
        bool known = false, left = false;
        double diameter = 0;  ///< of the tool
    };

    /// A slope or an arc by a parameter from 0 to 1, in the plane.
    struct Way {
        std::function<geom::Vec3(double)> at;
        std::function<geom::Vec2(geom::Vec2, geom::Vec2)> corner;          ///< between two of its places
        std::function<double(geom::Vec2, geom::Vec2, geom::Vec2)> beside;  ///< how far a way by a corner lies off
        bool touches = false;
    };

    void run(const cl::Record& record);
    void watch_contour();
    void add_wall(Walls& walls, const cl::Record& move, const geom::Vec3& from, const Side& on) const;
    void step(const Way& way, double from, double to, int halved = 0);
    void take_event(const cl::Record& record);
    void take_move(const cl::Record& record);
    void take_line(const cl::Record& record, const cl::Linear& line, const geom::Vec3& from);
    void take_arc(const cl::Arc& as_it_is, const geom::Vec3& begin);
    void slope(const geom::Vec3& from, const geom::Vec3& to, const Side& side);
    [[nodiscard]] bool level_arc(const cl::Arc& arc, const geom::Vec3& from, double radius);
    [[nodiscard]] bool standing_arc(const cl::Arc& arc, const geom::Vec3& from, double radius);
    void begin_stairs(std::uint64_t& counter);
    [[nodiscard]] bool may_run(double steps);
    [[nodiscard]] static bool acts(const cl::CompensationBegin& c) { return std::abs(c.normal.z) > 0.5; }
    [[nodiscard]] Side side_of(const cl::CompensationBegin& c) const;
    [[nodiscard]] Side side() const;
    void lose(const std::string& what);
    void lose_axes();

    // The way of the output, axis by axis, on places that the words of the control hold.
    [[nodiscard]] double held(double coordinate) const;
    void pass(const cl::Record& record);
    void go(std::size_t axis, double to);
    void legs(const geom::Vec3& to, const geom::Vec2& corner);
    void rapid_legs(const geom::Vec3& to);
    void say_height();
    void leave_known(const cl::Record& record, const std::optional<cl::Record>& place, const geom::Vec3& to);
    [[nodiscard]] bool forgets(const geom::Vec3& to) const;
    [[nodiscard]] std::array<bool, 3> moving(const geom::Vec3& to) const;

    StaircaseForm form_;
    Output output_;
    motion::Cursor cursor_;
    StaircaseSums sums_;
    const cl::Record* now_ = nullptr;
    std::vector<cl::Record> waiting_;  ///< of a compensated contour, until its end is known
    bool waits_ = false;
    std::optional<Walls> walls_;                    ///< that contour's, while the tool follows it
    std::optional<cl::CompensationBegin> leaving_;  ///< that has ended: the next way leads off its contour
    std::array<double, 3> stands_{NAN, NAN, NAN};   ///< where the output has led the tool
    bool rapid_ = false;                            ///< of the move that is being made
    geom::Vec3 axis_{0, 0, 1};
    std::optional<std::array<bool, 3>> said_;
    bool height_waits_ = false;        ///< the tool is another one, and Z has not been said since
    bool counts_ = false;              ///< moves are those of a slope or an arc
    cl::AxisEnds axes_;                ///< additional axes that the move takes along
    std::optional<cl::Record> place_;  ///< of the machine, to which the next move leads
};

}  // namespace obrys::write
