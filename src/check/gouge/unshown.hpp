#pragma once
/// Rest material that a surface shows where it could not be followed.

#include <span>
#include <vector>

#include "check/gouge/confirm.hpp"

namespace obrys::check {

/// Takes out places of rest material at which nothing is, by the cuts themselves, and near which the surface is known
/// to be off: that is said of these places (`open`), and what the surface shows there means nothing.
void drop_unfollowed(std::vector<mesh::Place>& excesses, std::span<const sim::milling::Box3> open,
                     const Machined& machined);

}  // namespace obrys::check
