#include "dialect/apt/words.hpp"

#include <algorithm>
#include <array>

#include "base/edit_distance.hpp"

namespace obrys::dialect::apt {

namespace {

constexpr std::string_view part_program =
    "it is of an APT part program, not of cutter locations: an APT processor "
    "makes GOTO and CIRCLE of it";
constexpr std::string_view for_post = "what it asks of the postprocessor is not known here";
constexpr std::string_view for_machine = "what it does on the machine is not known here";

/// In alphabetical order.
constexpr std::array majors{
    MajorWord{"ARC", Major::not_run, "how it gives the arc's end is not known for certain: write CIRCLE and GOTO"},
    MajorWord{"ARCSLP", Major::quiet, ""},
    MajorWord{"AUTOPS", Major::quiet, ""},
    MajorWord{"AUXFUN", Major::not_run, for_machine},
    MajorWord{"CALL", Major::part_word, part_program},
    MajorWord{"CALSUB", Major::not_run, "subprograms of the postprocessor are not followed"},
    MajorWord{"CHANNEL", Major::not_run, for_machine},
    MajorWord{"CIRCLE", Major::circle, ""},
    MajorWord{"CLAMP", Major::not_run, for_machine},
    MajorWord{"CLEARP", Major::not_run, "a clearance plane changes where the postprocessor goes"},
    MajorWord{"CLPRNT", Major::quiet, ""},
    MajorWord{"CLRSRF", Major::not_run, "a clearance plane changes where the postprocessor goes"},
    MajorWord{"COOLNT", Major::coolant, ""},
    MajorWord{"COPY", Major::part_word, part_program},
    MajorWord{"COUPLE", Major::not_run, for_machine},
    MajorWord{"CSI_SET_EXTENSION_LENGTH", Major::quiet, ""},
    MajorWord{"CSI_SET_FLUTE_LENGTH", Major::quiet, ""},
    MajorWord{"CSYS", Major::system, ""},
    MajorWord{"CUT", Major::quiet, ""},
    MajorWord{"CUTCOM", Major::compensate, ""},
    MajorWord{"CUTTER", Major::tool_data, ""},
    MajorWord{"CYCLE", Major::cycle, ""},
    MajorWord{"DELAY", Major::delay, ""},
    MajorWord{"DISPLY", Major::quiet, ""},
    MajorWord{"DNTCUT", Major::not_run, "whether the moves behind it are made is not known"},
    MajorWord{"END", Major::end, ""},
    MajorWord{"END-OF-PATH", Major::path_end, ""},
    MajorWord{"FEDRAT", Major::feed, ""},
    MajorWord{"FINI", Major::end, ""},
    MajorWord{"FROM", Major::from, ""},
    MajorWord{"GO", Major::part_word, part_program},
    MajorWord{"GOBACK", Major::part_word, part_program},
    MajorWord{"GODLTA", Major::go_delta, ""},
    MajorWord{"GODOWN", Major::part_word, part_program},
    MajorWord{"GOFWD", Major::apt_arc, ""},
    MajorWord{"GOHOME", Major::not_run, "where the machine's home lies is not known here"},
    MajorWord{"GOLFT", Major::part_word, part_program},
    MajorWord{"GORGT", Major::part_word, part_program},
    MajorWord{"GOTO", Major::go_to, ""},
    MajorWord{"GOUP", Major::part_word, part_program},
    MajorWord{"HEAD", Major::not_run, for_machine},
    MajorWord{"HEADER", Major::text, ""},
    MajorWord{"INCLUD", Major::not_run, "the file that it names is not read"},
    MajorWord{"INDEX", Major::part_word, part_program},
    MajorWord{"INDIRP", Major::part_word, part_program},
    MajorWord{"INDIRV", Major::along, ""},
    MajorWord{"INSERT", Major::insert, ""},
    MajorWord{"INTOL", Major::quiet, ""},
    MajorWord{"LEADER", Major::quiet, ""},
    MajorWord{"LETTER", Major::text, ""},
    MajorWord{"LINTOL", Major::quiet, ""},
    MajorWord{"LOAD", Major::load, ""},
    MajorWord{"LOADTL", Major::load_tool, ""},
    MajorWord{"LOOPND", Major::part_word, part_program},
    MajorWord{"LOOPST", Major::part_word, part_program},
    MajorWord{"MACHIN", Major::quiet, ""},
    MajorWord{"MACHINE", Major::quiet, ""},
    MajorWord{"MODE", Major::mode, "how coordinates are written behind it is not known for certain"},
    MajorWord{"MOVARC", Major::not_run, "its forms differ from postprocessor to postprocessor: write CIRCLE and GOTO"},
    MajorWord{"MSYS", Major::placement, ""},
    MajorWord{"MULTAX", Major::multax, ""},
    MajorWord{"NOPOST", Major::quiet, ""},
    MajorWord{"OFSTNO", Major::not_run, "which offset of the control it takes is not followed"},
    MajorWord{"OPSKIP", Major::not_run, "whether the blocks behind it are skipped is for the operator to say"},
    MajorWord{"OPSTOP", Major::optional_stop, ""},
    MajorWord{"ORIGIN", Major::origin, ""},
    MajorWord{"OUTTOL", Major::quiet, ""},
    MajorWord{"PAINT", Major::quiet, ""},
    MajorWord{"PARTNO", Major::text, ""},
    MajorWord{"PATERN", Major::part_word, part_program},
    MajorWord{"PITCH", Major::not_run, "threads by PITCH and THREAD are not run"},
    MajorWord{"PPFUN", Major::not_run, for_post},
    MajorWord{"PPLOT", Major::quiet, ""},
    MajorWord{"PPRINT", Major::text, ""},
    MajorWord{"PREFUN", Major::not_run, for_machine},
    MajorWord{"PROBE", Major::not_run, "probing is not simulated"},
    MajorWord{"PSIS", Major::part_word, part_program},
    MajorWord{"RAPID", Major::rapid, ""},
    MajorWord{"REFSYS", Major::part_word, part_program},
    MajorWord{"REMARK", Major::text, ""},
    MajorWord{"RESET", Major::not_run, for_post},
    MajorWord{"REWIND", Major::quiet, ""},
    MajorWord{"ROTABL", Major::not_run, "a rotary table that is turned by name is not followed"},
    MajorWord{"ROTATE", Major::not_run, "a rotary axis that is turned by name is not followed"},
    MajorWord{"ROTHED", Major::not_run, "a rotary head that is turned by name is not followed"},
    MajorWord{"SADDLE", Major::not_run, for_machine},
    MajorWord{"SAFPOS", Major::not_run, "a safe height changes where the postprocessor goes"},
    MajorWord{"SELCTL", Major::quiet, ""},
    MajorWord{"SELECT", Major::quiet, ""},
    MajorWord{"SEQNO", Major::quiet, ""},
    MajorWord{"SETUP", Major::setup, ""},
    MajorWord{"SPINDL", Major::spindle, ""},
    MajorWord{"STOP", Major::stop, ""},
    MajorWord{"SWITCH", Major::not_run,
              "another tool point is compensated behind it: which one the path is of is not "
              "known here"},
    MajorWord{"SYN", Major::synonym, ""},
    MajorWord{"THICK", Major::part_word, part_program},
    MajorWord{"THREAD", Major::not_run, "threads by PITCH and THREAD are not run"},
    MajorWord{"TITLES", Major::text, ""},
    MajorWord{"TLAXIS", Major::tool_axis, ""},
    MajorWord{"TLDATA", Major::tool_data, ""},
    MajorWord{"TMARK", Major::quiet, ""},
    MajorWord{"TOLER", Major::quiet, ""},
    MajorWord{"TOOL", Major::tool_path, ""},
    MajorWord{"TOOLNO", Major::tool_kind, ""},
    MajorWord{"TPRINT", Major::text, ""},
    MajorWord{"TRACUT", Major::not_run, "moving the path by a matrix is not run"},
    MajorWord{"TRANS", Major::shift, ""},
    MajorWord{"TRNTYP", Major::transform, ""},
    MajorWord{"TURRET", Major::load_tool, ""},
    MajorWord{"UNIT", Major::units, ""},
    MajorWord{"UNITS", Major::units, ""},
    MajorWord{"ZSURF", Major::part_word, part_program},
};
static_assert(std::is_sorted(majors.begin(), majors.end(),
                             [](const MajorWord& a, const MajorWord& b) { return a.name < b.name; }));

}  // namespace

const MajorWord* find_major(std::string_view upper) {
    const auto found = std::lower_bound(majors.begin(), majors.end(), upper,
                                        [](const MajorWord& w, std::string_view name) { return w.name < name; });
    return found != majors.end() && found->name == upper ? &*found : nullptr;
}

std::string_view nearest_major(std::string_view upper) {
    constexpr std::size_t near = 2, longest = 24;
    std::string_view best;
    if (upper.size() > longest) return best;
    std::size_t least = std::min(near + 1, upper.size() / 2);
    for (const MajorWord& w : majors)
        if (const std::size_t d = base::edit_distance(upper, w.name); d < least) {
            least = d;
            best = w.name;
        }
    return best;
}

}  // namespace obrys::dialect::apt
