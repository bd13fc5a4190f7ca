#pragma once
/// How long a machine takes for a stream: the path is divided at places where it stands, and between them a profile is
/// laid under it (profile.hpp). Memory does not grow with the path: a long one is planned in pieces.

#include <cmath>
#include <optional>
#include <vector>

#include "motion/cursor.hpp"
#include "sim/time/dynamics.hpp"
#include "sim/time/ledger.hpp"
#include "sim/time/profile.hpp"
#include "sim/time/speed_curve.hpp"
#include "sim/time/times.hpp"
#include "sim/time/tolerance_use.hpp"

namespace obrys::sim::time {

/// What is kept besides the sums.
struct TimerOptions {
    std::size_t places = 0;                     ///< so many of the slowest ones at least; 0: all
    std::size_t samples = 0;                    ///< of speed over time; 0: none
    std::optional<double> contour_tolerance{};  ///< mm: in the place of what the program says
};

class Timer {
public:
    /// `tools` outlives the timer.
    Timer(std::span<const shop::Tool> tools, Dynamics dynamics, const TimerOptions& options = {});
    void take(const cl::Record& record);
    /// Behind the last record; to be called once.
    [[nodiscard]] Times finish();
    /// Behind `finish`, where samples were asked for.
    [[nodiscard]] const SpeedCurve& curve() const { return curve_; }
    [[nodiscard]] const std::vector<ToleranceUse>& tolerances() const { return tolerances_; }

private:
    /// A block of the path that waits for its profile.
    struct Piece {
        Place place;
        std::uint32_t tool = 0;
        double fed = 0;  ///< mm/s as programmed, or rapid
        Cause asked = Cause::feed, most = Cause::feed, end = Cause::feed;
        geom::Vec3 leaves{NAN, NAN, NAN};  ///< direction at its end
        double sharpness = 0;              ///< mm: its length as a neighbour of a corner
    };

    /// Of the additional axes that a move takes along: what each can, and how far it goes.
    struct Turns {
        std::vector<std::pair<const AxisLimits*, double>> ways;
        bool begins_nowhere = false;  ///< where one of them stood nobody knows
        bool unknown = false;         ///< where one goes nobody knows, or how fast
    };

    void take_move(const motion::Step& step);
    [[nodiscard]] Turns turns_of(const motion::Step& step) const;
    void take_turn(const motion::Step& step, const Turns& turns);
    /// Each axis at its own rapid; false where the machine does not go so, or this is no such move.
    bool take_dog_leg(const motion::Step& step, const Turns& turns);
    /// Waits until the spindle has followed a cutting speed that is held to where the next cut begins.
    void await_spindle(const motion::Step& step);
    void take_m_function(const base::Span& from);
    /// How far the control may leave a corner, and how the lines lie beside that.
    [[nodiscard]] double tolerance_at(const motion::Step& step) const;
    [[nodiscard]] bool is_exact(const motion::Step& step) const;
    ToleranceUse& use_of(double tolerance, const motion::Step& step);
    void add(const motion::Step& step, double length, const geom::Vec3& from, const geom::Vec3& to, double curvature,
             const Turns& turns);
    void join(const geom::Vec3& direction, double length, const motion::Step& step);
    void spend(const Piece& piece, Cause cause, double seconds);
    void spend(const base::Span& from, Cause cause, double seconds);
    void untimed(const motion::Step& step);
    void from_nowhere();
    void take_spindle(const cl::Record& record, const cl::Spindle& spindle);
    /// Plans what waits; the machine stands at its end, for this cause.
    void stop(Cause why);
    /// The control may only be so fast that it can stand at the end of what it knows.
    void look_ahead();
    /// Plans what waits and spends the time up to a place well before the end of it, where it goes on.
    void plan_piece();
    void plan_half(const Profile& whole);
    /// Looks whether there is enough to plan a piece.
    void wait(const Block& block);
    void draw(const Span& span, double from, double seconds, const Place& place);
    void spend_blocks(const Profile& profile, std::size_t spans);
    /// At an exact stop behind motion as fast as this: until the axes stand in their window.
    void settle(const Piece& piece, double speed);
    /// The first `count` blocks are done.
    void drop(std::size_t count);
    [[nodiscard]] Cause cause_at(std::uint32_t place, const Block& block) const;

    Dynamics dynamics_;
    motion::Cursor cursor_;
    Times times_;
    std::vector<Block> blocks_;
    std::vector<Piece> pieces_;
    std::vector<BlockTime> block_times_;
    struct Waiting {
        double way = 0, speed = 0;  ///< mm, the fastest
        Limits least{INFINITY, INFINITY};
        std::size_t next = 0;  ///< blocks, with fewer than these no piece is planned
    } waiting_;
    Seconds* tool_ = nullptr;  ///< of the tool that was spent for last
    std::uint32_t tool_number_ = 0;
    Ledger ledger_;
    SpeedCurve curve_;
    std::vector<ToleranceUse> tolerances_;
    std::size_t use_ = 0;  ///< of them, the one in force
    TimerOptions options_;
    double begin_ = 0;                 ///< mm/s at the begin of the first block that waits
    Cause began_ = Cause::exact_stop;  ///< why it is no faster
    double spindle_ = 0;               ///< 1/min, with its sense
    double rapid_seconds_ = 0;         ///< since the last move at feed: the spindle has had so long to follow
    Place strobed_{UINT32_MAX, 0};     ///< whose M functions have been paid for
    bool last_rapid_ = false, begun_ = false;
};

/// 1/mm, of an arc; 0: it is straight, or no move.
[[nodiscard]] double curvature_of(const cl::Step& step, double length);

}  // namespace obrys::sim::time
