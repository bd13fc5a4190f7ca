#pragma once
/// What every command does before and after its work: opens the input, holds the outputs to it, prints complaints.

#include "arguments.hpp"
#include "driver/check_program.hpp"
#include "driver/cutting/tables.hpp"
#include "report/subject.hpp"

namespace obrys::cli {

void print_diagnostics(const driver::Session& s, base::Severity from = base::Severity::note);

/// The session, unless the input cannot be used or an output may not be written: then it has been said.
bool open(const Arguments& a, driver::Session& s);

/// The same of tables that were read without a program.
void print_diagnostics(const driver::cutting::Texts& texts);

/// Whether the outputs may be written beside these inputs. False: it has been said.
bool may_write(const Arguments& a, const std::vector<driver::fs::path>& inputs);

/// Whether the outputs may be written, now that all is known that was read. False: it has been said.
bool may_write(const Arguments& a, const driver::Session& s);

/// The request with what the call writes: no program prints into that.
[[nodiscard]] driver::Request with_outputs(const Arguments& a);

[[nodiscard]] report::Subject subject_of(const driver::Session& s, const driver::Checked& c);

}  // namespace obrys::cli
