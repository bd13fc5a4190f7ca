#pragma once
/// The programs that a run is in, innermost last, and their variables: values only. Private to interp.

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "cl/record.hpp"
#include "geom/vec.hpp"
#include "interp/modes.hpp"
#include "interp/variables.hpp"
#include "program/unit.hpp"

namespace obrys::interp {

using program::Unit;

/// A section being repeated (REPEAT label label P=n).
struct ActiveSection {
    std::uint32_t first = 0, last = 0, back = 0;
    std::uint64_t left = 0;
    std::uint64_t pass = 1, passes = 1;             ///< the first was run before, where it is repeated
    std::string name{};                             ///< of its label; empty: it has none
    const program::Statement* finishing = nullptr;  ///< the cycle whose contour it is; null: it is repeated only
    geom::Vec3 start{};                             ///< where that cycle began, programmed frame
};

/// CALL LBL being run.
struct LabelReturn {
    std::uint32_t pc = 0;   ///< where the run goes on
    cl::StackId stack = 0;  ///< of the caller
};

/// One program being run.
struct Activation {
    const Unit* unit = nullptr;
    std::uint32_t pc = 0;
    cl::StackId stack = 0;
    Scope locals;
    struct Counter {
        std::uint32_t statement = 0;
        std::uint64_t left = 0;
    };
    std::vector<Counter> counters;             ///< of repeat_count loops that are being run
    std::vector<std::uint32_t> unknown_loops;  ///< FOR statements whose passes were said not to be known: run once
    struct Passes {
        std::uint32_t statement = 0, target = 0;
        std::uint64_t count = 0;
    };
    std::vector<Passes> passes;  ///< of every backward branch taken, by its statement
    std::vector<ActiveSection> sections;
    std::vector<LabelReturn> labels;
    std::vector<std::uint32_t> ended_labels;               ///< LBL 0 with which calls of this run have ended
    std::vector<std::pair<double, bool>> outer_locals;     ///< the caller's local parameters, and whether they are set
    std::vector<std::pair<double, bool>> outer_arguments;  ///< the same of Traits::argument_parameters
    std::optional<SavedModes> saved_modes;                 ///< M70, M73
    bool restores_modes = false;                           ///< M73: they come back with the return
    std::uint32_t entry = 0;                               ///< statement with which every run of it begins
    std::uint64_t repeats = 0;                             ///< of L123 P3: further runs
    std::uint64_t repeats_left = 0;                        ///< of them
    std::size_t own_bindings = 0;             ///< bindings that are parameters; the rest goes with each run
    std::uint32_t arguments_given = 0;        ///< bit per parameter, for $P_SUBPAR
    std::vector<cl::PartArgument> arguments;  ///< those that the call gives, for the stream
    bool from_modal_call = false;
    bool is_text = false;         ///< of EXECSTRING: a block, not a program
    bool is_piece = false;        ///< … of the program below, read anew (read_again.cpp)
    std::uint32_t mode_span = 0;  ///< in Unit::modes: where the run is about
    bool saves = false;
    ModalState saved;
};

/// The calls under way, and what their variables and the global ones hold. A copy has variables of its own: those that
/// calls share (VAR arguments) they share in the copy, too.
struct CallState {
    std::vector<Activation> calls;
    Scope globals;

    CallState() = default;
    CallState(const CallState& other) : calls(other.calls), globals(other.globals) { have_own_variables(); }
    CallState(CallState&&) noexcept = default;
    CallState& operator=(const CallState& other) {
        if (this == &other) return *this;
        calls = other.calls;
        globals = other.globals;
        have_own_variables();
        return *this;
    }
    CallState& operator=(CallState&&) noexcept = default;
    ~CallState() = default;

private:
    void have_own_variables();  // call_state.cpp
};

}  // namespace obrys::interp
