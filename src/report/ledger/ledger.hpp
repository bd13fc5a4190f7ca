#pragma once
/// The ledger of a translation as documents: what became of every cycle, special function and call.

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/fate.hpp"

namespace obrys::report {

struct LedgerPlace {
    std::string file;
    std::uint64_t line = 0;  ///< from 1
};

struct LedgerEntry {
    std::string what;
    base::Fate fate = base::Fate::mapped;
    std::optional<LedgerPlace> from, to;  ///< `to` is absent where nothing was written for it
    std::uint64_t times = 1;              ///< how often it came to this
};

struct LedgerText {
    std::string name, text;  ///< UTF-8
};

/// A parameter, variable or program, and what it is called in what was written.
struct LedgerName {
    std::string from, to;
    std::string program;  ///< the only one that has it; empty: all have it in common
};

/// A line of what was written, and the one that it comes from.
struct LedgerLine {
    LedgerPlace from;
    std::uint64_t to = 0;
};

/// A run with other values: "R3=150".
struct LedgerRun {
    std::vector<std::string> set;
    std::string proof;
};

/// Of a translation statement by statement.
struct LedgerOfStructure {
    std::vector<LedgerName> names, programs;
    std::vector<LedgerLine> lines;
    std::vector<LedgerRun> runs;
};

struct Ledger {
    std::string program, control;            ///< that was read
    std::string output, post, post_control;  ///< what was written, by which post, and for what it is read again
    std::string proof;                       ///< "equal", "differs", "not compared"
    bool written = false;
    std::vector<LedgerEntry> entries;
    std::vector<LedgerText> sources, outputs;
    std::optional<LedgerOfStructure> structure;
};

[[nodiscard]] std::uint64_t count_of(const Ledger& ledger, base::Fate fate);
/// "12 mapped, 1 expanded, 0 lost".
[[nodiscard]] std::string summary(const Ledger& ledger);
[[nodiscard]] std::string ledger_text(const Ledger& ledger);
/// docs/report-json.md
[[nodiscard]] std::string ledger_json(const Ledger& ledger);
/// One page that needs nothing beside it.
[[nodiscard]] std::string ledger_html(const Ledger& ledger);

}  // namespace obrys::report
