#pragma once
/// Where what a translation writes goes: the program, its subprograms, the ledger.

#include <string>

#include "arguments.hpp"
#include "driver/translate.hpp"

namespace obrys::cli {

/// Where the program and its subprograms go. In a folder, subprograms may stand in files of their own.
struct Target {
    bool folder = false;
    std::string main;  ///< path; empty: standard output
    [[nodiscard]] std::string of(const std::string& name) const;
};

/// An existing folder, or what ends as one.
[[nodiscard]] bool is_folder(const std::string& output);
[[nodiscard]] Target target_of(const Arguments& a, const std::string& name, const write::Post& post);
/// As a ledger names what stands there.
[[nodiscard]] std::string name_of(const Target& target);

/// Whether all the files may be written, now that they are known. False: it has been said.
[[nodiscard]] bool may_write_all(const Arguments& a, const driver::Session& s, const Target& target,
                                 const driver::Translated& t, const std::string& ledger);
/// The program with its subprograms, where it is written, and the ledger, where it has a name: JSON, HTML or text by
/// that. All of them whole before any of them stands in its place; false: none does, and why has been said.
[[nodiscard]] bool deliver_all(const Target& target, const driver::Translated& t, const std::string& ledger_path,
                               const report::Ledger& ledger);
/// The ledger of this name is a page, which shows the texts beside it.
[[nodiscard]] bool shows_texts(const std::string& ledger);

/// " (the control counts in increments of 0.001 mm)"; empty where it takes places as they are written.
[[nodiscard]] std::string of_increments(const driver::Proved& p);
[[nodiscard]] const char* verdict_of(const driver::Proved& proved);

}  // namespace obrys::cli
