#pragma once
/// What statements that lead elsewhere say: branches, loops, jumps, repeated sections, calls of labels.

#include <cstdint>
#include <vector>

#include "program/cycle_definition.hpp"
#include "program/expr.hpp"
#include "program/names.hpp"

namespace obrys::program {

/// IF, ELSE, WHILE, UNTIL, LOOP, repeat_count and their ends. `target`: the statement at which the run goes on when the
/// branch is taken: if_ -> behind its else_ (or its endif) when false; else_ -> its endif; while_ -> behind its
/// endwhile when false; endwhile -> its while_; until -> its repeat_ when false; endloop -> its loop_; loop_ unused;
/// repeat_count -> behind its end; end_repeat_count -> its repeat_count. Leaving a structure early is a jump with its
/// target.
struct Branch {
    ExprId condition = no_expr;
    std::uint32_t target = no_target;
    bool has_break = false;        ///< of while_: a break of it stands before its end
    std::uint32_t same_label = 0;  ///< a number that structures of one label share; 0: no other one has it
};

struct For {
    ExprId variable = no_expr, from = no_expr, to = no_expr;  ///< no_expr in its endfor
    std::uint32_t target = no_target;                         ///< for_ -> its endfor; endfor -> its for_
};

enum class JumpDirection : std::uint8_t {
    forward,
    backward,
    either,
    either_quiet,
    start,
    again  ///< as `either`; back in a program that nobody called it would repeat that without end (M99 P)
};
/// What a jump out of a structure leaves there (Traits::loops_remember).
enum class Leaves : std::uint8_t { nothing, while_, do_, while_pass, do_pass };
struct Jump {
    ExprId condition = no_expr;  ///< no_expr: always
    JumpDirection direction = JumpDirection::forward;
    ExprId destination = no_expr;      ///< text (a label or N number) or a string variable; unused for start
    std::uint32_t target = no_target;  ///< the statement, where the reader knows it already
    Leaves leaves = Leaves::nothing;
    bool has_break = false;  ///< of a pass that is left: a break of the loop stands between here and its end
};

struct CaseArm {
    ExprId value = no_expr;  ///< no_expr: DEFAULT
    Jump jump;
};
struct Case {
    ExprId selector = no_expr;
    std::vector<CaseArm> arms;
};

/// REPEAT / REPEATB label [label] P=n.
struct Section {
    NameId first = 0, last = 0;
    bool to_here = false;    ///< REPEAT label: from the label to the statement before this one
    bool one_block = false;  ///< REPEATB: only the label's block
    ExprId passes = no_expr;
};

/// CALL LBL label: runs from the label to the next `label_end` and comes back; with REP: from the label to here, that
/// many times more.
struct LabelCall {
    ExprId label = no_expr;            ///< text
    std::uint32_t target = no_target;  ///< the label's statement, where the reader knows it
    ExprId repeats = no_expr;          ///< REP
};

}  // namespace obrys::program
