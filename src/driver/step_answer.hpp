#pragma once
/// What the STEP module says, on its way out of the process in which it runs. Private to driver.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "driver/guarded.hpp"
#include "mesh/mesh.hpp"
#include "mesh/step_module.hpp"

namespace obrys::driver {

struct StepAnswer {
    std::vector<mesh::Mesh> solids;
    std::string problem;  ///< of the file; where the result is not ok
    std::string loading;  ///< why the module could not be used; then nothing else is there
    mesh::ObrysStepResult result{};
};

/// Loads the module and has it read; all it says goes to `answer`.
void ask_module(const std::string& module, std::string_view bytes, const mesh::ObrysStepFineness& fineness,
                const Answer& answer);

/// Nothing where the answer is not whole, or names a vertex that is not there or a coordinate that cannot be.
[[nodiscard]] std::optional<StepAnswer> parse_answer(std::string_view answer);

}  // namespace obrys::driver
