#pragma once
/// STEP text -> Open CASCADE's shape, in mm. Private to the module.

#include <TopoDS_Shape.hxx>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>

#include "mesh/step_module.hpp"

namespace obrys::modules::step {

/// The outcome of reading that is not "ok"; thrown, and caught before it would leave the module.
struct Refusal {
    mesh::ObrysStepOutcome outcome;
    std::string text;
    std::uint64_t line = 0;  ///< of the file, from 1; 0: none
};

struct ReadShape {
    TopoDS_Shape shape;
    std::uint64_t complaints = 0;  ///< entries of the file that Open CASCADE did not take as they are
};

/// A text with what Open CASCADE says of it, where it says anything.
[[nodiscard]] inline std::string with(std::string text, const std::string& detail) {
    return detail.empty() ? text : std::move(text) + ": " + detail;
}

/// Throws Refusal, and whatever Open CASCADE throws.
[[nodiscard]] ReadShape read_shape(const char* bytes, std::size_t size);

}  // namespace obrys::modules::step
