#pragma once
/// A check's result as text, JSON, SARIF, picture and page. Every function returns the whole document, UTF-8.

#include <string>

#include "report/subject.hpp"

namespace obrys::report {

struct TextOptions {
    bool colours = false;  ///< ANSI escapes
    bool listed = true;    ///< also what is listed without effect on the verdict
    bool all = false;      ///< every move of a finding that several moves make
    bool quiet = false;    ///< verdict, findings and what was not checked only
};
/// The verdict line first, then findings as `file:line:col: severity: message [code]` with source line and call stack;
/// those of one cause (check/group.hpp) are one.
[[nodiscard]] std::string to_text(const Subject& subject, const TextOptions& options = {});

/// Version of the JSON's shape: docs/report-json.md.
inline constexpr int json_version = 2;
/// `all`: also what every move of a finding did.
[[nodiscard]] std::string to_json(const Subject& subject, bool all = false);

/// SARIF 2.1.0, one run, one rule for each code of base/codes.hpp. `all`: a result for every move of a finding.
[[nodiscard]] std::string to_sarif(const Subject& subject, bool all = false);

/// An input of several that could not be checked at all.
struct Unreadable {
    std::string input;
    std::vector<base::Diagnostic> diagnostics;
};
/// Of several checks one document each way: an array of the JSONs, a SARIF log with their runs.
[[nodiscard]] std::string unreadable_json(const Unreadable& input);
[[nodiscard]] std::string unreadable_sarif(const Unreadable& input);
[[nodiscard]] std::string joined_sarif(const std::vector<std::string>& logs);

struct SvgOptions {
    double width = 1040;  ///< picture units (96 to the inch); the height follows from the part
};
/// Stock, part, allowance, tool path and numbered findings; z to the right, x up, equal scale.
[[nodiscard]] std::string to_svg(const Subject& subject, const SvgOptions& options = {});

struct HtmlOptions {
    std::size_t most_moves = 20'000;  ///< the page shows no more
    std::size_t most_lines = 20'000;  ///< of program text
};
/// One page that needs no network.
[[nodiscard]] std::string to_html(const Subject& subject, const HtmlOptions& options = {});

}  // namespace obrys::report
