#pragma once
/// Test side only: a FANUC or Haas program read, with everything that belongs to it.

#include <random>

#include "read/rs274/fanuc/read.hpp"
#include "read/rs274/reading.hpp"

namespace obrys::read::rs274::testing {

inline Reading fanuc(std::string text, std::string name = "TEST.NC") {
    return Reading(std::move(text), std::move(name),
                   [](std::uint32_t file, const base::Sources& s, program::Names& n, base::Diagnostics& d) {
                       return read_fanuc(file, s, n, d, {.machine = dialect::rs274::FanucMachine::mill});
                   });
}
inline Reading haas(std::string text, std::string name = "TEST.NC") {
    return Reading(std::move(text), std::move(name),
                   [](std::uint32_t file, const base::Sources& s, program::Names& n, base::Diagnostics& d) {
                       return read_haas(file, s, n, d, {.machine = dialect::rs274::FanucMachine::mill});
                   });
}
inline Reading lathe(std::string text) {
    return Reading(std::move(text), "TEST.NC",
                   [](std::uint32_t file, const base::Sources& s, program::Names& n, base::Diagnostics& d) {
                       return read_fanuc(file, s, n, d, {.machine = dialect::rs274::FanucMachine::lathe});
                   });
}
inline std::string pick(std::mt19937& random, const std::vector<std::string>& from) {
    return from[std::uniform_int_distribution<std::size_t>(0, from.size() - 1)(random)];
}
/// A program in millimetres between its signs.
inline std::string program(const std::string& lines) { return "%\nO1\nG21\n" + lines + "\nM30\n%\n"; }

/// The statements behind `O1` and `G21` and before `M30`, one a line; complaints instead where there are any.
inline std::string body(const Reading& r) {
    if (!r.diagnostics.all().empty()) return r.first_message();
    const program::testing::TreeText text(r.unit(), r.names);
    std::string out;
    const auto count = static_cast<std::uint32_t>(r.unit().statements.size());
    for (std::uint32_t i = 1; i + 1 < count; ++i) out += (out.empty() ? "" : "\n") + text.statement(i);
    return out;
}
inline std::string on_mill(const std::string& lines) { return body(fanuc(program(lines))); }
inline std::string on_haas(const std::string& lines) { return body(haas(program(lines))); }

}  // namespace obrys::read::rs274::testing
