#pragma once
/// What a session reads besides the program it is about: job, machine, tables, backups, bodies.

#include "driver/session.hpp"

namespace obrys::driver {

[[nodiscard]] bool is_job(const std::filesystem::path& path);
/// A job that names no program is about the one beside it that is called like it: ball.ngc of ball.job.toml.
[[nodiscard]] std::string program_beside(const Storage& storage, const std::filesystem::path& job);
/// Every folder that the call or the job names is one.
[[nodiscard]] bool folders_are_there(Session& s, const Request& request, const std::filesystem::path& input);
/// Configuration and parameter file of a LinuxCNC machine. Without a configuration its stand-alone interpreter, which
/// canonical calls are compared with, takes a machine in inches.
void load_configuration(Session& s, const Request& request);
/// Backups of the control's variables that the job names; LinuxCNC's parameter file has a form of its own.
void load_backups(Session& s, const Request& request);
/// Bodies are read when they are needed; that they are there is seen at once.
void check_bodies(Session& s);
/// The machine that the call or the job names; false where it cannot be read. `named`: there is one.
[[nodiscard]] bool load_named_machine(Session& s, const Request& request, const std::filesystem::path& job_path,
                                      bool& named);
[[nodiscard]] bool read_main(Session& s, const Request& request, const std::filesystem::path& path);

}  // namespace obrys::driver
