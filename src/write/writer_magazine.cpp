/// Tools by their places and offsets, and what a postprocessor refuses to cut with.

#include <cmath>
#include <utility>

#include "base/number.hpp"
#include "write/writer.hpp"

namespace obrys::write {

/// The tool's place in the magazine; false where it has none.
bool Writer::place_tool(const cl::ToolChange& change, const std::string& what) {
    slot_ = nullptr;
    if (!magazine_ || change.number == 0) return true;
    std::string why;
    const MagazineSlot* slot = magazine_->take(change.number, why);
    if (slot == nullptr) {
        note(Fate::lost, what + ": " + why);
        return false;
    }
    slot_ = slot;
    offsets_wait_ = true;
    values_.set(Value::place, slot->place);
    return true;
}

/// Moves along Z say with which offset they go: another one into the material than towards it.
void Writer::set_offsets(bool rapid) {
    if (slot_ == nullptr || !values_.has(index_of(Value::z))) return;
    constexpr double still = 1e-6;  // mm
    if (!std::exchange(offsets_wait_, false) && std::abs(values_.number(index_of(Value::z)) - stands_[2]) <= still)
        return;
    if (rapid)
        values_.set(Value::approach, slot_->approach());
    else
        values_.set(Value::entry, slot_->entry());
}

/// A program whose tools are not said cuts with what is in the spindle.
void Writer::note_cut_without_tool(bool rapid) {
    if (!magazine_ || rapid || slot_ != nullptr || without_tool_noted_) return;
    without_tool_noted_ = true;
    note(Fate::lost, "the tool of a cut, which the program does not say,");
}

void Writer::note_tapping() {
    const cl::Spindle& spindle = cursor_.state().spindle;
    const double most = post_.most_tapping_speed;
    if (most == 0 || spindle.mode != cl::SpindleMode::rpm || !(spindle.speed > most)) return;
    note(Fate::lost, "tapping at " + base::shortest(spindle.speed) + " 1/min, where the post allows " +
                         base::shortest(most) + " 1/min at most,");
}

}  // namespace obrys::write
