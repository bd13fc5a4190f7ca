#pragma once
/// What a command line is told that cannot be read, and the help.

#include <CLI/CLI.hpp>
#include <string>

namespace obrys::cli {

/// A file whose name begins with - is read as options.
void explain_dashes(int argc, char** argv);
void print_usage_error(const CLI::App& app, const CLI::ParseError& e);
/// Of one command, or the overview; false where there is no such command.
[[nodiscard]] bool print_help(const std::string& topic);

}  // namespace obrys::cli
