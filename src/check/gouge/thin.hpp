#pragma once
/// Material that is left so thin that no cell of the surface holds it: fins between two cuts, webs. Rays that go
/// through it know it however thin it is, but for needles that pass between them. Millimetres.

#include <cstddef>

#include "check/gouge/confirm.hpp"

namespace obrys::check {

struct ThinRest {
    std::vector<mesh::Place> places;       ///< the worst first
    std::vector<sim::milling::Box3> open;  ///< where it is so thin that arithmetic may have made it
};

/// What leaves the part by more than `options.excess`. Not what lies in one of `known`: that is made higher where this
/// is.
[[nodiscard]] ThinRest thin_rest(const Machined& machined, const mesh::CompareOptions& options,
                                 std::vector<mesh::Place>& known);

}  // namespace obrys::check
