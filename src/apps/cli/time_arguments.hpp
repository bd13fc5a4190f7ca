#pragma once
/// The options of obrys time and obrys calibrate.

#include <CLI/CLI.hpp>

#include "arguments.hpp"

namespace obrys::cli {

[[nodiscard]] CLI::App* add_time(CLI::App& app, Arguments& a);
[[nodiscard]] CLI::App* add_calibrate(CLI::App& app, Arguments& a);

}  // namespace obrys::cli
