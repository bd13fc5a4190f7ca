#pragma once
/// Profiles and simple blanks of a job file as regions of the (z, x) plane. Private to this room.

#include <optional>

#include "shop/files/section.hpp"
#include "shop/job.hpp"

namespace obrys::shop {

/// Keys `profile`, `diameter` and `closed` of a section; nothing where the profile is missing or was reported.
[[nodiscard]] std::optional<Profile> read_profile(Section& section);
/// Keys `bar`, `tube`, `cone` of [stock].
[[nodiscard]] std::optional<Profile> read_blank(Section& section);

}  // namespace obrys::shop
