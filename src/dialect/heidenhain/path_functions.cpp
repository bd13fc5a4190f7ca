#include "dialect/heidenhain/path_functions.hpp"

#include <array>

namespace obrys::dialect::heidenhain {

namespace {

using enum Use;

constexpr std::array functions{
    PathFunction{"BEGIN PGM, END PGM", run, "a program's frame and unit"},
    PathFunction{"BLK FORM", accepted, "stock for the control's graphics; taken as the stock where the job says none"},
    PathFunction{"TOOL DEF", run, "tool with length and radius; with a number alone the next tool"},
    PathFunction{"TOOL CALL", run, "tool, tool axis, spindle speed, feed, oversizes"},
    PathFunction{"L", run, "straight line"},
    PathFunction{"X Y Z A B C U V W", run, "paraxial block, with R+ and R-"},
    PathFunction{"CC", run, "circle centre and pole"},
    PathFunction{"C", run, "arc about CC"},
    PathFunction{"CR", run, "arc by its radius"},
    PathFunction{"CT", run, "arc tangential to the element before"},
    PathFunction{"LP", run, "polar straight line"},
    PathFunction{"CP", run, "polar arc, helix"},
    PathFunction{"CTP", run, "polar tangential arc"},
    PathFunction{"CHF", run, "chamfer"},
    PathFunction{"RND", run, "rounding"},
    PathFunction{"RL RR R0", run, "radius compensation"},
    PathFunction{"APPR LT, LN, CT, LCT", run, "contour approach, also polar (PLT …)"},
    PathFunction{"DEP LT, LN, CT, LCT", run, "contour departure, also polar (PLCT)"},
    PathFunction{"FPOL FL FLT FC FCT FSELECT", run, "free contour programming"},
    PathFunction{"SPL", run, "cubic spline"},
    PathFunction{"LN", refused, "straight line with surface normal (3-D tool compensation)"},
    PathFunction{"F, F MAX, FZ, FU", run, "feed per minute, rapid, per tooth, per revolution"},
    PathFunction{"F AUTO", run, "feed of the cutting data, from TOOL CALL"},
    PathFunction{"FMAXT, FT", refused, "duration of a block"},
    PathFunction{"LBL, CALL LBL, REP", run, "labels, subprograms, program section repeats"},
    PathFunction{"CALL PGM", run, "programs"},
    PathFunction{"SEL PGM, CALL SELECTED PGM", refused, "a program that was selected before"},
    PathFunction{"CYCL DEF, CYCL CALL, CYCL CALL PAT, CYCL CALL POS", run, "cycles: see the list"},
    PathFunction{"PATTERN DEF, SEL PATTERN", run,
                 "points for CYCL CALL PAT: POS, ROW, PAT, FRAME, CIRC, PITCHCIRC, tables"},
    PathFunction{"CONTOUR DEF, SEL CONTOUR, DECLARE CONTOUR", run,
                 "contours of cycles 21 to 24; DEPTH of their own not in cycle 23 and formulas"},
    PathFunction{"SEL TABLE", run, "datum table of cycle 7"},
    PathFunction{"TRANS DATUM", run, "datum shift"},
    PathFunction{"PLANE SPATIAL, PROJECTED, EULER, VECTOR, POINTS, RELATIVE, RESET", run,
                 "tilted working plane, 3+2 axes"},
    PathFunction{"PLANE AXIAL", refused, "tilted working plane by positions of the rotary axes"},
    PathFunction{"GLOBAL DEF", run, "values that cycles refer to by PREDEF"},
    PathFunction{"FUNCTION RESET TCPM", accepted, "ends FUNCTION TCPM"},
    PathFunction{"FUNCTION TCPM", refused, "the tool tip keeps its place while tilting axes move"},
    PathFunction{"FUNCTION PARAX, FUNCTION MODE", refused, "parallel axes, turning"},
    PathFunction{"STOP", run, "stop of the program, with an M function"},
    PathFunction{"TCH PROBE", refused, "touch probe cycles: not simulated, their results come from the job"},
    PathFunction{"Q, QL, QR, QS", run, "parameters, formulas, texts"},
};

}  // namespace

std::span<const PathFunction> all_path_functions() { return functions; }

}  // namespace obrys::dialect::heidenhain
