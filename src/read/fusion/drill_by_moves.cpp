/// Holes that no canned cycle says: written as moves. The tool stands over the hole at the clearance.
/// Sources: Autodesk's published posts for HEIDENHAIN controls, which write guided deep drilling as cycle 241.

#include <algorithm>

#include "read/fusion/state.hpp"

namespace obrys::read::fusion {

using geom::Vec3;
using program::Code;
using program::Modal;

namespace {

/// Moves over one hole.
class Drill {
public:
    Drill(State& s, const Cycle& c, const Vec3& bottom)
        : s_(s), c_(c), where_(place_of(s.line)), bottom_(bottom), up_(s.at ? s.at->z - c.get("clearance") : 0) {}

    /// A height of the cycle in the tree's frame.
    [[nodiscard]] double height(std::string_view name) const { return c_.get(name) + up_; }
    void rapid(double z) { run_straight(s_, where_, {bottom_.x, bottom_.y, z}, true); }
    void feed(double z, double feed) {
        begin_block(s_, where_);
        tell_feed(s_, where_, feed);
        s_.build.modal(Modal::linear, where_.begin, where_.end);
        s_.build.literal(Code::z, z, where_.begin, where_.end);
        end_block(s_, where_);
        s_.at = Vec3{bottom_.x, bottom_.y, z};
    }
    void turn(double speed) { tell_spindle(s_, where_, speed, s_.tool->clockwise); }
    void dwell() {
        if (!(c_.get("dwell") > 0)) return;
        begin_block(s_, where_);
        s_.build.modal(Modal::dwell, where_.begin, where_.end);
        s_.build.literal(Code::p, c_.get("dwell"), where_.begin, where_.end);
        end_block(s_, where_);
    }

private:
    State& s_;
    const Cycle& c_;
    Place where_;
    Vec3 bottom_;
    double up_;
};

}  // namespace

void run_break_through(State& s, const Cycle& c, const Vec3& bottom) {
    Drill d(s, c, bottom);
    const double retract = d.height("retract"), clearance = d.height("clearance");
    assume(s, place_of(s.line),
           "feed and speed of breaking through are taken to begin breakThroughDistance above the bottom");
    d.rapid(retract);
    const double feed = c.get("feedrate"), slow = c.get("breakThroughFeedrate", feed), speed = s.tool->speed;
    d.feed(std::clamp(bottom.z + c.get("breakThroughDistance"), bottom.z, retract), feed);
    if (c.get("breakThroughSpindleSpeed") > 0) d.turn(c.get("breakThroughSpindleSpeed"));
    d.feed(bottom.z, slow > 0 ? slow : feed);
    d.dwell();
    d.rapid(clearance);
    d.turn(speed);
}

void run_guided(State& s, const Cycle& c, const Vec3& bottom) {
    Drill d(s, c, bottom);
    const double retract = d.height("retract"), clearance = d.height("clearance"),
                 start = d.height("stock") - c.get("startingDepth");
    const double speed = s.tool->speed, slow = c.get("positioningSpindleSpeed"), feed = c.get("feedrate");
    assume(
        s, place_of(s.line),
        "guided deep drilling is run as HEIDENHAIN's cycle 241, which Autodesk's post writes for it: in at positioning "
        "speed and feed to the starting depth, down at the feed, out at the retract feed to the retract plane");
    if (slow > 0) d.turn(slow);
    d.rapid(retract);
    d.feed(std::clamp(start, bottom.z, retract),
           c.get("positioningFeedrate") > 0 ? c.get("positioningFeedrate") : feed);
    d.turn(speed);
    d.feed(bottom.z, feed);
    d.dwell();
    if (slow > 0) d.turn(slow);
    d.feed(retract, c.get("retractFeedrate") > 0 ? c.get("retractFeedrate") : feed);
    d.rapid(clearance);
    d.turn(speed);
}

void run_feed_out(State& s, const Cycle& c, const Vec3& bottom) {
    Drill d(s, c, bottom);
    const double retract = d.height("retract"), clearance = d.height("clearance");
    d.rapid(retract);
    d.feed(bottom.z, c.get("feedrate"));
    d.dwell();
    d.feed(retract, c.get("retractFeedrate") > 0 ? c.get("retractFeedrate") : c.get("feedrate"));
    d.rapid(clearance);
}

}  // namespace obrys::read::fusion
