#pragma once
/// What a job file says of its cuts; the rest of it is read by shop/files/obrys. File format: docs/force.md.

#include "base/diagnostic.hpp"
#include "shop/cutting.hpp"

namespace obrys::shop {

[[nodiscard]] CuttingJob read_cutting_job(std::uint32_t file, const base::Sources& sources,
                                          base::Diagnostics& diagnostics);

}  // namespace obrys::shop
