#pragma once
/// What radius compensation hands on.

#include <cstdint>

#include "base/function_ref.hpp"
#include "path/element.hpp"

namespace obrys::path {

enum class Kind : std::uint8_t {
    passed,    ///< compensation off: as programmed
    contour,   ///< on the parallel of its element
    approach,  ///< the straight move onto it, or a move along w on the way
    retract,
    transition,  ///< inserted arc or line round an outer corner; tag of the following element
    link,        ///< inserted straight piece where parallels do not join (after a fault, or a gap in the contour)
    events,      ///< Method::held_move: nothing moves, `before` alone counts
};
struct Output {
    Element element;
    Kind kind = Kind::passed;
    bool operator==(const Output&) const = default;
};
using OutputSink = base::FunctionRef<void(const Output&)>;

}  // namespace obrys::path
