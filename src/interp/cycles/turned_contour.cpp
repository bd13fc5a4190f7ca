/// From block numbers to the elements of a turning cycle's contour. What is refused: FANUC series 16i/18i-T and 30i
/// operator's manuals, multiple repetitive cycles (docs/dialects/fanuc.md).

#include "interp/cycles/turned_contour.hpp"

#include <algorithm>
#include <cmath>

#include "base/codes.hpp"
#include "interp/capture.hpp"
#include "interp/cycles/cycles.hpp"
#include "path/corner_stage.hpp"

namespace obrys::interp {

namespace codes = base::codes;
using cl::CycleKind;
using cycles::TurningElement;
using program::CycleDefinition;
using program::Statement;
using program::StatementKind;
using Places = std::vector<std::uint32_t>;

namespace {

/// Blocks with the number that an expression says; nothing after a complaint.
std::optional<Places> blocks_of(Reckoning& run, const CycleDefinition& d, ExprId number_of, bool first) {
    const std::string letter = first ? "P" : "Q", what = first ? "first" : "last";
    const std::string remedy = letter + " names the " + what + " block of the contour";
    if (number_of == program::no_expr) {
        alarm(run, codes::value_range, d.where,
              d.name + ": the number of the contour's " + what + " block (" + letter + ") is missing", remedy);
        return std::nullopt;
    }
    const base::Span where = run.unit().span(number_of);
    const double n = number(run, number_of);
    if (run.stopped) return std::nullopt;
    if (std::isnan(n)) {
        unchecked(run, codes::unknown_value, where,
                  d.name + ": which block this is depends on a value that is not known");
        return std::nullopt;
    }
    const Places at = numbered_statements(run, n);
    if (!at.empty()) return at;
    alarm(run, codes::missing_label, where,
          d.name + ": there is no block N" + printed(Value::real(n)) + " in this program", remedy);
    return std::nullopt;
}

/// A finishing cycle looks back first, the others ahead.
std::uint32_t nearest_place(const Places& at, std::uint32_t self, bool back) {
    const auto after = std::upper_bound(at.begin(), at.end(), self);
    if (back) return after != at.begin() ? *std::prev(after) : at.front();
    return after != at.end() ? *after : at.back();
}

std::uint32_t end_of_block(const Unit& unit, std::uint32_t index) {
    while (index + 1 < unit.statements.size() && (unit.statements[index + 1].flags & program::line_start) == 0) ++index;
    return index;
}

/// Why a word may not stand in a contour; null where it may.
const char* refusal(Modal m) {
    switch (m) {
        case Modal::thread:
        case Modal::thread_rising:
        case Modal::thread_falling:
        case Modal::probe:
        case Modal::canned:
        case Modal::turning_cycle: return "a contour has only G0, G1, G2 and G3";
        case Modal::home:
        case Modal::from_home:
        case Modal::reference_point:
        case Modal::suppress_all:
        case Modal::set_data:
        case Modal::datum:
        case Modal::position_becomes:
        case Modal::local_shift:
            return "positions in the machine and shifts of the zero point have no place in a contour";
        case Modal::inch_all:
        case Modal::metric_all: return "the unit cannot change within a contour";
        default: return nullptr;
    }
}

const char* refusal(StatementKind k) {
    switch (k) {
        case StatementKind::call:
        case StatementKind::label_call: return "a contour cannot call subprograms or macros";
        case StatementKind::cycle_definition:
        case StatementKind::repeat_section: return "a contour cannot call cycles";
        case StatementKind::return_: return "the program ends within the contour";
        default: return nullptr;
    }
}

/// False after a complaint about what stands in the contour.
bool check_blocks(Saying& run, const CycleDefinition& d, const ContourBlocks& c) {
    const Unit& unit = run.unit();
    for (std::uint32_t i = c.first; i <= c.last; ++i) {
        const Statement& s = unit.statements[i];
        const char* why = refusal(s.kind);
        base::Span where = unit.span(s);
        for (std::uint32_t w = s.first; w < unit.words_end(i) && why == nullptr && s.kind == StatementKind::block;
             ++w) {
            const program::Word& word = unit.words[w];
            if (program::code_of(word) != Code::modal) continue;
            why = refusal(program::modal_of(word));
            where = unit.span(s, word);
        }
        if (why == nullptr) continue;
        alarm(run, codes::contour, where, d.name + ": this cannot stand in the blocks of the contour", why);
        return false;
    }
    return true;
}

bool names_both_axes(const Unit& unit, std::uint32_t first) {
    bool x = false, z = false;
    for (std::uint32_t i = first, end = end_of_block(unit, first); i <= end; ++i) {
        if (unit.statements[i].kind != StatementKind::block) continue;
        for (std::uint32_t w = unit.statements[i].first; w < unit.words_end(i); ++w) {
            x = x || program::code_of(unit.words[w]) == Code::x;
            z = z || program::code_of(unit.words[w]) == Code::z;
        }
    }
    return x && z;
}

void say_repeated(Saying& run, const CycleDefinition& d, ExprId number_of, const Places& at, bool back) {
    if (at.size() > 1)
        assume(run, run.unit().span(number_of),
               d.name + ": this block number stands " + std::to_string(at.size()) + " times in the program: the one " +
                   (back ? "before" : "behind") + " the cycle is taken",
               "a contour's first and last block need numbers of their own");
}

}  // namespace

std::optional<ContourBlocks> find_contour(Reckoning& run, const CycleDefinition& d, std::uint32_t self) {
    const bool back = d.kind == CycleKind::lathe_finish;
    const auto firsts = blocks_of(run, d, d.first_block, true);
    const auto lasts = firsts ? blocks_of(run, d, d.last_block, false) : std::nullopt;
    if (!lasts) return std::nullopt;
    ContourBlocks c;
    c.first = nearest_place(*firsts, self, back);
    const auto last = std::lower_bound(lasts->begin(), lasts->end(), c.first);
    if (last == lasts->end()) {
        alarm(run, codes::contour, run.unit().span(d.last_block),
              d.name + ": the contour's last block stands before its first one",
              "change P and Q, or the block numbers");
        return std::nullopt;
    }
    say_repeated(run, d, d.first_block, *firsts, back);
    c.last = end_of_block(run.unit(), *last);
    c.names_both_axes = names_both_axes(run.unit(), c.first);
    if (self >= c.first && self <= c.last) {
        alarm(run, codes::contour, d.where, d.name + ": the cycle stands within its own contour");
        return std::nullopt;
    }
    if (!check_blocks(run, d, c)) return std::nullopt;
    return c;
}

namespace {

/// The first block must go to the contour's start by a straight move.
bool check_start(Saying& run, const CycleDefinition& d, const ContourBlocks& c, const std::vector<Captured>& all) {
    const Unit& unit = run.unit();
    const Statement& first = unit.statements[c.first];
    const auto in_first = [&](const base::Span& where) {
        return where.begin >= first.begin &&
               where.begin <= unit.statements[end_of_block(unit, c.first)].begin + std::uint32_t{first.length};
    };
    if (!all.empty() && in_first(all.front().where) && !path::is_arc(all.front().element)) return true;
    alarm(run, codes::contour, unit.span(first), d.name + ": the first block of the contour is no straight move",
          "it leads to the contour's start with G0 or G1");
    return false;
}

TurningElement turned(const path::CornerOutput& out, const std::vector<Captured>& all) {
    const bool arc = path::is_arc(out.element);
    TurningElement e;
    e.to = out.element.to;
    e.centre = out.element.centre;
    e.turn = !arc ? 0 : out.element.sweep > 0 ? 1 : -1;
    e.rapid = !out.inserted && !arc && all[out.element.tag].rapid;
    return e;
}

bool is_known(const Captured& c) {
    const path::Element& e = c.element;
    return std::isfinite(e.to.x + e.to.y) && (!path::is_arc(e) || std::isfinite(e.centre.x + e.centre.y + e.sweep));
}

/// False after a complaint.
bool check_elements(Reckoning& run, const CycleDefinition& d, const std::vector<Captured>& all) {
    for (const Captured& c : all) {
        if (!is_known(c)) {
            unchecked(run, codes::unknown_value, c.where,
                      d.name + ": the contour depends on a value that is not known");
            return false;
        }
        if (!(c.frame == run.frame)) {
            alarm(run, codes::contour, c.where, d.name + ": the zero point changes within the contour");
            return false;
        }
    }
    if (all.back().corner.kind == path::CornerKind::none) return true;
    alarm(run, codes::contour, all.back().where, d.name + ": the contour ends with a chamfer or rounding",
          "end it with a move behind the corner");
    return false;
}

}  // namespace

std::optional<TurnedContour> turned_contour(Moving& run, const CycleDefinition& d, const ContourBlocks& c) {
    const auto looked = run.onward->blocks(c.first, c.last).said(run, d.name);
    if (!looked) {
        alarm(run, codes::contour, d.where, d.name + ": the run leaves the blocks of the contour before their end",
              "jumps must stay within the contour");
        return std::nullopt;
    }
    const std::vector<Captured>& all = *looked;
    if (!check_start(run, d, c, all) || !check_elements(run, d, all)) return std::nullopt;
    TurnedContour out;
    path::CornerStage corners;
    const auto take = [&](const path::CornerOutput& o) {
        const bool first = out.elements.empty();
        if (!first && !path::moves_in_plane(o.element)) return;
        out.elements.push_back(turned(o, all));
        out.places.push_back(all[o.element.tag].where);
    };
    for (std::size_t i = 0; i < all.size(); ++i) {
        path::Element e = all[i].element;
        e.tag = i;
        out.compensated = out.compensated || all[i].compensation != Modal::compensation_off;
        if (corners.push(std::move(e), all[i].corner, take)) {
            alarm(run, codes::value_range, all[i].where,
                  d.name + ": the chamfer or rounding before this block cannot be made");
            return std::nullopt;
        }
    }
    corners.flush(take);
    return out;
}

}  // namespace obrys::interp
