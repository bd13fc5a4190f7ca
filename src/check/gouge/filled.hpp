#pragma once
/// Material that is left in features of the part which the surface's cells cannot hold: a slot, an engraving, a thin
/// pocket, a small hole that nobody cuts. Looked for from the part to the result, by the sweeps themselves.
/// Millimetres.

#include <cstddef>
#include <vector>

#include "check/gouge/confirm.hpp"

namespace obrys::check {

struct FilledRest {
    std::vector<mesh::Place> places;  ///< the worst first; how deep the part's surface lies in material
    bool whole = true;                ///< false: the part has too many narrow faces to look at all
};

/// Places of the part's narrow faces (mesh/narrow.hpp) that lie deeper in what is left than three times
/// `options.excess`, and those that lie in it deeper than that once if material leaves the part there by more than it.
/// Not what is one of `known`: that is made higher where cells could not hold it.
[[nodiscard]] FilledRest filled_rest(const mesh::Comparison& found, const Machined& machined,
                                     const mesh::CompareOptions& options, std::vector<mesh::Place>& known);

}  // namespace obrys::check
