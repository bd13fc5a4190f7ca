#include "cycles/course.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/number.hpp"
#include "base/whole.hpp"
#include "cycles/names.hpp"

namespace obrys::cycles {

namespace {

constexpr double no_length = 1e-9;  ///< mm; a shorter move is none

/// False where a coordinate is not known (geom::length may overlook a NaN).
bool same_place(geom::Vec3 a, geom::Vec3 b) {
    return std::abs(a.x - b.x) <= no_length && std::abs(a.y - b.y) <= no_length && std::abs(a.z - b.z) <= no_length;
}

/// Feeds that may be rapid traverse (FMAX).
bool may_be_rapid(cl::CycleRole role) {
    return role == cl::CycleRole::feed_position || role == cl::CycleRole::feed_retract;
}
}  // namespace

Course::Course(const Demand& demand, const Situation& situation) : Course(demand, situation, false) {}

Course::Course(const Demand& demand, const Situation& situation, bool anywhere) : demand_(demand), at_(situation.at) {
    if (!anywhere) known(at_.x + at_.y, "the tool's position in the working plane");
    if (anywhere && std::isinf(at_.x + at_.y + at_.z)) not_simulated("the tool's position is not known");
}

double Course::checked(Role role, double value) {
    if (std::isnan(value)) {
        not_simulated(std::string(name(role)) + " is not known");
        out_.complaints.back().role = role;
    } else if (std::abs(value) > largest_input) {
        fault(role, std::string(name(role)) + " is out of range");
        return unknown;
    }
    return value;
}

double Course::taken(Role role, const Said& written, Must must) {
    if (must == Must::be_asked_for) return written.value_or(unknown);
    const bool is_feed = must == Must::be_feed || must == Must::be_feed_or_0;
    if (is_feed && written && may_be_rapid(role) && std::isinf(*written) && *written > 0) return *written;
    if (!written) fault(role, std::string(name(role)) + " is not given");
    const double value = written ? checked(role, *written) : unknown;
    switch (must) {
        case Must::be_known:
        case Must::be_asked_for: break;
        case Must::be_at_least_0:
            if (value < 0) fault(role, std::string(name(role)) + " must not be below 0");
            break;
        case Must::be_above_0:
            if (value <= 0) fault(role, std::string(name(role)) + " must be greater than 0");
            break;
        case Must::be_other_than_0:
            if (value == 0) fault(role, "the " + std::string(name(role)) + " must not be 0");
            break;
        case Must::be_feed:
        case Must::be_feed_or_0:
            if (value < 0 || (value == 0 && must == Must::be_feed))
                fault(role, "Feed rate is missing: " + std::string(name(role)) + " must be greater than 0");
            break;
        case Must::go_down:
        case Must::go_deep:
            if (value > 0)
                fault(role, "Enter depth as a negative value", "a depth is measured downwards from the surface");
            if (value == 0 && must == Must::go_deep) not_executed(role);
            break;
    }
    return value;
}

double Course::need(Role role) { return taken(role, demand_.find(role), Must::be_known); }

double Course::maybe(Role role, double otherwise) {
    const auto value = demand_.find(role);
    return value ? checked(role, *value) : otherwise;
}

int Course::whole(Role role, int otherwise, int least, int most, const char* what) {
    return whole(role, maybe(role, otherwise), otherwise, least, most, what);
}

int Course::whole(Role role, const Said& said, int otherwise, int least, int most, const char* what) {
    const double value = said.value_or(otherwise);
    if (const auto n = base::whole<int>(value, least, most)) return *n;
    if (!std::isnan(value))
        fault(role, std::string(what) + " must be a whole number from " + std::to_string(least) + " to " +
                        std::to_string(most));
    return least;
}

double Course::at_least(Role role, double least) { return not_below(role, need(role), least); }

double Course::not_below(Role role, double value, double least) {
    if (value < least) fault(role, std::string(name(role)) + " must not be below " + base::shortest(least));
    return value;
}

double Course::positive(Role role) { return taken(role, demand_.find(role), Must::be_above_0); }

double Course::step(Role role) {
    const double value = need(role);
    if (value == 0) fault(role, std::string(name(role)) + " must not be 0");
    return std::abs(value);
}

double Course::maybe_at_least(Role role, double least, double otherwise) {
    return demand_.find(role) ? at_least(role, least) : otherwise;
}

double Course::feed(Role role) {
    const auto value = demand_.find(role);
    if (value && may_be_rapid(role) && std::isinf(*value) && *value > 0) return *value;
    const double f = need(role);
    if (f <= 0) fault(role, "Feed rate is missing: " + std::string(name(role)) + " must be greater than 0");
    return f;
}

double Course::feed_or(Role role, double otherwise) {
    const auto value = demand_.find(role);
    return !value || *value == 0 ? otherwise : feed(role);
}

double Course::feed_in_force_or(const Said& said, Role role, double programmed) {
    if (said && *said != 0) return *said;
    if (known(programmed, "the feed rate") <= 0) fault(role, "Feed rate is missing", "program a feed rate F");
    return programmed;
}

double Course::depth(Role role) {
    const double value = need(role);
    if (value > 0) fault(role, "Enter depth as a negative value", "a depth is measured downwards from the surface");
    if (value == 0) not_executed(role);
    return value;
}

double Course::known(double value, const std::string& what) {
    if (!std::isfinite(value)) not_simulated(what + " is not known");
    return value;
}

double Course::tool_radius(const Situation& situation) {
    const double radius = known(situation.tool_radius, "the tool radius");
    if (radius < 0 || radius > largest_input) fault("the tool radius is out of range");
    return radius;
}

double Course::spindle_speed(const Situation& situation) {
    const double speed = known(situation.spindle_speed, "the spindle speed");
    if (speed < 0 || speed > largest_input) fault("the spindle speed is out of range");
    return speed;
}

void Course::fault(Role role, std::string text, std::string remedy) {
    out_.complaints.push_back({true, std::move(text), std::move(remedy), role});
    ready_ = false;
}

void Course::fault(std::string text, std::string remedy) {
    out_.complaints.push_back({true, std::move(text), std::move(remedy), std::nullopt});
    ready_ = false;
}

void Course::fault_at(std::size_t element, std::string text, std::string remedy) {
    out_.complaints.push_back({true, std::move(text), std::move(remedy), std::nullopt, element});
    ready_ = false;
}

void Course::not_executed(Role role) {
    skipped_ = Complaint{false, std::string(name(role)) + " is 0: the cycle is not executed", {}, role};
    ready_ = false;
}

void Course::remark(Role role, std::string text) { out_.complaints.push_back({false, std::move(text), {}, role}); }

void Course::doubt(Role role, std::string text, std::string remedy) {
    out_.complaints.push_back({false, std::move(text), std::move(remedy), role});
    out_.complaints.back().doubtful = true;
}

void Course::remark(std::string text, std::string remedy) {
    out_.complaints.push_back({false, std::move(text), std::move(remedy), std::nullopt});
}

void Course::not_simulated(std::string text, std::string remedy) {
    out_.complaints.push_back({false, std::move(text), std::move(remedy), std::nullopt});
    out_.simulated = false;
    ready_ = false;
}

bool Course::room() {
    if (full_) return false;
    if (out_.steps.size() < most_steps) return true;
    full_ = true;
    fault("the cycle takes more than " + base::shortest(double(most_steps)) + " steps", "enter larger infeeds");
    out_.complaints.back().too_many = true;
    return false;
}

void Course::add(cl::Step step) {
    if (room()) out_.steps.push_back(std::move(step));
}

void Course::set_feed(double value) {
    if (value == feed_) return;
    feed_ = value;
    add(cl::Feed{value, cl::FeedMode::per_minute});
}

void Course::rapid(geom::Vec3 to) {
    if (same_place(at_, to)) return;
    add(cl::Linear{.to = to, .rapid = true});
    at_ = to;
}

void Course::move(geom::Vec3 to, double feed) {
    if (std::isinf(feed)) return rapid(to);
    if (same_place(at_, to)) return;
    set_feed(feed);
    add(cl::Linear{.to = to, .rapid = false});
    at_ = to;
}

void Course::straight(geom::Vec3 to, bool rapid) {
    add(cl::Linear{.to = to, .rapid = rapid});
    at_ = to;
}

void Course::arc(geom::Vec2 centre, double sweep, double w, double feed) {
    const geom::Vec2 from = geom::Vec2{at_.x, at_.y} - centre;
    const double c = std::cos(sweep), s = std::sin(sweep);
    geom::Vec2 to = centre + geom::Vec2{c * from.x - s * from.y, s * from.x + c * from.y};
    const double turns = sweep / (2 * geom::pi);
    if (std::round(turns) != 0 && std::abs(turns - std::round(turns)) < 1e-12)
        to = {at_.x, at_.y};  // a full turn ends where it began
    set_feed(feed);
    add(cl::Arc{.to = {to.x, to.y, w}, .centre = {centre.x, centre.y, w}, .normal = {0, 0, 1}, .sweep = sweep});
    at_ = {to.x, to.y, w};
}

void Course::dwell(double seconds) {
    if (seconds > 0) add(cl::Dwell{.seconds = seconds});
}

void Course::spindle(double speed, int direction) {
    add(cl::Spindle{.speed = speed, .direction = static_cast<std::int8_t>(direction)});
}

void Course::thread_w(double w, double pitch, bool rigid) {
    if (std::abs(w - at_.z) <= no_length) return;
    at_.z = w;
    add(cl::Thread{.to = at_, .pitch = pitch, .rigid_tap = rigid});
}

Expansion Course::finish() {
    if (skipped_) {
        Expansion nothing;
        nothing.complaints.push_back(*skipped_);
        return nothing;
    }
    if (!out_.ok()) out_.steps.clear();
    return std::move(out_);
}

Expansion expand_by(Family family, const Demand& demand, const Situation& situation, bool anywhere) {
    if (family == nullptr) {
        Expansion e;
        e.simulated = false;
        e.complaints.push_back({false, "this cycle is not simulated", {}, std::nullopt});
        return e;
    }
    Course course(demand, situation, anywhere);
    family(course, demand, situation);
    return course.finish();
}

}  // namespace obrys::cycles
