#pragma once
/// Files of a check: where text goes, and the machined surface for other programs.

#include <string>

#include "arguments.hpp"
#include "driver/check_program.hpp"
#include "driver/output_file.hpp"
#include "report/subject.hpp"

namespace obrys::cli {

/// Writes the text where it was asked for. False where that fails (the complaint is printed).
bool deliver(const std::string& path, std::string_view text);
/// Ends a document; as above.
bool deliver(const std::string& path, driver::OutputFile& file);

[[nodiscard]] bool wants_surface(const Arguments& a);
/// --svg is the projections of what was milled.
[[nodiscard]] bool draws_milling(const Arguments& a, const driver::Checked& checked);
/// The files that were asked for. False where one could not be written; a job without milling stock has no surface.
bool write_surface(const Arguments& a, driver::Session& s, const driver::Checked& checked);
/// How every move was engaged, where that was asked for; as above.
bool write_engagement(const Arguments& a, const report::Subject& subject);

}  // namespace obrys::cli
