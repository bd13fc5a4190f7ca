/// Calls and repetitions of the program.

#include <algorithm>

#include "base/text.hpp"
#include "write/writer.hpp"

namespace obrys::write {

namespace {

std::string what_is(const cl::PartBegin& part) {
    const std::string name = part.name.empty() ? "" : " " + base::as_utf8(part.name);
    switch (part.kind) {
        case cl::PartKind::call: return "call of" + (name.empty() ? " a subprogram" : name);
        case cl::PartKind::label: return "call of section" + name;
        case cl::PartKind::repetition: break;
    }
    return "repetition" + (name.empty() ? "" : " of" + name);
}

}  // namespace

void Writer::settle() {
    if (stairs_) stairs_->finish();
    if (taps_) taps_->settle();
    if (stop_waits_) write_stop();
    flush_held();
    static_cast<void>(layout_.next());  // a call that waited for more passes
}

void Writer::take_part(const cl::Record& record) {
    flush_held();
    if (const auto* part = std::get_if<cl::PartBegin>(&record.step))
        open_part(record, *part);
    else if (!parts_.empty())
        close_part();
    static_cast<void>(cursor_.take(record));
}

/// What holds is written before the part, so that its passes begin alike; and in it modes are said again.
void Writer::open_part(const cl::Record& record, const cl::PartBegin& part) {
    const motion::State& s = cursor_.state();
    OpenPart open;
    open.in_layout = s.cycles == 0 && !s.leads && !lead_;
    open.whole = !s.compensation && !compensation_ && axes_.empty() && !place_;
    parts_.push_back(open);
    if (!open.in_layout) return;
    if (layout_.calls() && open.whole) {
        write_state();
        end_cycles();
        series_.defined.clear();
        printer_.forget_modes();
        feed_mode_.reset();
        printer_.keep_standing(true);
    }
    layout_.open(part, {Fate::mapped, what_is(part), record.from, record.stack, 0});
}

void Writer::close_part() {
    const OpenPart part = parts_.back();
    parts_.pop_back();
    if (!part.in_layout) return;
    const bool pending = cursor_.state().compensation || compensation_ || !axes_.empty() || place_;
    if (layout_.calls() && part.whole && !pending) write_state();
    layout_.close(part.whole && !pending);
    keep_standing();
}

/// The program ends within them.
void Writer::spill_parts() {
    layout_.spill();
    while (!parts_.empty()) {
        if (parts_.back().in_layout) layout_.close(false);
        parts_.pop_back();
    }
    keep_standing();
}

/// Passes of a part have the same blocks, whether they move or not.
void Writer::keep_standing() {
    const auto folds = [](const OpenPart& p) { return p.in_layout && p.whole; };
    printer_.keep_standing(layout_.calls() && std::any_of(parts_.begin(), parts_.end(), folds));
}

}  // namespace obrys::write
