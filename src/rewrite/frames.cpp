/// Shifts, rotations, mirror images and scalings: which are in force follows from the text.

#include "rewrite/frames.hpp"

#include <algorithm>

#include "rewrite/writing.hpp"

namespace obrys::rewrite {

using program::Code;
using program::CycleDefinition;
using program::FrameOp;
using program::Modal;

namespace {

bool has_modal(const Unit& unit, std::uint32_t statement, Modal m) {
    for (std::uint32_t w = unit.statements[statement].first; w < unit.words_end(statement); ++w)
        if (program::code_of(unit.words[w]) == Code::modal && program::modal_of(unit.words[w]) == m) return true;
    return false;
}

/// A shift by 0 is none.
void axes_named(const Unit& unit, std::uint32_t statement, bool ended, std::vector<Mode>& parts) {
    for (std::uint32_t w = unit.statements[statement].first; w < unit.words_end(statement); ++w)
        if (const Code code = program::code_of(unit.words[w]);
            code <= Code::z && (ended || !program::is_literal(unit.words[w]) || unit.literal(unit.words[w]) != 0))
            parts.push_back(shift_modes[static_cast<std::size_t>(code)]);
}

/// The setting's value is this number, whatever holds.
bool says(const Unit& unit, const program::CycleSetting& s, double number) {
    ExprId id = s.value;
    while (id != program::no_expr && unit.exprs[id].kind == ExprKind::unary) id = unit.exprs[id].a;
    return id != program::no_expr && !s.incremental && !s.as_modal && unit.exprs[id].kind == ExprKind::number &&
           unit.numbers[unit.exprs[id].a] == number;
}

std::vector<Mode> parts_of_cycle(const Unit& unit, const CycleDefinition& d, bool ended) {
    std::vector<Mode> parts;
    const bool mirror = d.kind == cl::CycleKind::mirror;
    if (mirror && (ended || !d.settings.empty())) parts.push_back(Mode::mirror);
    for (const program::CycleSetting& s : d.settings) {
        const auto axis = axis_of_role(s.role);
        const bool scale = d.kind == cl::CycleKind::scaling;
        if (mirror || (!ended && says(unit, s, scale ? 1 : 0))) continue;
        if (d.kind == cl::CycleKind::datum_shift && axis) parts.push_back(shift_modes[*axis]);
        if (d.kind == cl::CycleKind::rotation) parts.push_back(Mode::turn);
        if (scale) parts.push_back(Mode::scale);
    }
    return parts;
}

std::vector<Mode> parts_of_frame(const program::FrameCall& call, bool ended) {
    if (!call.additive && ended) return {frame_modes.begin(), frame_modes.end()};
    switch (call.op) {
        case FrameOp::shift: return {shift_modes.begin(), shift_modes.end()};
        case FrameOp::rotate: return {Mode::turn};
        case FrameOp::mirror: return {Mode::mirror};
        case FrameOp::scale: break;
    }
    return {Mode::scale};
}

}  // namespace

std::optional<std::size_t> axis_of_role(cl::CycleRole role) {
    switch (role) {
        case cl::CycleRole::axis_x: return 0;
        case cl::CycleRole::axis_y: return 1;
        case cl::CycleRole::axis_z: return 2;
        default: return std::nullopt;
    }
}

std::vector<Mode> frame_parts_of(const Unit& unit, std::uint32_t statement, bool ended) {
    const StatementKind kind = unit.statements[statement].kind;
    if (kind == StatementKind::cycle_definition)
        return parts_of_cycle(unit, unit.cycles[entry_of(unit, statement)], ended);
    if (kind == StatementKind::frame) return parts_of_frame(unit.frames[entry_of(unit, statement)], ended);
    std::vector<Mode> parts;
    if (kind != StatementKind::block) return parts;
    if (has_modal(unit, statement, Modal::local_shift)) axes_named(unit, statement, ended, parts);
    if (has_modal(unit, statement, Modal::rotation_on) || (ended && has_modal(unit, statement, Modal::rotation_off)))
        parts.push_back(Mode::turn);
    return parts;
}

Text Writing::nothing_of(Mode part) const {
    if (part == Mode::mirror) return {"", Level::atom, std::nullopt};
    return number_text(part == Mode::scale ? 1 : 0);
}

std::optional<Text> Writing::frame_part(Mode part) {
    const int said = held()[part];
    if (said == nowhere || !frame_acts(part)) return nothing_of(part);
    const auto found = frame_values_.find({said, part});
    const bool foreign = said >= 0 && programs[place_of(said).program] != unit;
    if (said >= 0 && found != frame_values_.end() && (!foreign || found->second.number || part == Mode::mirror))
        return found->second;
    if (frame_varies(part)) return frame_keeper(part);
    return std::nullopt;
}

/// One look at all statements: they may be many, and so may be those that change a frame.
void Writing::look_at_frames() {
    if (frames_) return;
    frames_ = Frames{0, {}, {}};
    std::set<Mode> elsewhere, meets;
    for (const Unit* u : programs)
        for (std::uint32_t i = 0; i < u->statements.size(); ++i) {
            const std::vector<Mode> parts = frame_parts_of(*u, i, true);
            if (parts.empty()) continue;
            ++frames_->count;
            for (const Mode m : frame_parts_of(*u, i, false)) frames_->act.insert(m);
            if (u != programs.front()) elsewhere.insert(parts.begin(), parts.end());
            for (const Mode m : frame_modes)
                if (u == programs.front() && modes.at(u)[i][m] == several) meets.insert(m);
        }
    for (const Mode m : frame_modes)
        if (m != Mode::mirror && frames_->act.contains(m) && meets.contains(m) && !elsewhere.contains(m))
            frames_->vary.insert(m);
}

bool Writing::frame_acts(Mode part) {
    look_at_frames();
    return frames_->act.contains(part);
}

/// The main program holds it in one place, where it alone says it and ways meet with different values.
bool Writing::frame_varies(Mode part) {
    look_at_frames();
    return unit == programs.front() && frames_->vary.contains(part);
}

std::optional<Text> Writing::frame_keeper(Mode part) {
    constexpr std::array names{"SHIFT_X", "SHIFT_Y", "SHIFT_Z", "TURN", "", "SCALE"};
    const auto i = static_cast<std::size_t>(part) - static_cast<std::size_t>(Mode::shift_x);
    std::string& name = frame_keepers_[{unit, part}];
    if (name.empty()) name = naming.keeper(*unit, names[i]).value_or("");
    return name.empty() ? std::nullopt : std::optional(Text{name, Level::atom, std::nullopt});
}

/// Places that the run reads before it writes them hold what a frame is that nobody has said.
void Writing::begin_frames() {
    for (const Mode m : frame_modes)
        if (frame_varies(m))
            if (const auto to = frame_keeper(m)) assign(*to, nothing_of(m));
}

void Writing::keep_frame(const std::array<Text, 6>& parts) {
    const auto number = static_cast<std::size_t>(std::find(programs.begin(), programs.end(), unit) - programs.begin());
    for (std::size_t i = 0; i < parts.size(); ++i) frame_values_[{place_number(number, at), frame_modes[i]}] = parts[i];
}

bool Writing::says_frames_again() {
    look_at_frames();
    return frames_->count > 1;
}

}  // namespace obrys::rewrite
