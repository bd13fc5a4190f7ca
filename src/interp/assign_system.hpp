#pragma once
/// Writing system variables. Private to interp.

#include "interp/run.hpp"

namespace obrys::interp {

/// `target` is the assignment's, of kind system.
void assign_system(Telling& run, const program::Expr& target, const program::Assign& a);

}  // namespace obrys::interp
