/// Letters that neither a code of the block nor the motion in force uses: the control refuses the block. Where the
/// block names its motion itself the reader has looked. Source: LinuxCNC 2.9, its stand-alone interpreter asked for
/// each of them (tests/linuxcnc/random_moves.py).

#include <bit>

#include "base/codes.hpp"
#include "base/text.hpp"
#include "interp/calls/calls.hpp"
#include "program/modal_group.hpp"

namespace obrys::interp {

namespace codes = base::codes;

namespace {

constexpr std::uint64_t held_letters = bit(Code::i) | bit(Code::j) | bit(Code::k) | bit(Code::l) | bit(Code::p) |
                                       bit(Code::q) | bit(Code::e) | bit(Code::radius) | bit(Code::offset_d) |
                                       bit(Code::offset_h);

/// Coordinates, centres or a word of its own make the motion in force run; another letter alone does not.
bool moves(const Moving& run) {
    constexpr std::uint64_t places = bit(Code::x) | bit(Code::y) | bit(Code::z) | bit(Code::a) | bit(Code::b) |
                                     bit(Code::c) | bit(Code::u) | bit(Code::v) | bit(Code::w) | bit(Code::i) |
                                     bit(Code::j) | bit(Code::k) | bit(Code::polar_angle) | bit(Code::polar_radius);
    const bool by_word = (run.block.groups >> static_cast<unsigned>(program::ModalGroup::motion) & 1u) != 0;
    return by_word || (run.block.present & places) != 0;
}

std::uint64_t used_by_motion(const Moving& run) {
    if (!moves(run)) return 0;
    switch (run.modal.motion) {
        case Modal::arc_cw:
        case Modal::arc_ccw: return bit(Code::i) | bit(Code::j) | bit(Code::k) | bit(Code::p) | bit(Code::radius);
        case Modal::thread: return bit(Code::k);
        case Modal::canned: {
            std::uint64_t used = bit(Code::radius) | bit(Code::l);
            for (const auto& w : run.traits->canned[static_cast<std::size_t>(run.modal.motion_number)].words)
                used |= bit(w.code);
            return used;
        }
        case Modal::rapid:
        case Modal::linear:
        case Modal::probe:
        case Modal::canned_off: return 0;
        default: return held_letters;
    }
}

std::uint64_t used_by_mode(Modal m) {
    switch (m) {
        case Modal::path_blend: return bit(Code::p) | bit(Code::q);
        case Modal::compensation_left:
        case Modal::compensation_right: return bit(Code::offset_d);
        case Modal::compensation_left_by:
        case Modal::compensation_right_by: return bit(Code::offset_d) | bit(Code::l) | bit(Code::radius);
        case Modal::tool_length:
        case Modal::tool_length_added: return bit(Code::offset_h);
        case Modal::surface_speed_on: return bit(Code::offset_d);
        default: return 0;
    }
}

std::uint64_t used_by_function(int m) {
    if (m >= 100) return held_letters;
    if (m == 19) return bit(Code::p) | bit(Code::q) | bit(Code::radius);
    if (m >= 50 && m <= 53) return bit(Code::p);
    if (m == 61) return bit(Code::q);
    if (m >= 62 && m <= 65) return bit(Code::p);
    if (m == 66) return bit(Code::p) | bit(Code::q) | bit(Code::e) | bit(Code::l);
    return m == 67 || m == 68 ? bit(Code::e) | bit(Code::q) : 0;
}

}  // namespace

void refuse_letters(Moving& run) {
    const BlockWords& b = run.block;
    std::uint64_t left = b.present & held_letters;
    if (left == 0 || b.special != Modal::linear || run.curve.open) return;
    left &= ~used_by_motion(run);
    if (left == 0) return;
    for (const int m : b.m) left &= ~used_by_function(m);
    const Unit& unit = run.unit();
    const auto index = static_cast<std::uint32_t>(run.statement - unit.statements.data());
    const std::uint32_t end = unit.words_end(index);
    for (std::uint32_t i = run.statement->first; i < end; ++i)
        if (program::code_of(unit.words[i]) == Code::modal) left &= ~used_by_mode(program::modal_of(unit.words[i]));
    for (std::uint32_t i = run.statement->first; i < end && left != 0; ++i) {
        const Code code = program::code_of(unit.words[i]);
        if (static_cast<unsigned>(code) >= 64 || (left & bit(code)) == 0) continue;
        const base::Span where = unit.span(*run.statement, unit.words[i]);
        const std::string word(base::trim(run.env.sources.text(where)));
        return alarm(run, codes::unknown_word, where,
                     word + " is used by no code of the block, nor by the motion in force",
                     "write the code it belongs to, e.g. G2 or G3 before a centre, or take it out");
    }
}

}  // namespace obrys::interp
