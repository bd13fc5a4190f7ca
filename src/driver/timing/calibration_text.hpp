#pragma once
/// What a calibration found, for people and scripts, and as values of a machine file.

#include <string>
#include <vector>

#include "driver/timing/calibrate.hpp"
#include "shop/files/obrys/machine_edit.hpp"

namespace obrys::driver {

[[nodiscard]] std::string as_text(const Calibration& c, const std::string& machine);
[[nodiscard]] std::string as_json(const Calibration& c, const std::string& machine);
/// Those that the runs show, also if only together with others. `table`: where the runs stand, for the origins.
[[nodiscard]] std::vector<shop::NewValue> new_values(const Calibration& c, const shop::Machine& machine,
                                                     const std::string& table);

}  // namespace obrys::driver
