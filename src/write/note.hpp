#pragma once
/// What becomes of what the stream says, in the text.

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "base/fate.hpp"
#include "cl/record.hpp"

namespace obrys::write {

/// What notes call it.
inline constexpr std::string_view radius_compensation = "radius compensation";

using base::Fate;

/// A cycle, a special function or a call of the program, and what became of it.
struct Note {
    Fate fate = Fate::lost;
    std::string what;
    base::Span from;
    cl::StackId stack = 0;
    std::uint64_t line = 0;  ///< of the text, counted from 1: the one that says it, or follows
    std::string file{};      ///< that holds the line; empty: that of the program
    std::string_view instead = "is written by its moves";  ///< of what is expanded
    std::string_view remedy{};  ///< it does the same by something that is taken for granted: how to say that
    bool may_be_lines = false;  ///< a curve that the post has no words for: its chords may stand there instead
    std::optional<base::Span> in_post{};  ///< where a function of the post has failed
};

/// "a move is not written: the post has no motion.tap"; of what is expanded with what stands `instead`.
[[nodiscard]] std::string sentence_of(const Note& note);

}  // namespace obrys::write
