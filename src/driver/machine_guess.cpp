#include "driver/machine_guess.hpp"

#include <algorithm>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/text.hpp"

namespace obrys::driver {

using program::bit;
using program::Code;
using program::Modal;

namespace {

/// How much a word says of the machine.
enum class Sign : std::uint8_t {
    none,
    lathe_for_certain,  ///< no mill has it
    lathe_alone,        ///< LIMS: for certain where no word of a mill stands beside it
    lathe_likely,       ///< a mill may have it in some blocks: G18 for an arc
    mill_likely,        ///< a lathe may have it: M6, G17
    mill_for_certain,   ///< Y beside no word of a lathe
    x,
};

Sign sign_of(Modal m, bool radius_at_start) {
    switch (m) {
        case Modal::turning_cycle:
        case Modal::diameter_on:
        case Modal::diameter_absolute_only: return Sign::lathe_for_certain;
        case Modal::diameter_off:
        case Modal::surface_speed_on:
        case Modal::plane_zx: return radius_at_start ? Sign::none : Sign::lathe_likely;
        case Modal::plane_xy:
        case Modal::plane_yz: return Sign::mill_likely;
        default: return Sign::none;
    }
}

Sign sign_of(const program::Unit& unit, const program::Word& w) {
    switch (unit.address(w)) {
        case Code::speed_limit: return Sign::lathe_alone;
        case Code::x: return Sign::x;
        case Code::y: return Sign::mill_for_certain;
        case Code::m: return program::is_literal(w) && unit.literal(w) == 6 ? Sign::mill_likely : Sign::none;
        case Code::modal: return sign_of(program::modal_of(w), unit.traits->radius_at_start);
        default: return Sign::none;
    }
}

bool tells_diameter(const program::Word& w) {
    if (program::code_of(w) != Code::modal) return false;
    const Modal m = program::modal_of(w);
    return m == Modal::diameter_on || m == Modal::diameter_off || m == Modal::diameter_absolute_only;
}

/// The words of each sign.
struct Found {
    program::MachineSigns signs;
    bool lathe = false, mill = false;  ///< for certain
    bool lathe_alone = false;
    std::optional<base::Span> x;  ///< the first X word before a word that tells what it means
    bool told = false;
};

/// Codes of words that can still tell something. Nearly every block has X and Y words, and only the first ones tell.
std::uint64_t telling(const Found& found) {
    std::uint64_t codes = bit(Code::modal) | bit(Code::m) | bit(Code::speed_limit) | bit(Code::named_value);
    if (!found.told && !found.x) codes |= bit(Code::x);
    if (!found.mill) codes |= bit(Code::y);
    return codes;
}

/// Whether the word is one of these; G0 to G3 tell nothing.
bool tells_more(std::uint64_t codes, const program::Unit& unit, const program::Word& w) {
    const auto has = [&](Code c) { return static_cast<unsigned>(c) < program::value_codes && (codes & bit(c)) != 0; };
    const Code code = program::code_of(w);
    if (!has(code)) return false;
    if (code == Code::modal) return program::modal_of(w) > Modal::arc_ccw;
    return code != Code::named_value || has(unit.address(w));
}

void take(Found& found, const program::Unit& unit, const program::Statement& s, const program::Word& w) {
    constexpr std::size_t enough = 64;  // words of a sign
    const Sign sign = sign_of(unit, w);
    const base::Span at = unit.span(s, w);
    if (sign == Sign::none || at.begin == at.end) return;  // what a reader adds says nothing
    found.told = found.told || tells_diameter(w);
    if (sign == Sign::x) {
        found.x = at;
        return;
    }
    found.lathe = found.lathe || sign == Sign::lathe_for_certain;
    found.lathe_alone = found.lathe_alone || sign == Sign::lathe_alone;
    found.mill = found.mill || sign == Sign::mill_for_certain;
    const bool mills = sign == Sign::mill_likely || sign == Sign::mill_for_certain;
    std::vector<base::Span>& places = mills ? found.signs.mill : found.signs.lathe;
    if (places.size() < enough) places.push_back(at);
}

/// The words lie one behind the other; which statement one belongs to is asked of those that tell something.
Found find_signs(const program::Unit& unit) {
    Found found;
    if (unit.statements.empty()) return found;
    const auto behind = [](std::uint32_t i, const program::Statement& s) { return i < s.first; };
    std::uint64_t codes = telling(found);
    const std::span<const program::Word> words(unit.words);
    for (const program::Word& w : words.subspan(unit.statements.front().first)) {
        // A quick look first: it takes codes above those of values for others, and leaves out what most blocks have.
        static_assert(program::value_codes == 64);
        if ((codes >> (w.code & 63U) & 1U) == 0) continue;
        if (program::code_of(w) == Code::modal && program::modal_of(w) <= Modal::arc_ccw) continue;
        if (!tells_more(codes, unit, w)) continue;
        const auto at = static_cast<std::uint32_t>(&w - words.data());
        const auto next = std::upper_bound(unit.statements.begin(), unit.statements.end(), at, behind);
        take(found, unit, *(next - 1), w);
        codes = telling(found);
    }
    return found;
}

}  // namespace

std::string list_of_signs(const std::vector<base::Span>& places, const base::Sources& sources) {
    constexpr std::size_t most = 4, longest = 24;
    std::vector<std::string> words;
    std::string list;
    for (const base::Span& place : places) {
        if (words.size() == most) break;
        std::string word = base::as_utf8(base::trim(sources.text(place)));
        if (word.size() > longest || std::find(words.begin(), words.end(), word) != words.end()) continue;
        list += (list.empty() ? "" : ", ") + word + " (line " + std::to_string(sources.position(place).line) + ")";
        words.push_back(std::move(word));
    }
    return list;
}

MachineGuess guess_machine(const program::Unit& unit) {
    using program::GuessedMachine;
    const Found found = find_signs(unit);
    const bool weighed = unit.traits->guessed_machine == GuessedMachine::by_words;
    const program::MachineSigns& signs = weighed ? found.signs : unit.machine_signs;
    const bool hinted = !signs.lathe.empty(), vetoed = !signs.mill.empty();
    MachineGuess guess;
    guess.turning =
        weighed ? found.lathe || (hinted && !vetoed) : unit.traits->guessed_machine == GuessedMachine::lathe;
    guess.signs = guess.turning ? signs.lathe : signs.mill;
    guess.against = guess.turning ? signs.mill : signs.lathe;
    const bool proven = guess.turning ? (found.lathe || found.lathe_alone) && !found.mill
                                      : !hinted || (found.mill && !found.lathe_alone);
    const bool doubtful = weighed ? !proven : signs.doubtful;
    if (doubtful && found.x && !unit.traits->radius_at_start) guess.doubtful = *found.x;
    return guess;
}

}  // namespace obrys::driver
