#pragma once
/// The statements of APT cutter-location text: what the word before the slash means. docs/dialects/apt-cl.md.
/// Sources: the words of the corpus; Dassault, "Syntaxes Interpreted by APT Import" (CATIA V5, Manufacturing
/// Infrastructure User's Guide); ICAM, "Post-Processor Vocabulary"; CGTech, "Supported APT-CLS NC Program Records".

#include <cstdint>
#include <string_view>

namespace obrys::dialect::apt {

enum class Major : std::uint8_t {
    go_to,       ///< GOTO: a straight move, or the end of the arc before it
    from,        ///< FROM: where the tool stands
    go_delta,    ///< GODLTA
    circle,      ///< CIRCLE: centre and axis of the arc to the next point
    along,       ///< INDIRV: the direction in which an arc begins
    apt_arc,     ///< TLON,GOFWD/(CIRCLE/…),ON,(LINE/…)
    rapid,       ///< RAPID: the next point at rapid
    feed,        ///< FEDRAT
    spindle,     ///< SPINDL
    load_tool,   ///< LOADTL, TURRET
    load,        ///< LOAD/TOOL
    tool_data,   ///< CUTTER, TLDATA
    tool_kind,   ///< TOOLNO: a tool for turning, or its number
    coolant,     ///< COOLNT
    compensate,  ///< CUTCOM
    cycle,       ///< CYCLE
    tool_axis,   ///< TLAXIS
    multax,      ///< MULTAX
    delay,       ///< DELAY
    stop,
    optional_stop,
    end,        ///< END, FINI: nothing behind it is run
    text,       ///< a note: the whole line
    insert,     ///< INSERT: the line goes to the control as it stands
    shift,      ///< TRANS
    origin,     ///< ORIGIN
    units,      ///< UNITS, UNIT
    system,     ///< CSYS: where the tool's axis lies from here on
    placement,  ///< MSYS: where the machine's zero lies in the part
    transform,  ///< TRNTYP: in which system points are written
    setup,      ///< SETUP: the part is clamped anew
    synonym,    ///< SYN
    mode,       ///< MODE
    quiet,      ///< no effect on the path: listed
    tool_path,  ///< TOOL PATH: an operation begins (NX)
    path_end,   ///< END-OF-PATH: an operation ends (NX)
    part_word,  ///< of APT part programs, which a processor turns into cutter locations
    not_run,
};

struct MajorWord {
    std::string_view name;
    Major major = Major::not_run;
    std::string_view note;  ///< why it is not run, what it does without effect on the path
};
/// Null: none of the known ones. `upper` without blanks.
[[nodiscard]] const MajorWord* find_major(std::string_view upper);
/// The known word that is spelt most like it; empty: none is near.
[[nodiscard]] std::string_view nearest_major(std::string_view upper);
/// The rest of the line is text, blanks and all, and needs no slash before it.
[[nodiscard]] constexpr bool is_text(Major m) { return m == Major::text || m == Major::insert; }

}  // namespace obrys::dialect::apt
