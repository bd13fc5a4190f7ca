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
    "  obrys make groove groove.toml --compare     a groove from its measures, by every strategy\n"
    "  obrys sheet PART.H -o PART.pdf              tools, set-up and times for the shop\n"
    "  obrys time PART.H --machine mill.toml       how long it takes, and on what\n"
    "  obrys data --vc 160 --diameter 10 --teeth 4 --fz 0.05    cutting data\n"
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

inline constexpr const char* data_help =
    "Cutting data: speed, feed, effective diameter, chip thickness, removal, power, torque and roughness from what is\n"
    "given of them; whatever one is not given follows from the others. With --machine its limits hold, and are said\n"
    "(docs/cutting-data.md).\n\n"
    "Examples:\n"
    "  obrys data --vc 160 --diameter 10 --teeth 4 --fz 0.05\n"
    "  obrys data --kind ball --vc 160 --diameter 10 --ap 0.2 --tilt 15 --teeth 2 --fz 0.05 --ae 0.3\n"
    "  obrys data --rpm 6000 --vf 432 --teeth 4 --diameter 10 --ap 2.5 --ae 10 --material AlSi12Cu --machine "
    "fv25cnc-a\n"
    "  obrys data --kind turning --vc 180 --diameter 60 --fz 0.3 --ap 2 --nose-radius 0.8 --material C45\n"
    "  obrys data --list\n\n"
    "Exit codes: 0 solved, 1 what is given contradicts itself, or the machine cannot do it, 2 usage or unreadable "
    "input,\n"
    "3 neither speed nor feed follows from what is given.";

inline constexpr const char* force_help =
    "Forces of a milling program: of each move that cuts mean and largest force, power, torque and how far the tool\n"
    "gives way, from what the simulation removed, the tool's edges and the material, at the feed that obrys time "
    "plans;\n"
    "and what the machine's spindle and the tool list say against it (docs/force.md).\n\n"
    "Examples:\n"
    "  obrys force part.job.toml\n"
    "  obrys force part.job.toml --material AlSi12Cu --machine fv25cnc-a\n"
    "  obrys force part.job.toml --format json -o force.json\n\n"
    "Exit codes: 0 computed, 1 findings, 2 usage or unreadable input, 3 not fully computed: something was not run, "
    "not\n"
    "simulated, or the material or the teeth of a tool are not known.";

inline constexpr const char* blade_help =
    "How a thin blade rings before, while and after it is finished from its tip to its root: natural frequencies,\n"
    "stiffness at the tip and at the cut, and which speeds tooth passing does not meet it at (docs/blade.md).\n\n"
    "Examples:\n"
    "  obrys blade blade.toml\n"
    "  obrys blade blade.toml --format json -o blade.json\n\n"
    "Exit codes: 0 computed, 1 it rings at the speed that is asked for, 2 usage or unreadable input.";

inline constexpr const char* cost_help =
    "What a piece, a batch and a year cost, by items, from a shop's cost table (docs/cost.md) and the time of a "
    "piece:\n"
    "that is given, or what obrys time estimates of a program. Variants stand beside each other.\n\n"
    "Examples:\n"
    "  obrys cost shop.toml --time 166\n"
    "  obrys cost shop.toml --program PART.H --machine mill.toml\n"
    "  obrys cost variants.toml --format json\n\n"
    "Exit codes: 0 costed, 2 usage or unreadable input, 3 not fully costed: a time is not known, or not all of it.";

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
