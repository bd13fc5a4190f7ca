#pragma once
/// Programs that stand in the main program's file: which of them the job names, and which were never run.

#include <string_view>
#include <vector>

#include "base/diagnostic.hpp"
#include "program/names.hpp"
#include "program/unit.hpp"

namespace obrys::driver {

/// "O2", "o0002" and "2" all name the program O2.
[[nodiscard]] bool is_called(const program::Unit& unit, std::string_view written);

/// Those that were run, and what their calls lead to, taken or not.
[[nodiscard]] std::vector<const program::Unit*> led_to(const std::vector<const program::Unit*>& in_file,
                                                       std::vector<const program::Unit*> entered,
                                                       const program::Names& names);
/// Complains about those that could be started (program::Unit::startable), or about all, of which nothing was run.
void say_what_was_not_run(const std::vector<const program::Unit*>& in_file,
                          const std::vector<const program::Unit*>& entered, bool all, base::Diagnostics& diagnostics);
/// With what they end.
/// Blocks that the control never runs, either: nothing calls them, or the program ends before them.
[[nodiscard]] bool is_of_no_run(const base::Diagnostic&);

inline constexpr std::string_view nothing_calls_it = " was never run: nothing that was run calls it";
/// A file of subprograms: the main program that stands around them called none and goes nowhere itself.
[[nodiscard]] bool holds_subprograms_alone(const std::vector<const program::Unit*>& in_file,
                                           const std::vector<const program::Unit*>& entered, const program::Unit& main);

/// A program without a move, translated or compared: what it leaves in force for the one that calls it is not looked
/// at.
void say_that_nothing_moves(base::Diagnostics& diagnostics, const program::Unit* main);

}  // namespace obrys::driver
