#include "shop/nearest.hpp"

#include <algorithm>

#include "base/edit_distance.hpp"
#include "base/text.hpp"

namespace obrys::shop {

namespace {

/// The first of `words` (in capitals) that is fewest edits away; empty where none is near.
std::string fewest_edits(const std::string& wanted, const std::vector<std::string>& words) {
    std::size_t best = std::max<std::size_t>(1, wanted.size() / 3) + 1;
    std::string found;
    for (const std::string& w : words) {
        const std::size_t d = base::edit_distance(wanted, base::to_upper(w));
        if (d < best) {
            best = d;
            found = w;
        }
    }
    return found;
}

/// The first of `words` that begins most alike: with the whole word, or with all but its last letter or two.
std::string same_begin(const std::string& wanted, const std::vector<std::string>& words) {
    std::size_t best = wanted.size() < 5 ? wanted.size() : std::max<std::size_t>(4, wanted.size() - 2);
    if (wanted.size() < 3) return {};
    std::string found;
    for (const std::string& w : words) {
        const std::string other = base::to_upper(w);
        const auto [end, unused] = std::mismatch(wanted.begin(), wanted.end(), other.begin(), other.end());
        const auto alike = static_cast<std::size_t>(end - wanted.begin());
        if (alike < best || (alike == best && !found.empty())) continue;
        best = alike;
        found = w;
    }
    return found;
}

}  // namespace

std::string nearest(std::string_view word, const std::vector<std::string>& words) {
    if (word.size() > 64) return {};
    const std::string wanted = base::to_upper(word);
    const std::string found = fewest_edits(wanted, words);
    return found.empty() ? same_begin(wanted, words) : found;
}

std::string joined(const std::vector<std::string>& words) {
    std::string out;
    for (const std::string& w : words) out += (out.empty() ? "" : ", ") + w;
    return out;
}

std::string words_remedy(std::string_view word, const std::vector<std::string>& words, std::string_view lead) {
    const std::string near = nearest(word, words);
    return (near.empty() ? "" : "did you mean \"" + near + "\"? ") + std::string(lead) + ": " + joined(words);
}

}  // namespace obrys::shop
