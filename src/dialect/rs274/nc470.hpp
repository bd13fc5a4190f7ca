#pragma once
/// NC 470, a control that moves one axis at a time: the words in which post nc-470 writes. Sources:
/// docs/dialects/nc-470.md.

#include "dialect/rs274/tables.hpp"

namespace obrys::dialect::rs274 {

extern const program::Traits nc470_traits;
extern const Dialect nc470;

}  // namespace obrys::dialect::rs274
