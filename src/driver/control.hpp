#pragma once
/// The controls whose programs can be read, one entry each: this table is all that ties a reader to the rest.

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/diagnostic.hpp"
#include "program/names.hpp"
#include "program/remarks.hpp"
#include "program/unit.hpp"
#include "shop/machine.hpp"

namespace obrys::driver {

/// One way of writing programs for a control.
struct Language {
    base::BlockNumbers numbers = base::BlockNumbers::none;
    /// `machine`: the one the program is for, where somebody says it; else null.
    std::vector<program::Unit> (*read)(std::uint32_t file, const base::Sources&, program::Names&, base::Diagnostics&,
                                       const shop::Machine* machine);
    /// 0 to 100; `signs`, where it is not null, gets the words of the text that speak for it.
    int (*likelihood)(std::string_view text, std::string_view file_name, std::vector<std::string>* signs);
    program::RemarkSigns remarks{};  ///< none where the reader itself puts them into the tree
};

struct Control {
    std::string_view name;  ///< of --control and of the job's `control`
    std::span<const Language> languages;
    /// Upper case, with the point. Subprograms are looked for in this order where two files have one name and the call
    /// does not name the suffix.
    std::span<const std::string_view> program_suffixes, definition_suffixes;
    /// File that holds the called program, upper case, without suffix, for programs that are not called by the name of
    /// their file ("O<FOO>": FOO); null: they are. A file of the program's own name counts where there is none such.
    std::string (*file_stem)(std::string_view program) = nullptr;
    /// Lengths without a point may be least input increments (X100 is 0.1 mm), and X of a lathe is a diameter from the
    /// start.
    bool counts_increments = false;
    /// Until the program says otherwise moves are joined as far as speed needs (G64).
    bool joins_freely = false;
    /// Among the files with a definition suffix: one of the control's. Null: all are.
    bool (*is_definition)(std::string_view text, std::string_view upper_name) = nullptr;
    /// The tool table that its stand-alone interpreter takes where it is given none; empty: there is no such.
    std::string_view interpreter_tools{};
    /// In capitals: one of the control's own words, which cannot name a label, a program or a variable. Null: its names
    /// stand where no word can.
    bool (*is_word)(std::string_view upper) = nullptr;
};
/// The language in which the text is most likely written; the first one where nothing says so.
[[nodiscard]] const Language& language_of(const Control& control, std::string_view text, std::string_view file_name);

[[nodiscard]] std::span<const Control> all_controls();
[[nodiscard]] const Control* find_control(std::string_view name);

struct Guess {
    const Control* control = nullptr;
    int likelihood = 0;
    std::vector<std::string> signs;  ///< words of the text that speak for it; empty: nothing but the form of the lines
    const Control* next = nullptr;   ///< the second best
    int next_likelihood = 0;
    bool by_suffix = false;  ///< the file's name says it
    /// Where the second best cannot be ruled out and would read a number as another length: what it is, with the
    /// number.
    std::string difference;
    std::string foreign;  ///< a control that cannot be read and whose words stand in the text; empty: none
};
/// The control for which the text was most likely written. `turns`: whether the machine is a lathe, where that is
/// known.
[[nodiscard]] Guess guess_control(std::string_view text, std::string_view file_name, std::optional<bool> turns = {});

}  // namespace obrys::driver
