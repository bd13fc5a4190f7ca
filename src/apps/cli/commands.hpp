#pragma once
/// The commands; each returns the exit code.

#include "arguments.hpp"

namespace obrys::cli {

[[nodiscard]] int check(const Arguments& arguments);
[[nodiscard]] int run(const Arguments& arguments);
[[nodiscard]] int plot(const Arguments& arguments);
[[nodiscard]] int translate(const Arguments& arguments);
[[nodiscard]] int post(const Arguments& arguments);
[[nodiscard]] int sheet(const Arguments& arguments);
[[nodiscard]] int time(const Arguments& arguments);
[[nodiscard]] int calibrate(const Arguments& arguments);
[[nodiscard]] int compare(const Arguments& arguments);
[[nodiscard]] int fmt(const Arguments& arguments);

}  // namespace obrys::cli
