/// Words of functions that do not act on the path (G5.1 Q, G22 X Y Z, M19 R), beside a motion or a cycle that reads the
/// same letters.

#include <algorithm>

#include "program/modal_group.hpp"
#include "read/rs274/fanuc/state.hpp"

namespace obrys::read::rs274 {

namespace {

constexpr std::string_view axis_letters = "XYZABCUVW";

bool is_of(char letter, std::string_view letters) { return letters.find(letter) != std::string_view::npos; }

bool has_coordinates(const FanucState& s) {
    return std::any_of(s.addresses.begin(), s.addresses.end(),
                       [](const Address& a) { return !a.used && !a.comma && is_of(a.letter, axis_letters); });
}

/// A G code of the block that acts once reads its coordinates: G28, G52, G53, G92.
bool acts_with_coordinates(const FanucState& s) {
    const bool word = std::any_of(s.words.begin(), s.words.end(), [](const BlockWord& w) {
        if (w.code != Code::modal) return false;
        const program::ModalGroup group = program::group_of(w.modal);
        return group == program::ModalGroup::once || group == program::ModalGroup::suppression ||
               w.modal == Modal::local_shift;
    });
    return word || std::any_of(s.special.begin(), s.special.end(), [](const Special& x) {
               return x.g->special != FanucSpecial::dwell && x.g->special != FanucSpecial::datum_number;
           });
}

/// The hole cycle in force reads the letter.
bool hole_reads(const FanucState& s, char letter) {
    if (is_of(letter, axis_letters) || letter == 'R' || letter == 'L') return true;
    if (letter == 'K' && !s.control.haas) return true;  // repeats
    const int hole = hole_of(s);
    const auto& table = s.variant.traits->canned;
    return std::any_of(table.begin(), table.end(), [&](const program::CannedCycle& c) {
        return c.number == hole && std::any_of(c.words.begin(), c.words.end(), [&](const program::CannedWord& w) {
                   return w.code == dialect::rs274::letter_code(letter);
               });
    });
}

/// Whether what else the block does reads the letter. `own_axes`: its coordinates are the function's where no word of
/// the block moves.
bool is_read_otherwise(const FanucState& s, char letter, bool own_axes) {
    if (letter == 'S') return false;
    const bool coordinates = has_coordinates(s);
    const bool moves = s.own_motion || (coordinates && !own_axes);
    if (hole_of(s) != 0 && coordinates && hole_reads(s, letter)) return true;
    if (s.turning != 0 && coordinates) return true;
    if (is_of(letter, axis_letters)) return s.own_motion || acts_with_coordinates(s);
    const bool arc = s.motion == Modal::arc_cw || s.motion == Modal::arc_ccw;
    if (moves && arc && is_of(letter, "RIJK")) return true;
    return moves && s.control.is_lathe() && is_of(letter, "RIK");  // corners, tapers
}

}  // namespace

void take_own_words(FanucState& s) {
    for (const OwnWords& own : s.own_words) {
        const bool own_axes = own.letters.find('X') != std::string_view::npos;
        bool shared = false;
        std::vector<Address*> taken;
        for (const char letter : own.letters) {
            Address* a = find_address(s, letter);
            const bool again = std::any_of(s.addresses.begin(), s.addresses.end(),
                                           [&](const Address& x) { return x.used && !x.comma && x.letter == letter; });
            if (a == nullptr || again) continue;  // a second one is said as such
            if (is_read_otherwise(s, letter, own_axes))
                shared = true;
            else
                taken.push_back(a);
        }
        for (Address* a : taken) {
            a->used = true;
            if (own.orients && a->letter != 'S') put_value(s, Order::value, Code::radius, a->value, *a);
        }
        if (shared) add_problem(s, Code::unsupported, own.begin, own.end, read_twice);
    }
}

}  // namespace obrys::read::rs274
