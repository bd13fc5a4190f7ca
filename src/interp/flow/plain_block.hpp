#pragma once
/// Long programs are made of blocks that hold nothing but G0 … G3, coordinates, centres and a feed. What has to be
/// looked at before such a block moves depends on its letters and on what is in force, not on its numbers: the first of
/// a kind is run with all of it, those that follow only move. Private to interp.

#include "interp/flow/flow.hpp"

namespace obrys::interp {

/// By its first word the block may be one of these.
[[nodiscard]] inline bool begins_plain(const Reckoning& run, const program::Statement& s) {
    constexpr std::uint64_t codes = linear_axes | bit(Code::i) | bit(Code::j) | bit(Code::k) | bit(Code::radius) |
                                    bit(Code::feed) | bit(Code::modal);
    const std::vector<program::Word>& words = run.unit().words;
    if (s.kind != program::StatementKind::block || s.first >= words.size()) return false;
    const program::Word& w = words[s.first];
    return w.code < program::value_codes && (codes >> w.code & 1U) != 0 && run.look == Look::no &&
           run.capture == nullptr;
}

/// Runs a block that begins like one of these where it is one; false where it is none.
[[nodiscard]] bool runs_plain_block(Cycling&, const program::Statement&, std::uint32_t index);
/// Conditions and loops: they change nothing of what is in force.
[[nodiscard]] bool keeps_plain_kinds(const program::Statement&);
/// Runs a block that does nothing but assign to variables of the program, while kinds are known: it changes nothing of
/// what is in force, nor of the words that the last plain block has left. False where it is none.
[[nodiscard]] bool runs_assignments(Calling&, const program::Statement&, std::uint32_t index);

}  // namespace obrys::interp
