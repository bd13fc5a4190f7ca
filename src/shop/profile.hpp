#pragma once
/// Profiles and simple blanks of a job file as regions of the (z, x) plane. Private to shop.

#include <optional>

#include "shop/job.hpp"
#include "shop/section.hpp"

namespace obrys::shop {

/// Keys `profile`, `diameter` and `closed` of a section; nothing where the profile is missing or was reported.
[[nodiscard]] std::optional<Profile> read_profile(Section& section);
/// Keys `bar`, `tube`, `cone` of [stock].
[[nodiscard]] std::optional<Profile> read_blank(Section& section);

}  // namespace obrys::shop
