#pragma once
/// FANUC and Haas programs: text -> program tree. What the text leaves open (docs/dialects/fanuc.md) the caller may
/// say.

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/diagnostic.hpp"
#include "base/source.hpp"
#include "dialect/rs274/fanuc.hpp"
#include "program/names.hpp"
#include "program/unit.hpp"

namespace obrys::read::rs274 {

/// What the machine file or the command line says; the rest is taken from the text.
struct FanucOptions {
    std::optional<dialect::rs274::FanucMachine> machine{};
    dialect::rs274::GSystem system = dialect::rs274::GSystem::a;
    dialect::rs274::WholeNumbers whole_numbers = dialect::rs274::WholeNumbers::increments;
    std::optional<bool> c_axis{};      ///< of lathes: the machine has an axis C, or has none
    bool whole_numbers_known = false;  ///< somebody says so: it is no assumption
};

/// Reads one source text: a unit for each of its programs (`O1234`), the first one first; a text without program number
/// is one unit, called like the file. Errors go to `diagnostics` (codes syntax, unclosed) and spoil only their block;
/// words that are not run become problems of their unit.
[[nodiscard]] std::vector<program::Unit> read_fanuc(std::uint32_t file, const base::Sources& sources,
                                                    program::Names& names, base::Diagnostics& diagnostics,
                                                    const FanucOptions& options);
[[nodiscard]] std::vector<program::Unit> read_haas(std::uint32_t file, const base::Sources& sources,
                                                   program::Names& names, base::Diagnostics& diagnostics,
                                                   const FanucOptions& options);

/// As above with nothing said by the caller.
[[nodiscard]] std::vector<program::Unit> read_fanuc(std::uint32_t file, const base::Sources& sources,
                                                    program::Names& names, base::Diagnostics& diagnostics);
[[nodiscard]] std::vector<program::Unit> read_haas(std::uint32_t file, const base::Sources& sources,
                                                   program::Names& names, base::Diagnostics& diagnostics);

/// How likely a text is a program for the control, 0 … 100; the file name counts too.
[[nodiscard]] int fanuc_likelihood(std::string_view text, std::string_view file_name,
                                   std::vector<std::string>* signs = nullptr);
[[nodiscard]] int haas_likelihood(std::string_view text, std::string_view file_name,
                                  std::vector<std::string>* signs = nullptr);

/// The kind of machine that a program is for, by its words; a mill where nothing speaks for a lathe.
struct MachineByText {
    dialect::rs274::FanucMachine machine = dialect::rs274::FanucMachine::mill;
    program::MachineSigns signs;
};
/// `file`: number of the text among the sources, for the places of the signs.
[[nodiscard]] MachineByText guess_machine(std::string_view text, std::uint32_t file = 0);

}  // namespace obrys::read::rs274
