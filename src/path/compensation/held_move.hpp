#pragma once
/// Radius compensation by one held move (Method::held_move), as RS-274 interpreters do it. Inside of compensation.hpp;
/// not for callers. What follows was taken from LinuxCNC 2.9's interpreter and its behaviour (rs274):
///   entry   line: to the normal at its end, left or right of it; it must be longer than the radius. Arc: its end as
///   any
///           arc's, and from where the tool stands to there about the point of the end's radius that is equally far
///           from both. A tool with a nose (Setting::tip) is first moved by a line so that its centre runs that arc.
///   corner  by the change of direction at the programmed point: up to `straight_on` none; away from the tool an arc
///   about
///           the point, in rapid two lines; towards it, or by more than half a turn, the held move's end goes to where
///           both paths of the centre cross. Half a turn counts as inner where the tool runs outside of an arc there.
///   moves along w wait in the queue behind the held move, and their point goes along with its end.
///   exit    the held move is settled when the compensation is switched off; the next move, a line in any direction,
///           leads from where the tool stands to its programmed end.
///   refused what the tool cannot reach, and a held line that a moved end turns round (it is looked at only where an
///   end
///           is moved: before an inner corner, an arc put in before a line, and the exit). Nothing more comes out then
///           until the compensation is switched off.
///   A flush (program stop) lets the held move go, too; the move behind it then starts where that one ended, and an
///   inner corner there is cut.

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "path/compensation/held_corner.hpp"
#include "path/compensation/output.hpp"
#include "path/setting.hpp"

namespace obrys::path {

class HeldMove {
public:
    /// A fault is that of the element pushed, and the last one: it ends the program.
    std::vector<Fault> push(Element&& e, const Setting& s, OutputSink out);
    /// Lets the held move go; compensation stays selected.
    std::vector<Fault> flush(OutputSink out);
    std::vector<Fault> switch_off(OutputSink out);
    [[nodiscard]] bool idle() const { return !active_ && !exit_ && !stopped_ && carried_.empty(); }

private:
    struct Queued {
        Queued(Element&& e, Kind kind, bool in_rapid = false, geom::Vec2 way = {})
            : out{std::move(e), kind}, rapid(in_rapid), direction(way), programmed(out.element.sweep) {}

        Output out;
        bool rapid = false;
        geom::Vec2 direction;   ///< of a line, before any end was moved; nothing along w
        double programmed = 0;  ///< sweep of an arc as programmed
    };

    void take(Element&& e, const Setting& s, OutputSink out);
    void pass(Element&& e, OutputSink out);
    void enter_line(Element&& e, const Setting& s);
    void enter_arc(Element&& e, const Setting& s);
    void follow_line(Element&& e, const Setting& s, OutputSink out);
    void follow_arc(Element&& e, const Setting& s, OutputSink out);
    bool move_end(geom::Vec2 to, OutputSink out);
    bool move_end(Queued& q, geom::Vec2 to);
    bool meet(const Meeting& m, OutputSink out);
    void round(Element& e, geom::Vec2 to, bool rapid, OutputSink out);
    void queue(Element&& e, Kind kind, bool rapid, geom::Vec2 direction);
    void release(OutputSink out);
    void emit(Queued& q, OutputSink out);
    void carry(Element& e);
    void emit_events(OutputSink out);
    bool refuse(Refusal why);

    bool active_ = false;   ///< an entry move was taken, and not switched off
    bool exit_ = false;     ///< switched off, the exit move is awaited
    bool stopped_ = false;  ///< refused
    double offset_ = 0;     ///< positive left
    geom::Vec2 tip_;
    HeldMoveLimits limits_;
    double bend_ = 0;               ///< tangent of the least change of direction that is a corner
    std::vector<Queued> queue_;     ///< the held move and what waits behind it
    HeldEnd front_;                 ///< of the held move, also after it has gone
    geom::Vec2 centre_;             ///< of the tool at the end of the newest move, no corner regarded
    geom::Vec2 start_;              ///< where the held move starts …
    bool start_known_ = false;      ///< … if that is looked at
    std::optional<geom::Vec2> at_;  ///< where the tool's moved point stands
    Events carried_;                ///< events that wait for the next output
    std::uint64_t tag_ = 0;         ///< of the newest element
    geom::Vec2 point_;              ///< where that starts
    std::vector<Fault> faults_;
};

}  // namespace obrys::path
