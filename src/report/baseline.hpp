#pragma once
/// What findings are called, so that they are known again in the next run; and files of findings that are known.

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "report/subject.hpp"

namespace obrys::report {

/// A name for each group that lasts while lines move: made of the code, the program's and the text's file name, the
/// line without its block number, the lines that called it, and a count where all that is equal; of what is no line's
/// its cause. 16 hexadecimal digits.
[[nodiscard]] std::vector<std::string> fingerprints(const Subject& subject, const std::vector<check::Group>& groups);
/// The same of something that was not checked or was assumed.
[[nodiscard]] std::string fingerprint(const Subject& subject, const check::Note& note);

/// Findings that are known, line by line: how bad each was; no amount where it had none. Named as groups are, with the
/// job, and paths as seen from the baseline's `folder` (absolute, a slash at its end). What has a cause that is no line
/// ("tool 5 holder") is known where every line that it comes up in is: one collision does not hide the next.
using Baseline = std::map<std::string, std::optional<double>>;

/// A baseline file of these runs. Findings of other runs are put behind one another: call it once for all.
[[nodiscard]] std::string to_baseline(const std::vector<std::string>& entries);
/// What one run has for it.
[[nodiscard]] std::vector<std::string> baseline_entries(const Subject& subject, const std::string& folder);
/// Nothing where the text is no baseline.
[[nodiscard]] std::optional<Baseline> read_baseline(std::string_view text);

/// How much worse than it was a known finding may be before it counts as new: the amount's unit is mm mostly.
inline constexpr double known_slack = 0.01;
/// Marks the findings of `result` (of the subject) that the baseline knows.
void mark_known(const Subject& subject, const Baseline& baseline, const std::string& folder, check::Result& result);

}  // namespace obrys::report
