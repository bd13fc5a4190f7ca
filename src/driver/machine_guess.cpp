#include "driver/machine_guess.hpp"

#include <array>
#include <optional>
#include <string_view>

namespace obrys::driver {

using program::Code;
using program::Modal;

namespace {

/// How much a word says of the machine.
enum class Sign : std::uint8_t {
    none,
    lathe_for_certain,  ///< no mill has it
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
    switch (program::code_of(w)) {
        case Code::speed_limit: return Sign::lathe_for_certain;
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

/// What the words name for each sign, the first one of each kind.
struct Found {
    std::array<std::string, 2> likely;  ///< lathe, mill: what to name in a message
    bool lathe = false, mill = false;   ///< for certain
    std::optional<base::Span> x;        ///< the first X word before a word that tells what it means
    bool told = false;

    void name(bool mill_side, const std::string& text) {
        std::string& list = likely[mill_side ? 1 : 0];
        if ((", " + list + ",").find(", " + text + ",") == std::string::npos) list += (list.empty() ? "" : ", ") + text;
    }
};

/// The name of a word in a message.
std::string name_of(const program::Word& w) {
    switch (program::code_of(w)) {
        case Code::speed_limit: return "a limit of the spindle speed";
        case Code::y: return "Y words";
        case Code::m: return "M6";
        default: break;
    }
    switch (program::modal_of(w)) {
        case Modal::plane_xy: return "G17";
        case Modal::plane_yz: return "G19";
        case Modal::plane_zx: return "G18";
        case Modal::surface_speed_on: return "G96";
        case Modal::diameter_on: return "DIAMON";
        case Modal::diameter_off: return "DIAMOF";
        case Modal::diameter_absolute_only: return "DIAM90";
        default: return "turning cycles";
    }
}

/// Whether a word can still tell anything. Nearly every block has X and Y words, and only the first ones tell.
bool tells_more(const Found& found, Code code) {
    switch (code) {
        case Code::x: return !found.told && !found.x;
        case Code::y: return !found.mill;
        case Code::m:
        case Code::modal:
        case Code::speed_limit: return true;
        default: return false;
    }
}

void take(Found& found, const program::Unit& unit, const program::Statement& s, const program::Word& w) {
    const Sign sign = sign_of(unit, w);
    found.told = found.told || tells_diameter(w);
    if (sign == Sign::none) return;
    if (sign == Sign::x) {
        found.x = unit.span(s, w);
        return;
    }
    found.lathe = found.lathe || sign == Sign::lathe_for_certain;
    found.mill = found.mill || sign == Sign::mill_for_certain;
    found.name(sign == Sign::mill_likely || sign == Sign::mill_for_certain, name_of(w));
}

}  // namespace

MachineGuess guess_machine(const program::Unit& unit) {
    Found found;
    for (std::uint32_t i = 0; i < unit.statements.size(); ++i) {
        const program::Statement& s = unit.statements[i];
        for (std::uint32_t k = s.first, end = unit.words_end(i); k < end; ++k)
            if (tells_more(found, program::code_of(unit.words[k]))) take(found, unit, s, unit.words[k]);
    }
    MachineGuess guess;
    const bool hinted = !found.likely[0].empty(), vetoed = !found.likely[1].empty();
    guess.turning = found.lathe || (hinted && !vetoed);
    guess.signs = found.likely[guess.turning ? 0 : 1];
    guess.against = found.likely[guess.turning ? 1 : 0];
    const bool proven = guess.turning ? found.lathe : found.mill || !hinted;
    if (!proven && found.x && !unit.traits->radius_at_start) guess.doubtful = *found.x;
    return guess;
}

}  // namespace obrys::driver
