#pragma once
/// Which control and which machine a program is taken to be for, and what is said of it.

#include <cstdint>
#include <optional>
#include <string>

#include "driver/control.hpp"
#include "driver/session.hpp"

namespace obrys::driver {

/// False after a complaint: there is no control of that name. An empty name is none.
[[nodiscard]] bool known_control(Session& s, const std::string& name, const base::Span& where);
/// The control that the call or the job names; else what the text looks like. None after a complaint. `turns`: whether
/// the machine is a lathe, where somebody says it.
[[nodiscard]] const Control* choose_control(Session& s, const Request& request, std::uint32_t file,
                                            std::optional<bool> turns);
/// Where none is named, one for what the program is.
void choose_machine(Session& s, const Request& request);
/// Diameters that were asked for where the control has none (Traits::has_diameter_words) are not taken, and said.
void settle_diameters(Session& s, const Request& request);

}  // namespace obrys::driver
