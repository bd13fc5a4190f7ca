/// Ways onto a contour and off it (APPR, DEP, G147).

#include "write/writer.hpp"

namespace obrys::write {

void Writer::take_lead(const cl::Record& record, const cl::LeadBegin& lead) {
    const auto first = static_cast<std::size_t>(lead.onto ? Command::onto_tangent_line : Command::off_tangent_line);
    const auto command = static_cast<Command>(first + static_cast<std::size_t>(lead.kind));
    flush_held();
    const geom::Vec3 from = cursor_.position().here();
    static_cast<void>(cursor_.take(record));
    if (!post_.has(command)) return write_path_of_lead(lead, from);
    write_state();
    const geom::Vec3 at = frames_.programmed(lead.at);
    values_.clear();
    if (!std::isnan(at.x)) values_.set(Value::x, at.x);
    if (!std::isnan(at.y)) values_.set(Value::y, at.y);
    if (!std::isnan(at.z)) values_.set(Value::z, at.z);
    if (lead.length != 0) values_.set(Value::size, lead.length);
    if (lead.radius != 0) values_.set(Value::radius, lead.radius);
    if (lead.angle != 0) values_.set(Value::sweep, geom::degrees(lead.angle));
    if (lead.feed != 0) values_.set(Value::own_feed, lead.feed);
    lead_ = Lead{command, lead.onto, lead.rapid, values_};
    if (!lead.onto) print_lead();
    folding_ = 1;
}

/// Compensation that began or ended on such a way would offset what is the tool's path already: onto a contour that
/// path is written up to its end, without compensation; off it compensation ends where the tool stands.
void Writer::write_path_of_lead(const cl::LeadBegin& lead, const geom::Vec3& from) {
    note(Fate::expanded, lead.onto ? "a way onto a contour, with the contour behind it," : "a way off a contour");
    plain_ = lead.onto;
    if (lead.onto || compensation_ != Command::compensation_off) return;
    write_state();
    write_line(from, false);
    compensation_.reset();
}

/// Onto a contour it waits for its end: its records say on which side.
void Writer::print_lead() {
    const Lead lead = *std::exchange(lead_, std::nullopt);
    values_ = lead.values;
    compensation_.reset();
    if (const auto& c = cursor_.state().compensation; c && lead.onto) compensation_ = compensation_of(*c);
    is_compensating_ = lead.onto && compensation_;
    constexpr std::string_view what = "a way onto a contour or off it";
    const std::uint64_t line = layout_.next();
    const Parts parts = parts_of(lead.rapid, nullptr);
    // A way with a feed of its own: where that is no word beside the one of the contour, the way says it, and what
    // follows says the contour's again.
    const ValueIndex own = index_of(Value::own_feed);
    if (values_.has(own) && !says(post_[lead.command], own)) values_.set(Value::feed, values_.number(own));
    const Printed printed = put(lead.command, parts, what);
    if (printed == Printed::all || printed == Printed::nothing)
        note(Fate::mapped, lead.onto ? "a way onto a contour" : "a way off a contour", line);
    else if (printed == Printed::failed)
        note(Fate::lost, "a way onto a contour or off it: a word cannot hold " + printer_.failed_word());
    compensation_.reset();
    if (!lead.onto) printer_.force(post_[Command::compensation_off]);
}

}  // namespace obrys::write
