/// Lengths and radii of tools: G43 H, G49 and D mean the same there, by words where the control has them and by the
/// tool where it compensates each by its own.

#include <algorithm>
#include <utility>

#include "base/whole.hpp"
#include "rewrite/block_words.hpp"

namespace obrys::rewrite {

using program::Modal;

namespace {

constexpr int most_offsets = 999'999;

/// The number of an offset that the text says; nothing where it is computed.
std::optional<int> number_of(const Text& v) {
    if (!v.number) return std::nullopt;
    return base::whole<int>(*v.number, 0, most_offsets);
}

}  // namespace

/// Programs of the control call a tool together with its length; else they say G43 where they want it.
bool BlockWords::tool_brings_length() const {
    const program::Traits& t = *w_.unit->traits;
    return t.offsets.datum_first == 0 || (w_.input.lathe && t.edge_is_offset_number);
}

/// Coordinates of the machine are those of what holds the tool: of controls of the G43 family whatever length is in
/// force.
bool BlockWords::holder_goes() const {
    const program::Traits& t = *w_.unit->traits;
    return t.offsets.datum_first != 0 || t.machine_words_are_gauge_point;
}

bool BlockWords::says_lengths() const {
    const std::string* on = w_.language.find("words.length-on");
    return on != nullptr && !on->empty();
}

void BlockWords::length_on(int offset) {
    const Places places{{"offset", std::to_string(offset)}, {"tool", std::to_string(w_.tool_in_spindle)}};
    w_.length_waits = filled(*w_.language.find("words.length-on"), places);
}

/// The words of the length, where they may stand in this block; else in one of their own, or further on. What holds the
/// tool goes to a place of the machine: there a length may end, and none begins.
std::string BlockWords::length_here(std::string_view key) {
    const auto is_z = [](const Axis& a) { return a.letter == 'Z'; };
    const auto z = std::find_if(axes_.begin(), axes_.end(), is_z);
    const std::string* form = w_.language.find(key);
    const std::string* off = w_.language.find("words.length-off");
    const bool beside = form != nullptr && form->find("{length}") != std::string::npos;
    const bool begins = machine_ && off != nullptr && w_.length_waits != *off;
    if (beside && (z == axes_.end() || begins)) return {};
    if (beside && !z->incremental) return std::exchange(w_.length_waits, {});
    w_.write_length();
    return {};
}

/// Behind a tool that brings its length, where the other control wants a word for that.
void BlockWords::length_of_tool() {
    if (tool_brings_length() && says_lengths() && w_.tool_in_spindle != 0) length_on(w_.tool_in_spindle);
}

/// H alone is another length where one is compensated; else G43 is still to come.
bool BlockWords::changes_length() {
    if (!offset_) return false;
    const int held = w_.held()[Mode::length];
    if (held == several) w_.refuse(w_.here, "whether H changes a length here depends on the way that the run has come");
    if (held == 0) w_.tell(w_.here, "H" + offset_->text + " has no effect before G43");
    return held == 1;
}

void BlockWords::lengths() {
    if (length_off_) {
        w_.length_waits.clear();
        if (w_.language.has("words.length-off"))
            w_.length_waits = *w_.language.find("words.length-off");
        else if (w_.tool_in_spindle != 0)
            w_.tell(w_.here, "G49 has no counterpart there: the length of the tool in the spindle always counts");
        return;
    }
    if (!length_ && !changes_length()) return;
    const std::optional<int> said = offset_ ? number_of(*offset_) : std::nullopt;
    if (offset_ && !said) return w_.refuse(w_.here, "a computed number of an offset is not translated by structure");
    if (!offset_ && w_.unit->traits->offset_numbers_stay)
        return w_.refuse(w_.here, "which length G43 means here depends on the H of blocks before",
                         "write H beside G43");
    const int offset = said.value_or(w_.tool_in_spindle);
    if (says_lengths()) {
        const bool by_number = w_.language.find("words.length-on")->find("{offset}") != std::string::npos;
        if (by_number || offset == w_.tool_in_spindle) return length_on(offset);
    } else if (offset == w_.tool_in_spindle) {
        return;  // it came with the tool
    }
    w_.refuse(w_.here, "the length of another tool than the one in the spindle (H" + std::to_string(offset) +
                           ") is not translated by structure");
}

/// D of this block, or the last one where it holds; nothing after a complaint.
std::optional<int> BlockWords::radius_offset() {
    if (radius_offset_ && !number_of(*radius_offset_)) {
        w_.refuse(w_.here, "a computed number of an offset is not translated by structure");
        return std::nullopt;
    }
    if (radius_offset_) return *number_of(*radius_offset_);
    const int held = w_.held()[Mode::radius];
    if (!w_.unit->traits->offset_numbers_stay || held == nowhere) return w_.tool_in_spindle;
    if (held >= 0) return held;
    w_.refuse(w_.here, "which D is meant here depends on the way that the run has come", "write D beside G41 or G42");
    return std::nullopt;
}

/// D without G41 or G42 is for those behind it; within a contour it is another radius from here on.
void BlockWords::radius_alone() {
    if (!radius_offset_ || compensation_ || w_.held()[Mode::side] == 0) return;
    w_.refuse(w_.here, "another radius within a compensated contour (D) is not translated by structure",
              "end the contour with G40 before it");
}

/// Nothing after a complaint.
std::optional<std::string> BlockWords::compensation_text() {
    if (!compensation_) return "";
    const bool off = *compensation_ == Modal::compensation_off;
    const std::string_view key = *compensation_ == Modal::compensation_left ? "words.comp-left"
                                 : off                                      ? "words.comp-off"
                                                                            : "words.comp-right";
    const std::string* text = w_.language.find(key);
    if (text == nullptr) {
        w_.refuse(w_.here, "radius compensation is not translated by structure to this control");
        return std::nullopt;
    }
    const std::optional<int> offset = off ? std::optional(0) : radius_offset();
    if (!offset) return std::nullopt;
    const bool by_number = text->find("{offset}") != std::string::npos;
    if (!off && *offset != w_.tool_in_spindle && (!by_number || *offset == 0)) {
        w_.refuse(w_.here, "radius compensation by D" + std::to_string(*offset) +
                               ", which is not that of the tool in the spindle, has no counterpart there");
        return std::nullopt;
    }
    return filled(*text, {{"tool", std::to_string(w_.tool_in_spindle)}, {"offset", std::to_string(*offset)}});
}

}  // namespace obrys::rewrite
