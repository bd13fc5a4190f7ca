#pragma once
/// How cutter locations are run: points are those of the tool's tip in the part, X a radius, nothing is modal but what
/// APT says. docs/dialects/apt-cl.md.

#include "program/traits.hpp"

namespace obrys::dialect::apt {

extern const program::Traits traits;
/// Of texts that turn: tools for turning stand in them.
extern const program::Traits turning_traits;

}  // namespace obrys::dialect::apt
