#pragma once
/// The commands of the command line and their options.

#include <CLI/CLI.hpp>

#include "arguments.hpp"

namespace obrys::cli {

struct Commands {
    CLI::App* check;
    CLI::App* run;
    CLI::App* plot;
    CLI::App* fmt;
    CLI::App* translate;
    CLI::App* compare;
    CLI::App* sheet;
    CLI::App* time;
    CLI::App* calibrate;
    CLI::App* post;
    CLI::App* version;
    CLI::App* help;
};

/// What opens a program or a job: control, machine, tools, where called programs are, where the result goes.
void add_request(CLI::App& app, Arguments& a);
[[nodiscard]] Commands add_commands(CLI::App& app, Arguments& a);
/// An empty name of a file is a variable of a script that nobody set.
void refuse_empty_names(const Commands& c);

}  // namespace obrys::cli
