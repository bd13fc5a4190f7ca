#pragma once
/// A run made step by step, which can be copied between two steps: for debuggers, and for whoever tries what would
/// come.

#include <memory>

#include "interp/heard.hpp"
#include "interp/interp.hpp"

namespace obrys::interp {

class Machine {
public:
    /// `main` and the environment must outlive it. `listener` hears what the control is told; nothing: nobody listens.
    Machine(const program::Unit& main, const Environment& environment, cl::CallStacks& stacks, cl::Sink sink,
            base::Diagnostics& diagnostics, std::optional<Listener> listener = {});
    /// Goes on from where `other` stands; neither knows of the other from there on, nobody listens. `stacks` begin as a
    /// copy of the other's. What the control keeps outside of the run (tables of Environment::files, printed texts) is
    /// not copied. Both use the environment's names and programs, which grow: they belong to one thread.
    Machine(const Machine& other, cl::CallStacks& stacks, cl::Sink sink, base::Diagnostics& diagnostics);
    ~Machine();
    Machine(const Machine&) = delete;
    Machine& operator=(const Machine&) = delete;

    /// Makes the next statement; false where the run has ended.
    bool step();
    [[nodiscard]] bool ended() const;
    /// The statement that step() makes next, as far as it is known beforehand; nothing where the run has ended.
    [[nodiscard]] std::optional<base::Span> next() const;
    /// Hands out what is held back and sums up. To be called once, when the run has ended or is given up.
    [[nodiscard]] Outcome finish();

private:
    std::unique_ptr<struct Run> run_;
    const program::Unit& main_;
};

/// Runs `main` and passes every record to `sink`. Complaints, assumptions and ignored words go to `diagnostics`.
Outcome run(const program::Unit& main, const Environment& environment, cl::CallStacks& stacks, cl::Sink sink,
            base::Diagnostics& diagnostics);

}  // namespace obrys::interp
