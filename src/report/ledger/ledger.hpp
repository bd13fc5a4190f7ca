#pragma once
/// The ledger of a translation as documents: what became of every cycle, special function and call.

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace obrys::report {

struct LedgerPlace {
    std::string file;
    std::uint64_t line = 0;  ///< from 1
};

enum class LedgerFate : std::uint8_t { mapped, expanded, lost };
[[nodiscard]] std::string_view name_of(LedgerFate fate);

struct LedgerEntry {
    std::string what;
    LedgerFate fate = LedgerFate::mapped;
    std::optional<LedgerPlace> from, to;  ///< `to` is absent where nothing was written for it
    std::uint64_t times = 1;              ///< how often it came to this
};

struct LedgerText {
    std::string name, text;  ///< UTF-8
};

struct Ledger {
    std::string program, control;  ///< that was read
    std::string output, post;      ///< what was written, and by which post
    std::string proof;             ///< "equal", "differs", "not compared"
    bool written = false;
    std::vector<LedgerEntry> entries;
    std::vector<LedgerText> sources, outputs;
};

[[nodiscard]] std::uint64_t count_of(const Ledger& ledger, LedgerFate fate);
/// "12 mapped, 1 expanded, 0 lost".
[[nodiscard]] std::string summary(const Ledger& ledger);
[[nodiscard]] std::string ledger_text(const Ledger& ledger);
/// docs/report-json.md
[[nodiscard]] std::string ledger_json(const Ledger& ledger);
/// One page that needs nothing beside it.
[[nodiscard]] std::string ledger_html(const Ledger& ledger);

}  // namespace obrys::report
