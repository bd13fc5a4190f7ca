#pragma once
/// Jobs from their texts. File format: docs/job-file.md.

#include "shop/job.hpp"

namespace obrys::shop {

/// Reads a job text. Always gives a job: what was wrong is in `diagnostics` (codes job-file, job-value) and left out.
/// `machine` is the shipped one that is named; without a name the generic lathe where the job has a profile as stock or
/// part or turning tools, else the generic mill. Where `machine_is_file` the generic one, until `use_machine`.
[[nodiscard]] Job read_job(std::uint32_t file, const base::Sources& sources, base::Diagnostics& diagnostics);

}  // namespace obrys::shop
