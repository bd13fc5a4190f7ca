#pragma once
/// How it is run: points are those of the tool's tip, X a radius; the reader says what holds in every block.
/// docs/dialects/fusion.md.

#include "program/traits.hpp"

namespace obrys::dialect::fusion {

extern const program::Traits traits;
/// Of texts that turn: tools for turning stand in them.
extern const program::Traits turning_traits;

}  // namespace obrys::dialect::fusion
