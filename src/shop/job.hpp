#pragma once
/// A job: the program and everything in the shop that its check needs. File format: docs/job-file.md.

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "base/diagnostic.hpp"
#include "base/source.hpp"
#include "geom/contour.hpp"
#include "shop/given.hpp"
#include "shop/machine.hpp"
#include "shop/solid.hpp"
#include "shop/tool.hpp"

namespace obrys::shop {

/// A profile in the (z, x) plane, x a radius, mm. `region` is already closed to the axis where it has to be.
struct Profile {
    geom::Region region;
    geom::Contour drawn;  ///< as given, for pictures
    base::Span where;
};

/// A value given for a parameter: replaces every constant assignment of it in the program.
struct Override {
    std::string name;  ///< upper case: "R3"
    double value = 0;
    base::Span where;  ///< file 0xFFFFFFFF when it came from the command line
};

/// A file that a job names.
struct NamedFile {
    std::string path;  ///< as written
    base::Span where;
};

/// Where the part's contour comes from when it is not written as points.
struct ProfileFromProgram {
    std::string program;  ///< path as written
    base::Span where;
};

/// Difference between the finished part and what this program must leave.
struct Allowance {
    std::optional<Profile> profile;  ///< own contour
    std::optional<ProfileFromProgram> program;
    double normal = 0;  ///< mm, normal to the part's contour
};

/// mm; a simulation that may leave the true surface by more than this sees no tool.
inline constexpr double largest_tolerance = 1;

/// Thresholds of the check, mm. Amounts at or below them are not findings.
struct Tolerances {
    double gouge = 0.001;
    double rest_material = 0.01;
    double rapid = 0.001;
    std::optional<double> simulation;  ///< deviation of the simulated milled surface; not said: --tolerance
};

/// What a check is asked for. Within a smaller one less has to be known, and the verdict says which it was.
enum class Scope : std::uint8_t {
    all,
    part,        ///< the part's shape: gouges, allowance, rest material, and the control's alarms
    collisions,  ///< everything but the part's shape: no part is needed
    motion,      ///< alarms, travel, feed, spindle, tools: neither stock nor part is needed
};
[[nodiscard]] std::string_view name(Scope scope);
[[nodiscard]] std::optional<Scope> scope_named(std::string_view name);
[[nodiscard]] constexpr bool judges_part(Scope scope) { return scope == Scope::all || scope == Scope::part; }

/// Limits that end a run that would not end by itself.
struct Budgets {
    std::uint64_t blocks = 50'000'000;
    std::uint64_t loop_passes = 10'000'000;
    std::uint32_t call_depth = 16;              ///< program levels, the main program's included (SINUMERIK 840D sl: 16)
    std::uint64_t simulated_moves = 4'000'000;  ///< some 0.5 kB of memory each
    double seconds = 60;
    bool bounds_loops = false;  ///< the job says `loop_passes`
    bool bounds_check = false;  ///< the job says `seconds`: they hold for the check, too, which has no end of its own
};

/// What a job says instead of its machine; empty: as the machine has it.
struct DefaultsOverride {
    std::optional<bool> diameter_programming, inch, feed_per_rev;
    std::optional<int> plane;
    std::optional<double> circle_tolerance;
};

/// How the zero offsets and the lengths of the tools belong together, where a program moves without compensating the
/// length of its tool; docs/adr/0016-tool-length.md.
enum class ToolLengths : std::uint8_t {
    not_said,
    touched_off,  ///< the zero was set with the tool that works in it first
    at_change,    ///< every tool's length is taken at its change, by the machine or by hand
    gauge,        ///< the zero counts from the gauge point of the spindle
};

struct Job {
    std::string program;  ///< path as written, relative to the job file; empty: not said
    std::string start;    ///< program of that file with which the run begins; empty: its first
    base::Span start_where;
    std::string control;  ///< empty: found from the content
    base::Span control_where, prints_where;
    std::string machine_name;      ///< shipped name or path; empty: generic for what the program is
    bool machine_is_file = false;  ///< machine_name is a path: the driver reads it, then `use_machine`
    base::Span machine_where;
    Machine machine;  ///< with `defaults` and `datums` of the job already in it
    DefaultsOverride defaults;
    std::map<std::uint32_t, geom::Vec3> datums;  ///< of the job itself; mm, x as a radius
    std::vector<Tool> tools;
    std::uint32_t first_tool = 0;       ///< number of the tool in use when the program begins; 0: not said
    std::vector<NamedFile> tool_files;  ///< docs/job-file.md names the kinds
    std::optional<Profile> stock;
    std::optional<Profile> part;
    std::optional<ProfileFromProgram> part_program;
    std::optional<Stock> solid_stock;  ///< of milling; never beside `stock`
    std::optional<Part> solid_part;    ///< of milling; never beside `part` or `part_program`
    std::vector<Clamp> clamps;
    std::optional<Allowance> allowance;
    std::vector<Override> overrides;
    std::vector<NamedFile> search;           ///< folders for subprograms
    std::vector<NamedFile> datum_tables;     ///< .D; the first is in use until one is selected
    std::vector<NamedFile> preset_tables;    ///< .PR; [datum] stands above them
    std::string prints;                      ///< folder for what programs print; empty: nowhere
    std::vector<int> skip_levels;            ///< block skip levels that are on
    GivenValues variables;                   ///< what no program at hand sets: GUD, #500, $A_IN[1] …
    std::vector<NamedFile> variables_files;  ///< backups of the control's variables
    Tolerances tolerances;
    Scope scope = Scope::all;
    Budgets budgets;
    ToolLengths tool_lengths = ToolLengths::not_said;
    base::Span program_where;
};

void apply_defaults(const DefaultsOverride& from, ControlDefaults& to);
/// Puts a machine into the job, with the job's own defaults and datums on top.
void use_machine(Job& job, Machine machine);

}  // namespace obrys::shop
