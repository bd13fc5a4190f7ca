#pragma once
/// What `obrys help` prints of each command.

namespace obrys::cli {

inline constexpr const char* main_help =
    "obrys reads, runs and checks NC programs.\n\n"
    "Examples:\n"
    "  obrys check groove.job.toml                 is it clean? where does it gouge, and how deep?\n"
    "  obrys check groove.job.toml --set R3=150    the same with another value of a parameter\n"
    "  obrys check PART.MPF --html report.html     a page with picture, findings and program text\n"
    "  obrys run PART.MPF --format csv             every move with its end point and source line\n"
    "  obrys plot groove.job.toml -o groove.svg    the tool path over stock and part\n"
    "  obrys translate PART.H --to fanuc -o P.nc   the same for another control\n"
    "  obrys compare PART.H P.nc                   do both make the machine do the same?\n"
    "  obrys post check my-mill.toml               what a post writes, and what its control makes of it\n"
    "  obrys sheet PART.H -o PART.pdf              tools, set-up and times for the shop\n"
    "  obrys time PART.H --machine mill.toml       how long it takes, and on what\n"
    "  obrys fmt -i PART.H                         number and write the blocks as the control does\n";

inline constexpr const char* check_help =
    "Runs a program, removes the stock and says what is wrong with it.\n\n"
    "Examples:\n"
    "  obrys check groove.job.toml\n"
    "  obrys check groove.job.toml --set R3=150 --set R9=4\n"
    "  obrys check PART.MPF --search subs --format json\n"
    "  obrys check groove.job.toml --html report.html --svg report.svg\n"
    "  obrys check *.job.toml --fail-on error --baseline known.json\n\n"
    "A job file (.toml) names program, machine, tools, stock and part; a program alone is run and checked as far as\n"
    "that goes.\n\n"
    "Several inputs are checked one after the other; the exit code is the worst one.\n\n"
    "Exit codes: 0 clean, 1 findings, 2 usage or unreadable input, 3 not fully checked.";

inline constexpr const char* run_help =
    "Interprets a program and prints its moves.\n\n"
    "Examples:\n"
    "  obrys run PART.MPF                      the CL stream in its text form\n"
    "  obrys run PART.MPF --format csv         one row a move: end point, feed, file, line, block\n"
    "  obrys run PART.MPF --quiet              counts only\n"
    "  obrys run PART.MPF --parameters         the values of the R parameters at the end\n\n"
    "Exit codes: 0 run to its end, 1 the control would stop with an alarm, 2 usage or unreadable input,\n"
    "3 something was not understood or not run.";

inline constexpr const char* plot_help =
    "Draws the tool path (feed green, rapid red) as SVG: of a lathe over stock, part and allowance, of a mill from "
    "above\n"
    "and from the side. A program without a job will do.\n"
    "--interpolation prints instead how far a controller that moves its axes in steps of this basic length unit "
    "leaves\n"
    "each programmed element, and draws that, enlarged, with --svg.\n\n"
    "Examples:\n"
    "  obrys plot groove.job.toml -o groove.svg\n"
    "  obrys plot groove.job.toml --set R3=150 > wrong.svg\n"
    "  obrys plot PART.MPF --interpolation 0.001 --svg steps.svg\n\n"
    "Exit codes: 0 the picture was made, 2 usage or unreadable input.";

inline constexpr const char* translate_help =
    "Writes a program for another control, or anew for its own: by what it makes the tool do, with cycles, zero "
    "points,\n"
    "frames, compensation and calls where the target has them. Nothing is written where something is lost.\n\n"
    "Examples:\n"
    "  obrys translate PART.H --to fanuc -o PART.nc\n"
    "  obrys translate PART.MPF --to linuxcnc --tools tool.tbl > PART.ngc\n"
    "  obrys translate PART.MPF --to my-mill.toml -o PART.nc    a post of one's own (docs/posts.md)\n"
    "  obrys translate PART.MPF --to fanuc --keep -o PART.nc    parameters, branches and subprograms stay\n"
    "  obrys translate PART.H --to sinumerik-840d -o out/       subprograms in files of their own\n"
    "  obrys translate PART.H --to fanuc -o PART.nc --ledger ledger.html    what became of each cycle and function\n\n"
    "Exit codes: 0 proved to do the same, 1 something is lost or the control would stop, 2 usage or unreadable input,\n"
    "3 something was not understood or not run.";

inline constexpr const char* compare_help =
    "Runs two programs, of any controls, and says whether they make the machine do the same: the same way of the "
    "tool,\n"
    "feed, spindle, coolant, tools and stops, and what is left of the stock; and whether they say it the same way: "
    "zero points, frames, cycles,\n"
    "compensation. Texts of the CL stream (obrys run) are read, too.\n\n"
    "Examples:\n"
    "  obrys compare PART.H PART.nc\n"
    "  obrys compare old.job.toml new.job.toml --format json\n"
    "  obrys compare PART.H PART.nc --job part.job.toml    its tools and stock for both\n"
    "  obrys compare PART.MPF PART.H --set R3=150 --map R3=Q3    a parameter and its counterpart\n\n"
    "Exit codes: 0 the machine does the same, 1 it does not, 2 usage or unreadable input, 3 something of either was "
    "not\n"
    "understood or not run.";

inline constexpr const char* post_help =
    "Posts, by which obrys translate writes the programs of a control (docs/posts.md): lists them, begins one of "
    "one's\n"
    "own, tries one out, shows what its commands print.\n\n"
    "Examples:\n"
    "  obrys post list\n"
    "  obrys post new \"Old mill\" --extends fanuc -o old-mill.toml\n"
    "  obrys post check old-mill.toml\n"
    "  obrys post preview fanuc --command cycle.canned-peck --set bottom=-20\n"
    "  obrys post preview old-mill.toml --format html -o old-mill.html\n\n"
    "Exit codes: 0 done, of check: the control does what was asked for wherever something is written; 1 check: it "
    "reads\n"
    "something otherwise; preview: the post has nothing for the command; 2 usage or a post that cannot be used; 3 "
    "check:\n"
    "not all could be read back.";
inline constexpr const char* sheet_help =
    "Prints the sheets of programs: tools, set-up (zeros, stock, travel) and times, as far as they are known without "
    "a\n"
    "model of acceleration. A job file names machine, tools and stock.\n\n"
    "Examples:\n"
    "  obrys sheet PART.H --tools TOOL.T\n"
    "  obrys sheet part.job.toml -o part.pdf\n"
    "  obrys sheet side1.job.toml side2.job.toml --job -o order.html\n"
    "  obrys sheet part.job.toml -o part.json; obrys sheet part.job.toml --since part.json\n\n"
    "Exit codes: 0 made, 1 the control would stop, so that it is not all of the program, 2 usage or unreadable input,\n"
    "3 something was not understood or not run.";

inline constexpr const char* time_help =
    "Estimates how long the machine takes for a program: speeds, accelerations and jerk of its axes, corners within "
    "the\n"
    "tolerance, look-ahead, block rate, exact stops, dwells, spindle and tool changes. Each second has one cause. What "
    "the\n"
    "machine file does not say is assumed and listed (docs/time.md).\n\n"
    "Examples:\n"
    "  obrys time PART.H --machine mill.toml\n"
    "  obrys time part.job.toml --compare tolerance=0.01,0.05\n"
    "  obrys time PART.MPF --format json -o times.json\n\n"
    "Exit codes: 0 timed, 1 the control would stop, so that it is not all of the program, 2 usage or unreadable "
    "input,\n"
    "3 something was not understood, or its feed is not known: not fully timed.";

inline constexpr const char* calibrate_help =
    "Fits the values of a machine file that decide times to recorded runs, says what the runs show and what they do "
    "not,\n"
    "and writes the file with what they show. The table (.csv) has the columns program and seconds, and where a line "
    "is\n"
    "for a part of the program tool, or first and last (lines); trace names a file t,x,y,z of places over time.\n"
    "--program writes a program whose times show much, for any control.\n\n"
    "Examples:\n"
    "  obrys calibrate --program --to fanuc -o CALIBRATE.nc\n"
    "  obrys calibrate mill.toml runs.csv\n"
    "  obrys calibrate mill.toml runs.csv -o mill-calibrated.toml\n\n"
    "Exit codes: 0 fitted, 1 --program: the post cannot say it, 2 usage or unreadable input, 3 a program is not timed "
    "fully:\n"
    "nothing is written.";

inline constexpr const char* fmt_help =
    "Formats HEIDENHAIN programs (Klartext .H, DIN/ISO .I): numbers the blocks, one blank between words, upper case\n"
    "keywords, signs of coordinates. Comments, texts and paths stay; so does every block it does not understand, "
    "which\n"
    "it names.\n\n"
    "Examples:\n"
    "  obrys fmt PART.H                        to standard output\n"
    "  obrys fmt -i PART.H SUB.H               write the files\n"
    "  obrys fmt --check *.H                   name the files that would change\n"
    "  obrys fmt --decimal comma PART.H        X+10,5\n\n"
    "Exit codes: 0 done, 1 --check: a file would change, 2 usage, unreadable input or no HEIDENHAIN program.";

}  // namespace obrys::cli
