#pragma once
/// How long a machine takes for a stream: the path is divided at places where it stands, and between them a profile is
/// laid under it (profile.hpp). Memory does not grow with the path: a long one is planned in pieces.

#include <cmath>
#include <optional>
#include <vector>

#include "motion/cursor.hpp"
#include "sim/time/dynamics.hpp"
#include "sim/time/profile.hpp"
#include "sim/time/times.hpp"

namespace obrys::sim::time {

class Timer {
public:
    /// `tools` outlives the timer.
    Timer(std::span<const shop::Tool> tools, Dynamics dynamics);
    void take(const cl::Record& record);
    /// Behind the last record; to be called once.
    [[nodiscard]] Times finish();

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
    [[nodiscard]] Turns take_turns(const cl::Step& step);
    void take_turn(const motion::Step& step, const Turns& turns);
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
    void spend_blocks(const Profile& profile, std::size_t spans);
    [[nodiscard]] Cause cause_at(std::uint32_t place, const Block& block) const;

    Dynamics dynamics_;
    motion::Cursor cursor_;
    Times times_;
    std::vector<Block> blocks_;
    std::vector<Piece> pieces_;
    Seconds* tool_ = nullptr;  ///< of the tool that was spent for last
    std::uint32_t tool_number_ = 0;
    std::size_t merged_ = 4096;            ///< how many places were left when they were merged
    double begin_ = 0;                     ///< mm/s at the begin of the first block that waits
    Cause began_ = Cause::exact_stop;      ///< why it is no faster
    double spindle_ = 0;                   ///< 1/min, with its sense
    std::map<std::string, double> stand_;  ///< of additional axes
    bool last_rapid_ = false, begun_ = false;
};

}  // namespace obrys::sim::time
