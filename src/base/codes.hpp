#pragma once
/// Every code a complaint or a finding can carry: stable, documented in docs/diagnostics.md, each with a test.
/// `kind` says what the code does to the verdict.

#include <array>
#include <cstdint>
#include <string_view>

namespace obrys::base {

enum class CodeKind : std::uint8_t {
    finding,    ///< something wrong was found: verdict "findings" (exit 1)
    unchecked,  ///< something was not understood or not run: verdict "not fully checked" (exit 3)
    input,      ///< the input cannot be read or the call is wrong (exit 2)
    info,       ///< listed, no effect on the verdict
};

struct Code {
    std::string_view name;
    CodeKind kind;
    std::string_view meaning;
};

namespace codes {
// findings: what the check is for
inline constexpr std::string_view gouge = "gouge";
inline constexpr std::string_view allowance_cut = "allowance-cut";
inline constexpr std::string_view rapid_in_stock = "rapid-in-stock";
inline constexpr std::string_view rest_material = "rest-material";
inline constexpr std::string_view holder_in_stock = "holder-in-stock";
inline constexpr std::string_view edges_too_short = "edges-too-short";
inline constexpr std::string_view clamp_collision = "clamp-collision";
inline constexpr std::string_view plunging_cut = "plunging-cut";
inline constexpr std::string_view sideways_cut = "sideways-cut";
inline constexpr std::string_view wrong_rotation = "wrong-rotation";
inline constexpr std::string_view tap_pitch = "tap-pitch";
inline constexpr std::string_view tool_length = "tool-length";
inline constexpr std::string_view tool_radius = "tool-radius";
inline constexpr std::string_view axis_limit = "axis-limit";
inline constexpr std::string_view spindle_limit = "spindle-limit";
inline constexpr std::string_view surface_speed = "surface-speed";
inline constexpr std::string_view thread_crossed = "thread-crossed";
inline constexpr std::string_view feed_limit = "feed-limit";
inline constexpr std::string_view feed_implausible = "feed-implausible";
inline constexpr std::string_view infeed_implausible = "infeed-implausible";
inline constexpr std::string_view tool_missing = "tool-missing";
inline constexpr std::string_view feed_missing = "feed-missing";
inline constexpr std::string_view spindle_stopped = "spindle-stopped";
// findings: of cutting data and forces
inline constexpr std::string_view feed_differs = "feed-differs-from-cutting-data";
inline constexpr std::string_view spindle_power = "spindle-power";
inline constexpr std::string_view spindle_torque = "spindle-torque";
inline constexpr std::string_view chip_too_thin = "chip-too-thin";
inline constexpr std::string_view chip_too_thick = "chip-too-thick";
// findings: the control itself would stop with an alarm here
inline constexpr std::string_view program_alarm = "program-alarm";
inline constexpr std::string_view arc_radius = "arc-radius";
inline constexpr std::string_view spline_start = "spline-start";
inline constexpr std::string_view arithmetic = "arithmetic";
inline constexpr std::string_view type_mismatch = "type-mismatch";
inline constexpr std::string_view undefined_name = "undefined-name";
inline constexpr std::string_view index_range = "index-range";
inline constexpr std::string_view value_range = "value-range";
inline constexpr std::string_view duplicate_name = "duplicate-name";
inline constexpr std::string_view missing_label = "missing-label";
inline constexpr std::string_view bad_argument = "bad-argument";
inline constexpr std::string_view compensation = "compensation";
inline constexpr std::string_view contour = "contour";
inline constexpr std::string_view repeated_word = "repeated-word";
inline constexpr std::string_view not_written = "not-written";
inline constexpr std::string_view runs_otherwise = "runs-otherwise";
// not understood, or not run
inline constexpr std::string_view syntax = "syntax";
inline constexpr std::string_view unknown_word = "unknown-word";
inline constexpr std::string_view unsupported = "unsupported";
inline constexpr std::string_view missing_subprogram = "missing-subprogram";
inline constexpr std::string_view budget = "budget";
inline constexpr std::string_view unclosed = "unclosed";
inline constexpr std::string_view unknown_value = "unknown-value";
inline constexpr std::string_view not_run = "not-run";
inline constexpr std::string_view not_simulated = "not-simulated";
inline constexpr std::string_view mesh_not_closed = "mesh-not-closed";
// input that cannot be read
inline constexpr std::string_view file_missing = "file-missing";
inline constexpr std::string_view file_empty = "file-empty";
inline constexpr std::string_view file_binary = "file-binary";
inline constexpr std::string_view job_file = "job-file";
inline constexpr std::string_view job_value = "job-value";
inline constexpr std::string_view mesh_file = "mesh-file";
inline constexpr std::string_view runs_file = "runs-file";
// listed only
inline constexpr std::string_view no_effect = "no-effect";
inline constexpr std::string_view written_by_moves = "written-by-moves";
inline constexpr std::string_view assumption = "assumption";
inline constexpr std::string_view force_extrapolated = "force-extrapolated";
}  // namespace codes

inline constexpr std::array all_codes{
    Code{codes::gouge, CodeKind::finding, "the tool cuts into the finished part"},
    Code{codes::allowance_cut, CodeKind::finding, "the tool cuts into the allowance that this program must leave"},
    Code{codes::rapid_in_stock, CodeKind::finding, "a rapid move removes material"},
    Code{codes::rest_material, CodeKind::finding, "material is left outside the allowance contour"},
    Code{codes::holder_in_stock, CodeKind::finding, "shank or holder of the tool runs into the stock"},
    Code{codes::edges_too_short, CodeKind::finding, "cut deeper than the cutting edges are long"},
    Code{codes::clamp_collision, CodeKind::finding, "tool, shank or holder runs into a clamp"},
    Code{codes::plunging_cut, CodeKind::finding, "a tool that does not cut at its centre plunges into material"},
    Code{codes::sideways_cut, CodeKind::finding, "a tool that cuts along its axis only is moved sideways in material"},
    Code{codes::wrong_rotation, CodeKind::finding, "the spindle turns against the cutting direction of the tool"},
    Code{codes::tap_pitch, CodeKind::finding, "a tap goes another way a revolution than its pitch"},
    Code{codes::tool_length, CodeKind::finding,
         "a feed move with the length compensation of another tool, or without the one it needs"},
    Code{codes::tool_radius, CodeKind::finding, "a move with the radius compensation of another tool"},
    Code{codes::axis_limit, CodeKind::finding, "an axis leaves its travel"},
    Code{codes::spindle_limit, CodeKind::finding, "a spindle speed outside the machine's range"},
    Code{codes::surface_speed, CodeKind::finding,
         "constant cutting speed where it sets no speed that holds: near the axis without a limit, on it, in a thread"},
    Code{codes::thread_crossed, CodeKind::finding, "a pass of a thread that does not follow the thread of the others"},
    Code{codes::feed_limit, CodeKind::finding, "a feed above the machine's maximum"},
    Code{codes::feed_implausible, CodeKind::finding, "a feed that no tool cuts with: one of the other feed mode"},
    Code{codes::infeed_implausible, CodeKind::finding,
         "an infeed that no tool cuts with: a decimal point is missing, or stands at the wrong place"},
    Code{codes::tool_missing, CodeKind::finding, "a tool or edge that the tool list does not hold"},
    Code{codes::feed_missing, CodeKind::finding, "a feed move without a programmed feed"},
    Code{codes::spindle_stopped, CodeKind::finding, "a cut while the spindle stands still"},
    Code{codes::feed_differs, CodeKind::finding, "cutting data that contradict each other, or those of the tool"},
    Code{codes::spindle_power, CodeKind::finding, "a move takes more power than the spindle has"},
    Code{codes::spindle_torque, CodeKind::finding, "a move takes more torque than the spindle has"},
    Code{codes::chip_too_thin, CodeKind::finding, "a feed per tooth below those of the tool"},
    Code{codes::chip_too_thick, CodeKind::finding, "a feed per tooth above those of the tool"},
    Code{codes::program_alarm, CodeKind::finding, "the program raises an alarm of its own (SETAL) or stops itself"},
    Code{codes::arc_radius, CodeKind::finding, "the end point does not lie on the circle"},
    Code{codes::spline_start, CodeKind::finding, "a spline that does not start where the last move ended"},
    Code{codes::arithmetic, CodeKind::finding, "division by zero, or a function outside its domain"},
    Code{codes::type_mismatch, CodeKind::finding, "a value of the wrong type"},
    Code{codes::index_range, CodeKind::finding, "an array index outside the array"},
    Code{codes::value_range, CodeKind::finding, "a value outside what its address or parameter allows"},
    Code{codes::duplicate_name, CodeKind::finding, "a name defined twice"},
    Code{codes::missing_label, CodeKind::finding, "a jump to a label that does not exist"},
    Code{codes::bad_argument, CodeKind::finding, "arguments that do not fit the called program"},
    Code{codes::compensation, CodeKind::finding, "tool radius compensation that the contour does not allow"},
    Code{codes::contour, CodeKind::finding,
         "contour elements that are not determined, contradict each other or do not join"},
    Code{codes::repeated_word, CodeKind::finding, "an address, or two words of one group, twice in a block"},
    Code{codes::not_written, CodeKind::finding,
         "what a translated program does not say, since its control or post cannot"},
    Code{codes::runs_otherwise, CodeKind::finding,
         "what a translated program does otherwise than the one it comes from"},
    Code{codes::syntax, CodeKind::unchecked, "text that does not follow the control's grammar"},
    Code{codes::undefined_name, CodeKind::unchecked,
         "a name that is not defined in the programs and definition files at hand"},
    Code{codes::unknown_word, CodeKind::unchecked, "a word this control's tables do not know"},
    Code{codes::unsupported, CodeKind::unchecked, "a known function that obrys does not run"},
    Code{codes::missing_subprogram, CodeKind::unchecked, "a called program that was not found"},
    Code{codes::budget, CodeKind::unchecked, "the run was ended by a limit on blocks, passes, depth or time"},
    Code{codes::unclosed, CodeKind::unchecked, "a loop or branch without its end"},
    Code{codes::unknown_value, CodeKind::unchecked, "a system variable whose value obrys cannot know"},
    Code{codes::not_run, CodeKind::unchecked, "a program that was not run, or a run without a cut"},
    Code{codes::not_simulated, CodeKind::unchecked, "a move that was run but whose material removal was not computed"},
    Code{codes::mesh_not_closed, CodeKind::unchecked,
         "a mesh whose surface does not bound a solid: inside and outside are not known"},
    Code{codes::file_missing, CodeKind::input, "a file that does not exist or cannot be read"},
    Code{codes::file_empty, CodeKind::input, "a file without content"},
    Code{codes::file_binary, CodeKind::input, "a file that is not text"},
    Code{codes::job_file, CodeKind::input, "a job, machine or tool file that is not valid TOML or has an unknown key"},
    Code{codes::job_value, CodeKind::input, "a value in a job, machine or tool file that cannot be used"},
    Code{codes::runs_file, CodeKind::input, "a table of recorded runs, or a trace of one, cannot be used"},
    Code{codes::mesh_file, CodeKind::input,
         "a file of a body (STL, STEP) that cannot be read: damaged, cut off, without content or without its module"},
    Code{codes::no_effect, CodeKind::info, "a known word without effect on motion"},
    Code{codes::written_by_moves, CodeKind::info, "what a translated program says by its moves alone"},
    Code{codes::assumption, CodeKind::info, "something assumed because the input does not say it"},
    Code{codes::force_extrapolated, CodeKind::info, "chips for which the material's law of force was not found"},
};

/// The entry of a code; `unsupported`'s kind for a name that is not in the table.
[[nodiscard]] constexpr CodeKind kind_of(std::string_view name) {
    for (const Code& c : all_codes)
        if (c.name == name) return c.kind;
    return CodeKind::unchecked;
}

}  // namespace obrys::base
