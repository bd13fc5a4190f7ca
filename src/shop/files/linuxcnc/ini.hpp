#pragma once
/// The configuration of a LinuxCNC machine (`machine.ini`): what a run of a program needs of it, and any key for
/// `#<_ini[section]key>`.
///
/// Form: `[SECTION]` lines, `KEY = value` lines, comments with `#` or `;` in front. A line that ends with `\` goes on
/// in the next. A value is the rest of its line without the blanks around it, a `#` or `;` in it included. As
/// LinuxCNC 2.9 looks it up (measured with its `rs274`): capitals matter, the first section of a name is the only one
/// that is seen, in it the first line of a key. Sources: LinuxCNC documentation 2.9, "INI Configuration", "Parameters
/// (INI)".

#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/diagnostic.hpp"
#include "base/source.hpp"

namespace obrys::shop {

struct IniEntry {
    std::string section, key;
    std::string value;  ///< UTF-8, without blanks around it
    base::Span where;   ///< the value; where it is empty, behind the `=`
};

struct LinuxcncIni {
    std::uint32_t file = 0;
    std::vector<IniEntry> entries;  ///< as found by a look-up: none of a second section of the same name
};

/// Reads the text. As warnings: a line that is no section, key or comment; a section that is there twice.
[[nodiscard]] LinuxcncIni read_linuxcnc_ini(std::uint32_t file, const base::Sources& sources,
                                            base::Diagnostics& diagnostics);

/// Value of a key; nothing where it is not there. `which` counts lines of the same key from 0.
[[nodiscard]] const IniEntry* find(const LinuxcncIni& ini, std::string_view section, std::string_view key,
                                   std::size_t which = 0);
/// What `#<_ini[section]key>` gives: section and key are taken in capitals; nothing where the key is not there or its
/// value is no number as a whole (the control then says so).
[[nodiscard]] std::optional<double> ini_number(const LinuxcncIni& ini, std::string_view section, std::string_view key);

/// Travel of an axis: [AXIS_X] MIN_LIMIT, MAX_LIMIT, MAX_VELOCITY; mm and mm/s, rotary axes degrees. NaN: not said.
struct IniAxis {
    char letter = 0;
    double low = std::numeric_limits<double>::quiet_NaN(), high = std::numeric_limits<double>::quiet_NaN();
    double max_velocity = std::numeric_limits<double>::quiet_NaN();
};

/// What a run needs. Files and folders as written; the driver finds them.
struct LinuxcncSettings {
    double mm_per_unit = 1;            ///< [TRAJ]LINEAR_UNITS: 1 or 25.4; of tool table, parameter file and limits
    std::string tool_table;            ///< [EMCIO]TOOL_TABLE
    bool random_tool_changer = false;  ///< [EMCIO]RANDOM_TOOLCHANGER
    bool spindle_goes_on = false;      ///< [EMCIO]TOOL_CHANGE_WITH_SPINDLE_ON
    std::string parameter_file;        ///< [RS274NGC]PARAMETER_FILE
    std::string startup_code;          ///< [RS274NGC]RS274NGC_STARTUP_CODE, else [EMC]
    std::string program_prefix;        ///< [DISPLAY]PROGRAM_PREFIX: folder of programs and of o-word files
    std::vector<std::string> subroutine_path;  ///< [RS274NGC]SUBROUTINE_PATH, folders parted by `:`, sought in order
    bool fanuc_subprograms = true;             ///< not [RS274NGC]DISABLE_FANUC_STYLE_SUB
    // Keys of [RS274NGC] of the same name, 0 or 1. A key that is not there counts as its bit of FEATURES (LinuxCNC
    // before 2.9), and without that as said here.
    bool retain_g43 = false;         ///< tool length offset stays when the tool is put back (bit 1)
    bool oword_nargs = false;        ///< #<n_args> in subprograms (bit 2)
    bool ini_vars = true;            ///< #<_ini[section]key> (bit 4)
    bool hal_pin_vars = true;        ///< #<_hal[pin]> (bit 8)
    bool no_downcase_oword = false;  ///< o-word names keep their capitals (bit 16)
    bool oword_warnonly = false;     ///< an o-word call that fails is a warning only (bit 32)
    bool g92_stays = true;           ///< not DISABLE_G92_PERSISTENCE: G92 offsets outlive the run
    /// By how much the radii of an arc's ends may differ, in the unit of the program (G21 mm, G20 inch), beside 0.1 %
    /// of the radius: [RS274NGC]CENTER_ARC_RADIUS_TOLERANCE_MM and _INCH, not below 0.001 mm and 0.00004 inch.
    double arc_tolerance_mm = 0.02 * 1.4142135623730951, arc_tolerance_inch = 0.002 * 1.4142135623730951;
    std::vector<IniAxis> axes;  ///< of the sections [AXIS_X] … [AXIS_W] that are there
};

/// The settings; reported with its place and taken as not said: a value that is no number, switch (0, 1, YES, NO, TRUE,
/// FALSE, ON, OFF) or unit (mm, metric, in, inch, imperial, or units per mm). Without LINEAR_UNITS mm is assumed
/// (note).
[[nodiscard]] LinuxcncSettings settings_of(const LinuxcncIni& ini, base::Diagnostics& diagnostics);

}  // namespace obrys::shop
