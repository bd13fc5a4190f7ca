#pragma once
/// Runs a program tree: values, flow, frames, modal state and calls become the CL stream.
/// What the control would stop at ends the run with a diagnostic; what obrys does not know is reported and stepped
/// over.

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "base/diagnostic.hpp"
#include "base/function_ref.hpp"
#include "cl/record.hpp"
#include "cl/stacks.hpp"
#include "interp/shop_files.hpp"
#include "program/unit.hpp"
#include "shop/job.hpp"

namespace obrys::interp {

/// Everything a run needs besides the program. References must outlive the run.
struct Environment {
    const base::Sources& sources;
    program::Names& names;
    const shop::Machine& machine;
    const std::vector<shop::Tool>& tools;
    const std::vector<shop::Override>& overrides;
    const shop::Budgets& budgets;
    const std::vector<int>& skip_levels;
    /// The program of that name (upper case, without suffix), or null.
    base::FunctionRef<const program::Unit*(std::string_view)> find_program;
    /// Units whose definitions hold for all programs (global user data).
    const std::vector<const program::Unit*>& definitions;
    /// What the control's variables hold before the run, as far as the job says it.
    const shop::GivenValues& variables;
    /// Tables and forms that the program reads, and what it prints; null: there are none.
    ShopFiles* files = nullptr;
    /// LinuxCNC's interpreter by itself (rs274): what nobody gives it has as it is delivered (parameters 0, no tool in
    /// the spindle, axes X Y Z A B C), and there is no machine, tool or workpiece that could be otherwise.
    bool stand_alone = false;
    /// Where the machine stands at first, machine coordinates; nothing: not known.
    std::optional<geom::Vec3> start{};
    /// What the control's numbered parameters hold before the run; null: not known.
    const std::map<std::uint32_t, double>* stored = nullptr;
    /// mm of a length of 1 in those parameters that hold machine coordinates.
    double machine_unit = 1;
    /// Settings of the control by section and key, upper case: "RS274NGC/FEATURES".
    const std::map<std::string, std::string>* settings = nullptr;
    /// Where called programs are looked for, as part of a sentence: "sub (.ngc, .nc)"; empty: nowhere to speak of.
    std::string searched{};
    /// Reads a text as a program of the control (EXECSTRING); null: there are none.
    const std::function<const program::Unit*(const std::string& text)>* read_text = nullptr;
    /// mm by which the path may differ from the programmed one before it is said.
    double contour_tolerance = 0.001;
    /// Backups of the control's variables: their assignments give values; `variables` stands above them.
    const std::vector<const program::Unit*>* backups = nullptr;
    shop::ToolLengths tool_lengths = shop::ToolLengths::not_said;
    /// Number of the tool in use when the program begins; 0: not known.
    std::uint32_t first_tool = 0;
    /// Where the file of the machine gives no home of X, Y or Z, machine coordinate 0 is taken for it (shop::home_of).
    bool homes_at_zero = false;
    /// For tests: statements that are looked at before every statement that is run, without a trace.
    std::uint32_t looked_ahead_in_vain = 0;
};

enum class Ending : std::uint8_t {
    regular,  ///< M30, M2, M17 or RET of the main program, or its last block
    alarm,    ///< the control would stop here
    budget,   ///< ended by a limit
};

/// A numbered parameter and its value at the end of the run.
struct ParameterValue {
    std::string name;  ///< as the control names it: "R5", "Q12"
    double value = 0;
};

/// Radius compensation that was in force while the tool was changed, in the order of the text.
struct CarriedCompensation {
    base::Span change;
    std::uint32_t until = 0xFFFFFFFF;  ///< byte of the file at which it ends
    std::string word;                  ///< "G42 of N150"
};

struct Outcome {
    Ending ending = Ending::regular;
    std::uint64_t blocks_executed = 0;
    std::vector<ParameterValue> parameters;     ///< those that were assigned
    std::vector<const program::Unit*> entered;  ///< programs of which something was run, the main one's too
    std::set<std::string> replaced;             ///< names of which Environment::overrides replaced a constant
    std::uint64_t statements = 0;               ///< gone through, those that were looked at ahead as well
    std::vector<CarriedCompensation> carried = {};
    bool repeats = false;            ///< the main program begins anew, without end (M99): one pass of it was run
    std::uint32_t repeats_from = 0;  ///< byte of its text where the next pass begins (M99 P)
};

}  // namespace obrys::interp
