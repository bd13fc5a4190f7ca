#pragma once
/// The check: takes the CL stream record by record, removes the stock, holds every move to part, allowance and machine.
/// Memory does not grow with the number of moves unless Setup::keep_moves asks for it.

#include <memory>
#include <optional>
#include <vector>

#include "check/result.hpp"
#include "cl/record.hpp"
#include "cl/stacks.hpp"
#include "geom/contour.hpp"
#include "shop/job.hpp"
#include "shop/machine.hpp"
#include "shop/tool.hpp"

namespace obrys::check {

/// What the program is held to. Regions lie in the (z, x) plane, x a radius, mm, and are closed to the axis.
struct Setup {
    shop::Machine machine;
    std::vector<shop::Tool> tools;
    bool tools_given = false;  ///< a tool list was given, even an empty one
    std::optional<geom::Region> stock;
    std::optional<geom::Region> part;       ///< finished part
    std::optional<geom::Region> allowance;  ///< what this program must leave: the part and the allowance on it
    shop::Tolerances tolerances;
    std::size_t keep_moves = 0;            ///< how many moves Result::moves keeps, for pictures
    std::size_t findings_per_code = 1000;  ///< the others are counted only
};

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
    [[nodiscard]] Result finish();
    [[nodiscard]] const Setup& setup() const;

private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace obrys::check
