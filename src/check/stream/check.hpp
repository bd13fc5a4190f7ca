#pragma once
/// The check: takes the CL stream record by record, removes the stock, holds every move to part, allowance and machine.
/// Memory does not grow with the number of moves unless Setup::keep_moves asks for it.

#include <memory>

#include "check/result.hpp"
#include "check/setup.hpp"
#include "cl/record.hpp"
#include "cl/stacks.hpp"

namespace obrys::check {

class Check {
public:
    /// `stacks` must hold the stacks of the records when they are taken.
    Check(Setup setup, const cl::CallStacks& stacks);
    ~Check();
    Check(Check&&) noexcept;
    Check& operator=(Check&&) noexcept;

    void take(const cl::Record& record);
    void operator()(const cl::Record& record) { take(record); }
    /// Rest material and figures. To be called once, after the last record.
    /// `whole`: the program was run to its end. Else what is left is no fault of what was run.
    [[nodiscard]] Result finish(bool whole = true);
    [[nodiscard]] const Setup& setup() const;

private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace obrys::check
