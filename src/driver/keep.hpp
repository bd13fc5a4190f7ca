#pragma once
/// A program written for another control statement by statement (translate --keep), and the proof: both are run, with
/// the program's own values and with others.

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "driver/translate.hpp"
#include "rewrite/rewrite.hpp"

namespace obrys::driver {

/// The tables of a post that say how programs compute and branch; nothing, with what is wrong in the session's
/// diagnostics, where it has none.
[[nodiscard]] std::optional<rewrite::Language> find_language(const std::string& name, Session& session);

/// The text, and what the program does with its own values.
struct Kept {
    rewrite::Rewritten rewritten;
    Translated translated;
};
[[nodiscard]] Kept keep(Session& session, const rewrite::Language& language, const std::string& name);

/// What a rewriting says, at its place in the program.
[[nodiscard]] base::Diagnostic complaint_of(const rewrite::Note& note);

/// Names on one side, and what they are called on the other.
using NameMap = std::vector<std::pair<std::string, std::string>>;
[[nodiscard]] NameMap map_of(const rewrite::Rewritten& rewritten);
/// "R3=150" as "Q3=150" where the map has R3; else as it is.
[[nodiscard]] std::vector<std::string> mapped(const std::vector<std::string>& set, const NameMap& map);
[[nodiscard]] shop::GivenValues mapped(const shop::GivenValues& given, const NameMap& map);

/// Sets of other values for the parameters that the programs assign once, as a constant: within a fifth of it. The same
/// ones every time; none where there is no such parameter.
[[nodiscard]] std::vector<std::vector<std::string>> other_values(const Session& session, const rewrite::Rewritten& what,
                                                                 std::size_t count);

/// As `prove`, with the values of `set` on both sides: the program is run again with them. A run that ends with an
/// alarm must do so in both.
[[nodiscard]] Proved prove_with(const std::vector<std::string>& set, const Kept& kept, const write::Post& post,
                                const Request& request, const compare::Tolerance& tolerance, std::string& what);

/// One run of both, with values of its own.
struct KeptRun {
    std::vector<std::string> set;
    Proof proof = Proof::not_compared;
};
/// What was done with each (docs/translate.md).
[[nodiscard]] report::Ledger ledger(const Session& session, const Kept& kept, const std::string& output,
                                    const std::vector<KeptRun>& runs);
/// The names of a ledger; nothing where the text is none.
[[nodiscard]] std::optional<NameMap> names_of_ledger(const std::string& text);
/// Where the ledger of a program lies: beside it.
[[nodiscard]] inline std::string ledger_beside(const std::string& program) { return program + ".ledger.json"; }

}  // namespace obrys::driver
