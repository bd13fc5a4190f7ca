#pragma once
/// Tool data of SINUMERIK controls.

#include "shop/tool.hpp"

namespace obrys::shop {

/// The tools of a SINUMERIK tool data file (TOA): lines `$TC_DPn[T,D]=value` and `$TC_TP2[T]="name"`.
[[nodiscard]] std::vector<Tool> read_toa(std::uint32_t file, const base::Sources& sources,
                                         base::Diagnostics& diagnostics);

}  // namespace obrys::shop
