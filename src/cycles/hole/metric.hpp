#pragma once
/// Pitch of ISO metric threads.

#include <optional>

namespace obrys::cycles {

/// Coarse pitch of a thread of this nominal diameter, both mm; nothing where ISO 261 has none. Source: ISO 261.
[[nodiscard]] std::optional<double> coarse_pitch(double diameter);

}  // namespace obrys::cycles
