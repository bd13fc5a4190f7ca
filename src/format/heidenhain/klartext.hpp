#pragma once
/// The two languages' block loops. Private to the folder.

#include "format/heidenhain/format.hpp"

namespace obrys::format::heidenhain {

[[nodiscard]] Formatted formatted_klartext(std::string_view text, const Options& options);
[[nodiscard]] Formatted formatted_iso(std::string_view text, const Options& options);

/// Numbers in a text that had none would make lines that stay as they are, and so get none, parts of the block before
/// them: where something stays, no block gets one. `Program`: the block loop of a language.
template <class Program>
[[nodiscard]] Formatted without_new_numbers(std::string_view text, const Options& options) {
    Program program(text, options);
    Formatted f = program.run();
    if (f.left.empty() || program.numbered()) return f;
    Program again(text, options);
    again.keep_numbers();
    return again.run();
}

}  // namespace obrys::format::heidenhain
