#pragma once
/// The words of one block: values only. Private to interp.

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "cl/technology.hpp"
#include "interp/variables.hpp"
#include "program/unit.hpp"
#include "program/word.hpp"

namespace obrys::interp {

using program::Code;
using program::ExprId;
using program::Modal;
using program::Unit;

inline constexpr std::uint64_t linear_axes =
    bit(Code::x) | bit(Code::y) | bit(Code::z);  ///< words, as BlockWords::present

/// An assignment whose value is known and that waits for the block's other expressions (Traits::assigns_together).
struct PendingAssign {
    const program::Assign* assign = nullptr;
    double index = 0;  ///< of a numbered parameter
    double value = 0;
};

/// The words of one block, gathered before they act together.
struct BlockWords {
    struct NamedAxis {
        std::string name;
        double value = 0;
        std::uint8_t reference = 0;
        base::Span where;
    };
    std::uint64_t present = 0;               ///< bit per Code, of which there are 64 at most
    mutable std::uint64_t used = 0;          ///< of these, those that something has acted on
    std::uint64_t twice = 0;                 ///< of these, those that the block has more than once
    std::uint32_t groups = 0;                ///< bit per program::ModalGroup that the block has a word of
    std::array<double, 64> value;            ///< by Code; valid where the bit is set
    std::array<std::uint8_t, 64> reference;  ///< 0 = as the modal state says, else 1 + program::Reference
    std::vector<int> m;
    std::vector<cl::Auxiliary> h;
    std::vector<NamedAxis> axes;  ///< additional axes by name
    std::string tool_name;
    bool tool_named = false;
    int special_number = 0;
    int retract = 0;                     ///< M140: 1 by its distance, 2 to the limit; 0: none
    int surface_word = 0;                ///< 96 or 97 where the block says it
    bool acted = false;                  ///< F, S, T and M have acted already (Code::act)
    std::optional<double> feed_alone;    ///< FB, as written
    std::optional<double> thread_start;  ///< SF, degrees
    bool stops_run = false;              ///< STOP without a function
    bool rapid = false;                  ///< its arc, approach or departure is run in rapid (C … FMAX)
    bool says_straight = false;          ///< G0 or G1 stands in the block
    bool polar_path = false;             ///< its path function takes polar coordinates alone (LP, CP, CTP)
    bool changes_plane = false;          ///< to another one
    bool machine_axis = false;           ///< a linear axis by the name it has in the machine
    std::vector<NamedAxis> positioned;   ///< linear axes that move on their own (POS, POSA); name: of the axis
    bool goes_on = false;                ///< … and the program does not wait for one of them
    std::vector<PendingAssign> pending;
    std::vector<Modal> behind;           ///< Traits::modes_behind_motion
    Modal special = Modal::linear;       ///< dwell, reference point, fixed point, pole; linear: none
    Modal suppress = Modal::linear;      ///< suppress_frames, suppress_all; linear: none
    Modal corner_end = Modal::linear;    ///< corner_crossing, corner_open; linear: none
    std::optional<Modal> motion_behind;  ///< the motion in force from the next block on: this one has its own
    Modal paraxial = Modal::linear;      ///< paraxial, paraxial_longer, paraxial_shorter; linear: none

    [[nodiscard]] bool has(Code c) const { return (present >> static_cast<unsigned>(c)) & 1u; }
    /// The value of a word that acts now: it counts as used (unused_words.cpp).
    [[nodiscard]] double get(Code c) const {
        use(c);
        return value[static_cast<std::size_t>(c)];
    }
    /// The value of a word that is only looked at; something else has to use it.
    [[nodiscard]] double peek(Code c) const { return value[static_cast<std::size_t>(c)]; }
    void use(Code c) const { used |= bit(c); }
    [[nodiscard]] bool has_m(int number) const { return std::find(m.begin(), m.end(), number) != m.end(); }
    [[nodiscard]] std::uint8_t ref(Code c) const { return reference[static_cast<std::size_t>(c)]; }
    void put(Code c, double v, std::uint8_t r = 0) {
        const auto i = static_cast<std::size_t>(c);
        twice |= present & std::uint64_t{1} << i;
        present |= std::uint64_t{1} << i;
        value[i] = v;
        reference[i] = r;
    }
    void clear();
};

/// Kinds of plain blocks that have been run since anything but blocks of these kinds was (flow/alike.cpp).
struct PlainKinds {
    struct Kind {
        std::uint64_t words = 0;  ///< what they are, in their order; 0: no kind
        Modal motion = Modal::linear;
    };
    std::array<Kind, 16> kinds{};
    bool any = false;
    void forget() {
        if (any) *this = {};
    }
};

}  // namespace obrys::interp
