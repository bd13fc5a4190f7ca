#pragma once
/// What the programmer has written for people. The run needs none of it; who writes the program for another control
/// asks for it.

#include <string_view>

#include "program/unit.hpp"

namespace obrys::program {

/// How a control's programs say that a text is for people.
struct RemarkSigns {
    char to_line_end = '\0';   ///< from here to the end of the line; 0: none
    bool brackets = false;     ///< ( … )
    bool star_blocks = false;  ///< a block that begins with * is a heading
    /// Behind this sign at its end a line goes on in the next one, whose remarks are the control's own names of its
    /// parameters; 0: none.
    char goes_on = '\0';

    [[nodiscard]] bool any() const { return to_line_end != '\0' || brackets || star_blocks; }
};

/// Puts the remarks of the unit's part of the text before the statements that they stand before or beside. What a
/// statement shows to the operator itself is no remark, nor what stands between the words of a statement of several
/// lines.
void add_remarks(Unit& unit, std::string_view text, const RemarkSigns& signs);

}  // namespace obrys::program
