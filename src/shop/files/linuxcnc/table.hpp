#pragma once
/// The tool table of LinuxCNC (`tool.tbl`), read and written. A line is a tool: `T1 P1 D6.0 Z-20.5 ; slot drill`.
///
/// Words may stand in any order; T (tool number) and P (pocket) are needed. X Y Z A B C U V W are the tool's offsets, D
/// is its diameter (of a lathe tool: of the nose, 2 r), I and J the front and back angle in degrees, Q the orientation
/// of a lathe tool, 0 to 9. Lengths are in the machine's unit ([TRAJ]LINEAR_UNITS); the file does not say which. A
/// comment goes from `;` to the end of the line. Only blanks part words: LinuxCNC 2.9 overlooks what follows a tab.
/// Older files have columns: tool, pocket, length, diameter, comment (mills), or tool, pocket, Z, X, diameter, front
/// angle, back angle, orientation, comment (lathes); LinuxCNC up to 2.8 takes them, 2.9 does not.
///
/// As LinuxCNC 2.9 does, a line with a mistake is passed over, as is one without P (it never comes into the control's
/// list); of two lines with one tool number the first counts (measured with its `rs274`). Unlike it, a number with
/// something behind it is a mistake. Everything is kept as it was read: `write(read(text)) == text`.
/// Sources: LinuxCNC documentation 2.9, "Tool Table", "Lathe User Information"; behaviour of `rs274` 2.9.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "shop/tool.hpp"

namespace obrys::shop {

/// A number of a line: where it stands in the line's text, without its letter, and its value in the table's unit.
struct LinuxcncField {
    char letter = 0;  ///< capital; also in files with columns
    std::uint32_t begin = 0, end = 0;
    double value = 0;
};

struct LinuxcncLine {
    enum class Form : std::uint8_t {
        none,     ///< empty, a comment, a header, or not understood
        words,    ///< T1 P1 …
        columns,  ///< of a file of LinuxCNC before 2.4
    };
    std::string text;                   ///< without its line end
    std::string line_end;               ///< "\r\n", "\n", "\r" or, at the end of the text, nothing
    std::uint32_t at = no_place;        ///< where the line begins in the file; `no_place` where it was added
    Form form = Form::none;             ///< other than `none`: a tool, with T and P
    std::vector<LinuxcncField> fields;  ///< in the order of the line; of a line not understood those that can be read
    std::uint32_t comment = 0;          ///< where the comment's text begins; the line's length where there is none

    static constexpr std::uint32_t no_place = 0xFFFFFFFF;
};

struct LinuxcncTable {
    std::uint32_t file = 0;
    std::vector<LinuxcncLine> lines;
};

/// Reads the text. Reported with its place, the line then passed over: an unknown letter, a word that is no number, a T
/// P or Q that is no whole number, a missing T or P. As a warning: a letter twice (the last counts), a tool number
/// twice (the first line counts), a line in columns, a tab between words (which is read as a blank).
[[nodiscard]] LinuxcncTable read_linuxcnc_table(std::uint32_t file, const base::Sources& sources,
                                                base::Diagnostics& diagnostics);
/// The table as text: what was read byte for byte, but for values that were set and lines that were added.
[[nodiscard]] std::string write_linuxcnc_table(const LinuxcncTable& table);

/// Value of a word of a line; nothing where the line does not have it.
[[nodiscard]] std::optional<double> value_of(const LinuxcncLine& line, char letter);
/// Text of a line's comment without blanks around it, as UTF-8.
[[nodiscard]] std::string comment_of(const LinuxcncLine& line);
/// Index of the line that counts for a tool number.
[[nodiscard]] std::optional<std::size_t> find_line(const LinuxcncTable& table, std::int64_t number);

/// Sets a word of a tool's line in the table's unit: in its place, or behind the last word. Nothing else of the line
/// changes. Gives what is wrong, and changes nothing, where the letter is none of the table, the value is not finite or
/// not whole (T P Q), the line is no tool or its columns have no place for the letter.
[[nodiscard]] std::optional<std::string> set_field(LinuxcncTable& table, std::size_t line, char letter, double value);
/// Adds a line `T<number> P<pocket>` behind the last tool; gives what is wrong where the tool is already there.
[[nodiscard]] std::optional<std::string> add_tool(LinuxcncTable& table, std::int64_t number, std::int64_t pocket);

/// The tools, lengths converted to mm (`mm_per_unit`: 1 or 25.4). T0 and the second line of one number are left out.
/// With Q 1 to 9 a tool is a turning insert of nose radius D/2: its orientation is counted as shop/tool.hpp does, tip
/// and entering angle follow from I and J where they make an insert, else they are assumed (`Tool::assumed`). Other
/// tools have the radius D/2, the length Z and the kind that the comment plainly names ("1/4 end mill", "ball nose",
/// "spot drill"), else `other`; a drill's point angle is assumed. The name is the comment. A Q outside 0 to 9 is
/// reported and taken as 0.
[[nodiscard]] std::vector<Tool> tools_of(const LinuxcncTable& table, double mm_per_unit,
                                         base::Diagnostics& diagnostics);

/// read_linuxcnc_table and tools_of in one.
[[nodiscard]] std::vector<Tool> read_tbl(std::uint32_t file, const base::Sources& sources, double mm_per_unit,
                                         base::Diagnostics& diagnostics);

}  // namespace obrys::shop
