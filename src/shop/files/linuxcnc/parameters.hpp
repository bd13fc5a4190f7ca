#pragma once
/// The parameter file of LinuxCNC (`rs274ngc.var`): values of #1 … #5601 that outlive a run, read and written.
///
/// A line is a number, blanks or a tab, a value: `5221<TAB>10.000000`; what follows is overlooked. Numbers ascend.
/// Lengths are in the machine's unit ([TRAJ]LINEAR_UNITS). What the control does (LinuxCNC documentation, "Parameters";
/// behaviour of `rs274` 2.9): it refuses a file whose numbers do not ascend or leave 1 … 5601; lines of another form
/// are passed over without a word. At the end of a run it renames the file to `….bak` and writes it anew with the
/// numbers that were in it and those it needs (`needed_parameters`), six decimals each, so comments are lost; a needed
/// number that the file lacks counts as 0. Numbers above 5400 are set by the control itself, whatever the file says.

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "base/diagnostic.hpp"
#include "base/source.hpp"

namespace obrys::shop {

struct LinuxcncParameter {
    std::string text;             ///< the line without its end
    std::string line_end;         ///< "\r\n", "\n", "\r" or, at the end of the text, nothing
    std::uint32_t at = no_place;  ///< where the line begins in the file; `no_place` where it was added
    int number = 0;               ///< 0: no parameter (empty, a comment, not understood)
    double value = 0;
    std::uint32_t begin = 0, end = 0;  ///< the value in `text`

    static constexpr std::uint32_t no_place = 0xFFFFFFFF;
};

struct LinuxcncParameters {
    std::uint32_t file = 0;
    std::vector<LinuxcncParameter> lines;
};

constexpr int last_linuxcnc_parameter = 5601;

/// Reads the text. Reported with its place: a number out of range or not above the one before (the line does not
/// count), as a warning a line that is neither empty, a comment (`;`, `#`, `(` in front) nor a parameter, and as a note
/// that needed parameters are missing.
[[nodiscard]] LinuxcncParameters read_linuxcnc_parameters(std::uint32_t file, const base::Sources& sources,
                                                          base::Diagnostics& diagnostics);
/// The file as text: what was read byte for byte, but for values that were set.
[[nodiscard]] std::string write_linuxcnc_parameters(const LinuxcncParameters& parameters);

/// Value of a parameter; nothing where the file does not have it.
[[nodiscard]] std::optional<double> value_of(const LinuxcncParameters& parameters, int number);
/// All of them by number.
[[nodiscard]] std::map<int, double> values_of(const LinuxcncParameters& parameters);
/// Sets a parameter: in its line, with six decimals as the control writes, or in a new line at its place. Gives what is
/// wrong, and changes nothing, where the number is out of range or the value not finite.
[[nodiscard]] std::optional<std::string> set_parameter(LinuxcncParameters& parameters, int number, double value);

/// The numbers that the control needs, ascending: #5161-5169 and #5181-5189 (G28, G30), #5210-5219 (G92 and whether it
/// is on), #5220 (coordinate system, 1 for G54), #5221-5230, #5241-5250, … #5381-5390 (G54 … G59.3: X Y Z A B C U V W
/// and rotation).
[[nodiscard]] const std::vector<int>& needed_parameters();

}  // namespace obrys::shop
