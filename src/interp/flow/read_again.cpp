/// Blocks that the run comes to with another state than that in which they were read: they are read anew.

#include <algorithm>

#include "base/codes.hpp"
#include "interp/capture.hpp"
#include "interp/flow/flow.hpp"

namespace obrys::interp {

namespace codes = base::codes;
using program::ModeSpan;
using program::ModeUse;
using program::StatementKind;

namespace {

/// Past this many pieces are not read anew: no program of a workpiece has as many.
constexpr std::size_t most_read = 200'000;

/// What stands here alone, without the program around it.
bool stands_alone(StatementKind k) {
    return k == StatementKind::block || k == StatementKind::call || k == StatementKind::cycle_definition;
}

bool can_be_run(const Unit& unit, std::uint32_t first) {
    for (std::uint32_t i = first; i < unit.statements.size(); ++i)
        if (!stands_alone(unit.statements[i].kind)) return false;
    // The contour of a cycle is looked for in the program around it.
    return std::all_of(unit.cycles.begin(), unit.cycles.end(),
                       [](const program::CycleDefinition& c) { return c.first_block == program::no_expr; });
}

/// It was read in a state like that of the run: where other words of it count, it may ask for more than in the text.
bool fits(const Reckoning& run, const program::PieceRead& read) {
    const program::ModeTable& table = read.unit->modes;
    for (const ModeSpan& span : table.spans) {
        if (span.first != read.first) continue;
        const ModeUse& use = table.uses[span.use];
        return program::different(table.states[use.before], run.modes, use.relied) == 0;
    }
    return true;
}

/// The piece as it is read in the state at hand; null where it cannot be run so. Read once for each state.
const program::PieceRead* piece_at(RunState& run, std::uint32_t index, const ModeUse& use) {
    const Unit& unit = run.unit();
    ReadPieces& kept = *run.read_pieces;
    ReadPieces::Key key{&unit, index, {}};
    for (std::size_t i = 0; i < program::mode_count; ++i)
        if ((use.relied >> i & 1U) != 0) key.relied[i] = run.modes[i];
    std::deque<program::PieceRead>& readings = kept.pieces[key];
    for (const program::PieceRead& read : readings) {
        if (read.unit == nullptr) return nullptr;
        if (fits(run, read)) return &read;
    }
    if (unit.modes.reader == nullptr || ++kept.count > most_read) return nullptr;
    base::Diagnostics said;
    program::PieceRead read =
        unit.modes.reader->read(unit, index, use, run.modes, run.env.sources, run.env.names, said);
    read.said = std::move(said);
    if (read.unit != nullptr && (!can_be_run(*read.unit, read.first) || !fits(run, read))) read.unit.reset();
    readings.push_back(std::move(read));
    return readings.back().unit == nullptr ? nullptr : &readings.back();
}

/// The span of the statement; null where it neither depends on modes nor sets them.
const ModeSpan* span_of(Activation& act, std::uint32_t index) {
    const std::vector<ModeSpan>& spans = act.unit->modes.spans;
    if (act.mode_span < spans.size() && index >= spans[act.mode_span].last) ++act.mode_span;  // the usual way
    const auto holds = [&](std::size_t i) {
        return i < spans.size() && index >= spans[i].first && index < spans[i].last;
    };
    if (holds(act.mode_span)) return &spans[act.mode_span];
    const bool between = (act.mode_span == spans.size() || index < spans[act.mode_span].first) &&
                         (act.mode_span == 0 || index >= spans[act.mode_span - 1].last);
    if (between) return nullptr;
    const auto behind = std::upper_bound(spans.begin(), spans.end(), index,
                                         [](std::uint32_t i, const ModeSpan& s) { return i < s.last; });
    act.mode_span = static_cast<std::uint32_t>(behind - spans.begin());
    return holds(act.mode_span) ? &*behind : nullptr;
}

/// What the reader said of the piece, once; each time it is run, so that looking ahead does not say it for the run.
void say_of(Saying& run, const program::PieceRead& piece) {
    if (run.complaints != nullptr) return;
    for (const base::Diagnostic& d : piece.said.all()) {
        const auto& all = run.diagnostics->all();
        const bool known = std::any_of(all.begin(), all.end(), [&](const base::Diagnostic& other) {
            return other.code == d.code && other.where.file == d.where.file && other.where.begin == d.where.begin &&
                   other.text == d.text;
        });
        if (!known) run.diagnostics->add(d);
    }
}

void run_piece(Moving& run, const program::PieceRead& piece) {
    say_of(run, piece);
    const std::size_t depth = run.calls.size();
    Activation block;
    block.unit = piece.unit.get();
    block.pc = piece.first;
    block.stack = run.top().stack;
    block.locals = run.top().locals;  // the variables themselves are shared
    block.own_bindings = block.locals.size();
    block.is_text = block.is_piece = true;
    run.calls.push_back(std::move(block));
    const bool calls = piece.unit->statements.back().kind == StatementKind::call;
    while (!calls && run.calls.size() > depth && !run.stopped) run.onward->step();
}

}  // namespace

bool runs_read_again(RunState& run, std::uint32_t index) {
    const ModeSpan* span = span_of(run.top(), index);
    if (span == nullptr) return false;
    const program::ModeTable& table = run.unit().modes;
    const ModeUse& use = table.uses[span->use];
    if (use.whole && index != span->first) return false;
    const ModeUse*& fit = run.modes_fit[span->use % run.modes_fit.size()];
    if (fit == &use) return false;
    if (program::different(table.states[use.before], run.modes, use.relied) != 0) {
        if (const program::PieceRead* piece = piece_at(run, index, use)) {
            run.top().pc = use.whole ? span->last : index + 1;
            run_piece(run, *piece);
            return true;
        }
        const std::string why =
            table.reader == nullptr
                ? std::string("the block means something else in the state in which the run comes to it")
                : table.reader->difference(table.states[use.before], run.modes, use.relied);
        unchecked(run, codes::unsupported, run.here(), why + ": it is run as it stands in the text",
                  "say in the block, or before it where every way to it comes by, what is to hold");
    }
    const program::Modes& after = table.states[use.after];
    if (program::different(after, run.modes, use.written) != 0) {
        run.modes_fit = {};
        for (std::size_t i = 0; i < program::mode_count; ++i)
            if ((use.written >> i & 1U) != 0) run.modes[i] = after[i];
    } else if (program::different(table.states[use.before], run.modes, use.relied) == 0) {
        fit = &use;
    }
    return false;
}

}  // namespace obrys::interp
