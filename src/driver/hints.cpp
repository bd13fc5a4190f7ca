#include "driver/hints.hpp"

#include <algorithm>

#include "base/codes.hpp"
#include "base/text.hpp"

namespace obrys::driver {

namespace {

using Place = std::pair<std::uint32_t, std::uint32_t>;

/// The line of a place, without its end.
Place line_of(std::string_view text, std::uint32_t at) {
    constexpr std::string_view ends = "\r\n";
    const std::size_t before = text.substr(0, at).find_last_of(ends);
    const std::size_t end = std::min(text.find_first_of(ends, at), text.size());
    return {static_cast<std::uint32_t>(before == std::string_view::npos ? 0 : before + 1),
            static_cast<std::uint32_t>(end)};
}

/// "Z-54": the number with its letter.
std::string word_at(std::string_view text, const Place& number) {
    std::size_t begin = number.first;
    while (begin > 0 && base::is_blank(text[begin - 1])) --begin;
    if (begin > 0 && base::is_letter(text[begin - 1])) --begin;
    return std::string(text.substr(begin, number.second - begin));
}

/// Numbers of the finding's block, as words.
std::string words_without_point(const program::Unit& unit, std::string_view text, std::uint32_t at) {
    const auto& all = unit.small_lengths;
    if (all.empty() || unit.lengths_with_point <= all.size()) return {};
    const Place line = line_of(text, at);
    std::string words;
    std::uint32_t last = 0;  // what a cycle reads ahead stands twice
    for (auto n = std::lower_bound(all.begin(), all.end(), Place(line.first, 0));
         n != all.end() && n->second <= line.second; ++n) {
        if (n->second == last) continue;
        last = n->second;
        words += (words.empty() ? "" : ", ") + word_at(text, *n);
    }
    return words;
}

}  // namespace

void ask_for_points(const std::vector<std::shared_ptr<const program::Unit>>& units, const base::Sources& sources,
                    check::Result& result) {
    for (check::Finding& f : result.findings)
        for (const auto& unit : units) {
            if (f.where == check::nowhere || unit->file != f.where.file || f.where.begin < unit->begin ||
                f.where.begin >= unit->end)
                continue;
            const std::string words = words_without_point(*unit, sources[f.where.file].text, f.where.begin);
            // Such a finding asks for the point of its word by itself.
            const bool asked = f.code == base::codes::infeed_implausible && words.find(',') == std::string::npos;
            if (words.empty() || asked) continue;
            f.remedy += (f.remedy.empty() ? "" : "; ") + words +
                        (words.find(',') == std::string::npos ? " is" : " are") +
                        " read in increments (0.001 mm, 0.0001 inch): look whether a decimal point is missing";
        }
}

void name_carried_compensation(const interp::Outcome& outcome, check::Result& result) {
    for (check::Finding& f : result.findings)
        for (const interp::CarriedCompensation& c : outcome.carried) {
            if (f.where == check::nowhere || c.change.file != f.where.file || f.where.begin < c.change.begin ||
                f.where.begin >= c.until)
                continue;
            f.remedy += (f.remedy.empty() ? "" : "; ") + c.word +
                        " is still in force here: see whether it was to be switched off before the tool change";
            break;
        }
}

}  // namespace obrys::driver
