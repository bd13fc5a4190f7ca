#pragma once
/// Infeeds, pecks and first cuts so small that a decimal point must be missing. Private to interp.

#include <functional>

#include "cycles/cycle.hpp"
#include "interp/say.hpp"

namespace obrys::interp {

/// Where a role of the call stands in the text; the call's place where nobody knows.
using PlaceOfRole = std::function<base::Span(cl::CycleRole)>;

/// Says what of the call is too small to be meant. A cycle that would take very many moves of that is not run: the
/// complaint is made, and of its steps there stay those to its place and the one away from it; false where they are not
/// known.
[[nodiscard]] bool doubt_infeeds(Saying&, std::string_view name, const cycles::Demand&, cycles::Expansion&,
                                 const PlaceOfRole&);
/// The word of the block at hand, with its letter; the block where it has none.
[[nodiscard]] base::Span place_of_word(const Saying&, program::Code);

}  // namespace obrys::interp
