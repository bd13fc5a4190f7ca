#include "rewrite/held.hpp"

#include <optional>
#include <set>
#include <utility>

#include "base/whole.hpp"
#include "program/modal_group.hpp"
#include "rewrite/frames.hpp"

namespace obrys::rewrite {

using program::Modal;
using program::StatementKind;
using program::Unit;

namespace {

constexpr unsigned places_of_statement = 20;  ///< bits

void set_mode(Held& h, Modal m) {
    if (program::motion_group(m) == program::ModalGroup::motion) h[Mode::motion] = static_cast<int>(m);
    switch (m) {
        case Modal::plane_xy: h[Mode::plane] = 17; break;
        case Modal::plane_zx: h[Mode::plane] = 18; break;
        case Modal::plane_yz: h[Mode::plane] = 19; break;
        case Modal::absolute: h[Mode::distance] = 0; break;
        case Modal::incremental: h[Mode::distance] = 1; break;
        case Modal::diameter_on: h[Mode::across] = 1; break;
        case Modal::diameter_off: h[Mode::across] = 0; break;
        case Modal::feed_per_minute: h[Mode::feed] = 0; break;
        case Modal::feed_per_rev: h[Mode::feed] = 1; break;
        case Modal::surface_speed_on: h[Mode::surface] = 1; break;
        case Modal::surface_speed_off: h[Mode::surface] = 0; break;
        case Modal::tool_length: h[Mode::length] = 1; break;
        case Modal::tool_length_off: h[Mode::length] = 0; break;
        case Modal::compensation_left:
        case Modal::compensation_right: h[Mode::side] = 1; break;
        case Modal::compensation_off: h[Mode::side] = 0; break;
        default: break;
    }
}

void set_cycle(Held& h, const program::CycleDefinition& cycle, int place) {
    if (cycle.kind == cl::CycleKind::contour_definition) h[Mode::contour] = place;
    if (cycle.call_active) h[Mode::cycle] = place;
}

/// The number that a word says; `several` where it is computed.
int number_said(const Unit& unit, const program::Word& word) {
    constexpr int most = 999'999;
    if (!program::is_literal(word)) return several;
    return base::whole<int>(unit.literal(word), 0, most).value_or(several);
}

/// T, M6 and D of a block.
void set_tools(Held& h, const Unit& unit, std::uint32_t statement, bool tools_wait) {
    std::optional<int> tool, change;
    bool on_m6 = false;
    for (std::uint32_t w = unit.statements[statement].first; w < unit.words_end(statement); ++w) {
        const program::Word& word = unit.words[w];
        switch (program::code_of(word)) {
            case program::Code::tool_definition: return;  // TOOL DEF 5 changes no tool
            case program::Code::tool: tool = number_said(unit, word); break;
            case program::Code::tool_change:
                change = program::is_literal(word) ? number_said(unit, word) / 100 : nowhere;
                break;
            case program::Code::offset_d: h[Mode::radius] = number_said(unit, word); break;
            case program::Code::m: on_m6 = on_m6 || number_said(unit, word) == 6; break;
            default: break;
        }
    }
    if (change == nowhere) change = tool;  // without T another speed alone
    if (tool && !change && tools_wait) h[Mode::prepared] = *tool;
    if (on_m6 && tools_wait) h[Mode::tool] = tool.value_or(h[Mode::prepared]);
    if (tool && !tools_wait) h[Mode::tool] = *tool;
    if (change) h[Mode::tool] = *change;
}

Held behind(const Unit& unit, std::size_t number, std::uint32_t statement, Held h, bool tools_wait) {
    const int place = place_number(number, statement);
    if (unit.statements[statement].kind == StatementKind::cycle_definition)
        set_cycle(h, unit.cycles[entry_of(unit, statement)], place);
    for (const Mode m : frame_parts_of(unit, statement, true)) h[m] = nowhere;
    for (const Mode m : frame_parts_of(unit, statement, false)) h[m] = place;
    if (unit.statements[statement].kind == StatementKind::contour) h[Mode::contour] = several;  // CONTOUR DEF
    if (unit.statements[statement].kind != StatementKind::block) return h;
    set_tools(h, unit, statement, tools_wait);
    for (std::uint32_t w = unit.statements[statement].first; w < unit.words_end(statement); ++w) {
        if (program::code_of(unit.words[w]) != program::Code::modal) continue;
        const Modal m = program::modal_of(unit.words[w]);
        const bool feed_word = m == Modal::feed_per_minute || m == Modal::feed_per_rev;
        if (feed_word && unit.traits->feed_mode_ends_surface_speed) h[Mode::surface] = 0;
        set_mode(h, m);
        if (m == Modal::pole_given) h[Mode::pole] = place;
        if (m == Modal::pole_from_position || m == Modal::pole_from_zero || m == Modal::pole_from_pole)
            h[Mode::pole] = nowhere;
    }
    return h;
}

/// True where `into` has changed.
bool join(Held& into, const Held& from) {
    bool changed = false;
    for (std::size_t i = 0; i < into.of.size(); ++i) {
        if (from.of[i] == never_there || into.of[i] == from.of[i] || into.of[i] == several) continue;
        into.of[i] = into.of[i] == never_there ? from.of[i] : several;
        changed = true;
    }
    return changed;
}

}  // namespace

int place_number(std::size_t program, std::uint32_t statement) {
    constexpr std::uint32_t most = 1 << places_of_statement;
    if (program >= 1000 || statement >= most) return several;
    return static_cast<int>(program * most + statement);
}

StatementPlace place_of(int number) {
    const auto n = static_cast<std::uint32_t>(number);
    return {n >> places_of_statement, n & ((1U << places_of_statement) - 1)};
}

namespace {

/// Follows the ways that a run may take until nothing changes any more: every statement again only where something
/// else comes to it.
class Following {
public:
    Following(const std::vector<const Unit*>& programs, const std::map<const Unit*, Graph>& graphs,
              const Surroundings& around)
        : programs_(programs), graphs_(graphs), around_(around), callers_(programs.size()) {
        for (std::size_t n = 0; n < programs.size(); ++n) number_[programs[n]] = n;
        for (const Unit* unit : programs) held_.emplace_back(unit->statements.size() + 1);
    }

    HeldModes run(const Held& start) {
        come_to(0, 0, start);
        while (!open_.empty()) {
            const Place at = open_.back();
            open_.pop_back();
            step(at);
        }
        HeldModes all;
        for (std::size_t n = 0; n < programs_.size(); ++n) all[programs_[n]] = std::move(held_[n]);
        return all;
    }

private:
    struct Place {
        std::size_t program;
        std::uint32_t statement;
    };

    void come_to(std::size_t program, std::uint32_t statement, const Held& with) {
        if (!join(held_[program][statement], with)) return;
        if (statement + 1 < held_[program].size()) return open_.push_back({program, statement});
        open_.insert(open_.end(), callers_[program].begin(), callers_[program].end());
    }

    void step(const Place& at) {
        const Unit& unit = *programs_[at.program];
        Held out = behind(unit, at.program, at.statement, held_[at.program][at.statement], around_.tools_wait);
        if (unit.statements[at.statement].kind == StatementKind::call)
            call(at, unit.calls[entry_of(unit, at.statement)], out);
        for (const std::uint32_t to : graphs_.at(&unit).next[at.statement])
            if (to < held_[at.program].size()) come_to(at.program, to, out);
    }

    void call(const Place& at, const program::Call& c, Held& out) {
        const Unit* called = around_.callee(*programs_[at.program], c);
        if (called == nullptr) return;
        const std::size_t n = number_.at(called);
        if (known_.emplace(at.program, at.statement).second) callers_[n].push_back(at);
        come_to(n, 0, held_[at.program][at.statement]);
        if (called->save) return;
        if (c.passes != program::no_expr) come_to(n, 0, held_[n].back());
        out = held_[n].back();
    }

    const std::vector<const Unit*>& programs_;
    const std::map<const Unit*, Graph>& graphs_;
    const Surroundings& around_;
    std::map<const Unit*, std::size_t> number_;
    std::vector<std::vector<Held>> held_;  ///< by the numbers of programs
    std::vector<std::vector<Place>> callers_;
    std::set<std::pair<std::size_t, std::uint32_t>> known_;
    std::vector<Place> open_;
};

}  // namespace

HeldModes held_modes(const std::vector<const Unit*>& programs, const Held& start,
                     const std::map<const Unit*, Graph>& graphs, const Surroundings& around) {
    return Following(programs, graphs, around).run(start);
}

}  // namespace obrys::rewrite
