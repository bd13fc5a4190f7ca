#pragma once
/// The tolerances of the 2D kernel, millimetres.

namespace obrys::geom {

/// Points nearer than this are one point, a point nearer than this to an edge lies on it.
inline constexpr double snap = 1e-9;
/// A corner is dropped from a result where the joined edge passes it nearer than this; small, since the
/// error of repeated joining adds up.
inline constexpr double join = 1e-11;

}  // namespace obrys::geom
