#include <algorithm>
#include <cmath>

#include "program/modal_group.hpp"
#include "read/rs274/fanuc/state.hpp"

namespace obrys::read::rs274 {

namespace {

/// M99 P.
bool jumps(FanucState& s) {
    const bool back = std::any_of(s.addresses.begin(), s.addresses.end(),
                                  [](const Address& a) { return a.letter == 'M' && as_integer(a.value) == 99; });
    return back && find_address(s, 'P') != nullptr;
}

void empty_block(FanucState& s) {
    s.build().statement(StatementKind::block, s.line.begin());
    s.build().end_statement(s.line.end());
}

}  // namespace

void add_control(FanucState& s, StatementKind kind, std::size_t index) {
    s.build().control(kind, index, s.line.begin(), s.line.end());
}

namespace {

/// An address whose first one a G code has taken: the second one would be left.
void refuse_repeated(FanucState& s) {
    std::uint32_t taken = 0;  // bit per letter
    for (Address& a : s.addresses) {
        const std::uint32_t bit = 1U << static_cast<unsigned>(a.letter - 'A');
        const bool again = !a.used && !a.comma && a.letter != 'G' && a.letter != 'M' && (taken & bit) != 0;
        if (again) {
            a.used = true;
            add_problem(s, Code::unsupported, a.begin, a.end, "the address stands twice in the block");
        }
        if (a.used && !a.comma) taken |= bit;
    }
}

/// Coordinates of a block that goes on with a motion which is not run: no other one takes them.
bool goes_on_with_lost_motion(const FanucState& s) {
    if (s.own_motion || !s.special.empty() || !s.lost_motion) return false;
    const bool once = std::any_of(s.words.begin(), s.words.end(), [](const BlockWord& w) {
        return w.code == Code::modal && program::group_of(w.modal) == program::ModalGroup::suppression;
    });
    return !once && std::any_of(s.words.begin(), s.words.end(),
                                [](const BlockWord& w) { return w.code >= Code::x && w.code <= Code::w; });
}

/// While G68, G51 or G51.1 is in force the control takes no G27 to G30 (reference position) and no G52 to G59 or G92
/// (coordinate systems). Source: B-63684EN, coordinate system rotation, scaling, programmable mirror image.
void refuse_in_rotation(FanucState& s) {
    if (s.control.haas) return;
    for (const Address& a : s.addresses) {
        const auto g = a.letter == 'G' ? g_tenths(a) : std::nullopt;
        if (g && ((*g >= 270 && *g <= 300) || (*g >= 520 && *g <= 599) || *g == 920) && (s.transformed & ~tilted) != 0)
            add_problem(s, Code::unsupported, a.begin, a.end,
                        "G68, G51 or G51.1 is in force, in which it must not be programmed");
        // The same, programmable mirror image: not within scaling or rotation.
        if (g && (*g == 501 || *g == 511) && (s.transformed & (rotated | enlarged)) != 0)
            add_problem(s, Code::unsupported, a.begin, a.end,
                        "G68 or G51 is in force, in which it must not be programmed");
    }
}

/// G10 of the block.
bool sets_data(const FanucState& s) {
    return std::any_of(s.special.begin(), s.special.end(),
                       [](const Special& x) { return x.g->special == FanucSpecial::set_data; });
}

}  // namespace

void as_piece(FanucState& s, base::FunctionRef<void()> make) {
    const auto count = [&] { return static_cast<std::uint32_t>(s.unit().statements.size()); };
    const std::uint32_t first = count();
    s.modes.begin_piece();
    make();
    // Words that leave nothing in the tree, as M29 and G15, or nothing in this state.
    if ((s.modes.has_written() || s.facts.refused) && count() == first) empty_block(s);
    s.modes.end_piece(s.unit().modes, {first, count()}, !s.failed);
}

namespace {

void emit_all(FanucState& s) {
    begin_words(s);
    s.special.clear();
    s.own_words.clear();
    s.own_motion = s.restore_motion = s.hole_apart = false;
    s.corner.reset();
    for (Address& a : s.addresses)
        if (a.letter == 'G' && !a.used) read_g_code(s, a);
    for (Address& a : s.addresses)
        if (a.letter == 'M' && !a.used) read_m_code(s, a);
    s.hole_apart = sets_data(s);  // P, K, R are not those of the cycle
    refuse_in_rotation(s);
    if (!s.failed) run_specials(s);
    if (!s.failed) take_own_words(s);
    if (!s.failed) refuse_in_tilt(s);
    refuse_repeated(s);
    if (!s.failed) judge_block_behind_corner(s);
    if (!s.failed && turning_block(s)) return;
    for (Address& a : s.addresses)
        if (!s.failed && !a.used) emit_address(s, a);
    s.hole_apart = false;
    if (s.failed) return;
    judge_corner(s);
    if (s.lost || goes_on_with_lost_motion(s)) s.facts.refused = true;
    emit_block(s);
    if (!s.restore_motion) return;
    s.build().statement(StatementKind::block, s.line.begin());
    s.build().modal(s.motion, s.line.begin(), s.line.end());
    s.build().end_statement(s.line.end());
}

}  // namespace

void emit_addresses(FanucState& s) {
    as_piece(s, [&] { emit_all(s); });
}

namespace {

/// A jump forwards whose target comes later; its index.
std::size_t open_jump(FanucState& s, std::uint8_t skip) {
    s.build().begin_block(skip);
    s.unit().jumps.emplace_back();
    add_control(s, StatementKind::jump, s.unit().jumps.size() - 1);
    return s.unit().jumps.size() - 1;
}

/// `X10. /Z5.`: while the skip is on, what stands behind the slash is not there (B-63684EN, optional block skip). The
/// block both ways, and a jump over the short one that the skip takes out.
void read_slashed(FanucState& s) {
    if (s.skip != 0)
        return fail(s, s.line.begin(), s.line.end(), "a second / in a block is not run", "write two blocks");
    const std::vector<Address> all = s.addresses;
    const auto here = [&] { return static_cast<std::uint32_t>(s.unit().statements.size()); };
    const auto emit = [&](std::size_t count) {
        s.addresses.assign(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(count));
        if (!read_calls(s) && !s.failed) emit_addresses(s);
    };
    const std::size_t to_whole = open_jump(s, s.slash->second), words = s.slash->first;
    const program::Modes before = s.modes.all();
    s.build().begin_block();
    emit(words);
    const std::size_t to_end = open_jump(s, 0);
    s.unit().jumps[to_whole].target = here();
    s.modes.put_all(before);  // the other way, not a block behind it
    if (!s.failed) emit(all.size());
    s.unit().jumps[to_end].target = here();
}

/// Macro statements and NC words stand in blocks of their own.
void end_macro_statement(FanucState& s) {
    while (!s.failed && s.line.peek() == '(') static_cast<void>(take_comment(s));
    if (s.failed || s.line.at_end()) return;
    fail(s, s.line.here(), s.line.end(), "this stands behind a macro statement, which needs a block of its own",
         "write it in a block before or behind it");
}

bool calls_macro(const FanucState& s) {
    return std::any_of(s.addresses.begin(), s.addresses.end(), [](const Address& a) {
        const auto g = g_tenths(a);
        return g && (*g == 650 || *g == 660 || *g == 661);
    });
}

/// Numbers of functions, tools and offsets have no decimal point; as arguments of a macro they are values as others.
/// FANUC, decimal point programming: X Y Z U V W A B C I J K Q R F may have one; alarm 7.
void refuse_points(FanucState& s) {
    if (calls_macro(s)) return;
    const std::string_view letters = s.control.is_lathe() ? "MT" : "MTHD";
    for (const Address& a : s.addresses) {
        if ((a.letter == 'P' || a.letter == 'L') && !a.comma && a.value.is_literal() && !a.value.literal.integer &&
            !s.control.haas)
            return fail(s, a.begin, a.end, "a decimal point cannot stand here (alarm 7)",
                        "write a whole number: of dwells ms, of lengths the least input increment");
        if (a.comma || letters.find(a.letter) == std::string_view::npos || !a.value.is_literal()) continue;
        if (a.value.number() == std::floor(a.value.number())) continue;  // posts for FANUC write M251. as well
        return fail(
            s, a.begin, a.end,
            s.control.haas ? "a whole number stands behind this letter" : "a decimal point cannot stand here (alarm 7)",
            "write a whole number");
    }
}

}  // namespace

void read_rest(FanucState& s) {
    s.condition = no_expr;
    if (++s.depth > deepest)
        return fail(s, s.line.here(), s.line.end(), "IF … THEN is nested too deeply in one block",
                    "write blocks of their own");
    if (read_macro_statement(s)) return end_macro_statement(s);
    if (s.failed) return;
    if (s.control.haas && s.line.peek() == '[') {  // [#1 LT 10] M99 P20
        s.operators = 0;
        s.condition = read_bracket(s);
        if (s.failed) return;
    }
    const std::uint32_t begin = s.line.here();
    read_addresses(s);
    if (s.failed) return;
    if (s.condition != no_expr && !jumps(s)) return fail(s, begin, s.line.end(), "expected M99 P behind the condition");
    if (s.addresses.empty()) return;
    refuse_points(s);
    if (s.failed) return;
    if (s.slash) return read_slashed(s);
    if (read_calls(s) || s.failed) return;
    if (!s.called.empty())
        return fail(s, s.called_begin, s.called_end, "the name of a program stands behind M98, G65 or G66");
    emit_addresses(s);
}

void read_fanuc_block(FanucState& s, std::uint32_t begin, std::uint32_t end) {
    s.failed = false;
    s.depth = 0;
    s.hole_apart = false;
    s.brackets_match.reset();
    s.modes.begin_block();
    // A comment ends at the bracket that belongs to its own; where there is none, at the first one.
    s.line.load(s.text, begin, end, true, false);
    if (s.line.fault() == CommentFault::unclosed) s.line.load(s.text, begin, end, false, false);
    if (s.line.at_end()) return;
    if (s.line.fault() == CommentFault::unclosed)
        return fail(s, s.line.fault_begin(), s.line.end(), "the comment is not closed", "add )");
    read_head(s);
    if (s.failed) return;
    note_number(s);
    s.build().begin_block(s.skip);
    const std::size_t before = s.unit().statements.size();
    read_rest(s);
    if (s.unit().statements.size() == before && (s.number || s.skip != 0)) empty_block(s);
}

}  // namespace obrys::read::rs274
