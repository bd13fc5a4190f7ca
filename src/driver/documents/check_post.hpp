#pragma once
/// A post tried out: what it writes of every kind of record and cycle, and what its control makes of that.

#include <string>
#include <vector>

#include "driver/session.hpp"
#include "write/samples.hpp"
#include "write/writer.hpp"

namespace obrys::driver {

enum class Outcome : std::uint8_t {
    written,
    expanded,  ///< by its moves, or by other words
    refused,   ///< something of it is lost, and said to be
    nothing,   ///< it has no words, and needs none
};
enum class ReadBack : std::uint8_t {
    none,  ///< the control has no reader, or the moves are the control's own
    same,  ///< the control does what was asked for
    said,  ///< it does the same, which is said in other words
    differs,
    unclear,  ///< something of it was not understood
};

struct TriedSample {
    write::Sample sample;
    Outcome outcome = Outcome::written;
    std::vector<std::string> blocks;  ///< as written
    std::vector<write::Note> notes;
    ReadBack read = ReadBack::none;
    std::vector<std::string> differences;  ///< of the meaning, or what the reader says
};

struct TriedPost {
    std::vector<TriedSample> samples;
    bool has_reader = false;
    [[nodiscard]] std::size_t count(Outcome o) const;
    [[nodiscard]] std::size_t count(ReadBack r) const;
};

[[nodiscard]] TriedPost try_post(const write::Post& post);

[[nodiscard]] std::string_view name_of(Outcome o);
[[nodiscard]] std::string_view name_of(ReadBack r);

}  // namespace obrys::driver
